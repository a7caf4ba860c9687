// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_DEPTH_SPAN_HPP
#define OPENCV_GWATERSHED_DEPTH_SPAN_HPP

#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What depths become levels of nearness.
struct DepthSpan
{
    FloatRange range;
    bool nearer;  //!< some are much nearer than the range
    bool farther; //!< some are much farther, or infinite
};

//! The depths of a map that get levels, where it becomes surfaces: from a sample, a denser one where holes leave few
//! depths, and all pixels where those of the sample are all the same. {0, 0} if there are not two depths. farthest
//! is the far end of a range that was set, or infinity. What is farther than a range is taken for its end, and a few
//! near depths keep their levels then.
DepthSpan findSpan(const Mat& depth, float farthest);

}}} // namespace

#endif
