// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/block_gradient.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/masks.hpp"
#include "shared/row_chunks.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Sum of the absolute differences of the neighbours to both sides, in coarse steps.
static ushort gradientAt(const Feature* f, int step, const RegionDistance& distance)
{
    int color = 0;
    for (int k = 0; k < 3; k++)
        color += std::abs(f[1].color[k] - f[-1].color[k]) + std::abs(f[step].color[k] - f[-step].color[k]);
    if (!f[1].depth || !f[-1].depth || !f[step].depth || !f[-step].depth)
        return ushort(color >> GRADIENT_STEP_LOG2);
    const int depth = std::abs(f[1].depth - f[-1].depth) + std::abs(f[step].depth - f[-step].depth);
    return ushort((distance.color_share * color + distance.depth_share * depth) / (FULL_WEIGHT << GRADIENT_STEP_LOG2));
}

//! The same of 4 blocks without depth.
static inline v_uint32x4 gradientOfColors(const Feature* f, int step)
{
    const v_uint8x16 ones = v_setall_u8(1);
    const v_uint8x16 beside = v_absdiff(v_load(f[1].color), v_load(f[-1].color));
    const v_uint8x16 upright = v_absdiff(v_load(f[step].color), v_load(f[-step].color));
    return v_shr<GRADIENT_STEP_LOG2>(v_dotprod_expand(beside, ones, v_dotprod_expand(upright, ones)));
}

//! The same with depth. Shares are those of colour and of depth, four times.
static inline v_uint32x4 gradientOfColorsAndDepths(const Feature* f, int step, const v_int16x8& shares)
{
    const v_uint8x16 left = v_load(f[-1].color), right = v_load(f[1].color);
    const v_uint8x16 upper = v_load(f[-step].color), lower = v_load(f[step].color);
    const v_uint8x16 beside = v_absdiff(right, left), upright = v_absdiff(lower, upper);
    const v_uint8x16 ones = v_reinterpret_as_u8(v_setall_u32(0x010101)); // for the colours
    const v_uint32x4 color = v_dotprod_expand(beside, ones, v_dotprod_expand(upright, ones));
    const v_uint32x4 depth = add(v_shr<24>(v_reinterpret_as_u32(beside)), v_shr<24>(v_reinterpret_as_u32(upright)));
    const v_uint32x4 lowest = v_shr<24>(v_reinterpret_as_u32(v_min(v_min(left, right), v_min(upper, lower))));
    const v_int32x4 have_depth = isPositive(v_reinterpret_as_s32(lowest));
    const v_int16x8 pairs = v_reinterpret_as_s16(add(color, v_shl<16>(depth)));
    const v_int32x4 with = v_shr<GRADIENT_STEP_LOG2 + FULL_WEIGHT_LOG2>(v_dotprod(pairs, shares));
    const v_int32x4 without = v_reinterpret_as_s32(v_shr<GRADIENT_STEP_LOG2>(color));
    return v_reinterpret_as_u32(add(without, bitAnd(subtract(with, without), have_depth)));
}

//! The pixels at the border of the image have no neighbours to both sides: they count as edges.
static void gradientOfRow(const Feature* row, int step, const RegionDistance& distance, int cols, ushort* to)
{
    const int STRIDE = 8;
    const v_int16x8 shares = v_reinterpret_as_s16(v_setall_s32(distance.color_share + (distance.depth_share << 16)));
    int x = 1;
    to[0] = to[cols - 1] = ushort(UNKNOWN_GRADIENT);
    for (; !distance.with_depth && x < cols - STRIDE; x += STRIDE)
        v_store(to + x, v_pack(gradientOfColors(row + x, step), gradientOfColors(row + x + STRIDE / 2, step)));
    for (; x < cols - STRIDE; x += STRIDE)
        v_store(to + x, v_pack(gradientOfColorsAndDepths(row + x, step, shares),
                               gradientOfColorsAndDepths(row + x + STRIDE / 2, step, shares)));
    for (; x < cols - 1; x++)
        to[x] = gradientAt(row + x, step, distance);
}

void computeBlockGradient(const Padded<Feature>& features, const RegionDistance& distance, const Mat& mask,
                          Mat& gradient)
{
    CV_TRACE_FUNCTION();
    const int rows = features.size().height;
    gradient.create(features.size(), CV_16UC1);
    gradient.row(0).setTo(Scalar(UNKNOWN_GRADIENT));
    gradient.row(rows - 1).setTo(Scalar(UNKNOWN_GRADIENT));
    forRows(Range(1, std::max(1, rows - 1)), [&](int y)
    {
        gradientOfRow(features.row(y), features.step(), distance, gradient.cols, gradient.ptr<ushort>(y));
    });
    if (!mask.empty())
        forgetGradients(mask, gradient);
}

}}} // namespace
