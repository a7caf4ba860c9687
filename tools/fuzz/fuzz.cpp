// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "session.hpp"

//! The target of libFuzzer: a session for each sequence of bytes, often a second one with the same result.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const int MAX_PIXELS = 64 * 64;
    static const std::shared_ptr<fuzz::Threads> threads = fuzz::Threads::install();
    fuzz::silenceErrors();
    const std::vector<uint8_t> bytes(data, data + size);
    const uint64 first = fuzz::Session(bytes, MAX_PIXELS, threads.get()).run();
    if (size % 4 == 0)
        fuzz::require(fuzz::Session(bytes, MAX_PIXELS, 0).run() == first, "the same calls give the same results");
    return 0;
}
