// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/surface.hpp"
#include "depth/depth_noise.hpp"
#include "depth/depth_rows.hpp"
#include "depth/depth_span.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

const int NEAR_INVERSE = 1 << 13; //!< inverse depth of the near end of the range
const int FARTHEST = 1, NEAREST = 255;
const int NEAR_GAP = 64, FAR_GAP = 16; //!< levels between an end of the range and what is much nearer or farther
const double LEVELS = 2500;  //!< of nearness, at most, down to infinity: finer differences are noise

//! Nearness is offset + slope / depth, rounded down.
struct NearnessScale
{
    float offset, slope;
    float horizon; //!< nearness of an infinite depth, not rounded
};

//! Levels of four depths, 0 where depth is missing.
//! @note A division comes before the addition, so that no processor can do both in one step, rounded otherwise. It is
//! by no 0, which would end a program that traps divisions by 0.
inline v_int32x4 levelsOf(const float* depths, NearnessScale scale)
{
    const v_float32x4 depth = v_load(depths);
    const v_int32x4 is_known = hasDepth(depth);
    const v_float32x4 divisor = v_select(v_reinterpret_as_f32(is_known), depth, v_setall_f32(1));
    const v_float32x4 level = add(v_setall_f32(scale.offset), divide(v_setall_f32(scale.slope), divisor));
    const v_float32x4 within = v_min(v_max(level, v_setall_f32(FARTHEST)), v_setall_f32(NEAREST));
    return bitAnd(v_trunc(within), is_known);
}

//! The lowest and the highest level of some pixels that have depth.
struct LevelRange
{
    int low = NEAREST, high = 0;

    void add(const LevelRange& other)
    {
        low = std::min(low, other.low);
        high = std::max(high, other.high);
    }

    //! Of a row. No level becomes the highest one if 1 is taken off.
    void add(const uchar* levels, int cols)
    {
        uchar below_low = uchar(low - 1), above = uchar(high);
        for (int x = 0; x < cols; x++)
        {
            below_low = std::min(below_low, uchar(levels[x] - 1));
            above = std::max(above, levels[x]);
        }
        low = below_low + 1;
        high = above;
    }
};

//! Inverse depths of blocks of 2x2 pixels, of those that have depth; 0 if none has. Four blocks are done at once.
void invertRows(const float* upper, const float* lower, int blocks, float near_depth, short* inverses)
{
    const v_float32x4 scale = v_setall_f32(NEAR_INVERSE * near_depth);
    for (int x = 0; x < blocks; x += 4)
    {
        v_float32x4 a, b, c, d;
        v_load_deinterleave(upper + 2 * x, a, b);
        v_load_deinterleave(lower + 2 * x, c, d);
        const v_float32x4 sum = add(add(a, b), add(c, d));
        const v_int32x4 number = add(add(hasDepth(a), hasDepth(b)), add(hasDepth(c), hasDepth(d))); // less than 0
        const v_float32x4 count = v_cvt_f32(subtract(v_setzero_s32(), number));
        const v_float32x4 mean = divide(multiply(scale, count), v_max(sum, v_setall_f32(FLT_MIN)));
        v_pack_store(inverses + x, v_trunc(v_min(mean, v_setall_f32(InverseDepths::MOST))));
    }
}

//! Levels that are left over tell apart what is nearer than the range. Its far end may be infinite.
NearnessScale scaleOf(const DepthSpan& span, double noise_of_inverse)
{
    const bool has_gap = span.farther && span.range.last <= FLT_MAX;
    const int near_level = span.nearer ? NEAREST - NEAR_GAP : NEAREST;
    const int far_level = has_gap ? FARTHEST + FAR_GAP : FARTHEST;
    const double inverse_near = 1. / span.range.first, inverse_far = 1. / span.range.last;
    const double most = LEVELS / inverse_near;
    const double finest = noise_of_inverse * most > LEVELS_OF_NOISE ? LEVELS_OF_NOISE / noise_of_inverse : most;
    const double slope = std::min((near_level - far_level) / std::max(inverse_near - inverse_far, DBL_MIN), finest);
    const double horizon = far_level - slope / span.range.last; // a quotient is rounded before it is taken off
    return { float(horizon + 0.5), float(slope), float(horizon) };
}

//! Nearness of all pixels, and inverse depths of all blocks, within limits. Returns the levels that there are.
LevelRange scaleAndInvert(const Mat& depth, FloatRange limits, NearnessScale scale, float near_depth, Mat& nearness,
                          InverseDepths& inverses)
{
    const int blocks = inverses.blocks.width;
    std::vector<LevelRange> ranges(inverses.blocks.height);
    parallel_for_(Range(0, int(ranges.size())), [&](const Range& rows)
    {
        std::vector<float> pair[2]; // of rows; the second one may be missing
        for (std::vector<float>& row : pair)
            row.assign(alignSize(2 * blocks, 16), 0.f);
        for (int y = rows.start; y < rows.end; y++)
        {
            if (2 * y + 1 == depth.rows)
                std::fill(pair[1].begin(), pair[1].end(), 0.f);
            for (int i = 0; i < std::min(2, depth.rows - 2 * y); i++)
            {
                uchar* levels = nearness.ptr(2 * y + i);
                readDepthRow(depth.row(2 * y + i), pair[i].data());
                if (limits.last <= FLT_MAX)
                    clipRow(limits, pair[i]);
                writeLevels(pair[i].data(), depth.cols, [&](const float* from) { return levelsOf(from, scale); },
                            levels);
                ranges[y].add(levels, depth.cols);
            }
            invertRows(pair[0].data(), pair[1].data(), blocks, near_depth, inverses.row(y));
        }
    });
    LevelRange all;
    for (const LevelRange& levels : ranges)
        all.add(levels);
    return all;
}

} // namespace

//! @note A range that the user has set begins at half of the nearest depths of the frame at least: levels are those of
//! inverse depth, of which a near end that is much nearer than all depths would leave hardly any.
void findSurface(const Mat& depth, FloatRange range, Camera& camera, SurfaceBuffers& buffers, Mat& nearness,
                 Mat& normals)
{
    CV_TRACE_FUNCTION();
    nearness = normals = Mat();
    const bool is_set = range.last > 0;
    const FloatRange limits = { range.first, is_set ? range.last : std::numeric_limits<float>::infinity() };
    DepthSpan span = findSpan(depth, limits.last);
    if (span.range.last <= 0)
        return; // there are not two depths
    if (is_set)
    {
        range.first = std::max(range.first, std::min(span.range.first, range.last) / 2);
        span = { range, false, false };
    }
    const NearnessScale scale = scaleOf(span, noiseOfDepth(depth, limits, true));
    camera.horizon = scale.horizon;

    buffers.nearness.create(depth.size(), CV_8UC1);
    buffers.inverses.create(depth.size());
    const LevelRange levels = scaleAndInvert(depth, limits, scale, span.range.first, buffers.nearness,
                                             buffers.inverses);
    if (levels.low >= levels.high)
        return;
    nearness = buffers.nearness;
    if (findNormals(camera, buffers.inverses, buffers.raw_normals, buffers.normals))
        normals = buffers.normals;
}

}}} // namespace
