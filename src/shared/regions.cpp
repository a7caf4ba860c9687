// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

Reciprocals::Reciprocals() : of()
{
    for (int area = 1; area < COUNT; area++)
        of[area] = int64(double(FIXED_ONE) / area);
}

const Reciprocals reciprocals;

void Regions::divideBlocks(int side)
{
    const int elements = side * side;
    surfaces.camera = surfaces.camera.divided(side);
    for (size_t i = 0; i < surfaces.sums.size(); i++)
    {
        surfaces.sums[i].divideBlocks(side, sums[i].depth_area);
        surfaces.means[i].divideBlocks(side, means[i].depth);
    }
    for (int i = 0; i < size(); i++)
    {
        RegionSum& sum = sums[i];
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
    update(to);
}

}}} // namespace
