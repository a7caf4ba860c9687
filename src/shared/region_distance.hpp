// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_DISTANCE_HPP
#define OPENCV_GWATERSHED_REGION_DISTANCE_HPP

#include "shared/regions.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! Distance of a pixel to the mean of a region: the sum of the absolute differences of colour, and
//! of depth.
//! @note Equation (3) divided by the larger of alpha and 1 - alpha, so that depth that is missing,
//! or the same everywhere, leaves colour as it is beside the other terms of a height.
class RegionDistance
{
public:
    //! with_depth may be false if no feature has depth; it makes some loops faster.
    RegionDistance(int lightness, int chroma, float alpha, bool with_depth_) : with_depth(with_depth_)
    {
        const float larger = std::max(alpha, 1 - alpha);
        color_share = cvRound(FULL_WEIGHT * alpha / larger);
        depth_share = beside_color = cvRound(FULL_WEIGHT * (1 - alpha) / larger);
        const short color[4] = { short(lightness), short(chroma), short(chroma), 0 };
        for (int k = 0; k < 3; k++)
        {
            weights[0][k] = color[k];
            weights[1][k] = short((color_share * color[k] + FULL_WEIGHT / 2) / FULL_WEIGHT);
        }
        weights[0][3] = 0;
        weights[1][3] = short(depth_share);
    }

    //! Regions have surfaces: depth is measured against planes, and normals count, too. weight is their share in what
    //! counts beside colour, scale that of one level of a normal against one of depth. The flood knows no planes, so
    //! depth counts little there, or planes seen at an angle become strips.
    void addSurfaces(float weight, float scale)
    {
        const int IN_FLOOD = 16;
        with_surfaces = true;
        normal_share = cvRound(depth_share * weight * scale);
        depth_share = cvRound(depth_share * (1 - weight));
        weights[1][3] = short(depth_share / IN_FLOOD);
    }

    //! The distance of colours alone, with the weights that they have beside depth, if there are surfaces. ofSurface()
    //! is what it lacks. Depth says nothing from pixel to pixel: on a slanted plane it has a step at each of them.
    RegionDistance withoutSurface() const
    {
        RegionDistance distance = *this;
        if (with_surfaces)
            distance.weights[1][3] = 0;
        return distance;
    }

    //! What the surface adds to a distance, in 1/FULL_WEIGHT of a step: the depth of a pixel against the plane of the
    //! region at its place, and its normal against that of the region; nothing of what is not known.
    int ofSurface(const Feature& f, const Normal& n, const RegionMean& r, const SurfaceMean& s, int x, int y) const
    {
        const int has_normal = -int(n.known() & s.known());
        const int turned = std::abs(STEPS_PER_LEVEL * n.x - s.x) + std::abs(STEPS_PER_LEVEL * n.y - s.y);
        return ofPlane(f, r, s, x, y) + ((normal_share * turned) & has_normal);
    }

    //! The same without normals.
    int ofPlane(const Feature& f, const RegionMean& r, const SurfaceMean& s, int x, int y) const
    {
        const int has_depth = -int((f.depth != 0) & (r.depth != RegionMean::NO_DEPTH)); // all bits
        return (depth_share * std::abs(STEPS_PER_LEVEL * f.depth - s.depthAt(x, y))) & has_depth;
    }

    int operator()(const Feature& f, const RegionMean& r, int of_surface = 0) const
    {
        const short* w = weightsOf(f, r);
        int sum = of_surface + w[3] * std::abs(STEPS_PER_LEVEL * f.depth - r.depth);
        for (int k = 0; k < 3; k++)
            sum += w[k] * std::abs(STEPS_PER_LEVEL * f.color[k] - r.color[k]);
        return sum / FULL_WEIGHT;
    }

    //! Distance of two pixels.
    int operator()(const Feature& f, const Feature& g) const
    {
        const short* w = weights[(f.depth != 0) & (g.depth != 0)];
        int sum = w[3] * std::abs(f.depth - g.depth);
        for (int k = 0; k < 3; k++)
            sum += w[k] * std::abs(f.color[k] - g.color[k]);
        return sum / (FULL_WEIGHT / STEPS_PER_LEVEL);
    }

    //! The square of it, in squared levels.
    int squared(const Feature& f, const RegionMean& r, int of_surface = 0) const
    {
        const int d = (*this)(f, r, of_surface);
        return d * d / (STEPS_PER_LEVEL * STEPS_PER_LEVEL);
    }

    //! The squares of four pairs at once.
    template <bool WITH_DEPTH>
    v_int32x4 squared(const Feature* const* f, const RegionMean* const* r, const v_int32x4& of_surfaces) const
    {
        v_int32x4 first = v_setall_s32(pairOf(weights[0], 0)), second = v_setall_s32(pairOf(weights[0], 2));
        if (WITH_DEPTH)
            splitPairs(v_load_halves(weightsOf(*f[0], *r[0]), weightsOf(*f[1], *r[1])),
                       v_load_halves(weightsOf(*f[2], *r[2]), weightsOf(*f[3], *r[3])), first, second);
        const v_uint32x4 features(bitsOf(*f[0]), bitsOf(*f[1]), bitsOf(*f[2]), bitsOf(*f[3]));
        v_uint16x8 low, high;
        v_expand(v_reinterpret_as_u8(features), low, high);
        v_int32x4 color_differences, depth_differences;
        splitPairs(difference(low, v_load_halves(r[0]->color, r[1]->color)),
                   difference(high, v_load_halves(r[2]->color, r[3]->color)), color_differences, depth_differences);
        const v_int32x4 sum = v_dotprod(v_reinterpret_as_s16(color_differences), v_reinterpret_as_s16(first),
            v_dotprod(v_reinterpret_as_s16(depth_differences), v_reinterpret_as_s16(second), of_surfaces));
        const v_int16x8 d = v_reinterpret_as_s16(v_shr<8>(sum)); // it fits into the lower half
        return v_shr<8>(v_dotprod(d, d));
    }

    bool with_depth, with_surfaces = false;
    int color_share, depth_share, normal_share = 0;
    int beside_color; //!< weight of depth and normals together
    short weights[2][4]; //!< of a feature, without depth and with it

private:
    //! Two of the four values of a feature, as they lie in memory.
    static int pairOf(const short* values, int first)
    {
        int pair;
        memcpy(&pair, values + first, sizeof(pair));
        return pair;
    }

    //! From four times four values the first two of each, and the last two.
    static void splitPairs(const v_int16x8& a, const v_int16x8& b, v_int32x4& first, v_int32x4& second)
    {
        v_int32x4 even, odd;
        v_zip(v_reinterpret_as_s32(a), v_reinterpret_as_s32(b), even, odd);
        v_zip(even, odd, first, second);
    }

    static unsigned bitsOf(const Feature& f)
    {
        unsigned bits;
        memcpy(&bits, &f, sizeof(bits));
        return bits;
    }

    static v_int16x8 difference(const v_uint16x8& features, const v_int16x8& means)
    {
        return v_reinterpret_as_s16(v_absdiff(v_reinterpret_as_s16(v_shl<4>(features)), means));
    }

    const short* weightsOf(const Feature& f, const RegionMean& r) const
    {
        return weights[(f.depth != 0) & (r.depth != RegionMean::NO_DEPTH)];
    }
};

}}} // namespace

#endif
