// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_IN_USE_HPP
#define OPENCV_GWATERSHED_IN_USE_HPP

#include "precomp.hpp"

#include <atomic>

namespace cv { namespace ximgproc { namespace gws {

//! Who uses an object: any number of readers, or one writer. Nobody waits; who comes at a wrong time gets an exception.
class InUse
{
public:
    InUse() : users_(0) {}
    //! Users are those of an object, not of what it holds.
    InUse(const InUse&) : users_(0) {}
    InUse& operator=(const InUse&) { return *this; }

private:
    friend class Reading;
    friend class Writing;

    static const int WRITER = -1;

    static void refuse()
    {
        CV_Error(Error::StsError, "The object is in use by another thread: give each thread an object of its own");
    }

    mutable std::atomic<int> users_;
};

//! A reader for the time of a scope.
class Reading
{
public:
    explicit Reading(const InUse& in_use) : users_(in_use.users_)
    {
        int before = users_;
        do
        {
            if (before == static_cast<int>(InUse::WRITER))
                InUse::refuse();
        } while (!users_.compare_exchange_weak(before, before + 1));
    }
    ~Reading() { users_--; }

private:
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;
    std::atomic<int>& users_;
};

//! The writer for the time of a scope.
class Writing
{
public:
    explicit Writing(const InUse& in_use) : users_(in_use.users_)
    {
        int nobody = 0;
        if (!users_.compare_exchange_strong(nobody, static_cast<int>(InUse::WRITER)))
            InUse::refuse();
    }
    ~Writing() { users_ = 0; }

private:
    Writing(const Writing&) = delete;
    Writing& operator=(const Writing&) = delete;
    std::atomic<int>& users_;
};

}}} // namespace

#endif
