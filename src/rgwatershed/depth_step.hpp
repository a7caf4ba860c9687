// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_DEPTH_STEP_HPP
#define OPENCV_GWATERSHED_DEPTH_STEP_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Pixels of a block that differ by more levels of depth are those of two sides of a step: STEP_OF_DEPTH, or more where
//! depth is noisy. depth is CV_8UC1, 0 where it is missing.
int stepOfDepth(const Mat& depth);

}}} // namespace

#endif
