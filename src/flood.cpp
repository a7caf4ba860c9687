// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Lines 4 to 14: the pixels beside a marker are queued at the height of equation (4).
static void fillQueues(NodeMap& map, const Mat& gradient, float border_threshold, int alpha,
                       NodeQueues& queues)
{
    Node* nodes = map.data();
    const Vec4i neighbors = map.neighbors();
    const int threshold = border_threshold > 0 ? cvCeil(std::min(border_threshold, 65535.f)) : 65535;
    for (int y = 0; y < gradient.rows; y++)
    {
        const ushort* gradient_row = gradient.ptr<ushort>(y);
        for (int x = 0, p = map.index(Point(0, y)); x < gradient.cols; x++, p++)
        {
            Node& node = nodes[p];
            const bool is_line = (node.state == UNLABELLED) & (gradient_row[x] >= threshold) &
                                 (gradient_row[x] != UNKNOWN_GRADIENT);
            node.state = is_line ? int(LINE) : node.state;
            const int label = std::max(std::max(nodes[p + neighbors[0]].state, nodes[p + neighbors[1]].state),
                                       std::max(nodes[p + neighbors[2]].state, nodes[p + neighbors[3]].state));
            if (label <= 0 || node.state != UNLABELLED)
                continue;
            int height = INT_MAX;
            for (int k = 0; k < 4; k++)
            {
                const Node& neighbor = nodes[p + neighbors[k]];
                if (neighbor.state > 0)
                    height = std::min(height, distance(node.pixel, neighbor.pixel, alpha));
            }
            node.state = IN_QUEUE;
            queues.push(p, height);
        }
    }
}

//! The label that the labelled neighbours of a queued node share, or LINE if they differ.
static inline int commonLabel(const Node* node, const Vec4i& neighbors)
{
    const int left = node[neighbors[0]].state, top = node[neighbors[1]].state;
    const int right = node[neighbors[2]].state, bottom = node[neighbors[3]].state;
    const int label = std::max(std::max(left, top), std::max(right, bottom));
    const bool differ = ((left > 0) & (left != label)) | ((top > 0) & (top != label)) |
                        ((right > 0) & (right != label)) | ((bottom > 0) & (bottom != label));
    return differ ? int(LINE) : label;
}

//! Reads the rows that some nodes of a batch will need. They lie anywhere in the image: so they are
//! fetched at the same time, instead of one after the other.
static void touchRows(const Node* nodes, int step, const std::vector<int>& batch, size_t begin, size_t end)
{
    for (size_t i = begin; i < std::min(end, batch.size()); i++)
        for (int row = -step; row <= step; row += step)
            touch(nodes[batch[i] + row].state);
}

//! Lines 15 to 36. Invariant: a node enters a queue once, from the first labelled neighbour that
//! is taken out; it gets its label, or becomes a line, when it is taken out itself. A node queued
//! below the current height waits until the heights begin again at 0, and one queued at that height
//! goes behind those that are there. So the order of the queues alone decides, and neither lines nor
//! the frame pass the flood on.
static void flood(Node* nodes, const Vec4i& neighbors, int alpha, NodeQueues& queues, std::vector<int>& batch)
{
    const size_t AHEAD = 8;
    const int step = neighbors[3];
    while (queues.take(batch))
    {
        touchRows(nodes, step, batch, 0, AHEAD);
        for (size_t i = 0; i < batch.size(); i++)
        {
            if (i % AHEAD == 0)
                touchRows(nodes, step, batch, i + AHEAD, i + 2 * AHEAD);
            const int p = batch[i];
            Node& node = nodes[p];
            node.state = commonLabel(&node, neighbors);
            if (node.state == LINE)
                continue;
            for (int k = 0; k < 4; k++)
            {
                const int a = p + neighbors[k];
                if (nodes[a].state != UNLABELLED)
                    continue;
                nodes[a].state = IN_QUEUE;
                queues.push(a, distance(node.pixel, nodes[a].pixel, alpha));
            }
        }
    }
}

void floodFromMarkers(const Mat& gradient, float border_threshold, int alpha, NodeMap& nodes,
                      PlainFloodBuffers& buffers)
{
    CV_TRACE_FUNCTION();
    buffers.queues.clear();
    fillQueues(nodes, gradient, border_threshold, alpha, buffers.queues);
    flood(nodes.data(), nodes.neighbors(), alpha, buffers.queues, buffers.batch);
}

}}} // namespace
