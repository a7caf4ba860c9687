// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_graph.hpp"
#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Distance of neighbouring pixels, equations (1) to (3).
struct PixelHeight
{
    int operator()(Point p, Point q) const
    {
        return distance(nodes.row(p.y)[p.x].pixel, nodes.row(q.y)[q.x].pixel, alpha);
    }

    const NodeMap& nodes;
    const int alpha;
};

static bool comesFirst(const RegionGraph::Boundary& a, const RegionGraph::Boundary& b)
{
    return a.regions[0] < b.regions[0] || (a.regions[0] == b.regions[0] && a.regions[1] < b.regions[1]);
}

static void listPairs(const RegionGraph& graph, bool with_heights, Mat& pairs, Mat& lengths, Mat& heights)
{
    std::vector<RegionGraph::Boundary> sorted(graph.boundaries());
    const int count = int(sorted.size());
    for (int i = 0; i < count; i++)
        if (sorted[i].regions[1] < sorted[i].regions[0])
            std::swap(sorted[i].regions[0], sorted[i].regions[1]);
    std::sort(sorted.begin(), sorted.end(), comesFirst);

    pairs.create(count, 2, CV_32SC1);
    lengths.create(count, 1, CV_32SC1);
    heights.create(with_heights ? count : 0, 1, CV_32FC1);
    for (int i = 0; i < count; i++)
    {
        pairs.at<int>(i, 0) = sorted[i].regions[0];
        pairs.at<int>(i, 1) = sorted[i].regions[1];
        lengths.at<int>(i) = sorted[i].length;
        if (with_heights)
            heights.at<float>(i) = float(double(sorted[i].height) / sorted[i].length);
    }
}

void listAdjacency(const Mat& labels, int num_labels, const Mat& color, const Mat& depth, int alpha, Mat& pairs,
                   Mat& lengths, Mat& heights)
{
    CV_TRACE_FUNCTION();
    RegionGraph graph;
    graph.reset(num_labels);
    if (color.empty())
        addBoundaries(labels, NoHeight(), graph);
    else
    {
        NodeMap nodes;
        makeNodes(color, depth, nodes);
        const PixelHeight height = { nodes, alpha };
        addBoundaries(labels, height, graph);
    }
    listPairs(graph, !color.empty(), pairs, lengths, heights);
}

}}} // namespace
