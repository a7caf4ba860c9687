// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_CONTOURS_HPP
#define OPENCV_GWATERSHED_CONTOURS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Mask of the pixels that have a neighbour with another label.
void drawContours(const Mat& labels, bool thick_line, Mat& mask);

}}} // namespace

#endif
