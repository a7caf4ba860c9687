// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "steps.hpp"

#include <map>
#include <set>

namespace cv { namespace ximgproc { namespace gws {

struct Region
{
    int area;
    std::map<int, int> boundary; //!< length of the common boundary, in pixel edges, by neighbour
};

static void addBoundary(int a, int b, std::vector<Region>& regions)
{
    if (a == b)
        return;
    regions[a].boundary[b]++;
    regions[b].boundary[a]++;
}

static std::vector<Region> findRegions(const Mat& labels, int num_labels)
{
    std::vector<Region> regions(num_labels, Region());
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        const int* below = labels.ptr<int>(std::min(y + 1, labels.rows - 1));
        for (int x = 0; x < labels.cols; x++)
        {
            regions[row[x]].area++;
            addBoundary(row[x], row[std::min(x + 1, labels.cols - 1)], regions);
            addBoundary(row[x], below[x], regions);
        }
    }
    return regions;
}

//! The neighbour with the longest common boundary; of equal ones the first.
static int closestNeighbor(const Region& region)
{
    int closest = -1, longest = 0;
    for (std::map<int, int>::const_iterator it = region.boundary.begin(); it != region.boundary.end(); ++it)
        if (it->second > longest)
        {
            longest = it->second;
            closest = it->first;
        }
    return closest;
}

//! Moves area and boundary of the region `from` to the region `to`.
static void absorb(int from, int to, std::vector<Region>& regions)
{
    regions[to].area += regions[from].area;
    const std::map<int, int>& boundary = regions[from].boundary;
    for (std::map<int, int>::const_iterator it = boundary.begin(); it != boundary.end(); ++it)
    {
        regions[it->first].boundary.erase(from);
        if (it->first == to)
            continue;
        regions[it->first].boundary[to] += it->second;
        regions[to].boundary[it->first] += it->second;
    }
    regions[from] = Region();
}

//! Numbers the regions that are left from 0; parent leads to the region that took one in.
static int renumber(const std::vector<int>& parent, Mat& labels)
{
    const int n = int(parent.size());
    std::vector<int> number(n, -1);
    int count = 0;
    for (int i = 0; i < n; i++)
        if (parent[i] == i)
            number[i] = count++;
    for (int i = 0; i < n; i++)
    {
        int root = i;
        while (parent[root] != root)
            root = parent[root];
        number[i] = number[root];
    }
    parallel_for_(Range(0, labels.rows), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
        {
            int* row = labels.ptr<int>(y);
            for (int x = 0; x < labels.cols; x++)
                row[x] = number[row[x]];
        }
    });
    return count;
}

int mergeSmallRegions(int num_labels, int min_area, Mat& labels)
{
    CV_TRACE_FUNCTION();
    std::vector<Region> regions = findRegions(labels, num_labels);
    std::set<std::pair<int, int> > small; // area and label of the regions to merge
    std::vector<int> parent(num_labels);
    for (int i = 0; i < num_labels; i++)
    {
        parent[i] = i;
        if (regions[i].area < min_area)
            small.insert(std::make_pair(regions[i].area, i));
    }
    while (!small.empty())
    {
        const int from = small.begin()->second;
        small.erase(small.begin());
        const int to = closestNeighbor(regions[from]);
        if (to < 0)
            continue; // it fills the image
        small.erase(std::make_pair(regions[to].area, to));
        absorb(from, to, regions);
        parent[from] = to;
        if (regions[to].area < min_area)
            small.insert(std::make_pair(regions[to].area, to));
    }
    return renumber(parent, labels);
}

}}} // namespace
