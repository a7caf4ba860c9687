// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_HPP
#define OPENCV_GWATERSHED_REGION_HPP

#include "padded.hpp"

#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! A pixel, or a block of pixels, as RGWATERSHED compares it: lightness and two colour differences
//! of an opponent space, and scaled depth, 0 if missing.
struct Feature
{
    uchar color[3];
    uchar depth;
};

//! Labels of RGWATERSHED while it works: regions are 0..n-1.
enum RegionLabel
{
    UNSEEN = -1,       //!< not reached by any region
    OUTSIDE = INT_MIN  //!< around the image, outside of the mask, and what no marker reached
};

//! Means over the pixels of a region, in 1/16 of a level.
struct RegionMean
{
    short color[3];
    short depth; //!< NO_DEPTH if no pixel has any

    enum { NO_DEPTH = -1 };
};

//! The mean of one pixel.
inline RegionMean meanOf(const Feature& f)
{
    const RegionMean mean = { { short(16 * f.color[0]), short(16 * f.color[1]), short(16 * f.color[2]) },
                              short(f.depth ? 16 * f.depth : int(RegionMean::NO_DEPTH)) };
    return mean;
}

//! Sums over the pixels of a region.
struct RegionSum
{
    int64 color[3], depth;
    int area, depth_area; //!< pixels, and pixels with depth

    //! Adds a pixel, or takes it away where times is -1.
    void add(const Feature& f, int times = 1)
    {
        for (int k = 0; k < 3; k++)
            color[k] += int64(times) * f.color[k];
        depth += int64(times) * f.depth;
        depth_area += f.depth ? times : 0;
        area += times;
    }

    void add(const RegionSum& r)
    {
        for (int k = 0; k < 3; k++)
            color[k] += r.color[k];
        depth += r.depth;
        depth_area += r.depth_area;
        area += r.area;
    }

    RegionMean mean() const
    {
        const int64 reciprocal = FIXED_ONE / area;
        RegionMean m;
        for (int k = 0; k < 3; k++)
            m.color[k] = divide(color[k], reciprocal);
        m.depth = depth_area ? divide(depth, FIXED_ONE / depth_area) : short(RegionMean::NO_DEPTH);
        return m;
    }

private:
    static const int64 FIXED_ONE = int64(1) << 48; // sums in 1/16 of a level times it, over the area, fit into 64 bits

    static short divide(int64 sum, int64 reciprocal)
    {
        return short((16 * sum * reciprocal + FIXED_ONE / 2) >> 48);
    }
};

//! The regions of an image. Means lie apart from the sums, because the loops over pixels read no
//! more, and change when update() is called.
struct Regions
{
    std::vector<RegionMean> means;
    std::vector<RegionSum> sums;

    int size() const { return int(sums.size()); }
    void resize(int n)
    {
        means.resize(n);
        sums.resize(n);
    }
    void clear(int n)
    {
        resize(n);
        std::fill(sums.begin(), sums.end(), RegionSum());
    }
    //! From sums over blocks to sums over the 2x2 blocks or pixels in them, whose mean they are.
    void divideBlocks()
    {
        for (int i = 0; i < size(); i++)
        {
            RegionSum& sum = sums[i];
            for (int k = 0; k < 3; k++)
                sum.color[k] *= 4;
            sum.depth *= 4;
            sum.area = int(std::min<int64>(4 * int64(sum.area), INT_MAX)); // at odd borders there are fewer pixels
            sum.depth_area = int(std::min<int64>(4 * int64(sum.depth_area), INT_MAX));
        }
    }
    void update(int i) { means[i] = sums[i].mean(); }
    void update()
    {
        for (int i = 0; i < size(); i++)
            update(i);
    }
};

//! Distance of a pixel to the mean of a region: the sum of the absolute differences of colour, and
//! of depth. Weights are in 1/256, the distance in 1/16 of a level.
//! @note Equation (3) divided by the larger of alpha and 1 - alpha, so that depth that is missing,
//! or the same everywhere, leaves colour as it is beside the other terms of a height.
class RegionDistance
{
public:
    //! with_depth may be false if no feature has depth; it makes some loops faster.
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

    //! The square of it, in squared levels.
    int squared(const Feature& f, const RegionMean& r) const
    {
        const int d = (*this)(f, r);
        return (d * d) >> 8;
    }

    //! Both squares of the distances to two regions, at once.
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
