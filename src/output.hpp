// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_OUTPUT_HPP
#define OPENCV_GWATERSHED_OUTPUT_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Throws where an output, which has a name, cannot become a matrix of a type; a vector can only where `is_line` tells
//! that the matrix has one row or column.
void checkOutput(const _OutputArray& output, int type, bool is_line, const char* name);

//! Allocates an output that was checked; the matrix has the size, also where the output is a vector.
Mat createOutput(const _OutputArray& output, Size size, int type);

}}} // namespace

#endif
