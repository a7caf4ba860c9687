// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_GRADIENT_MAP_HPP
#define OPENCV_GWATERSHED_GRADIENT_MAP_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Sobel magnitude of the grey image and of depth, weighted by alpha in 1/256: CV_16UC1, 0..1140.
void computeGradientMap(const Mat& color, const Mat& depth, int alpha, Mat& gradient);

}}} // namespace

#endif
