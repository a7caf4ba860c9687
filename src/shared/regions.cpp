// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

static double P(const char* name, double value)
{
    const char* s = getenv(name);
    return s ? atof(s) : value;
}

//! The normal's z completes it to a unit vector; where it meets the ray of the centre, depth has the slopes.
//! @note Sums are of integers, and floats are multiplied and divided only, so that all processors agree.
SurfaceMean SurfaceSum::mean(int depth, int depth_area, const Camera& camera) const
{
    SurfaceMean mean = SurfaceMean();
    if (depth_area == 0)
        return mean;
    mean.center_x = int((16 * x + depth_area / 2) / depth_area);
    mean.center_y = int((16 * y + depth_area / 2) / depth_area);
    if (area == 0)
        return mean;
    mean.x = short((STEPS_PER_LEVEL * normal_x + area / 2) / area);
    mean.y = short((STEPS_PER_LEVEL * normal_y + area / 2) / area);
    const int ONE = 127 * STEPS_PER_LEVEL, RAY = 4096, WIDEST = 2 * RAY, STEEPEST = 1 << 14;
    const int nx = mean.x - 128 * STEPS_PER_LEVEL, ny = mean.y - 128 * STEPS_PER_LEVEL;
    const int square = std::max(ONE * ONE - nx * nx - ny * ny, 0);
    const int nz = int(std::sqrt(float(square)));
    const auto ray = [&](int center, float axis, float focal)
    {
        const float away = float(center - cvRound(16 * axis)) / focal;
        return int(std::min(std::max(away * (RAY / 16), float(-WIDEST)), float(WIDEST)));
    };
    const int along = nx * ray(mean.center_x, camera.center.x, camera.focal.x) +
                      ny * ray(mean.center_y, camera.center.y, camera.focal.y) + nz * RAY;
    const int above_horizon = depth - cvRound(STEPS_PER_LEVEL * camera.horizon);
    const float scale = float(above_horizon) / float(std::max(along, RAY * ONE / 16)) * (64 * RAY);
    const float slope_x = float(nx) * scale / camera.focal.x, slope_y = float(ny) * scale / camera.focal.y;
    const float gain = float(P("PLANE", 1));
    mean.slope_x = short(std::min(std::max(gain * slope_x, float(-STEEPEST)), float(STEEPEST)));
    mean.slope_y = short(std::min(std::max(gain * slope_y, float(-STEEPEST)), float(STEEPEST)));
    return mean;
}

static void addSurfaces(const FeatureMap& features, const Mat& labels, std::vector<SurfaceSum>& sums)
{
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            if (labels.at<int>(y, x) >= 0)
                sums[labels.at<int>(y, x)].add(features.row(y)[x], features.normals.row(y)[x], Point(x, y));
}

void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    regions.clear(regions.size());
    if (regions.with_normals)
        addSurfaces(features, labels, regions.surface_sums);
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        const Feature* feature = features.row(y);
        for (int x = 0; x < labels.cols;)
        {
            const int label = row[x];
            RegionSum run = RegionSum();
            for (; x < labels.cols && row[x] == label; x++)
                run.add(feature[x]);
            if (label >= 0)
                regions.sums[label].add(run);
        }
    }
    regions.update();
}

}}} // namespace
