// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FUZZ_THREADS_HPP
#define OPENCV_GWATERSHED_FUZZ_THREADS_HPP

#include <opencv2/core.hpp>
#include <opencv2/core/parallel/parallel_backend.hpp>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace fuzz
{

//! A back end of cv::parallel_for_ made of nothing but std::thread, so that ThreadSanitizer sees all of it; or of
//! no threads at all: the tasks run one by one, in an order that changes, which shows what depends on the order.
class Threads : public cv::parallel::ParallelForAPI
{
public:
    //! Makes it the back end of OpenCV.
    static std::shared_ptr<Threads> install()
    {
        const std::shared_ptr<Threads> threads = std::make_shared<Threads>();
        cv::parallel::setParallelForBackend(threads);
        return threads;
    }

    //! 0: no threads, but another order; 1: no parallel_for_; more: as many threads.
    void use(int count)
    {
        cv::setNumThreads(count == 0 ? 2 : count);
        shuffled_ = count == 0;
        order_ = cv::RNG();
    }

    void parallel_for(int tasks, FN_parallel_for_body_cb_t body, void* data) CV_OVERRIDE
    {
        if (shuffled_)
            runShuffled(tasks, body, data);
        else
            runThreads(tasks, body, data);
    }

    int getThreadNum() const CV_OVERRIDE { return 0; }
    int getNumThreads() const CV_OVERRIDE { return count_; }
    int setNumThreads(int count) CV_OVERRIDE
    {
        std::swap(count, count_);
        return count;
    }
    const char* getName() const CV_OVERRIDE { return "fuzz"; }

private:
    void runShuffled(int tasks, FN_parallel_for_body_cb_t body, void* data)
    {
        std::vector<int> order(tasks);
        for (int i = 0; i < tasks; i++)
        {
            const int j = order_.uniform(0, i + 1);
            order[i] = order[j];
            order[j] = i;
        }
        for (int task : order)
            body(task, task + 1, data);
    }

    //! No thread ends before all have done their work: OpenCV locks where threads begin and end, which would put
    //! the work of one before that of the next, and ThreadSanitizer would find no race between them.
    void runThreads(int tasks, FN_parallel_for_body_cb_t body, void* data)
    {
        const int count = std::min(count_, tasks);
        std::atomic<int> working(count);
        std::vector<std::thread> threads;
        for (int i = 0; i < count; i++)
        {
            const int first = int(int64(tasks) * i / count), end = int(int64(tasks) * (i + 1) / count);
            threads.push_back(std::thread([=, &working]()
            {
                body(first, end, data);
                for (working--; working > 0;)
                    std::this_thread::yield();
            }));
        }
        for (std::thread& thread : threads)
            thread.join();
    }

    int count_ = 2;
    bool shuffled_ = false;
    cv::RNG order_;
};

} // namespace

#endif
