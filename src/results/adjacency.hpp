// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ADJACENCY_HPP
#define OPENCV_GWATERSHED_ADJACENCY_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Pairs of superpixels that touch, with the length and, if color is not empty, the contrast of their boundary. The
//! tables are those of SuperpixelGWatershed::getAdjacency().
void listAdjacency(const Mat& labels, int num_labels, const Mat& color, const Mat& depth, int alpha, Mat& pairs,
                   Mat& lengths, Mat& contrasts);

}}} // namespace

#endif
