// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_graph.hpp"
#include "steps.hpp"

#include <set>

namespace cv { namespace ximgproc { namespace gws {

//! The neighbour with the longest common boundary; of equal ones the first label.
static int closestNeighbor(const std::vector<RegionGraph::Boundary>& boundaries)
{
    int closest = -1, longest = 0;
    for (size_t i = 0; i < boundaries.size(); i++)
    {
        const RegionGraph::Boundary& b = boundaries[i];
        if (b.length > longest || (b.length == longest && b.neighbor < closest))
        {
            longest = b.length;
            closest = b.neighbor;
        }
    }
    return closest;
}

static void measure(const Mat& labels, RegionGraph& graph, std::vector<int>& areas)
{
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        const int* below = labels.ptr<int>(std::min(y + 1, labels.rows - 1));
        for (int x = 0; x < labels.cols; x++)
        {
            const int label = row[x], right = row[std::min(x + 1, labels.cols - 1)];
            areas[label]++;
            if (right != label)
                graph.addEdges(label, right, 1);
            if (below[x] != label)
                graph.addEdges(label, below[x], 1);
        }
    }
}

int mergeSmallRegions(int num_labels, int min_area, Mat& labels)
{
    CV_TRACE_FUNCTION();
    RegionGraph graph(num_labels);
    std::vector<int> areas(num_labels, 0), numbers;
    measure(labels, graph, areas);

    std::set<std::pair<int, int> > small; // area and label of the regions to merge, smallest first
    for (int i = 0; i < num_labels; i++)
        if (areas[i] < min_area)
            small.insert(std::make_pair(areas[i], i));
    while (!small.empty())
    {
        const int from = small.begin()->second, to = closestNeighbor(graph.boundaries(from));
        small.erase(small.begin());
        if (to < 0)
            continue; // it fills the image
        small.erase(std::make_pair(areas[to], to));
        graph.unite(from, to);
        areas[to] += areas[from];
        if (areas[to] < min_area)
            small.insert(std::make_pair(areas[to], to));
    }
    const int count = graph.number(numbers);
    renumber(numbers, labels);
    return count;
}

}}} // namespace
