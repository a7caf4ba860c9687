// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/bucket_queue.hpp"

namespace cv { namespace ximgproc { namespace gws {

template <int PRIORITIES> int BucketQueue<PRIORITIES>::take(int* batch)
{
    if (num_used_ == 0)
        return 0;
    while (ends_[priority_] == 0)
        priority_ = priority_ + 1 < PRIORITIES ? priority_ + 1 : 0;
    const int chunk = first_[priority_], begin = chunk * CHUNK;
    const bool is_last = next_[chunk] == NONE;
    const int count = is_last ? ends_[priority_] - begin : int(CHUNK);
    std::copy_n(items_.begin() + begin, int(CHUNK), batch);
    first_[priority_] = next_[chunk];
    next_[chunk] = free_;
    free_ = chunk;
    if (is_last)
    {
        ends_[priority_] = 0;
        num_used_--;
    }
    return count;
}

template <int PRIORITIES> void BucketQueue<PRIORITIES>::appendChunk(int priority)
{
    int chunk = free_;
    if (chunk != NONE)
        free_ = next_[chunk];
    else
    {
        chunk = num_chunks_++;
        if (chunk == int(next_.size()))
        {
            items_.resize(items_.size() + CHUNK);
            next_.push_back(NONE);
        }
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
