// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/depth_sample.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

DepthSample sampleDepths(const Mat& depth, int64 step, float farthest)
{
    const size_t size = depth.elemSize(), total = depth.total();
    std::vector<uchar> bytes((total + size_t(step) - 1) / size_t(step) * size);
    uchar* to = bytes.data();
    visitSample(depth.size(), step, [&](int y, int x) { to = std::copy_n(depth.ptr(y, x), size, to); });
    DepthSample sample;
    std::vector<float>& depths = sample.depths;
    depths.resize(bytes.size() / size);
    readDepths(Mat(1, int(depths.size()), depth.type(), bytes.data()), depths.data());
    for (float& value : depths)
        value = std::min(value, farthest);
    sample.has_far = std::any_of(depths.begin(), depths.end(), [](float value) { return isFarDepth(value); });
    depths.erase(std::remove_if(depths.begin(), depths.end(), [](float value) { return !isValidDepth(value); }),
                 depths.end());
    return sample;
}

}}} // namespace
