// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef GWATERSHED_PYTHON_SESSION_HPP
#define GWATERSHED_PYTHON_SESSION_HPP

#include <opencv2/gwatershed.hpp>
#include <pybind11/pybind11.h>

#include <mutex>
#include <string>

namespace gwatershed
{

using cv::ximgproc::SuperpixelGWatershed;

//! What Python has for an object of the class. Calls run without the lock of the interpreter and one after the other,
//! so threads that share an object wait for each other.
class Session
{
public:
    explicit Session(const cv::Ptr<SuperpixelGWatershed>& superpixels) : superpixels_(superpixels) {}

    //! Calls work(SuperpixelGWatershed&), which must not touch Python.
    template <typename Work> auto call(Work work) -> decltype(work(std::declval<SuperpixelGWatershed&>()))
    {
        pybind11::gil_scoped_release released;
        std::lock_guard<std::mutex> lock(mutex_);
        return work(*superpixels_);
    }

    //! The parameters as text, for pickle.
    std::string write();
    //! From that text, or from that of a file of save().
    void read(const std::string& parameters);

private:
    cv::Ptr<SuperpixelGWatershed> superpixels_;
    std::mutex mutex_;
};

} // namespace gwatershed

#endif
