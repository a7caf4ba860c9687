// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FEATURE_PYRAMID_HPP
#define OPENCV_GWATERSHED_FEATURE_PYRAMID_HPP

#include "shared/features.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Opponent colours, or colours as they are, and depth, on the levels 0 (of pixels) to top. A level has the means of
//! blocks of 2x2 of the one before; an odd last row or column is repeated.
//! color is 8-bit with 1, 3 or 4 channels, depth CV_8UC1 or empty.
void makePyramid(const Mat& color, const Mat& depth, const Mat& normals, bool lab_input, int top, FeatureMap* levels);

}}} // namespace

#endif
