// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_EDGE_BLOCKS_HPP
#define OPENCV_GWATERSHED_EDGE_BLOCKS_HPP

#include "shared/features.hpp"
#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

struct EdgeBlock
{
    int at; //!< its index
    Feature other; //!< the colour of a side or its own: that which the block has not now
};

//! Blocks astride of an edge. Their colour is a mixture that nothing in the image has, so they would be regions of
//! their own, along the edge. While regions are found, each has the colour of the side that it is more like.
class EdgeBlocks
{
public:
    //! Gives these blocks the colour of a side. Labels are UNSEEN, or OUTSIDE for what is neither block nor side.
    void takeSides(const Padded<int>& labels, Padded<Feature>& blocks);
    //! Gives them their own colours back, in the regions as well.
    void takeBack(const Padded<int>& labels, Padded<Feature>& blocks, Regions& regions);

private:
    std::vector<std::vector<EdgeBlock> > found_; // by chunks of rows
};

}}} // namespace

#endif
