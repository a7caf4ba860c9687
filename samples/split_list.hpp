// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_SAMPLES_SPLIT_LIST_HPP
#define OPENCV_SAMPLES_SPLIT_LIST_HPP

#include <opencv2/core.hpp>

#include <sstream>
#include <string>
#include <vector>

//! The parts of an argument between commas; empty ones, too, but not one at the end.
inline std::vector<cv::String> splitList(const cv::String& list)
{
    std::vector<cv::String> parts;
    std::stringstream stream(list);
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts;
}

#endif
