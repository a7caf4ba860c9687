// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

Reciprocals::Reciprocals() : of()
{
    for (int area = 1; area < COUNT; area++)
        of[area] = int64(double(FIXED_ONE) / area);
}

void Regions::divideBlocks(int side)
{
    const int elements = side * side;
    surfaces.camera = surfaces.camera.divided(side);
    for (size_t i = 0; i < surfaces.sums.size(); i++)
    {
        surfaces.sums[i].divideBlocks(side, sums[i].depth_area);
        surfaces.means[i].divideBlocks(side, means[i].depth);
    }
    for (RegionSum& sum : sums)
    {
        for (int k = 0; k < 3; k++)
            sum.color[k] *= elements;
        sum.depth *= elements;
        sum.area = int(std::min<int64>(elements * int64(sum.area), INT_MAX)); // less at the borders
        sum.depth_area = int(std::min<int64>(elements * int64(sum.depth_area), INT_MAX));
    }
}

void Regions::copy(int from, int to)
{
    means[to] = means[from];
    sums[to] = sums[from];
    if (surfaces.present)
    {
        surfaces.means[to] = surfaces.means[from];
        surfaces.sums[to] = surfaces.sums[from];
    }
}

void Regions::unite(int from, int to)
{
    sums[to].add(sums[from]);
    if (surfaces.present)
        surfaces.sums[to].add(surfaces.sums[from]);
}

//! Of those that numberOf(0), ... name.
template <typename NumberOf>
void Regions::updateAll(int count, const NumberOf& numberOf, bool few_depths_count)
{
    const auto haveDepth = [&](int i) { return few_depths_count || sums[i].hasDepth(); };
    for (int k = 0; k < count; k++)
    {
        const int i = numberOf(k);
        means[i] = sums[i].mean();
        if (!haveDepth(i))
            means[i].depth = RegionMean::NO_DEPTH;
    }
    if (!surfaces.present)
        return;
    SurfaceSolver(surfaces.camera).solveAll(count, [&](int k) -> SurfaceSolver::Source
    {
        const int i = numberOf(k);
        return { &surfaces.sums[i], means[i].depth, haveDepth(i) ? sums[i].depth_area : 0 };
    }, [&](int k, const SurfaceMean& mean) { surfaces.means[numberOf(k)] = mean; });
}

void Regions::update(const Range& range, bool few_depths_count)
{
    updateAll(range.size(), [&](int k) { return range.start + k; }, few_depths_count);
}

void Regions::update(const std::vector<int>& numbers, bool few_depths_count)
{
    updateAll(int(numbers.size()), [&](int k) { return numbers[k]; }, few_depths_count);
}

}}} // namespace
