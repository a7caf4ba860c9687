// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/union_cost.hpp"

namespace cv { namespace ximgproc { namespace gws {

// The noise between regions of the same cell of the grid of markers, in 1/64 of a squared level. So these are united
// first where colours are even, and superpixels are the cells of the grid there.
enum { NOISE_IN_CELL = 24 };

enum { EXCESS = 32 * 64 }; // exponent of the area of a union beyond the usual, in 1/64

//! Of weighted means, in 1/256 of a squared level.
static inline int squaredDistance(const short* a, const short* b)
{
    const int d0 = a[0] - b[0], d1 = a[1] - b[1], d2 = a[2] - b[2];
    return d0 * d0 + d1 * d1 + d2 * d2;
}

//! The same with depth, which some may not have, with the weights of the flood.
static int squaredDistance(const RegionDistance& distance, const short* a, const short* b)
{
    const int sum = squaredDistance(a, b);
    if (a[3] == RegionMean::NO_DEPTH || b[3] == RegionMean::NO_DEPTH)
        return sum;
    const int depth = (distance.depth_share * (a[3] - b[3])) >> 8;
    return int((int64(sum) * distance.color_share * distance.color_share) >> 16) + depth * depth;
}

//! How far the centre of a region is from the plane of another one, in depth.
static int depthBetween(const SurfaceMean& plane, const SurfaceMean& other, int other_depth)
{
    return std::abs(plane.depthAtCenter(other.center) - other_depth);
}

//! The same with surfaces. Of the two planes the one counts that holds the other region better: that of a small region
//! may be wrong.
static int squaredDistance(const RegionDistance& distance, const short* a, const short* b, const SurfaceMean& surface_a,
                           const SurfaceMean& surface_b)
{
    if (a[3] == RegionMean::NO_DEPTH || b[3] == RegionMean::NO_DEPTH)
        return squaredDistance(a, b);
    const int step = std::min(depthBetween(surface_a, surface_b, b[3]), depthBetween(surface_b, surface_a, a[3]));
    const int depth = (distance.depth_share * step) >> 8;
    const int share = surface_a.known() && surface_b.known() ? distance.normal_share : 0;
    const int x = (share * (surface_a.x - surface_b.x)) >> 8, y = (share * (surface_a.y - surface_b.y)) >> 8;
    const int color = int((int64(squaredDistance(a, b)) * distance.color_share * distance.color_share) >> 16);
    return color + depth * depth + x * x + y * y;
}

int UnionCost::distanceWithDepth(const MergeRegion& a, const MergeRegion& b) const
{
    return distance_.with_surfaces
            ? squaredDistance(distance_, a.mean, b.mean, surfaces_[a.index], surfaces_[b.index])
            : squaredDistance(distance_, a.mean, b.mean);
}

//! The words of four records: one vector for each.
struct FourRegions
{
    explicit FourRegions(const MergeRegion* const* regions)
    {
        v_int32x4 words[4];
        for (int k = 0; k < 4; k++)
            words[k] = v_reinterpret_as_s32(v_load(regions[k]->mean));
        v_transpose4x4(words[0], words[1], words[2], words[3], first_means, last_mean, area, log_area);
        for (int k = 0; k < 4; k++)
            words[k] = v_reinterpret_as_s32(v_load(&regions[k]->texture));
        v_transpose4x4(words[0], words[1], words[2], words[3], textures, light, cell, index);
    }

