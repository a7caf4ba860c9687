// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ARGUMENTS_HPP
#define OPENCV_GWATERSHED_ARGUMENTS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! @file Checks of inputs and outputs. A check of an input returns its matrix (the data is not copied), or throws.

void checkIterations(int num_iterations);
void checkSize(int64 width, int64 height);

//! An image that can be segmented.
Mat checkImage(InputArray input);
//! The depth of an image of that size.
Mat checkDepth(InputArray input, Size size);
//! An image to measure, of any type; may be empty.
Mat checkValues(InputArray input, Size size);
//! CV_8UC1; may be empty.
Mat checkMask(InputArray input);
//! CV_32SC1; may be empty.
Mat checkMarkers(InputArray input);

//! Throws if an output cannot become a matrix of a type. A vector can only if the matrix has one row or one column,
//! which is_line tells. The message has the name of the output.
void checkOutput(const _OutputArray& output, int type, bool is_line, const char* name);

//! Allocates an output that was checked. The matrix returned has the size, even if the output is a vector.
Mat createOutput(const _OutputArray& output, Size size, int type);

}}} // namespace

#endif
