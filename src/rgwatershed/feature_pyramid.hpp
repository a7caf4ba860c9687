// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FEATURE_PYRAMID_HPP
#define OPENCV_GWATERSHED_FEATURE_PYRAMID_HPP

#include "shared/features.hpp"
#include "shared/frame.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Opponent colours, or colours as they are, and depth, on the levels 0 (of pixels) to top. A level has the means of
//! blocks of 2x2 of the one before; an odd last row or column is repeated.
//! Normals, if there are any, are those of the blocks of level 1.
void makePyramid(const Frame& frame, bool lab_input, int top, FeatureMap* levels);

}}} // namespace

#endif
