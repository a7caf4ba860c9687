// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_DEPTH_SCALE_HPP
#define OPENCV_GWATERSHED_DEPTH_SCALE_HPP

#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Depth as CV_8UC1 in the buffer, 1..255, 0 where missing; empty if depth is empty or tells
//! nothing apart. Both limits 0: the range is taken from the frame, and depth in 8 bits is as it is.
Mat scaleDepth(const Mat& depth, FloatRange range, Mat& buffer);

}}} // namespace

#endif
