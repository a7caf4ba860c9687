// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/surface_fits.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

void MeanPoint::add(const DepthRun& run)
{
    double area = area_, xz = xz_, yz = yz_, z = z_;
    for (int i = 0; i < run.length; i++)
    {
        const double depth = run.depths[i];
        if (!isValidDepth(depth))
            continue;
        area++;
        xz += (run.x + i) * depth;
        yz += run.y * depth;
        z += depth;
    }
    area_ = area;
    xz_ = xz;
    yz_ = yz;
    z_ = z;
}

void MeanPoint::add(const MeanPoint& other)
{
    area_ += other.area_;
    xz_ += other.xz_;
    yz_ += other.yz_;
    z_ += other.z_;
}

Vec3f MeanPoint::position(Point2f focal) const
{
    if (area_ == 0)
        return Vec3f::all(std::numeric_limits<float>::quiet_NaN());
    return Vec3f(float(xz_ / area_ / focal.x), float(yz_ / area_ / focal.y), float(z_ / area_));
}

void PlaneFit::add(const DepthRun& run)
{
    PlaneFit of_run;
    for (int i = 0; i < run.length; i++)
    {
        if (!isValidDepth(run.depths[i]))
            continue;
        const double place = run.x + i, inverse = 1 / run.depths[i];
        of_run.area_++;
        of_run.x_ += place;
        of_run.xx_ += place * place;
        of_run.w_ += inverse;
        of_run.xw_ += place * inverse;
    }
    of_run.y_ = run.y * of_run.area_;
    of_run.xy_ = run.y * of_run.x_;
    of_run.yy_ = run.y * run.y * of_run.area_;
    of_run.yw_ = run.y * of_run.w_;
    add(of_run);
}

void PlaneFit::add(const PlaneFit& other)
{
    area_ += other.area_;
    x_ += other.x_;
    y_ += other.y_;
    xx_ += other.xx_;
    xy_ += other.xy_;
    yy_ += other.yy_;
    w_ += other.w_;
    xw_ += other.xw_;
    yw_ += other.yw_;
}

//! By least squares. The part of the product of variances that is left beside the covariance tells whether the places
//! are on one line. It is exactly 0 on a row or column, whose mean place is exact.
Vec3f PlaneFit::normal(Point2f focal) const
{
    const double LINE = 1e-6;
    const double area = std::max(area_, 1.); // 0 where there is no depth
    const double mean_x = x_ / area, mean_y = y_ / area;
    const double cxx = xx_ - x_ * mean_x, cxy = xy_ - x_ * mean_y, cyy = yy_ - y_ * mean_y;
    const double cxw = xw_ - w_ * mean_x, cyw = yw_ - w_ * mean_y, determinant = cxx * cyy - cxy * cxy;
    if (determinant <= LINE * cxx * cyy)
        return Vec3f::all(std::numeric_limits<float>::quiet_NaN());
    const double slope_x = (cxw * cyy - cyw * cxy) / determinant, slope_y = (cyw * cxx - cxw * cxy) / determinant;
    // In focal lengths, the inverse depth of a plane with normal n is proportional to n (x, y, 1).
    const Vec3d away(slope_x * focal.x, slope_y * focal.y, w_ / area - slope_x * mean_x - slope_y * mean_y);
    return Vec3f(-away / norm(away));
}

}}} // namespace
