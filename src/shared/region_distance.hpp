// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_DISTANCE_HPP
#define OPENCV_GWATERSHED_REGION_DISTANCE_HPP

#include "shared/regions.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! Distance of a pixel to the mean of a region: the sum of the absolute differences of colour, and
//! of depth. Weights are in 1/256, the distance in 1/16 of a level.
//! @note Equation (3) divided by the larger of alpha and 1 - alpha. So the weight of colour against the other terms of
//! a priority is the same with depth and without.
class RegionDistance
{
public:
    //! with_depth may be false if no feature has depth, which makes some loops faster.
    RegionDistance(int lightness, int chroma, float alpha, bool with_depth_) : with_depth(with_depth_)
    {
        const float larger = std::max(alpha, 1 - alpha);
        color_share = cvRound(256 * alpha / larger);
        depth_share = cvRound(256 * (1 - alpha) / larger);
        const short color[4] = { short(lightness), short(chroma), short(chroma), 0 };
        for (int k = 0; k < 3; k++)
        {
            weights[0][k] = color[k];
            weights[1][k] = short((color_share * color[k] + 128) >> 8);
        }
        weights[0][3] = 0;
        weights[1][3] = short(depth_share);
    }

    int operator()(const Feature& f, const RegionMean& r) const
    {
        const short* w = weightsOf(f, r);
        const int d0 = std::abs(16 * f.color[0] - r.color[0]), d1 = std::abs(16 * f.color[1] - r.color[1]);
        const int d2 = std::abs(16 * f.color[2] - r.color[2]), d3 = std::abs(16 * f.depth - r.depth);
        return (w[0] * d0 + w[1] * d1 + w[2] * d2 + w[3] * d3) >> 8;
    }

    //! The square of the distance, in squared levels.
    int squared(const Feature& f, const RegionMean& r) const
    {
        const int d = (*this)(f, r);
        return (d * d) >> 8;
    }

    //! The squares of the distances to two regions.
    template <bool WITH_DEPTH> Vec2i squared(const Feature& f, const RegionMean& a, const RegionMean& b) const
    {
        const short* weights_a = WITH_DEPTH ? weightsOf(f, a) : weights[0];
        const short* weights_b = WITH_DEPTH ? weightsOf(f, b) : weights[0];
        unsigned bytes;
        memcpy(&bytes, &f, sizeof(bytes));
        const v_uint16x8 feature = v_shl<4>(v_expand_low(v_reinterpret_as_u8(v_setall_u32(bytes))));
        const v_int16x8 means = v_load_halves(a.color, b.color);
        const v_int16x8 difference = v_reinterpret_as_s16(v_absdiff(v_reinterpret_as_s16(feature), means));
        int sums[4];
        v_store(sums, v_dotprod(difference, v_load_halves(weights_a, weights_b)));
        const int d = (sums[0] + sums[1]) >> 8, e = (sums[2] + sums[3]) >> 8;
        return Vec2i((d * d) >> 8, (e * e) >> 8);
    }

    bool with_depth;
    int color_share, depth_share;
    short weights[2][4]; //!< of a feature, without depth and with it

private:
    const short* weightsOf(const Feature& f, const RegionMean& r) const
    {
        return weights[(f.depth != 0) & (r.depth != RegionMean::NO_DEPTH)];
    }
};

}}} // namespace

#endif
