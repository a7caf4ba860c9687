// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_DEPTH_ROWS_HPP
#define OPENCV_GWATERSHED_DEPTH_ROWS_HPP

#include "shared/sample.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { LEVELS_AT_ONCE = 16 };

//! As readDepths(), of the usual type without a detour.
void readDepthRow(const Mat& row, float* to);
//! What was measured becomes a depth of the range.
void clipRow(FloatRange range, std::vector<float>& depths);

//! All bits where there is a depth.
inline v_int32x4 hasDepth(const v_float32x4& depth)
{
    return isPositive(v_reinterpret_as_s32(depth));
}

//! Writes the levels of a row of depths. levelsOf() gives those of the four from a place on. Behind the depths is room
//! for a multiple of LEVELS_AT_ONCE.
template <typename LevelsOf>
inline void writeLevels(const float* depths, int cols, const LevelsOf& levelsOf, uchar* levels)
{
    int x = 0;
    const auto next = [&]()
    {
        const float* from = depths + x;
        return v_pack_u(v_pack(levelsOf(from), levelsOf(from + 4)), v_pack(levelsOf(from + 8), levelsOf(from + 12)));
    };
    for (; x + LEVELS_AT_ONCE <= cols; x += LEVELS_AT_ONCE)
        v_store(levels + x, next());
    if (x == cols)
        return;
    uchar last[LEVELS_AT_ONCE];
    v_store(last, next());
    std::copy(last, last + (cols - x), levels + x);
}

}}} // namespace

#endif
