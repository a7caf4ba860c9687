// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_HPP
#define OPENCV_GWATERSHED_REGION_HPP

#include "padded.hpp"

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
    OUTSIDE = INT_MIN  //!< the frame
};

//! Means over the pixels of a region, in 1/16 of a level.
struct RegionMean
{
    int color[3];
    int depth; //!< NO_DEPTH if no pixel has any

    enum { NO_DEPTH = -1 };
};

//! Sums over the pixels of a region.
struct RegionSum
{
    int64 color[3], depth;
    int area, depth_area; //!< pixels, and pixels with depth

    //! Adds a pixel, or takes it away where times is -1.
    void add(const Feature& f, int times = 1)
    {
        for (int k = 0; k < 3; k++)
            color[k] += times * f.color[k];
        depth += times * f.depth;
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
        RegionMean m;
        for (int k = 0; k < 3; k++)
            m.color[k] = int((16 * color[k] + area / 2) / area);
        m.depth = depth_area ? int((16 * depth + depth_area / 2) / depth_area) : int(RegionMean::NO_DEPTH);
        return m;
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
struct RegionDistance
{
    int lightness, chroma;
    int color_share, depth_share;

    RegionDistance(int lightness_, int chroma_, float alpha) : lightness(lightness_), chroma(chroma_)
    {
        const float larger = std::max(alpha, 1 - alpha);
        color_share = cvRound(256 * alpha / larger);
        depth_share = cvRound(256 * (1 - alpha) / larger);
    }

    int operator()(const Feature& f, const RegionMean& r) const
    {
        const int d0 = std::abs(16 * f.color[0] - r.color[0]);
        const int d1 = std::abs(16 * f.color[1] - r.color[1]);
        const int d2 = std::abs(16 * f.color[2] - r.color[2]);
        const int color = (lightness * d0 + chroma * (d1 + d2)) >> 8;
        if (f.depth == 0 || r.depth == RegionMean::NO_DEPTH)
            return color;
        return (color_share * color + depth_share * std::abs(16 * f.depth - r.depth)) >> 8;
    }

    //! The square of it, in squared levels.
    int squared(const Feature& f, const RegionMean& r) const
    {
        const int d = (*this)(f, r);
        return (d * d) >> 8;
    }
};

}}} // namespace

#endif
