// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/depth_sample.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

DepthSample sampleDepths(const Mat& depth, int64 step, float farthest)
{
    std::vector<float> values;
    DepthSample sample = { {}, false };
    readSample(depth.size(), step, depth.type(), [&](int y, int x) { return depth.ptr(y, x); }, [&](const Mat& some)
    {
        values.resize(some.cols);
        readDepths(some, values.data());
        for (float any : values)
        {
            const float value = std::min(any, farthest);
            sample.has_far |= isFarDepth(value);
            if (isValidDepth(value))
                sample.depths.push_back(value);
        }
    });
    return sample;
}

}}} // namespace
