// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ADJACENCY_HPP
#define OPENCV_GWATERSHED_ADJACENCY_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Pairs of superpixels that touch, the length of their boundary, and its mean contrast where color is not
//! empty; tables as SuperpixelGWatershed::getAdjacency() has them.
void listAdjacency(const Mat& labels, int num_labels, const Mat& color, const Mat& depth, int alpha, Mat& pairs,
                   Mat& lengths, Mat& contrasts);

}}} // namespace

#endif
