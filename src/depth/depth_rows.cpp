// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/depth_rows.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

void readDepthRow(const Mat& row, float* to)
{
    const int AT_ONCE = 8, cols = row.depth() == CV_16U ? row.cols & -AT_ONCE : 0;
    const ushort* from = row.ptr<ushort>();
    const v_uint16x8 missing = v_setall_u16(USHRT_MAX);
    for (int x = 0; x < cols; x += AT_ONCE)
    {
        const v_uint16x8 depths = v_load(from + x);
        v_uint32x4 low, high;
        v_expand(v_sub_wrap(depths, bitAnd(depths, equal(depths, missing))), low, high);
        v_store(to + x, v_cvt_f32(v_reinterpret_as_s32(low)));
        v_store(to + x + 4, v_cvt_f32(v_reinterpret_as_s32(high)));
    }
    if (cols < row.cols)
        readDepths(row.colRange(cols, row.cols), to + cols);
}

void clipRow(FloatRange range, std::vector<float>& depths)
{
    for (float& depth : depths)
        depth = depth > 0 ? std::min(std::max(depth, range.first), range.last) : depth;
}

}}} // namespace
