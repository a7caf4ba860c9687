// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MASK_PYRAMID_HPP
#define OPENCV_GWATERSHED_MASK_PYRAMID_HPP

#include "shared/padded.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Bounding box of the non-zero pixels of a CV_8UC1 mask; empty if there are none.
Rect findBounds(const Mat& mask);

//! Gradients beside a pixel outside of the mask become UNKNOWN_GRADIENT.
void forgetGradients(const Mat& mask, Mat& gradient);

//! What stands for a gradient that cannot be told: markers avoid it, and it is no border.
enum { UNKNOWN_GRADIENT = USHRT_MAX };

//! A mask, and masks of the blocks of 2x2, 4x4... pixels that lie in it as a whole.
class MaskPyramid
{
public:
    //! Replaces the mask, CV_8UC1 with 0 and 255, which must not be written to later.
    void build(const Mat& mask, int max_level);

    const Mat& mask(int level) const { return levels_[level].mask; }
    //! Number of blocks inside.
    int blocks(int level) const { return levels_[level].blocks; }
    //! Number of connected components of the blocks.
    int components(int level) const { return levels_[level].components; }
    //! Number of connected components of the pixels in which no block lies.
    int lost(int level) const { return levels_[level].lost; }

private:
    struct Level
    {
        Mat mask;
        int blocks, components, lost;
    };

    std::vector<Level> levels_;
};

}}} // namespace

#endif
