// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_LABEL_RUNS_HPP
#define OPENCV_GWATERSHED_LABEL_RUNS_HPP

#include "shared/bit_positions.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Writes to `positions`, in order, where two rows differ; it has room for cols. Returns how many these are.
inline int listDifferences(const int* row, const int* other, int cols, int* positions)
{
    const BitPositions& table = bitPositions();
    int *to = positions, x = 0;
    for (; x <= cols - 8; x += 8)
    {
        const int same = v_signmask(equal(v_load(row + x), v_load(other + x))) |
                         v_signmask(equal(v_load(row + x + 4), v_load(other + x + 4))) << 4;
        to = writePositions<0>(table, unsigned(same ^ 255), x, to);
    }
    for (; x < cols; x++)
    {
        *to = x;
        to += row[x] != other[x];
    }
    return int(to - positions);
}

}}} // namespace

#endif
