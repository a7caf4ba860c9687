// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BLOCK_GRADIENT_HPP
#define OPENCV_GWATERSHED_BLOCK_GRADIENT_HPP

#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Gradient map of all colours and depth, weighted as in the distance, CV_16UC1.
//! mask is that of the blocks, or empty: beside what is outside of it gradients are UNKNOWN_GRADIENT.
void computeBlockGradient(const Padded<Feature>& features, const RegionDistance& distance, const Mat& mask,
                                     Mat& gradient);

}}} // namespace

#endif
