// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/union_plan.hpp"
#include "shared/grid_markers.hpp"
#include <algorithm>

namespace cv { namespace ximgproc { namespace gws {

//! A region and the cell of a grid in which its centre lies.
struct RegionPlace
{
    Point cell;
    int region;
};

//! The places of regions in a grid with one cell for each. Centres are those of a sample of 16 pixels in a cell, so
//! very small regions may have none.
static std::vector<RegionPlace> findPlaces(const Mat& labels, int num_labels)
{
    const int FINE = 4;
    const int rows = MarkerGrid(labels.size(), labels.size(), 1, num_labels, 1).rows;
    const Size samples(FINE * std::max(1, cvRound(double(num_labels) / rows)), FINE * rows);
    std::vector<int> columns(samples.width);
    for (int x = 0; x < samples.width; x++)
        columns[x] = int(int64(labels.cols) * (2 * x + 1) / (2 * samples.width));
    std::vector<Vec3d> sums(num_labels, Vec3d::all(0)); // of whole numbers
    for (int y = 0; y < samples.height; y++)
    {
        const int* row = labels.ptr<int>(int(int64(labels.rows) * (2 * y + 1) / (2 * samples.height)));
        for (int x = 0; x < samples.width; x++)
        {
            const int label = row[columns[x]];
            if (label >= 0)
                sums[label] += Vec3d(x + 0.5, y + 0.5, FINE);
        }
    }
    std::vector<RegionPlace> places;
    for (int i = 0; i < num_labels; i++)
        if (sums[i][2] > 0)
        {
            const double scale = 1 / sums[i][2];
            const RegionPlace place = { Point(cvFloor(sums[i][0] * scale), cvFloor(sums[i][1] * scale)), i };
            places.push_back(place);
        }
    return places;
}

//! Divides some regions into halves, by the longer side of the cells that they lie in.
static void divide(RegionPlace* first, RegionPlace* last, int above, UnionPlan& plan)
{
    Point lowest = first->cell, highest = lowest;
    for (const RegionPlace* place = first; place != last; place++)
    {
        lowest = Point(std::min(lowest.x, place->cell.x), std::min(lowest.y, place->cell.y));
        highest = Point(std::max(highest.x, place->cell.x), std::max(highest.y, place->cell.y));
    }
    const Point extent = highest - lowest;
    const int part = last - first > 1 ? int(plan.above.size()) : above;
    if (last - first > 1)
        plan.above.push_back(above);
    if (extent == Point())
    {
        for (const RegionPlace* place = first; place != last; place++)
            plan.parts[place->region] = part;
        return;
    }
    const bool wide = extent.x > extent.y;
    const Point middle = lowest + Point((extent.x + 1) / 2, (extent.y + 1) / 2);
    RegionPlace* const second = std::partition(first, last, [&](const RegionPlace& place)
    {
        return wide ? place.cell.x < middle.x : place.cell.y < middle.y;
    });
    divide(first, second, part, plan);
    divide(second, last, part, plan);
}

UnionPlan planUnions(const Mat& labels, int num_labels)
{
    UnionPlan plan;
    plan.parts.resize(num_labels);
    for (int i = 0; i < num_labels; i++)
        plan.parts[i] = -2 - i; // differs from all others
    std::vector<RegionPlace> places = findPlaces(labels, num_labels);
    if (!places.empty())
        divide(places.data(), places.data() + places.size(), -1, plan);
    return plan;
}

}}} // namespace
