// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

// Every new of this program and of the module goes through here, so that a test can see its size
// and let it fail.

static std::atomic<bool> recording(false);
static std::atomic<size_t> largest_size(0);
static std::atomic<int> left_until_failure(-1); // below 0: none fails

void* operator new(size_t size)
{
    if (recording && size > largest_size)
        largest_size = size;
    if (left_until_failure >= 0 && left_until_failure-- == 0)
        throw std::bad_alloc();
    if (void* memory = std::malloc(size ? size : 1))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
    std::free(memory);
}

void operator delete(void* memory, size_t) noexcept; // no standard header declares it for C++11
void operator delete(void* memory, size_t) noexcept  // what C++14 and later call
{
    std::free(memory);
}

namespace opencv_test
{

NewRecorder::NewRecorder()
{
    largest_size = 0;
    recording = true;
}

NewRecorder::~NewRecorder()
{
    recording = false;
}

size_t NewRecorder::largest() const
{
    return largest_size;
}

void failNewAfter(int count)
{
    left_until_failure = count;
}

bool newHasFailed()
{
    return left_until_failure < 0;
}

} // namespace
