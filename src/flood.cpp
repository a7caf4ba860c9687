// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The 256 queues of Algorithm 1, first in first out each. A queue is a chain through the states
//! of its nodes, so that pushing allocates nothing.
class BucketQueue
{
public:
    explicit BucketQueue(Node* nodes) : nodes_(nodes), height_(0), used_() {}

    void push(int node, int height)
    {
        uint64& word = used_[height >> 6];
        const uint64 bit = uint64(1) << (height & 63);
        if (word & bit)
            nodes_[last_[height]].state = IN_QUEUE - node;
        else
            first_[height] = node;
        word |= bit;
        last_[height] = node;
        nodes_[node].state = IN_QUEUE;
    }

    //! Takes a node from the queue at the current height; if that is empty, from the next one that
    //! is not, beginning again at 0 after 255. Returns 0, a node of the frame, if all are empty.
    int pop()
    {
        if (!isUsed(height_) && !advance())
            return 0;
        const int node = first_[height_];
        const int next = IN_QUEUE - nodes_[node].state;
        if (next)
            first_[height_] = next;
        else
            used_[height_ >> 6] &= ~(uint64(1) << (height_ & 63));
        return node;
    }

private:
    bool isUsed(int height) const { return (used_[height >> 6] >> (height & 63)) & 1; }

    bool advance()
    {
        if (!(used_[0] | used_[1] | used_[2] | used_[3]))
            return false;
        do
            height_ = (height_ + 1) & 255;
        while (!isUsed(height_));
        return true;
    }

    Node* nodes_;
    int height_;
    uint64 used_[4]; // a bit for each height whose queue is not empty
    int first_[256], last_[256];
};

//! Lines 4 to 14: the pixels beside a marker are queued at the height of equation (4).
static void fillQueues(NodeMap& map, const Mat& gradient, float border_threshold, int alpha,
                       BucketQueue& queue)
{
    Node* nodes = map.data();
    const Vec4i neighbors = map.neighbors();
    for (int y = 0; y < gradient.rows; y++)
    {
        const ushort* gradient_row = gradient.ptr<ushort>(y);
        for (int x = 0, p = map.index(Point(0, y)); x < gradient.cols; x++, p++)
        {
            if (nodes[p].state != UNLABELLED)
                continue;
            if (border_threshold > 0 && gradient_row[x] >= border_threshold && gradient_row[x] != UNKNOWN_GRADIENT)
            {
                nodes[p].state = LINE;
                continue;
            }
            int height = INT_MAX;
            for (int k = 0; k < 4; k++)
            {
                const Node& neighbor = nodes[p + neighbors[k]];
                if (neighbor.state > 0)
                    height = std::min(height, distance(nodes[p].pixel, neighbor.pixel, alpha));
            }
            if (height != INT_MAX)
                queue.push(p, height);
        }
    }
}

//! The label that the labelled neighbours of a queued node share, or LINE if they differ.
static inline int commonLabel(const Node* node, const Vec4i& neighbors)
{
    const int left = node[neighbors[0]].state, top = node[neighbors[1]].state;
    const int right = node[neighbors[2]].state, bottom = node[neighbors[3]].state;
    const int label = std::max(std::max(left, top), std::max(right, bottom));
    const bool differ = (left > 0 && left != label) || (top > 0 && top != label) ||
                        (right > 0 && right != label) || (bottom > 0 && bottom != label);
    return differ ? int(LINE) : label;
}

//! Lines 15 to 36. Invariant: a node enters a queue once, from the first labelled neighbour that
//! is taken out; it gets its label, or becomes a line, when it is taken out itself. A node queued
//! below the current height waits until the heights begin again at 0. So the order of the queues
//! alone decides, and neither lines nor the frame pass the flood on.
static void flood(Node* nodes, const Vec4i& neighbors, int alpha, BucketQueue& queue)
{
    while (const int p = queue.pop())
    {
        Node& node = nodes[p];
        node.state = commonLabel(&node, neighbors);
        if (node.state == LINE)
            continue;
        for (int k = 0; k < 4; k++)
        {
            const int a = p + neighbors[k];
            if (nodes[a].state == UNLABELLED)
                queue.push(a, distance(node.pixel, nodes[a].pixel, alpha));
        }
    }
}

void floodFromMarkers(const Mat& gradient, float border_threshold, int alpha, NodeMap& nodes)
{
    CV_TRACE_FUNCTION();
    BucketQueue queue(nodes.data());
    fillQueues(nodes, gradient, border_threshold, alpha, queue);
    flood(nodes.data(), nodes.neighbors(), alpha, queue);
}

}}} // namespace
