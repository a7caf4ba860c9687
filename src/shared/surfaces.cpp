// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/surfaces.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Distance is one over nearness above the horizon, area its square.
float areaScale(int depth, const Camera& camera)
{
    const float MOST = 32; // times as far, where it ends
    const int horizon = cvRound(STEPS_PER_LEVEL * camera.horizon), nearest = 255 * STEPS_PER_LEVEL - horizon;
    const float times = std::min(float(nearest) / float(std::max(depth - horizon, 1)), MOST);
    return times * times;
}

void SurfaceMean::divideBlocks(int side, int depth)
{
    slope_x = short(slope_x / side);
    slope_y = short(slope_y / side);
    center = side * center + Point(1, 1) * (CENTER_UNIT * (side - 1) / 2);
    setDepth(depth);
}

void SurfaceSum::divideBlocks(int side, int depth_area)
{
    const int elements = side * side;
    normal_x *= elements;
    normal_y *= elements;
    normal_area = int(std::min<int64>(elements * int64(normal_area), INT_MAX));
    const int64 middle = int64(elements) * (side - 1) * depth_area / 2; // of a block in its elements
    x = elements * side * x + middle;
    y = elements * side * y + middle;
}

static const int RAY_LOG2 = 12, RAY = 1 << RAY_LOG2; // the unit of rays

//! Quotients of sums in 1/`unit`, rounded.
static v_int32x4 divide(const v_float32x4& sums, const v_float32x4& counts, int unit)
{
    const v_float32x4 quotients = divide(multiply(sums, v_setall_f32(float(unit))), counts);
    return v_trunc(add(quotients, v_setall_f32(0.5f)));
}

SurfaceSolver::SurfaceSolver(const Camera& camera)
    : horizon_(cvRound(STEPS_PER_LEVEL * camera.horizon)),
      axis_x_(cvRound(float(SurfaceMean::CENTER_UNIT) * camera.center.x)),
      axis_y_(cvRound(float(SurfaceMean::CENTER_UNIT) * camera.center.y)),
      per_focal_(1 / camera.focal.x, 1 / camera.focal.y)
{
}

//! Where the rays of places go, for a step forward of RAY.
static v_int32x4 raysOf(const v_int32x4& centers, int axis, float per_focal)
{
    const v_float32x4 widest = v_setall_f32(2 * RAY);
    const v_float32x4 scale = v_setall_f32(per_focal * float(RAY) / float(SurfaceMean::CENTER_UNIT));
    const v_float32x4 rays = multiply(v_cvt_f32(subtract(centers, v_setall_s32(axis))), scale);
    return v_trunc(v_max(v_min(rays, widest), v_setall_f32(-2 * RAY)));
}

static v_int32x4 slopesOf(const v_int32x4& normals, const v_float32x4& scales, float per_focal)
{
    const float STEEPEST = 1 << 14; // fits into 16 bits
    const v_float32x4 slopes = multiply(multiply(v_cvt_f32(normals), scales), v_setall_f32(per_focal));
    return v_trunc(v_max(v_min(slopes, v_setall_f32(STEEPEST)), v_setall_f32(-STEEPEST)));
}

