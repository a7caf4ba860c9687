// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_DISTANCE_HPP
#define OPENCV_GWATERSHED_REGION_DISTANCE_HPP

#include "shared/regions.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { STEP_OF_DEPTH = 32 }; //!< levels of depth: more is a step, less a slope or noise

//! Distance of a pixel to the mean of a region: the sum of the absolute differences of colour, and
//! of depth.
//! @note Equation (3) divided by the larger of alpha and 1 - alpha, so that depth that is missing,
//! or the same everywhere, leaves colour as it is beside the other terms of a priority.
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
    //! counts beside colour, scale that of one level of a normal against one of depth.
    void addSurfaces(float weight, float scale)
    {
        with_surfaces = true;
        normal_share = cvRound(float(depth_share) * weight * scale);
        depth_share = cvRound(float(depth_share) * (1 - weight));
        weights[1][3] = short(depth_share);
    }

    //! Lets normals count less: 0 to 1 of what they do.
    void trustNormals(float trust) { normal_share = cvRound(float(normal_share) * trust); }

    //! The distance of colours alone, with the weights that they have beside depth, if there are surfaces. Depth says
    //! nothing from pixel to pixel: on a slanted plane it has a step at each of them.
    RegionDistance withoutSurface() const
    {
        RegionDistance distance = *this;
        if (with_surfaces)
            distance.weights[1][3] = 0;
        return distance;
    }

    //! Colours say little about things whose depth is known: what is not a distance, as lightness and the textures of
    //! blocks, is weighed by how much more colour counts than depth, and is left out if it does not.
    int shareOfColor(int exponent) const
    {
        return with_depth ? exponent * (FULL_WEIGHT - beside_color) / FULL_WEIGHT : exponent;
    }

    //! Differences of colour, and textures of pixels, say more: they count in full, unless depth counts more than twice
    //! as much as colour. Where it does, shareOfColor() has left the textures of blocks out already.
    int shareOfDetails(int exponent) const
    {
        return with_depth ? exponent * std::min(2 * color_share, int(FULL_WEIGHT)) / FULL_WEIGHT : exponent;
    }

    //! Distances of four pairs of pixels, in steps.
    template <bool WITH_DEPTH> v_int32x4 between(const v_uint8x16& f, const v_uint8x16& g) const
    {
        v_uint16x8 low, high;
        v_expand(v_absdiff(f, g), low, high);
        v_int32x4 colors, depths;
        v_int32x4 first = v_setall_s32(pairOf(weights[0], 0)), second = v_setall_s32(pairOf(weights[0], 2));
        splitPairs(v_reinterpret_as_s16(low), v_reinterpret_as_s16(high), colors, depths);
        if (WITH_DEPTH)
        {
            const v_int32x4 no_depth = missingDepth(f, g);
            first = choose(no_depth, 0);
            second = choose(no_depth, 2);
        }
        return v_shr<FULL_WEIGHT_LOG2 - STEPS_PER_LEVEL_LOG2>(
                dotProduct(colors, first, dotProduct(depths, second, v_setzero_s32())));
    }

    //! The square of the distance of a pixel to a region, in squared levels. A pixel with depth is as far from a region
    //! without as from one beyond a step: else this would be the nearer one wherever a surface is not quite a plane.
    int squared(const Feature& f, const RegionMean& r) const
    {
        const short* w = weightsOf(f, r);
        return squareOf(ofColors(f, r, w) + w[3] * std::abs(STEPS_PER_LEVEL * f.depth - r.depth) +
                        stepToUnknown(f, r));
    }

    //! The same for a region with a surface: the depth of the pixel counts against the plane of the region at its
    //! place, and its normal n against that of the region; nothing of what is not known.
    int squared(const Feature& f, const Normal& n, const RegionMean& r, const SurfaceMean& s, Point p) const
    {
        const short* w = weightsOf(f, r);
        const int turned = std::abs(STEPS_PER_LEVEL * n.x - s.x) + std::abs(STEPS_PER_LEVEL * n.y - s.y);
        const int has_normal = -(int(n.known()) & int(s.known())); // all bits
        return squareOf(ofColors(f, r, w) + w[3] * std::abs(STEPS_PER_LEVEL * f.depth - s.depthAt(p.x, p.y)) +
                        ((normal_share * turned) & has_normal) + stepToUnknown(f, r));
    }

    //! The squares of four pairs at once.
    template <bool WITH_DEPTH> v_int32x4 squared(const Feature* const* f, const RegionMean* const* r) const
    {
        v_int32x4 first = v_setall_s32(pairOf(weights[0], 0)), second = v_setall_s32(pairOf(weights[0], 2));
        if (WITH_DEPTH)
            splitPairs(v_load_halves(weightsOf(*f[0], *r[0]), weightsOf(*f[1], *r[1])),
                       v_load_halves(weightsOf(*f[2], *r[2]), weightsOf(*f[3], *r[3])), first, second);
        v_int16x8 low, high;
        loadFeatures(f, low, high);
        v_int32x4 color_differences, depth_differences;
        splitPairs(gws::difference(low, v_load_halves(r[0]->color, r[1]->color)),
                   gws::difference(high, v_load_halves(r[2]->color, r[3]->color)), color_differences,
                   depth_differences);
        v_int32x4 sum = v_setzero_s32();
        if (WITH_DEPTH)
            sum = v_int32x4(stepToUnknown(*f[0], *r[0]), stepToUnknown(*f[1], *r[1]), stepToUnknown(*f[2], *r[2]),
                            stepToUnknown(*f[3], *r[3]));
        return squareOf(dotProduct(color_differences, first, dotProduct(depth_differences, second, sum)));
    }

    //! The same for regions with surfaces. x are the places of the pixels in row y. Normals n count if WITH_NORMALS.
    template <bool WITH_NORMALS>
    v_int32x4 squared(const Feature* const* f, const Normal* const* n, const RegionMean* const* r,
                      const SurfaceMean* const* s, const v_int32x4& x, int y) const
    {
        v_int16x8 low, high;
        loadFeatures(f, low, high);
        v_int32x4 colors, depths, mean_colors, mean_depths; // pairs of 16 bits; depth is the second after a colour
        splitPairs(low, high, colors, depths);
        splitPairs(v_load_halves(r[0]->color, r[1]->color), v_load_halves(r[2]->color, r[3]->color), mean_colors,
                   mean_depths);
        v_int32x4 surface = loadWords(*s[0]), normals, slopes, bases, rest;
        v_transpose4x4(surface, loadWords(*s[1]), loadWords(*s[2]), loadWords(*s[3]), normals, slopes, bases, rest);

        const v_int32x4 no_depth = missingDepth(depths, mean_depths);
        const v_int32x4 first = choose(no_depth, 0), second = choose(no_depth, 2);
        const v_int32x4 have_depth = isPositive(v_shr<16>(depths)), are_unknown = v_shr<31>(mean_depths);
        v_int32x4 sum = bitAnd(bitAnd(have_depth, are_unknown), v_setall_s32(STEP_TO_UNKNOWN * depth_share));
        mean_depths = putSecond(mean_depths, planeDepths(slopes, bases, x, y));
        if (WITH_NORMALS)
            sum = add(sum, ofNormals(n, normals));
        sum = dotProduct(difference(colors, mean_colors), first, sum);
        return squareOf(dotProduct(difference(depths, mean_depths), second, sum));
    }

    bool with_depth, with_surfaces = false;
    int color_share, depth_share, normal_share = 0;
    int beside_color; //!< weight of depth and normals together
    short weights[2][4]; //!< of a feature, without depth and with it

