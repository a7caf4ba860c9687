// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/depth_sample.hpp"
#include "depth/depth_span.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The near end of a range that leaves out a hundredth of the depths there: moved to leave out a thousandth, because
//! what is small and near is worth telling apart, but not so far that nearness gets less than 4/5 of its levels.
static float extendNearEnd(FloatRange range, std::vector<float>& depths)
{
    const auto thousandth = depths.begin() + ptrdiff_t(depths.size() / 1000);
    std::nth_element(depths.begin(), thousandth, depths.end());
    const double inverse_near = 1. / range.first, inverse_far = 1. / range.last;
    return std::max(*thousandth, float(1 / (inverse_near + (inverse_near - inverse_far) / 4)));
}

//! The middle one of the values that differ. A far plane, or a value for "no depth", is one of them, on however many
//! pixels it is.
static float middleOf(std::vector<float> values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values[(values.size() - 1) / 2];
}

//! Takes out what is so much farther or nearer than other depths that they would have hardly any levels beside it, if
//! it is more than outliers.
static void removeExtremes(std::vector<float>& depths, DepthSpan& span)
{
    const float MUCH = 64;
    const ptrdiff_t hundredth = ptrdiff_t(depths.size() / 100);
    const auto ends = std::minmax_element(depths.begin(), depths.end());
    if (*ends.second / MUCH <= *ends.first)
        return;
    const float middle = middleOf(depths);
    const auto distant = std::partition(depths.begin(), depths.end(), [&](float d) { return d / MUCH <= middle; });
    if (depths.end() - distant > hundredth)
    {
        span.farther = true;
        depths.erase(distant, depths.end());
    }
    const auto others = std::partition(depths.begin(), depths.end(), [&](float d) { return d < middle / MUCH; });
    span.nearer = others - depths.begin() > hundredth;
    if (span.nearer)
        depths.erase(depths.begin(), others);
}

//! Takes out a few depths that are apart from all others and much nearer, as those of a robot's gripper, if they would
//! take most levels of nearness.
static void removeNear(std::vector<float>& depths, DepthSpan& span)
{
    const float APART = 1.8f;
    const double MOST = 0.8;
    const ptrdiff_t n = ptrdiff_t(depths.size()), few = n / 7, hundredth = n / 100;
    if (hundredth == 0 || span.nearer)
        return;
    const auto begin = depths.begin();
    std::nth_element(begin, begin + few, depths.end());
    std::nth_element(begin + few, depths.end() - hundredth, depths.end());
    const double inverse_far = 1. / *(depths.end() - hundredth);
    const double inverse_near = 1. / *std::min_element(begin, begin + few + 1);
    const auto leaveFew = [&](float d) { return 1. / d - inverse_far < (1 - MOST) * (inverse_near - inverse_far); };
    if (!leaveFew(begin[few]))
        return;
    std::sort(begin, begin + few);
    for (auto other = std::find_if(begin, begin + few, leaveFew); other != begin + few; ++other)
        if (other - std::upper_bound(begin, other, *other / APART) <= hundredth && other - begin > n / 1000)
        {
            span.nearer = true;
            depths.erase(begin, other);
            return;
        }
}

//! The range of depths without outliers at each end. {0, 0} if there are not two depths.
static DepthSpan spanOf(DepthSample& sample, bool takes_all)
{
    std::vector<float>& depths = sample.depths;
    DepthSpan span = { { 0, 0 }, false, sample.has_far };
    if (depths.empty())
        return span;
    removeExtremes(depths, span);
    if (!takes_all)
        removeNear(depths, span);
    FloatRange range = rangeWithout(depths.size() / 100, depths);
    if (range.first >= range.last)
    {
        range.first = *std::min_element(depths.begin(), depths.end());
        range.last = *std::max_element(depths.begin(), depths.end());
    }
    if (range.first >= range.last && span.farther)
        range.last = std::numeric_limits<float>::infinity();
    if (range.first < range.last)
        range.first = extendNearEnd(range, depths);
    if (range.first < range.last || span.nearer)
        span.range = range;
    return span;
}

//! Whether two pixels have different depths; an infinite one differs from the others.
static bool hasTwoDepths(const Mat& depth, float farthest)
{
    std::vector<float> row(depth.cols);
    float known = 0;
    for (int y = 0; y < depth.rows; y++)
    {
        readDepths(depth.row(y), row.data());
        for (float any : row)
        {
            const float value = std::min(any, farthest);
            if (value > 0 && known > 0 && value != known)
                return true;
            known = std::max(known, value);
        }
    }
    return false;
}

DepthSpan findSpan(const Mat& depth, float farthest)
{
    const int64 total = int64(depth.rows) * depth.cols;
    const int64 MANY = 8192, ENOUGH = MANY / 2; // a thousandth of them are 4 depths at least: the near end is not one
    for (int64 step = sampleStep(total, MANY);;)
    {
        DepthSample sample = sampleDepths(depth, step, farthest);
        int64 count = int64(sample.depths.size());
        if (count >= ENOUGH || step == 1)
        {
            const DepthSpan span = spanOf(sample, farthest <= FLT_MAX);
            if (span.range.last > 0 || step == 1)
                return span;
            count = 0;
        }
        step = std::max<int64>(step * count / MANY, 1);
        if (step == 1 && !hasTwoDepths(depth, farthest))
            return DepthSpan();
    }
}

}}} // namespace
