// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MASK_PYRAMID_HPP
#define OPENCV_GWATERSHED_MASK_PYRAMID_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! A mask, and masks of the blocks of 2x2, 4x4... pixels, which may have small holes. What is connected in blocks is
//! connected in pixels, too.
class MaskPyramid
{
public:
    //! Sets the mask, CV_8UC1 with 0 and 255. It is not copied, and must not be written to later.
    void build(const Mat& mask);

    const Mat& mask(int level) const { return levels_[level].mask; }
    //! Number of blocks inside.
    int blocks(int level) const { return levels_[level].blocks; }
    //! Number of connected components of the blocks.
    int components(int level) const { return levels_[level].components; }
    //! Number of connected components of the mask that hold no block of that level.
    int lost(int level) const { return levels_[level].lost; }

private:
    struct Level
    {
        Mat mask;
        int blocks, components, lost;
    };

    static int countLost(const Mat& components, const std::vector<Level>& levels, int top);

    std::vector<Level> levels_;
};

}}} // namespace

#endif