    v_int32x4 first_means, last_mean, textures; // pairs of 16 bits
    v_int32x4 area, log_area, light, cell, index;
};

static inline v_int32x4 logarithm(const v_float32x4& values)
{
    return subtract(v_shr<15>(v_reinterpret_as_s32(values)), v_setall_s32(127 << 8));
}

static inline v_int32x4 logarithm(const v_int32x4& values) { return logarithm(v_cvt_f32(values)); }

static inline v_float32x4 sumOf(const v_int32x4& a, const v_int32x4& b)
{
    return add(v_reinterpret_as_f32(a), v_reinterpret_as_f32(b));
}

static inline v_int16x8 lowerHalves(const v_int32x4& pairs)
{
    return v_reinterpret_as_s16(bitAnd(pairs, v_setall_s32(0xFFFF)));
}

//! Of numbers that fit into 16 bits.
static inline v_int16x8 makePairs(const v_int32x4& lower, const v_int32x4& upper)
{
    return v_add_wrap(lowerHalves(lower), v_reinterpret_as_s16(v_shl<16>(upper)));
}

//! The same pair four times.
static inline v_int16x8 makePairs(int lower, int upper)
{
    return makePairs(v_setall_s32(lower), v_setall_s32(upper));
}

static inline v_int32x4 weigh(const v_int32x4& a, const v_int32x4& b, const v_int16x8& exponents, const v_int32x4& sum)
{
    return v_dotprod(makePairs(a, b), exponents, sum);
}

//! @note Sums are those of integers: compilers may round a product and a sum of floats once or twice.
void UnionCost::findFour(MergeEdge* edges) const
{
    const MergeRegion *first[4], *second[4];
    int distances[4], costs[4];
    float contrasts[4];
    for (int k = 0; k < 4; k++)
    {
        first[k] = records_ + edges[k].a;
        second[k] = records_ + edges[k].b;
        contrasts[k] = float(edges[k].contrast + STEPS_PER_LEVEL * int64(edges[k].length));
        if (distance_.with_depth)
            distances[k] = distanceWithDepth(*first[k], *second[k]);
    }
    const FourRegions a(first), b(second);
    const v_int16x8 differences = v_sub_wrap(v_reinterpret_as_s16(a.first_means), v_reinterpret_as_s16(b.first_means));
    const v_int16x8 last_differences = v_sub_wrap(lowerHalves(a.last_mean), lowerHalves(b.last_mean));
    const v_int32x4 squared_distance = distance_.with_depth
            ? v_load(distances)
            : v_dotprod(differences, differences, v_dotprod(last_differences, last_differences));
    const v_int32x4 steps = v_reinterpret_as_s32(v_abs(differences)); // of two channels in a word
    const v_int32x4 last_steps = v_reinterpret_as_s32(v_abs(last_differences));
    const v_int16x8 textures = v_reinterpret_as_s16(a.textures), other_textures = v_reinterpret_as_s16(b.textures);
    const v_int32x4 smoother = v_reinterpret_as_s32(v_min(textures, other_textures));
    const v_int32x4 turn = v_shr<16>(v_reinterpret_as_s32(v_abs(v_sub_wrap(textures, other_textures))));

    const v_int32x4 zero = v_setzero_s32();
    const v_int32x4 length = logarithm(v_int32x4(edges[0].length, edges[1].length, edges[2].length, edges[3].length));
    const v_int32x4 log_union = logarithm(sumOf(a.area, b.area));
    const v_int32x4 relative_length = subtract(length, v_shr<1>(v_min(a.log_area, b.log_area)));
    const v_int32x4 compactness = bitAnd(v_min(v_shr<1>(relative_length), zero), if_they_grow_);
    const v_int32x4 excess = v_max(subtract(subtract(log_union, compactness), log_usual_area_), zero);
    const v_int32x4 noise = v_select(equal(a.cell, b.cell), noise_in_cell_, noise_);
    const v_int32x4 distance = logarithm(add(squared_distance, noise));
    const v_int32x4 areas = subtract(add(a.log_area, b.log_area), log_union);
    const v_int32x4 contrast = subtract(logarithm(v_load(contrasts)), length);
    const v_int32x4 lightness = logarithm(add(v_reinterpret_as_s32(lowerHalves(steps)), light_level_));
    const v_int32x4 chroma = logarithm(add(add(v_shr<16>(steps), last_steps), v_setall_s32(STEPS_PER_LEVEL)));
    const v_int32x4 brightness = subtract(logarithm(sumOf(a.light, b.light)), log_union);

    v_int32x4 cost = weigh(distance, excess, distance_and_excess_, zero);
    cost = weigh(areas, contrast, areas_and_contrast_, cost);
    cost = weigh(relative_length, lightness, length_and_lightness_, cost);
    cost = weigh(brightness, chroma, brightness_and_chroma_, cost);
    cost = weigh(smoother, turn, texture_and_direction_, cost);
    v_store(costs, cost);
    for (int k = 0; k < 4; k++)
        edges[k].cost = costs[k];
}

//! Lightness says little about things whose depth is known: its terms count as much as colour counts more than depth.
static int weighLightness(int exponent, const RegionDistance& distance)
{
    return distance.with_depth ? exponent * (FULL_WEIGHT - distance.beside_color) / FULL_WEIGHT : exponent;
}

UnionCost::UnionCost(const RegionDistance& distance, const MergeRules& rules, const MergeRegion* records,
                     const SurfaceMean* surfaces, int log_usual_area)
    : distance_(distance), records_(records), surfaces_(surfaces),
      noise_(v_setall_s32(4 * rules.noise)), noise_in_cell_(v_setall_s32(4 * NOISE_IN_CELL)),
      log_usual_area_(v_setall_s32(log_usual_area)), if_they_grow_(v_setall_s32(-int(rules.grow))),
      light_level_(v_setall_s32((distance.weights[0][0] * STEPS_PER_LEVEL) / FULL_WEIGHT)),
      distance_and_excess_(makePairs(distance.with_depth ? rules.with_depth : rules.distance, EXCESS)),
      areas_and_contrast_(makePairs(rules.areas, rules.contrast)),
      length_and_lightness_(makePairs(-rules.length, -weighLightness(rules.lightness, distance))),
      brightness_and_chroma_(makePairs(-weighLightness(rules.brightness, distance), rules.chroma)),
      texture_and_direction_(makePairs(-rules.texture, rules.direction))
{
}

void UnionCost::find(EdgeList& list, size_t first) const
{
    const size_t rest = (list.count - first) % 4, last = list.count - rest;
    for (size_t i = first; i < last; i += 4)
        findFour(&list.edges[i]);
    if (rest == 0)
        return;
    MergeEdge edges[4];
    for (size_t k = 0; k < 4; k++)
        edges[k] = list.edges[last + std::min(k, rest - 1)];
    findFour(edges);
    std::copy(edges, edges + rest, &list.edges[last]);
}

}}} // namespace
