// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "results/surface_fits.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! Sums over the pixels with depth of one superpixel. Places are relative to the optical axis, in focal lengths, so
//! that the inverse depth w of a plane with normal n is proportional to n (x, y, 1).
struct Fit
{
    double area, x, y, xx, xy, yy, w, xw, yw, xz, yz, z;

    void add(double px, double py, double depth)
    {
        const double inverse = 1 / depth;
        area += 1;
        x += px;
        y += py;
        xx += px * px;
        xy += px * py;
        yy += py * py;
        w += inverse;
        xw += px * inverse;
        yw += py * inverse;
        xz += px * depth;
        yz += py * depth;
        z += depth;
    }

    Vec3f position() const { return Vec3f(float(xz / area), float(yz / area), float(z / area)); }

    //! By least squares. The part of the product of variances that is left beside the covariance tells whether the
    //! places are on one line.
    Vec3f normal() const
    {
        const double LINE = 1e-6;
        const double cxx = xx - x * x / area, cxy = xy - x * y / area, cyy = yy - y * y / area;
        const double cxw = xw - x * w / area, cyw = yw - y * w / area, determinant = cxx * cyy - cxy * cxy;
        if (!(determinant > LINE * cxx * cyy))
            return Vec3f::all(std::numeric_limits<float>::quiet_NaN());
        const double a = (cxw * cyy - cyw * cxy) / determinant, b = (cyw * cxx - cxw * cxy) / determinant;
        const Vec3d away(a, b, (w - a * x - b * y) / area);
        return Vec3f(-away / norm(away));
    }
};

} // namespace

void measureSurfaces(const Mat& labels, int num_labels, const Mat& depth, Point2f focal, Mat& positions, Mat& normals)
{
    CV_TRACE_FUNCTION();
    std::vector<Fit> fits(num_labels, Fit());
    const Point2d center(0.5 * (labels.cols - 1), 0.5 * (labels.rows - 1));
    std::vector<double> depths(labels.cols);
    for (int y = 0; y < depth.rows; y++)
    {
        readDepths(depth.row(y), depths.data());
        for (int x = 0; x < labels.cols; x++)
        {
            const int label = labels.at<int>(y, x);
            if (label >= 0 && isValidDepth(depths[x]))
                fits[label].add((x - center.x) / focal.x, (y - center.y) / focal.y, depths[x]);
        }
    }
    positions.create(num_labels, 3, CV_32FC1);
    normals.create(num_labels, 3, CV_32FC1);
    for (int i = 0; i < num_labels; i++)
    {
        *positions.ptr<Vec3f>(i) = fits[i].position(); // 0 / 0 is NaN
        *normals.ptr<Vec3f>(i) = fits[i].normal();
    }
}

}}} // namespace
