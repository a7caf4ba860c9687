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
    return a.neighbor < b.neighbor;
}

//! The boundaries of each region with those of larger labels, in order.
static void listPairs(const RegionGraph& graph, int num_labels, bool with_heights, Mat& pairs, Mat& lengths,
                      Mat& heights)
{
    int count = 0;
    for (int i = 0; i < num_labels; i++)
        count += int(graph.boundaries(i).size());
    count /= 2; // each one is known on both sides
    pairs.create(count, 2, CV_32SC1);
    lengths.create(count, 1, CV_32SC1);
    heights.create(with_heights ? count : 0, 1, CV_32FC1);

    int row = 0;
    for (int i = 0; i < num_labels; i++)
    {
        std::vector<RegionGraph::Boundary> sorted = graph.boundaries(i);
        std::sort(sorted.begin(), sorted.end(), comesFirst);
        for (size_t j = 0; j < sorted.size(); j++)
        {
            if (sorted[j].neighbor < i)
                continue;
            pairs.at<int>(row, 0) = i;
            pairs.at<int>(row, 1) = sorted[j].neighbor;
            lengths.at<int>(row) = sorted[j].length;
            if (with_heights)
                heights.at<float>(row) = float(double(sorted[j].height) / sorted[j].length);
            row++;
        }
    }
}

void listAdjacency(const Mat& labels, int num_labels, const Mat& color, const Mat& depth, int alpha, Mat& pairs,
                   Mat& lengths, Mat& heights)
{
    CV_TRACE_FUNCTION();
    RegionGraph graph(num_labels);
    if (color.empty())
        addBoundaries(labels, NoHeight(), graph);
    else
    {
        NodeMap nodes;
        makeNodes(color, depth, nodes);
        const PixelHeight height = { nodes, alpha };
        addBoundaries(labels, height, graph);
    }
    listPairs(graph, num_labels, !color.empty(), pairs, lengths, heights);
}

}}} // namespace
