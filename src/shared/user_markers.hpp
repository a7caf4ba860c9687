// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_USER_MARKERS_HPP
#define OPENCV_GWATERSHED_USER_MARKERS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Numbers the positive values of a CV_32SC1 map of markers, inside of the mask if that is not empty, from
//! 0 in their order; all else becomes -1. Returns how many there are.
int numberMarkers(const Mat& markers, const Mat& mask, Mat& numbered);

}}} // namespace

#endif
