// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

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

void measureSurfaces(const FeatureMap& features, const Mat& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    regions.surfaces.start(features.camera, regions.size());
    std::vector<SurfaceSum>& sums = regions.surfaces.sums;
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        const Feature* feature = features.row(y);
        for (int x = 0; x < labels.cols; x++)
            if (row[x] >= 0)
                sums[row[x]].add(feature[x], features.normalAt(Point(x, y)), Point(x, y));
    }
    regions.update();
}

void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    regions.surfaces.present = false;
    regions.clear(regions.size());
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
    if (features.withNormals())
        measureSurfaces(features, labels, regions);
    else
        regions.update();
}

}}} // namespace
