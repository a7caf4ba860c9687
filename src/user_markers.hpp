// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_USER_MARKERS_HPP
#define OPENCV_GWATERSHED_USER_MARKERS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Numbers the different positive values of a CV_32SC1 map from 0, in their order. All other pixels, and those
//! outside of the mask if it is not empty, become -1. Returns how many values there are.
int numberMarkers(const Mat& markers, const Mat& mask, Mat& numbered);

//! A few markers, as scribbles, are drawn on things of any size, with all of their colours. So each part of one, in a
//! cell of a grid, gets a number of its own, and grows by the colours near to it. Returns how many there are. owners
//! has the marker of each part; it is empty if the markers are too many for that, and stay whole.
int divideMarkers(int num_markers, Mat& numbered, std::vector<int>& owners);

}}} // namespace

#endif
