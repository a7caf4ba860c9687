// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/variation_guard.hpp"

namespace cv { namespace ximgproc { namespace gws {

VariationGuard::VariationGuard(const Mat& color, const Padded<int>& labels, int num_regions,
                               const std::vector<int>& owners)
    : color_(color), sums_(num_regions, Vec3d::all(0)), means_(num_regions), areas_(num_regions, 0), owners_(owners)
{
    const int cn = color.channels(), green = cn == 1 ? 0 : 1, red = cn == 1 ? 0 : 2;
    for (int y = 0; y < color.rows; y++)
    {
        const int* row = labels.row(y);
        const uchar* pixel = color.ptr(y);
        for (int x = 0; x < color.cols;)
        {
            const int label = row[x];
            const int begin = x;
            int64 sum[3] = { 0, 0, 0 }; // of a run of pixels
            for (; x < color.cols && row[x] == label; x++, pixel += cn)
            {
                sum[0] += pixel[0];
                sum[1] += pixel[green];
                sum[2] += pixel[red];
            }
            if (label < 0)
                continue;
            sums_[label] += Vec3d(double(sum[0]), double(sum[1]), double(sum[2]));
            areas_[label] += x - begin;
        }
    }
    update(Range(0, num_regions));
    joinOwned();
}

Vec3d VariationGuard::colorAt(Point p) const
{
    const int cn = color_.channels();
    const uchar* pixel = color_.ptr(p.y) + size_t(p.x) * cn;
    return cn == 1 ? Vec3d::all(pixel[0]) : Vec3d(pixel[0], pixel[1], pixel[2]);
}

//! While every move of a sweep goes to a mean that is not farther, by the means at its start, the
//! sum of squared distances to the means cannot rise, as in k-means: then the means move, and it
//! falls again. So the explained variation never falls; without ties it rises with every move, so there is a last one.
bool VariationGuard::permits(Point p, int from, int to) const
{
    const Vec3d color = colorAt(p), a = color - means_[from], b = color - means_[to];
    const double before = a.dot(a), after = b.dot(b);
    return permits_ties_ ? after <= before : after < before;
}

void VariationGuard::add(Point p, int region, int times)
{
    sums_[region] += times * colorAt(p);
    areas_[region] += times;
}

//! Means are taken in steps of 2^-17, so that squared distances to them are exact in doubles: the same whether or not a
//! compiler fuses products with sums, also where a pixel lies half way between two means.
static double meanOf(double sum, int area)
{
    const double STEPS = 1 << 17;
    return cvRound(STEPS * sum / area) / STEPS;
}

void VariationGuard::update(const Range& regions)
{
    for (int i = regions.start; i < regions.end; i++)
        for (int k = 0; k < 3; k++)
            means_[i][k] = meanOf(sums_[i][k], areas_[i]);
}

void VariationGuard::joinOwned()
{
    if (owners_.empty())
        return;
    std::vector<Vec3d> sums(owners_.size(), Vec3d::all(0)); // by owner, of whom there are no more than regions
    std::vector<int> areas(owners_.size(), 0);
    for (size_t i = 0; i < owners_.size(); i++)
    {
        sums[owners_[i]] += sums_[i];
        areas[owners_[i]] += areas_[i];
    }
    for (size_t i = 0; i < owners_.size(); i++)
        for (int k = 0; k < 3; k++)
            means_[i][k] = meanOf(sums[owners_[i]][k], areas[owners_[i]]);
}

}}} // namespace
