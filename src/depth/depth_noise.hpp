// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_DEPTH_NOISE_HPP
#define OPENCV_GWATERSHED_DEPTH_NOISE_HPP

#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Levels of depth between two neighbours, at most, in the median: more of them cut up what is flat.
const double LEVELS_OF_NOISE = 20;

//! The median difference of two neighbours in someRows(), of their depths or of the inverses, within limits: on
//! surfaces there is little but noise between pixels, and edges are too few to matter. 0 if there are no such two.
double noiseOfDepth(const Mat& depth, FloatRange limits, bool of_inverse);

}}} // namespace

#endif
