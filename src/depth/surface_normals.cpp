// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/surface_normals.hpp"
#include "shared/features.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

const int REACH = InverseDepths::REACH, STRIDE = InverseDepths::STRIDE;

//! How far three inverse depths are from a straight line, or more than that can be where one is not known.
inline v_int16x8 bendOf(const v_int16x8& a, const v_int16x8& b, const v_int16x8& c, const v_int16x8& known)
{
    const v_int16x8 bend = v_min(v_absdiffs(subtract(a, b), subtract(b, c)), v_setall_s16(SHRT_MAX - 1));
    return v_max(bend, bitAnd(v_sub_wrap(known, v_setall_s16(1)), v_setall_s16(SHRT_MAX)));
}

//! What slopes along an axis are limited to, and what makes them parts of normals.
struct SlopeScale
{
    SlopeScale(short steepest_, float per_slope_)
        : steepest(v_setall_s16(steepest_)), lowest(v_setall_s16(short(-steepest_))),
          per_slope(v_setall_f32(per_slope_))
    {
    }

    v_int16x8 steepest, lowest;
    v_float32x4 per_slope;
};

//! Slopes of inverse depth at 8 blocks: differences over REACH elements, to the side on which it is nearer to a
//! straight line. `known` stays 1 where one side has depth, else it becomes 0.
inline v_int16x8 inverseSlopes(const short* w, int step, const SlopeScale& scale, v_int16x8& known)
{
    const v_int16x8 one = v_setall_s16(1), here = v_load(w);
    const v_int16x8 a = v_load(w - REACH * step), half_a = v_load(w - REACH / 2 * step);
    const v_int16x8 b = v_load(w + REACH * step), half_b = v_load(w + REACH / 2 * step);
    const v_int16x8 known_a = v_min(v_min(a, half_a), one), known_b = v_min(v_min(b, half_b), one);
    const v_int16x8 bend_a = bendOf(here, half_a, a, known_a), bend_b = bendOf(here, half_b, b, known_b);
    const v_int16x8 to_b = v_shr<15>(subtract(subtract(bend_b, bend_a), one)); // all bits
    const v_int16x8 slope_a = subtract(here, a), slope_b = subtract(b, here);
    const v_int16x8 slope = v_add_wrap(slope_a, bitAnd(v_sub_wrap(slope_b, slope_a), to_b));
    known = v_min(known, v_max(known_a, known_b));
    return v_max(v_min(slope, scale.steepest), scale.lowest);
}

//! Directions of the rays of blocks along one axis, for a step forward of 1. Rays farther out are as those at WIDEST.
//! There are some more, so that the last stride is a whole one.
std::vector<float> raysOfBlocks(int blocks, float focal, float center)
{
    const float WIDEST = 2;
    std::vector<float> rays(alignSize(blocks, STRIDE));
    for (size_t i = 0; i < rays.size(); i++)
        rays[i] = std::min(std::max((2 * float(i) + 0.5f - center) / focal, -WIDEST), WIDEST);
    return rays;
}

//! Finds the normals of a row of blocks.
//! @note No product is added to anything, because some processors round that once, others twice. Squares are taken
//! as integers.
class NormalFinder
{
public:
    NormalFinder(const Camera& camera, Size blocks)
        : per_slope_x_(camera.focal.x / (2 * REACH)), per_slope_y_(camera.focal.y / (2 * REACH)),
          steepest_x_(steepestOf(per_slope_x_)), steepest_y_(steepestOf(per_slope_y_)),
          rays_x_(raysOfBlocks(blocks.width, camera.focal.x, camera.center.x)),
          rays_y_(raysOfBlocks(blocks.height, camera.focal.y, camera.center.y))
    {
    }

    //! Around the inverse depths w of the row are REACH more, and behind it a whole stride.
    void findRow(const short* w, int step, int y, int* normals) const
    {
        const SlopeScale scale_x(steepest_x_, per_slope_x_), scale_y(steepest_y_, per_slope_y_);
        const v_float32x4 ray_y = v_setall_f32(rays_y_[y]);
        const float* const rays_x = rays_x_.data();
        const int width = int(rays_x_.size());
        for (int x = 0; x < width; x += STRIDE)
        {
            const v_int16x8 here = v_load(w + x);
            v_int16x8 known = v_min(here, v_setall_s16(1));
            const v_int16x8 slopes_x = inverseSlopes(w + x, 1, scale_x, known);
            const v_int16x8 slopes_y = inverseSlopes(w + x, step, scale_y, known);
            v_int32x4 inverses[2], x_parts[2], y_parts[2], known_parts[2];
            v_expand(here, inverses[0], inverses[1]);
            v_expand(slopes_x, x_parts[0], x_parts[1]);
            v_expand(slopes_y, y_parts[0], y_parts[1]);
            v_expand(v_sub_wrap(v_setzero_s16(), known), known_parts[0], known_parts[1]);
            for (int k = 0; k < 2; k++)
            {
                const v_float32x4 parts_x = multiply(v_cvt_f32(x_parts[k]), scale_x.per_slope);
                const v_float32x4 parts_y = multiply(v_cvt_f32(y_parts[k]), scale_y.per_slope);
                const v_int32x4 found = normalsOf(inverses[k], parts_x, parts_y, v_load(rays_x + x + 4 * k), ray_y);
                v_store(normals + x + 4 * k, bitAnd(found, known_parts[k]));
            }
        }
    }

private:
    //! So that squares of what normals are made of fit.
    static short steepestOf(float per_slope)
    {
        return short(std::min(2 * float(InverseDepths::MOST) / per_slope, float(SHRT_MAX)));
    }

