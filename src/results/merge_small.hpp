// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_SMALL_HPP
#define OPENCV_GWATERSHED_MERGE_SMALL_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Merges regions smaller than min_area pixels, the smallest first. Returns the new number of labels.
int mergeSmallRegions(int num_labels, int min_area, Mat& labels);

}}} // namespace

#endif
