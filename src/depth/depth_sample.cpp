// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/depth_sample.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Some pixels at a time: where step is 1, all of them would be a second depth map.
DepthSample sampleDepths(const Mat& depth, int64 step, float farthest)
{
    const size_t AT_ONCE = 4096, size = depth.elemSize();
    std::vector<uchar> bytes;
    std::vector<float> values(AT_ONCE);
    DepthSample sample = { {}, false };
    const auto take = [&]()
    {
        const int count = int(bytes.size() / size);
        readDepths(Mat(1, count, depth.type(), bytes.data()), values.data());
        for (int i = 0; i < count; i++)
        {
            const float value = std::min(values[i], farthest);
            sample.has_far |= isFarDepth(value);
            if (isValidDepth(value))
                sample.depths.push_back(value);
        }
        bytes.clear();
    };
    visitSample(depth.size(), step, [&](int y, int x)
    {
        bytes.insert(bytes.end(), depth.ptr(y, x), depth.ptr(y, x) + size);
        if (bytes.size() == AT_ONCE * size)
            take();
    });
    if (!bytes.empty())
        take();
    return sample;
}

}}} // namespace