private:
    enum { STEP_TO_UNKNOWN = STEPS_PER_LEVEL * STEP_OF_DEPTH };

    //! Of a pixel with depth to a region without, in 1/FULL_WEIGHT of a step.
    int stepToUnknown(const Feature& f, const RegionMean& r) const
    {
        return f.depth != 0 && r.depth == RegionMean::NO_DEPTH ? STEP_TO_UNKNOWN * depth_share : 0;
    }

    //! Two of the four values of a feature, as they lie in memory.
    static int pairOf(const short* values, int first)
    {
        int pair;
        memcpy(&pair, values + first, sizeof(pair));
        return pair;
    }

    static v_int16x8 stepsOf(const v_uint16x8& levels)
    {
        return v_reinterpret_as_s16(v_shl<STEPS_PER_LEVEL_LOG2>(levels));
    }

    //! Four features, in steps.
    static void loadFeatures(const Feature* const* f, v_int16x8& low, v_int16x8& high)
    {
        v_uint16x8 low_levels, high_levels;
        v_expand(loadFour(*f[0], *f[1], *f[2], *f[3]), low_levels, high_levels);
        low = stepsOf(low_levels);
        high = stepsOf(high_levels);
    }

    //! Normal, slopes and base are the first three words.
    static v_int32x4 loadWords(const SurfaceMean& s)
    {
        return v_reinterpret_as_s32(v_load(reinterpret_cast<const uchar*>(&s)));
    }

    static v_int32x4 difference(const v_int32x4& a, const v_int32x4& b)
    {
        return v_reinterpret_as_s32(gws::difference(v_reinterpret_as_s16(a), v_reinterpret_as_s16(b)));
    }

    //! Of pairs of 16 bits.
    static v_int32x4 dotProduct(const v_int32x4& a, const v_int32x4& b, const v_int32x4& sum)
    {
        return v_dotprod(v_reinterpret_as_s16(a), v_reinterpret_as_s16(b), sum);
    }

    //! In 1/FULL_WEIGHT of a step.
    static int ofColors(const Feature& f, const RegionMean& r, const short* w)
    {
        int sum = 0;
        for (int k = 0; k < 3; k++)
            sum += w[k] * std::abs(STEPS_PER_LEVEL * f.color[k] - r.color[k]);
        return sum;
    }

    //! Of distances in 1/FULL_WEIGHT of a step, in squared levels.
    static int squareOf(int sum)
    {
        const int d = sum / FULL_WEIGHT;
        return d * d / (STEPS_PER_LEVEL * STEPS_PER_LEVEL);
    }
    //! @note Distances fit into the lower half.
    static v_int32x4 squareOf(const v_int32x4& sum)
    {
        const v_int16x8 d = v_reinterpret_as_s16(v_shr<FULL_WEIGHT_LOG2>(sum));
        return v_shr<2 * STEPS_PER_LEVEL_LOG2>(v_dotprod(d, d));
    }

    //! All bits where the second of a pair of values is missing: 0 in a feature, less in a mean.
    static v_int32x4 missingDepth(const v_int32x4& features, const v_int32x4& means)
    {
        const short SECOND[2] = { 0, 1 };
        const v_int16x8 lower = v_min(v_reinterpret_as_s16(features), v_reinterpret_as_s16(means));
        const v_int32x4 depth = v_dotprod(lower, v_reinterpret_as_s16(v_setall_s32(pairOf(SECOND, 0))));
        return v_shr<31>(subtract(depth, v_setall_s32(1)));
    }

    //! All bits where one of two features has no depth.
    static v_int32x4 missingDepth(const v_uint8x16& f, const v_uint8x16& g)
    {
        const v_uint32x4 depths = v_shr<24>(v_reinterpret_as_u32(v_min(f, g)));
        return v_shr<31>(subtract(v_reinterpret_as_s32(depths), v_setall_s32(1)));
    }

    //! A pair of weights: those without depth where it is missing.
    v_int32x4 choose(const v_int32x4& no_depth, int pair) const
    {
        const v_int16x8 with = v_reinterpret_as_s16(v_setall_s32(pairOf(weights[1], pair)));
        const v_int16x8 without = v_reinterpret_as_s16(v_setall_s32(pairOf(weights[0], pair)));
        const v_int16x8 change = v_sub_wrap(without, with);
        return v_reinterpret_as_s32(v_add_wrap(with, bitAnd(change, v_reinterpret_as_s16(no_depth))));
    }

    //! As SurfaceMean::depthAt(), of the lower four.
    static v_int16x8 planeDepths(const v_int32x4& slopes, const v_int32x4& bases, const v_int32x4& x, int y)
    {
        v_int16x8 places, rest;
        v_zip(v_pack(x, x), v_setall_s16(short(y)), places, rest);
        const v_int32x4 depths = v_dotprod(v_reinterpret_as_s16(slopes), places, bases);
        const v_int32x4 steps = v_shr<SurfaceMean::PLANE_UNIT_LOG2>(depths);
        return SurfaceMean::limit(v_pack(steps, steps));
    }

    //! Pairs with other second values.
    static v_int32x4 putSecond(const v_int32x4& pairs, const v_int16x8& values)
    {
        const short FIRST[2] = { -1, 0 };
        v_int16x8 second, rest;
        v_zip(v_setzero_s16(), values, second, rest);
        const v_int32x4 first = bitAnd(pairs, v_setall_s32(pairOf(FIRST, 0)));
        return v_reinterpret_as_s32(v_add_wrap(v_reinterpret_as_s16(first), second));
    }

    //! What normals add. Both values of one that is not known are 0.
    v_int32x4 ofNormals(const Normal* const* n, const v_int32x4& means) const
    {
        v_uint16x8 low, high;
        v_expand(loadFour(*n[0], *n[1], *n[2], *n[3]), low, high);
        v_int32x4 normals, rest;
        splitPairs(stepsOf(low), stepsOf(high), normals, rest);
        const v_int16x8 lower = v_min(v_reinterpret_as_s16(normals), v_reinterpret_as_s16(means));
        const v_int16x8 known = v_sub_wrap(v_setzero_s16(), v_min(lower, v_setall_s16(1)));
        const v_int16x8 shares = bitAnd(v_setall_s16(short(normal_share)), known);
        return v_dotprod(v_reinterpret_as_s16(difference(normals, means)), shares);
    }

    const short* weightsOf(const Feature& f, const RegionMean& r) const
    {
        return weights[(f.depth != 0) & (r.depth != RegionMean::NO_DEPTH)];
    }
};

}}} // namespace

#endif
