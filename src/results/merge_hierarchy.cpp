// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "results/merge_hierarchy.hpp"
#include "results/region_graph.hpp"
#include "shared/region_merge.hpp"
#include "shared/renumber.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Found as those of RGWATERSHED; doc/log.md has the figures.
static const int LENGTH_EXPONENT = 16, CONTRAST_EXPONENT = 8; // in 1/16

//! Distance of neighbouring pixels in colour and depth, in 1/16 of a level.
struct FeatureContrast
{
    int operator()(Point p, Point q) const
    {
        return distance(features.row(p.y)[p.x], meanOf(features.row(q.y)[q.x]));
    }

    const Padded<Feature>& features;
    const RegionDistance& distance;
};

//! The lists of both regions of each boundary of a graph.
static void listNeighbors(const RegionGraph& graph, int num_regions, NeighborLists& lists)
{
    const std::vector<RegionGraph::Boundary>& boundaries = graph.boundaries();
    lists.counts.assign(num_regions, 0);
    lists.starts.assign(num_regions, 0);
    lists.neighbors.resize(2 * boundaries.size());
    lists.contrasts.resize(2 * boundaries.size());
    for (size_t i = 0; i < boundaries.size(); i++)
        for (int side = 0; side < 2; side++)
            lists.counts[boundaries[i].regions[side]]++;
    for (int i = 1; i < num_regions; i++)
        lists.starts[i] = lists.starts[i - 1] + lists.counts[i - 1];
    std::vector<int> ends(lists.starts);
    for (size_t i = 0; i < boundaries.size(); i++)
        for (int side = 0; side < 2; side++)
        {
            const int position = ends[boundaries[i].regions[side]]++;
            const Neighbor neighbor = { boundaries[i].regions[!side], boundaries[i].length };
            lists.neighbors[position] = neighbor;
            lists.contrasts[position] = boundaries[i].contrast;
        }
}

//! @note Not in the paper. Merging of the region adjacency graph by Ward's criterion, which is that of
//! S. Beaulieu, M. Goldberg, Hierarchy in picture segmentation: a stepwise optimization approach (1989).
void MergeHierarchy::build(const Padded<Feature>& features, const RegionDistance& distance, const Mat& labels,
                           int num_labels)
{
    CV_TRACE_FUNCTION();
    Regions regions;
    regions.resize(num_labels);
    measureRegions(features, labels, regions);
    MergeBuffers buffers;
    SimilarMerger merger(distance, LENGTH_EXPONENT, CONTRAST_EXPONENT, buffers, regions);
    const FeatureContrast contrast = { features, distance };
    RegionGraph graph;
    graph.reset(num_labels);
    addBoundaries(labels, contrast, graph);
    listNeighbors(graph, num_labels, buffers.lists);
    merger.runToTheEnd();

    labels.copyTo(labels_);
    unions_ = merger.unions();
    num_labels_ = num_labels;
}

int MergeHierarchy::cut(int num_labels, Mat& labels) const
{
    const size_t count = std::min(size_t(std::max(num_labels_ - num_labels, 0)), unions_.size());
    std::vector<int> parents, numbers;
    applyUnions(unions_, count, num_labels_, parents);
    const int left = numberRegions(parents, numbers);
    labels_.copyTo(labels);
    renumber(numbers, labels);
    return left;
}

}}} // namespace
