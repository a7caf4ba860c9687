// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/union_plan.hpp"
#include "shared/grid_markers.hpp"
#include <numeric>

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! Divides the cells of a grid into tiles of nearly equal numbers of cells: bands of three rows (of up to five where
//! three do not divide them) are divided into pieces.
class Tiling
{
public:
    Tiling(Size grid, int num_tiles) : width_(grid.width), tiles_of_rows_(grid.height)
    {
        const int ROWS = 3, num_bands = std::max(1, grid.height / ROWS);
        for (int i = 0, top = 0, first = 0; i < num_bands; i++)
        {
            const int bottom = int(int64(i + 1) * grid.height / num_bands);
            const double share = double(bottom - top) / (grid.height - top);
            const Tiles tiles = { first, std::max(1, cvRound((num_tiles - first) * share)) };
            std::fill(tiles_of_rows_.begin() + top, tiles_of_rows_.begin() + bottom, tiles);
            first += tiles.count;
            top = bottom;
        }
    }

    int tileOf(const Point& cell) const
    {
        const Tiles& tiles = tiles_of_rows_[cell.y];
        return tiles.first + int(int64(cell.x) * tiles.count / width_);
    }

private:
    //! Those of a band.
    struct Tiles
    {
        int first, count;
    };

    const int width_;
    std::vector<Tiles> tiles_of_rows_;
};

//! A region, the cell of a grid in which its centre lies, and its tile.
struct RegionPlace
{
    int tile, region;
    Point cell;
};

//! Regions of a list that are to be divided.
struct Group
{
    Range range; // in the list
    int above;   // the part that it is a half of
};

} // namespace

//! Tiles one after the other; the order of the places of each one stays.
static std::vector<RegionPlace> orderByTiles(const std::vector<RegionPlace>& places)
{
    std::vector<int> ends; // of the places of each tile
    for (const RegionPlace& place : places)
    {
        ends.resize(std::max(ends.size(), size_t(place.tile) + 2));
        ends[place.tile + 1]++;
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<RegionPlace> ordered(places.size());
    for (const RegionPlace& place : places)
        ordered[ends[place.tile]++] = place;
    return ordered;
}

//! The places of regions in a grid with one cell for each, in the order of their tiles. Centres are those of a sample
//! of 16 pixels in a cell, so very small regions may have none.
static std::vector<RegionPlace> findPlaces(const Mat& labels, int num_labels)
{
    const int FINE = 4, IN_TILE = 10;
    const int rows = MarkerGrid(labels.size(), labels.size(), 1, num_labels, 1).rows;
    const Size grid(std::max(1, cvRound(double(num_labels) / rows)), rows), samples = grid * FINE;
    const auto middleOf = [](int64 i, int64 count, int64 length) { return int(length * (2 * i + 1) / (2 * count)); };
    std::vector<int> columns(samples.width);
    for (int x = 0; x < samples.width; x++)
        columns[x] = middleOf(x, samples.width, labels.cols);
    std::vector<Vec3d> sums(num_labels, Vec3d::all(0)); // of halves, so they are exact
    for (int y = 0; y < samples.height; y++)
    {
        const int* row = labels.ptr<int>(middleOf(y, samples.height, labels.rows));
        for (int x = 0; x < samples.width; x++)
        {
            const int label = row[columns[x]];
            if (label >= 0)
                sums[label] += Vec3d(x + 0.5, y + 0.5, FINE);
        }
    }
    const Tiling tiling(grid, num_labels / IN_TILE);
    std::vector<RegionPlace> places;
    for (int i = 0; i < num_labels; i++)
        if (sums[i][2] > 0)
        {
            const Point cell(int(sums[i][0] / sums[i][2]), int(sums[i][1] / sums[i][2]));
            places.push_back({ tiling.tileOf(cell), i, cell });
        }
    return orderByTiles(places);
}

//! Divides the regions of a group into halves, by the longer side of the cells that they lie in.
static void divide(const Group& group, std::vector<RegionPlace>& places, UnionPlan& plan, std::vector<Group>& groups)
{
    RegionPlace* const begin = places.data();
    RegionPlace* const first = begin + group.range.start;
    RegionPlace* const last = begin + group.range.end;
    Point lowest = first->cell, highest = lowest;
    for (const RegionPlace* place = first; place != last; place++)
    {
        lowest = Point(std::min(lowest.x, place->cell.x), std::min(lowest.y, place->cell.y));
        highest = Point(std::max(highest.x, place->cell.x), std::max(highest.y, place->cell.y));
    }
    int part = group.above;
    if (group.range.size() > 1)
    {
        part = int(plan.above.size());
        plan.above.push_back(group.above);
    }
    const Point extent = highest - lowest;
    if (extent == Point())
    {
        for (const RegionPlace* place = first; place != last; place++)
            plan.parts[place->region] = part;
        return;
    }
    const bool wide = extent.x > extent.y;
    const Point middle = lowest + Point((extent.x + 1) / 2, (extent.y + 1) / 2);
    const int between = int(std::partition(first, last, [&](const RegionPlace& place)
    {
        return wide ? place.cell.x < middle.x : place.cell.y < middle.y;
    }) - begin);
    groups.push_back({ Range(group.range.start, between), part });
    groups.push_back({ Range(between, group.range.end), part });
}

UnionPlan planUnions(const Mat& labels, int num_labels)
{
    UnionPlan plan;
    plan.parts.resize(num_labels);
    for (int i = 0; i < num_labels; i++)
        plan.parts[i] = -2 - i; // differs from all others
    std::vector<RegionPlace> places = findPlaces(labels, num_labels);
    std::vector<Group> groups;
    const int count = int(places.size());
    for (int first = 0, last; first < count; first = last)
    {
        for (last = first + 1; last < count && places[last].tile == places[first].tile;)
            last++;
        groups.push_back({ Range(first, last), -2 - places[first].region });
    }
    for (size_t i = 0; i < groups.size(); i++)
    {
        const Group group = groups[i]; // the list grows
        divide(group, places, plan, groups);
    }
    return plan;
}

UnionPlan planUnions(const std::vector<int>& left, int in_cell, int num_regions)
{
    UnionPlan plan;
    if (left.empty())
        return plan;
    for (const int region : left)
        plan.parts.push_back(region / in_cell);
    const int last = *std::max_element(plan.parts.begin(), plan.parts.end());
    for (int i = 0; i <= last; i++)
        plan.above.push_back(i);
    plan.parts.resize(num_regions, -1);
    return plan;
}

}}} // namespace
