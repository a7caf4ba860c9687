// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

VariationGuard::VariationGuard(const Mat& color, const Padded<int>& labels, int num_regions)
    : color_(color), sums_(num_regions, Vec3d::all(0)), means_(num_regions), areas_(num_regions, 0)
{
    for (int y = 0; y < color.rows; y++)
        for (int x = 0; x < color.cols; x++)
        {
            const int label = labels.row(y)[x];
            if (label == OUTSIDE)
                continue;
            sums_[label] += colorAt(Point(x, y));
            areas_[label]++;
        }
    update();
}

Vec3d VariationGuard::colorAt(Point p) const
{
    const int cn = color_.channels();
    const uchar* pixel = color_.ptr(p.y) + p.x * cn;
    return cn == 1 ? Vec3d(pixel[0], 0, 0) : Vec3d(pixel[0], pixel[1], pixel[2]);
}

//! While every move of a sweep goes to a mean that is not farther, by the means at its start, the
//! sum of squared distances to the means cannot rise, as in k-means: then the means move, and it
//! falls again. So the explained variation never falls.
bool VariationGuard::permits(Point p, int from, int to) const
{
    const Vec3d color = colorAt(p), a = color - means_[from], b = color - means_[to];
    return b.dot(b) <= a.dot(a);
}

void VariationGuard::move(Point p, int from, int to)
{
    const Vec3d color = colorAt(p);
    sums_[from] -= color;
    sums_[to] += color;
    areas_[from]--;
    areas_[to]++;
}

//! The means are taken in steps of 2^-17, so that squared distances to them are exact in doubles: the same whether or
//! not a compiler fuses products with sums, also where a pixel lies half way between two means.
void VariationGuard::update()
{
    const double STEPS = 1 << 17;
    for (size_t i = 0; i < sums_.size(); i++)
        for (int k = 0; k < 3; k++)
            means_[i][k] = cvRound(STEPS * sums_[i][k] / areas_[i]) / STEPS;
}

}}} // namespace
