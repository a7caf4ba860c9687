// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FUZZ_ATTEMPTS_HPP
#define OPENCV_GWATERSHED_FUZZ_ATTEMPTS_HPP

#include "checks.hpp"
#include "session.hpp"

namespace fuzz
{

//! What can be seen of an object.
struct Session::State
{
    Settings settings;
    bool is_segmented;
    Partition partition;

    bool operator==(const State& s) const
    {
        return settings == s.settings && is_segmented == s.is_segmented &&
               partition.num_labels == s.partition.num_labels && same(partition.labels, s.partition.labels);
    }
};

//! Whether a call throws nothing. No other exception than that of OpenCV gets through.
template <typename Call> bool succeeds(Call call)
{
    try
    {
        call();
        return true;
    }
    catch (const cv::Exception&)
    {
        return false;
    }
}

//! Returns whether the call was accepted.
template <typename Call> bool Session::attempt(bool is_valid, const char* name, Call call)
{
    const State before = state();
    require(succeeds(call) == is_valid, name);
    require(is_valid || state() == before, "a wrong call changes nothing");
    return is_valid;
}

} // namespace

#endif
