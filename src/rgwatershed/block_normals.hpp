// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BLOCK_NORMALS_HPP
#define OPENCV_GWATERSHED_BLOCK_NORMALS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Normals of blocks of 3x3 or 4x4 pixels, from those of blocks of 2x2: means of what is known of those they touch,
//! which are two in each row and column. Rows of both end with some that are not known, up to a whole stride.
void uniteNormals(const Mat& normals, int side, Size size, Mat& united);

}}} // namespace

#endif
