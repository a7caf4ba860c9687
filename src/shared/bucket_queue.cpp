// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/bucket_queue.hpp"

namespace cv { namespace ximgproc { namespace gws {

template <int PRIORITIES> bool BucketQueue<PRIORITIES>::take(std::vector<int>& batch)
{
    if (num_used_ == 0)
        return false;
    while (ends_[priority_] == 0)
        priority_ = priority_ + 1 < PRIORITIES ? priority_ + 1 : 0;
    batch.clear();
    const int last = (ends_[priority_] - 1) / CHUNK;
    for (int chunk = first_[priority_]; chunk != NONE;)
    {
        const int begin = chunk * CHUNK, end = chunk == last ? ends_[priority_] : begin + CHUNK;
        const int following = next_[chunk];
        batch.insert(batch.end(), items_.begin() + begin, items_.begin() + end);
        next_[chunk] = free_;
        free_ = chunk;
        chunk = following;
    }
    ends_[priority_] = 0;
    num_used_--;
    return true;
}

template <int PRIORITIES> void BucketQueue<PRIORITIES>::appendChunk(int priority)
{
    int chunk = free_;
    if (chunk != NONE)
        free_ = next_[chunk];
    else
    {
        chunk = int(next_.size());
        items_.resize(items_.size() + CHUNK);
        next_.push_back(NONE);
    }
    next_[chunk] = NONE;
    if (ends_[priority] > 0)
        next_[(ends_[priority] - 1) / CHUNK] = chunk;
    else
    {
        first_[priority] = chunk;
        num_used_++;
    }
    ends_[priority] = chunk * CHUNK;
}

template class BucketQueue<256>;
template class BucketQueue<1024>;

}}} // namespace
