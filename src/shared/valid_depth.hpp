// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_VALID_DEPTH_HPP
#define OPENCV_GWATERSHED_VALID_DEPTH_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Whether a depth, as readDepths() gives it, was measured. Doubles are what they are as floats.
inline bool isValidDepth(float depth) { return depth > 0 && depth <= FLT_MAX; }
inline bool isValidDepth(double depth) { return depth <= FLT_MAX && float(depth) > 0; }

//! Whether it is farther than any depth that was measured.
inline bool isFarDepth(float depth) { return depth > FLT_MAX; }

//! Reads a row of a depth map, with room for as many values. What is missing becomes 0: what is 0 or below, NaN and, in
//! 16 bits, 65535. What is farther than can be measured, as infinity, stays above FLT_MAX.
template <typename Value> inline void readDepths(const Mat& row, Value* to)
{
    Mat values(1, row.cols, DataType<Value>::type, to);
    row.convertTo(values, values.type());
    const Value missing = row.depth() == CV_16U ? Value(USHRT_MAX) : Value(0);
    for (int x = 0; x < row.cols; x++)
        to[x] = ((to[x] > 0) & (to[x] != missing)) ? to[x] : Value(0);
}

}}} // namespace

#endif
