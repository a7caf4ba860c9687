// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_VALID_DEPTH_HPP
#define OPENCV_GWATERSHED_VALID_DEPTH_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Whether depth is known. It is missing where it is 0 and, in float, where it is negative, infinite or NaN.
inline bool isValidDepth(uchar depth) { return depth != 0; }
inline bool isValidDepth(ushort depth) { return depth != 0; }
inline bool isValidDepth(float depth) { return depth > 0 && depth <= FLT_MAX; }
inline bool isValidDepth(double depth) { return depth > 0 && depth <= DBL_MAX; }

}}} // namespace

#endif
