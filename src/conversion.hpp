// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_CONVERSION_HPP
#define OPENCV_GWATERSHED_CONVERSION_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The image in 8 bits: the image itself if it has 8 bits, else converted into the buffer.
Mat convertImage(const Mat& image, Mat& buffer);

//! Depth as CV_8UC1 in the buffer: 1..255, 0 where it is missing. Empty if depth is empty or the same everywhere. If
//! both limits are 0, the range is taken from the frame.
Mat scaleDepth(const Mat& depth, float near_depth, float far_depth, Mat& buffer);

}}} // namespace

#endif
