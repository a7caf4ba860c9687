// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_HEIGHT_QUEUES_HPP
#define OPENCV_GWATERSHED_HEIGHT_QUEUES_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Queues of nodes for the heights 0..HEIGHTS-1, first in first out each. They are chains of chunks of one array, so
//! memory is that of the nodes that wait at the same time. (height_queues.cpp)
template <typename Node, int HEIGHTS> class CV_EXPORTS HeightQueues
{
public:
    HeightQueues() { clear(); }

    void clear()
    {
        nodes_.clear();
        next_.clear();
        free_ = NONE;
        height_ = num_used_ = 0;
        std::fill_n(first_, HEIGHTS, int(NONE));
        std::fill_n(ends_, HEIGHTS, 0);
    }

    //! The height of the nodes that were taken last.
    int height() const { return height_; }

    void push(const Node& node, int height)
    {
        if (ends_[height] % CHUNK == 0)
            appendChunk(height);
        nodes_[ends_[height]++] = node;
    }

    //! Takes all nodes from the queue at the current height; if that is empty, from the next one that
    //! is not, beginning again at 0 after the last. Returns false if all are empty.
    bool take(std::vector<Node>& batch);

private:
    enum { CHUNK = 32, NONE = -1 };

    //! Puts a chunk that is free, or a new one, at the end of a queue.
    void appendChunk(int height);

    std::vector<Node> nodes_; // those of chunk i from i * CHUNK on
    std::vector<int> next_;   // chunk in the chain, for each chunk
    int free_;                // first of the chain of those that no queue has
    int height_;
    int num_used_;            // queues that are not empty
    int first_[HEIGHTS];      // chunk of each of them
    int ends_[HEIGHTS];       // behind its last node, in nodes_; 0 if it is empty
};

}}} // namespace

#endif
