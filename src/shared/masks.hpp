// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MASKS_HPP
#define OPENCV_GWATERSHED_MASKS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Bounding box of the non-zero pixels of a CV_8UC1 mask; empty if there are none.
Rect findBounds(const Mat& mask);

//! Gradients with a pixel outside of the mask in their 3x3 window become UNKNOWN_GRADIENT.
void forgetGradients(const Mat& mask, Mat& gradient);

//! Stands for a gradient that is not known. Markers avoid it, and it makes no border.
enum { UNKNOWN_GRADIENT = USHRT_MAX };

}}} // namespace

#endif
