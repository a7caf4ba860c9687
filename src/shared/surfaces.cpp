// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

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

static int64 divide(int64 sum, int count)
{
    return (sum + count / 2) / count;
}

static const int RAY = 4096; // the unit of rays

//! Where the ray of a place goes, for a step forward of RAY.
static int rayOf(int center, float axis, float focal)
{
    const float WIDEST = 2 * RAY;
    const float away = float(center - cvRound(float(SurfaceMean::CENTER_UNIT) * axis)) / focal;
    return int(std::min(std::max(away * float(RAY) / float(SurfaceMean::CENTER_UNIT), -WIDEST), WIDEST));
}

static short slopeOf(int normal, float scale, float focal)
{
    const float STEEPEST = 1 << 14;
    return short(std::min(std::max(float(normal) * scale / focal, -STEEPEST), STEEPEST));
}

//! With the normal (nx, ny, nz) and the ray (x, y, 1) of the centre, nearness above the horizon grows by
//! nx / (nx x + ny y + nz) of it over one focal length to the right.
//! @note Sums are of integers, and floats are only multiplied and divided, so that all processors agree.
SurfaceMean SurfaceSum::mean(int depth, int depth_area, const Camera& camera) const
{
    SurfaceMean mean = SurfaceMean();
    if (depth_area == 0)
        return mean;
    mean.center.x = int(divide(SurfaceMean::CENTER_UNIT * x, depth_area));
    mean.center.y = int(divide(SurfaceMean::CENTER_UNIT * y, depth_area));
    mean.setDepth(depth);
    if (normal_area == 0)
        return mean;
    mean.x = short(divide(STEPS_PER_LEVEL * normal_x, normal_area));
    mean.y = short(divide(STEPS_PER_LEVEL * normal_y, normal_area));

    const int ZERO = STEPS_PER_LEVEL * Normal::ZERO, ONE = STEPS_PER_LEVEL * Normal::ONE;
    const int nx = mean.x - ZERO, ny = mean.y - ZERO;
    const int nz = int(std::sqrt(float(std::max(ONE * ONE - nx * nx - ny * ny, 0))));
    const int facing = nx * rayOf(mean.center.x, camera.center.x, camera.focal.x) +
                       ny * rayOf(mean.center.y, camera.center.y, camera.focal.y) + nz * RAY;
    const int LEAST_FACING = ONE * RAY / 16; // planes seen more edge-on than this are noise
    const int above_horizon = depth - cvRound(STEPS_PER_LEVEL * camera.horizon);
    const float scale = float(above_horizon) / float(std::max(facing, LEAST_FACING)) * (SurfaceMean::PLANE_UNIT * RAY);
    mean.slope_x = slopeOf(nx, scale, camera.focal.x);
    mean.slope_y = slopeOf(ny, scale, camera.focal.y);
    mean.setDepth(depth);
    return mean;
}

}}} // namespace
