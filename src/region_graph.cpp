// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_graph.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Regions have few neighbours: looking through them is faster than any map.
RegionGraph::Boundary* RegionGraph::find(std::vector<Boundary>& boundaries, int neighbor)
{
    for (size_t i = 0; i < boundaries.size(); i++)
        if (boundaries[i].neighbor == neighbor)
            return &boundaries[i];
    return 0;
}

void RegionGraph::add(int region, const Boundary& boundary)
{
    if (Boundary* known = find(boundaries_[region], boundary.neighbor))
    {
        known->length += boundary.length;
        known->height += boundary.height;
    }
    else
        boundaries_[region].push_back(boundary);
}

void RegionGraph::remove(int region, int neighbor)
{
    Boundary* boundary = find(boundaries_[region], neighbor);
    *boundary = boundaries_[region].back();
    boundaries_[region].pop_back();
}

void RegionGraph::addEdges(int a, int b, int count, int64 height)
{
    const Boundary to_b = { b, count, height }, to_a = { a, count, height };
    add(a, to_b);
    add(b, to_a);
}

void RegionGraph::unite(int from, int to)
{
    std::vector<Boundary> moved;
    moved.swap(boundaries_[from]);
    for (size_t i = 0; i < moved.size(); i++)
    {
        remove(moved[i].neighbor, from);
        if (moved[i].neighbor == to)
            continue;
        add(to, moved[i]);
        const Boundary back = { to, moved[i].length, moved[i].height };
        add(moved[i].neighbor, back);
    }
    parents_[from] = to;
}

int numberRegions(const std::vector<int>& parents, std::vector<int>& numbers)
{
    const int n = int(parents.size());
    std::vector<int> roots(parents);
    int count = 0;
    numbers.assign(n, 0);
    for (int i = 0; i < n; i++)
        if (parents[i] == i)
            numbers[i] = count++;
    for (int i = 0; i < n; i++)
    {
        int root = i;
        while (roots[root] != root)
            root = roots[root] = roots[roots[root]];
        numbers[i] = numbers[root];
    }
    return count;
}

void renumber(const std::vector<int>& numbers, Mat& labels)
{
    parallel_for_(Range(0, labels.rows), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
        {
            int* row = labels.ptr<int>(y);
            for (int x = 0; x < labels.cols; x++)
                row[x] = row[x] < 0 ? row[x] : numbers[row[x]];
        }
    });
}

}}} // namespace
