// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ARGUMENTS_HPP
#define OPENCV_GWATERSHED_ARGUMENTS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! @file Checks of inputs and outputs. Those of inputs return the header of a matrix that is as it must be, or throw.

const int MAX_CHANNELS = 4; //!< of an image

void checkIterations(int num_iterations);
void checkSize(int64 width, int64 height);

//! An image that can be segmented.
Mat checkImage(InputArray input);
//! The depth of an image of a size; may be empty.
Mat checkDepth(InputArray input, Size size);
//! An image to measure, of any depth but 64-bit integers, and any number of channels; may be empty.
Mat checkValues(InputArray input, Size size);
//! CV_8UC1; may be empty.
Mat checkMask(InputArray input);
//! CV_32SC1; may be empty.
Mat checkMarkers(InputArray input);

//! Throws where an output, which has a name, cannot become a matrix of a type; a vector can only where `is_line` tells
//! that the matrix has one row or column.
void checkOutput(const _OutputArray& output, int type, bool is_line, const char* name);

//! Allocates an output that was checked; the matrix has the size, also where the output is a vector.
Mat createOutput(const _OutputArray& output, Size size, int type);

}}} // namespace

#endif