    //! In 1/256.
    static v_int32x4 squareOf(const v_float32x4& a)
    {
        return v_trunc(multiply(multiply(a, a), v_setall_f32(1 / 256.f)));
    }

    //! One part of vectors, as that of a Normal.
    static v_int32x4 partOf(const v_float32x4& a, const v_float32x4& lengths)
    {
        return v_trunc(add(v_setall_f32(float(Normal::ZERO) + 0.5f), divide(a, lengths)));
    }

    //! The normal of a plane whose inverse depth w has the slopes u, v, along rays (x, y, 1), is
    //! (focal u, focal v, w - x focal u - y focal v). Its first two parts are given.
    static v_int32x4 normalsOf(const v_int32x4& w, const v_float32x4& x, const v_float32x4& y,
                               const v_float32x4& rays_x, const v_float32x4& rays_y)
    {
        const float UNIT = 1.f / float(Normal::ONE);
        const v_int32x4 away_x = v_trunc(multiply(x, rays_x)), away_y = v_trunc(multiply(y, rays_y));
        const v_float32x4 z = v_cvt_f32(subtract(subtract(w, away_x), away_y));
        const v_int32x4 squares = add(add(squareOf(x), squareOf(y)), add(squareOf(z), v_setall_s32(2)));
        const v_float32x4 lengths = v_sqrt(multiply(v_cvt_f32(squares), v_setall_f32(UNIT * UNIT * 256)));
        return add(add(partOf(x, lengths), v_shl<NormalSum::Y_SHIFT>(partOf(y, lengths))),
                   v_setall_s32(1 << NormalSum::COUNT_SHIFT));
    }

    const float per_slope_x_, per_slope_y_;
    const short steepest_x_, steepest_y_;
    const std::vector<float> rays_x_, rays_y_;
};

//! Means over 3x3 blocks, where the one in the middle is known, of a row of whole strides.
void smoothRow(const int* above, const int* row, const int* below, int cols, std::vector<int>& columns, Normal* to)
{
    columns.resize(cols + 2); // sums of three, between empty ones
    int* sums = columns.data();
    sums[0] = sums[cols + 1] = 0;
    for (int x = 0; x < cols; x += 4)
        v_store(sums + x + 1, add(add(v_load(above + x), v_load(row + x)), v_load(below + x)));
    for (int x = 0; x < cols; x += 4)
    {
        const v_int32x4 sum = add(add(v_load(sums + x), v_load(sums + x + 1)), v_load(sums + x + 2));
        const v_int32x4 known = isPositive(v_load(row + x));
        NormalSum::mean(bitAnd(sum, known), to + x);
    }
}

} // namespace

bool findNormals(const Camera& camera, const InverseDepths& inverses, Mat& raw_normals, Mat& normals)
{
    const int FEW = 4; // if no more than one in so many blocks with depth has a normal
    const Size blocks = inverses.blocks;
    raw_normals.create(blocks.height + 2, inverses.paddedWidth(), CV_32SC1);
    raw_normals.row(0).setTo(Scalar(0));
    raw_normals.row(blocks.height + 1).setTo(Scalar(0));
    const NormalFinder finder(camera, blocks);
    forRows(Range(0, blocks.height),
            [&](int y) { finder.findRow(inverses.row(y), inverses.step(), y, raw_normals.ptr<int>(y + 1)); });
    if (FEW * countNonZero(raw_normals) <= countNonZero(inverses.buffer))
        return false;
    normals.create(blocks.height, raw_normals.cols, CV_8UC2);
    parallel_for_(Range(0, blocks.height), [&](const Range& rows)
    {
        std::vector<int> sums;
        for (int y = rows.start; y < rows.end; y++)
            smoothRow(raw_normals.ptr<int>(y), raw_normals.ptr<int>(y + 1), raw_normals.ptr<int>(y + 2), normals.cols,
                      sums, normals.ptr<Normal>(y));
    });
    return true;
}

}}} // namespace
