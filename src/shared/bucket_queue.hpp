// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BUCKET_QUEUE_HPP
#define OPENCV_GWATERSHED_BUCKET_QUEUE_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Queues of items for the priorities 0..PRIORITIES-1, first in first out each. They are chains of chunks of one array,
//! so memory is that of the items that wait at the same time.
template <int PRIORITIES> class BucketQueue
{
public:
    enum { CHUNK = 32 };

    //! The priority of items that are dropped, up to CHUNK - 1 of them between two calls of drop().
    enum { NEVER = PRIORITIES };

    BucketQueue() : items_(CHUNK), next_(1) { clear(); }

    void clear()
    {
        free_ = NONE;
        priority_ = num_used_ = 0;
        num_chunks_ = 1; // for those that are dropped
        std::fill_n(first_, PRIORITIES, int(NONE));
        std::fill_n(ends_, PRIORITIES, 0);
        drop();
    }

    void drop() { ends_[NEVER] = 1; }

    //! The priority of the items that were taken last.
    int priority() const { return priority_; }

    void push(int item, int priority)
    {
        if (ends_[priority] % CHUNK == 0)
            appendChunk(priority);
        items_[ends_[priority]++] = item;
    }

    //! Takes the first items, up to CHUNK, from the queue at the current priority; if that is empty, from the next one
    //! that is not, beginning again at 0 after the last. Returns their number, 0 if all are empty.
    int take(int* batch);

private:
    enum { NONE = -1 };

    //! Puts a chunk that is free, or a new one, at the end of a queue.
    void appendChunk(int priority);

    std::vector<int> items_; // those of chunk i from i * CHUNK on
    std::vector<int> next_;  // chunk in the chain, for each chunk
    int num_chunks_;         // that were used; there may be more from before
    int free_;               // first of the chain of those that no queue has
    int priority_;
    int num_used_;          // queues that are not empty
    int first_[PRIORITIES]; // chunk of each of them
    int ends_[PRIORITIES + 1]; // behind its last item, in items_; 0 if it is empty
};

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

}}} // namespace

#endif
