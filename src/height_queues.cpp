// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "height_queues.hpp"

namespace cv { namespace ximgproc { namespace gws {

template <typename Node, int HEIGHTS> bool HeightQueues<Node, HEIGHTS>::take(std::vector<Node>& batch)
{
    if (num_used_ == 0)
        return false;
    while (ends_[height_] == 0)
        height_ = height_ + 1 < HEIGHTS ? height_ + 1 : 0;
    batch.clear();
    const int last = (ends_[height_] - 1) / CHUNK;
    for (int chunk = first_[height_]; chunk != NONE;)
    {
        const int begin = chunk * CHUNK, end = chunk == last ? ends_[height_] : begin + CHUNK;
        const int following = next_[chunk];
        batch.insert(batch.end(), nodes_.begin() + begin, nodes_.begin() + end);
        next_[chunk] = free_;
        free_ = chunk;
        chunk = following;
    }
    ends_[height_] = 0;
    num_used_--;
    return true;
}

template <typename Node, int HEIGHTS> void HeightQueues<Node, HEIGHTS>::appendChunk(int height)
{
    int chunk = free_;
    if (chunk != NONE)
        free_ = next_[chunk];
    else
    {
        chunk = int(next_.size());
        nodes_.resize(nodes_.size() + CHUNK);
        next_.push_back(NONE);
    }
    next_[chunk] = NONE;
    if (ends_[height] > 0)
        next_[(ends_[height] - 1) / CHUNK] = chunk;
    else
    {
        first_[height] = chunk;
        num_used_++;
    }
    ends_[height] = chunk * CHUNK;
}

template class HeightQueues<int, 256>;
template class HeightQueues<Point, 1024>;

}}} // namespace
