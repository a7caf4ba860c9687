// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FEATURE_PYRAMID_HPP
#define OPENCV_GWATERSHED_FEATURE_PYRAMID_HPP

#include "rgwatershed/block_grid.hpp"
#include "rgwatershed/mask_pyramid.hpp"
#include "shared/features.hpp"
#include "shared/frame.hpp"
#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The levels of a pyramid: pixels are level 0; the blocks of each further level are made of those of the one before.
struct BlockLevels
{
    int top;  //!< the last level
    int base; //!< side of the blocks of level 1 in pixels, 2 or 3; it doubles on each level after it
    bool centered; //!< short blocks lie in the middle. Else places in blocks become places in pixels by one formula.

    //! Side of the blocks of a level in pixels.
    int side(int level) const { return level == 0 ? 1 : base << (level - 1); }
    //! Side of the blocks of a level in those of the level before.
    int ratio(int level) const { return level == 1 ? base : 2; }
    //! The blocks of a level in the elements of the level before, for an image of a size.
    BlockGrid grid(int level, Size size) const
    {
        return BlockGrid(sizeOf(level - 1, size), ratio(level), centered);
    }
    //! What an image of a size has of the blocks of a level.
    Size sizeOf(int level, Size size) const
    {
        const int s = side(level);
        return Size((size.width + s - 1) / s, (size.height + s - 1) / s);
    }
};

//! What the depth of a block at a step leaves out of the sum over its elements.
struct LostDepth
{
    Point block;
    int sum;
};

//! The features of a level.
struct PyramidLevel : FeatureMap
{
    std::vector<std::vector<LostDepth> > lost_depths; //!< by chunks of rows
};

//! Opponent colours, or colours as they are, and depth, on all levels. A block has the mean of those it is made of;
//! where some of them are missing, the last one stands for them. At a step, its depth is that of one side.
//! Normals, if there are any, are those of blocks of 2x2 pixels; larger blocks have their means.
void makePyramid(const Frame& frame, bool lab_input, const BlockLevels& levels, const MaskPyramid& masks,
                 PyramidLevel* features);

//! Adds to the sums of regions of blocks, divided, what the depths of blocks at a step leave out: the other side of it.
//! Then they are the sums over the elements, which move to other regions one by one.
void addLostDepths(const PyramidLevel& blocks, const Padded<int>& labels, Regions& regions);

}}} // namespace

#endif
