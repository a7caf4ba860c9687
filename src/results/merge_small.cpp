// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/merge_small.hpp"
#include "results/region_graph.hpp"
#include "shared/renumber.hpp"
#include <set>

namespace cv { namespace ximgproc { namespace gws {

//! The neighbour with the longest common boundary for its size, by squared length over area; of equal ones the one with
//! the lowest label. NONE without neighbours. By the length alone, what has grown would have the longest boundary with
//! all around it, and swallow an even area.
static int closestNeighbor(RegionGraph& graph, const std::vector<int>& areas, int region)
{
    int closest = RegionGraph::NONE;
    double longest = 0;
    for (int i = graph.first(region); i != RegionGraph::NONE; i = graph.next(region, i))
    {
        const RegionGraph::Boundary& b = graph.boundaries()[i];
        const int neighbor = b.regions[!b.side(region)];
        const double length = double(b.length) * b.length / areas[neighbor];
        if (length > longest || (length == longest && neighbor < closest))
        {
            longest = length;
            closest = neighbor;
        }
    }
    return closest;
}

int mergeSmallRegions(int num_labels, int min_area, Mat& labels)
{
    CV_TRACE_FUNCTION();
    RegionGraph graph(num_labels);
    std::vector<int> areas(num_labels, 0), numbers;
    addBoundaries(labels, NoContrast(), graph);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            if (labels.at<int>(y, x) >= 0)
                areas[labels.at<int>(y, x)]++;

    std::set<std::pair<int, int> > small; // area and label of the regions to merge, smallest first
    for (int i = 0; i < num_labels; i++)
        if (areas[i] < min_area)
            small.insert(std::make_pair(areas[i], i));
    while (!small.empty())
    {
        const int from = small.begin()->second, to = closestNeighbor(graph, areas, from);
        small.erase(small.begin());
        if (to == RegionGraph::NONE)
            continue; // it has no neighbour
        small.erase(std::make_pair(areas[to], to));
        graph.unite(from, to);
        areas[to] += areas[from];
        if (areas[to] < min_area)
            small.insert(std::make_pair(areas[to], to));
    }
    const int count = numberRegions(graph.parents(), numbers);
    renumber(numbers, labels);
    return count;
}

}}} // namespace