namespace {

//! What is known of four surfaces before they are solved.
struct FourSurfaceSums
{
    explicit FourSurfaceSums(const SurfaceSolver::Source* s)
        : depths(s[0].depth, s[1].depth, s[2].depth, s[3].depth)
    {
        const SurfaceSum &a = *s[0].sum, &b = *s[1].sum, &c = *s[2].sum, &d = *s[3].sum;
        const v_int32x4 depth_areas(s[0].depth_area, s[1].depth_area, s[2].depth_area, s[3].depth_area);
        const v_int32x4 normal_areas(a.normal_area, b.normal_area, c.normal_area, d.normal_area);
        const v_float32x4 one = v_setall_f32(1);
        const v_float32x4 places = v_max(v_cvt_f32(depth_areas), one), normals = v_max(v_cvt_f32(normal_areas), one);
        const v_float32x4 x_sums(float(a.x), float(b.x), float(c.x), float(d.x));
        const v_float32x4 y_sums(float(a.y), float(b.y), float(c.y), float(d.y));
        const v_float32x4 nx_sums(float(a.normal_x), float(b.normal_x), float(c.normal_x), float(d.normal_x));
        const v_float32x4 ny_sums(float(a.normal_y), float(b.normal_y), float(c.normal_y), float(d.normal_y));
        const v_int32x4 have_depth = isPositive(depth_areas); // places of depths that do not count have sums, too
        center_x = bitAnd(divide(x_sums, places, SurfaceMean::CENTER_UNIT), have_depth);
        center_y = bitAnd(divide(y_sums, places, SurfaceMean::CENTER_UNIT), have_depth);
        x = divide(nx_sums, normals, STEPS_PER_LEVEL);
        y = divide(ny_sums, normals, STEPS_PER_LEVEL);
        known = bitAnd(have_depth, isPositive(normal_areas));
    }

    v_int32x4 depths, center_x, center_y;
    v_int32x4 x, y;  // of normals
    v_int32x4 known; // all bits where there is a normal
};

} // namespace

//! With the normal (nx, ny, nz) and the ray (x, y, 1) of the centre, nearness above the horizon grows by
//! nx / (nx x + ny y + nz) of it over one focal length to the right.
//! @note Sums are of integers, and floats are only multiplied and divided, so that all processors agree.
void SurfaceSolver::solve(const Source* sources, SurfaceMean* means) const
{
    const FourSurfaceSums sums(sources);
    const int ONE = STEPS_PER_LEVEL * Normal::ONE;
    const v_int32x4 zero = v_setall_s32(STEPS_PER_LEVEL * Normal::ZERO);
    const v_int32x4 nx = subtract(sums.x, zero), ny = subtract(sums.y, zero);
    const v_int16x8 across = makePairs(nx, ny), rays = makePairs(raysOf(sums.center_x, axis_x_, per_focal_.x),
                                                                 raysOf(sums.center_y, axis_y_, per_focal_.y));
    const v_float32x4 forward = v_cvt_f32(subtract(v_setall_s32(ONE * ONE), v_dotprod(across, across)));
    const v_int32x4 nz = v_trunc(v_sqrt(v_max(forward, v_setzero_f32())));
    const v_float32x4 facing = v_cvt_f32(v_dotprod(across, rays, v_shl<RAY_LOG2>(nz)));
    const float LEAST_FACING = float(ONE * RAY) / 16; // planes seen more edge-on than this are noise
    const v_float32x4 above_horizon = v_cvt_f32(subtract(sums.depths, v_setall_s32(horizon_)));
    const v_float32x4 scales = multiply(divide(above_horizon, v_max(facing, v_setall_f32(LEAST_FACING))),
                                        v_setall_f32(SurfaceMean::PLANE_UNIT * RAY));
    const v_int16x8 slopes = makePairs(slopesOf(nx, scales, per_focal_.x), slopesOf(ny, scales, per_focal_.y));

    v_int32x4 columns[4], rows[4]; // of each surface: normal, slopes and centre
    columns[0] = bitAnd(v_reinterpret_as_s32(makePairs(sums.x, sums.y)), sums.known);
    columns[1] = bitAnd(v_reinterpret_as_s32(slopes), sums.known);
    columns[2] = sums.center_x;
    columns[3] = sums.center_y;
    v_transpose4x4(columns[0], columns[1], columns[2], columns[3], rows[0], rows[1], rows[2], rows[3]);
    for (int k = 0; k < 4; k++)
    {
        int words[4];
        v_store(words, rows[k]);
        memcpy(static_cast<void*>(means + k), words, 2 * sizeof(int)); // up to the slopes
        means[k].center = Point(words[2], words[3]);
        means[k].setDepth(sources[k].depth);
    }
}

}}} // namespace
