// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_graph.hpp"

namespace cv { namespace ximgproc { namespace gws {

void RegionGraph::reset(int num_regions)
{
    const int USUAL_BOUNDARIES = 3; // for each region
    boundaries_.clear();
    boundaries_.reserve(size_t(num_regions) * USUAL_BOUNDARIES);
    firsts_.assign(num_regions, int(NONE));
    degrees_.assign(num_regions, 0);
    parents_.resize(num_regions);
    for (int i = 0; i < num_regions; i++)
        parents_[i] = i;
}

//! Takes the boundaries that are no more out of the list of a region, from a link on.
int RegionGraph::skipGone(int region, int& link)
{
    while (link != NONE && !boundaries_[link].exists())
    {
        link = boundaries_[link].next[boundaries_[link].side(region)];
        degrees_[region]--;
    }
    return link;
}

int RegionGraph::first(int region)
{
    return skipGone(region, firsts_[region]);
}

int RegionGraph::next(int region, int boundary)
{
    Boundary& b = boundaries_[boundary];
    return skipGone(region, b.next[b.side(region)]);
}

//! Looks through the shorter one of the lists.
int RegionGraph::find(int a, int b)
{
    if (degrees_[b] < degrees_[a])
        std::swap(a, b);
    for (int i = first(a); i != NONE; i = next(a, i))
        if (boundaries_[i].regions[!boundaries_[i].side(a)] == b)
            return i;
    return NONE;
}

void RegionGraph::add(int a, int b, int length, int64 height)
{
    const int known = find(a, b);
    if (known != NONE)
    {
        boundaries_[known].length += length;
        boundaries_[known].height += height;
        return;
    }
    const Boundary boundary = { { a, b }, { firsts_[a], firsts_[b] }, length, height };
    firsts_[a] = firsts_[b] = int(boundaries_.size());
    degrees_[a]++;
    degrees_[b]++;
    boundaries_.push_back(boundary);
}

void RegionGraph::unite(int from, int to, std::vector<int>& joined)
{
    joined.clear();
    for (int i = first(from); i != NONE;)
    {
        Boundary& boundary = boundaries_[i];
        const int side = boundary.side(from), neighbor = boundary.regions[!side], following = next(from, i);
        const int known = neighbor == to ? i : find(to, neighbor);
        if (known == NONE)
        {
            boundary.regions[side] = to;
            boundary.next[side] = firsts_[to];
            firsts_[to] = i;
            degrees_[to]++;
        }
        else
        {
            if (known != i)
            {
                boundaries_[known].length += boundary.length;
                boundaries_[known].height += boundary.height;
                joined.push_back(known);
            }
            boundary.length = 0;
        }
        i = following;
    }
    parents_[from] = to;
}

int numberRegions(const std::vector<int>& parents, std::vector<int>& numbers)
{
    const int n = int(parents.size());
    std::vector<int> roots(parents), number_of_root(n, -1);
    int count = 0;
    numbers.resize(n);
    for (int i = 0; i < n; i++)
    {
        int root = i;
        while (roots[root] != root)
            root = roots[root] = roots[roots[root]];
        if (number_of_root[root] < 0)
            number_of_root[root] = count++;
        numbers[i] = number_of_root[root];
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
