// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_DEPTH_SAMPLE_HPP
#define OPENCV_GWATERSHED_DEPTH_SAMPLE_HPP

#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Depths of some pixels of a map.
struct DepthSample
{
    std::vector<float> depths; //!< that were measured
    bool has_far;              //!< some are infinite
};

//! A sample with one of each `step` pixels that follow one another. What is farther than a limit becomes the limit.
DepthSample sampleDepths(const Mat& depth, int64 step, float farthest = std::numeric_limits<float>::infinity());

}}} // namespace

#endif
