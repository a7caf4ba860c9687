// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/union_cost.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { MOST_OF_SHADE = 8 }; // a squared distance of shades above so many times what their slope explains is an edge
enum { LAST = 32 * EXPONENT_ONE * LOG_ONE }; // what a union that is too large costs more: a factor of 2^32
enum { EXCESS = 32 * EXPONENT_ONE }; // exponent of the area of a union beyond the usual

//! The words of four records: one vector for each.
struct FourRegions
{
    explicit FourRegions(const MergeRegion* const* regions_) : regions(regions_)
    {
        v_int32x4 words[4], areas, lights;
        const auto load = [&](int k, int half)
        {
            return v_reinterpret_as_s32(v_load(reinterpret_cast<const uchar*>(regions[k]) + 16 * half));
        };
        for (int k = 0; k < 4; k++)
            words[k] = load(k, 0);
        v_transpose4x4(words[0], words[1], words[2], words[3], first_means, last_mean, areas, slopes);
        for (int k = 0; k < 4; k++)
            words[k] = load(k, 1);
        v_transpose4x4(words[0], words[1], words[2], words[3], textures, lights, cell, rough);
        area = v_reinterpret_as_f32(areas);
        light = v_reinterpret_as_f32(lights);
    }

    const MergeRegion* const* regions;
    v_int32x4 first_means, last_mean, slopes, textures; // pairs of 16 bits
    v_int32x4 cell, rough;
    v_float32x4 area, light;
};

static inline v_int32x4 logarithm(const v_float32x4& values)
{
    return subtract(v_shr<LOG_SHIFT>(v_reinterpret_as_s32(values)), v_setall_s32(LOG_BIAS));
}

static inline v_int32x4 logarithm(const v_int32x4& values) { return logarithm(v_cvt_f32(values)); }

//! Logarithms of the areas of four pairs of regions.
struct FourAreas
{
    FourAreas(const FourRegions& a, const FourRegions& b)
        : both(logarithm(add(a.area, b.area)))
    {
        const v_int32x4 first = logarithm(a.area), second = logarithm(b.area);
        smaller = v_min(first, second);
        product = subtract(add(first, second), both);
    }

    v_int32x4 both;    // n1 + n2
    v_int32x4 product; // n1 n2 / (n1 + n2)
    v_int32x4 smaller; // of n1 and n2
};

//! The same pair four times.
static inline v_int16x8 makePairs(int lower, int upper)
{
    return makePairs(v_setall_s32(lower), v_setall_s32(upper));
}

static inline v_int32x4 weigh(const v_int32x4& a, const v_int32x4& b, const v_int16x8& exponents, const v_int32x4& sum)
{
    return v_dotprod(makePairs(a, b), exponents, sum);
}

namespace {

//! The surfaces of four regions.
struct FourSurfaces
{
    FourSurfaces(const SurfaceMean* surfaces, const MergeRegion* records, const MergeRegion* const* regions)
    {
        v_int32x4 words[4], base;
        int y[4];
        for (int k = 0; k < 4; k++)
        {
            const SurfaceMean& surface = surfaces[regions[k] - records];
            words[k] = v_reinterpret_as_s32(v_load(reinterpret_cast<const uchar*>(&surface))); // up to x of the centre
            y[k] = surface.center.y;
        }
        v_transpose4x4(words[0], words[1], words[2], words[3], normals, slopes, base, center_x);
        center_y = v_load(y);
    }

    v_int32x4 normals, slopes; // pairs of 16 bits
    v_int32x4 center_x, center_y;
};

} // namespace

//! How far centres are from planes of others, in depth. Of two planes the one counts that holds the other region
//! better: that of a small region may be wrong.
static v_int32x4 depthBetween(const FourSurfaces& a, const FourSurfaces& b, const v_int32x4& depth_a,
                              const v_int32x4& depth_b)
{
    const v_int32x4 x = subtract(b.center_x, a.center_x), y = subtract(b.center_y, a.center_y);
    v_int16x8 away, rest; // farther than 2047 elements is as far as that
    v_zip(v_pack(x, x), v_pack(y, y), away, rest);
    const int UNIT_LOG2 = SurfaceMean::PLANE_UNIT_LOG2 + SurfaceMean::CENTER_UNIT_LOG2;
    const v_int32x4 rise = v_shr<UNIT_LOG2>(v_dotprod(v_reinterpret_as_s16(a.slopes), away)); // of a to b
    const v_int32x4 fall = v_shr<UNIT_LOG2>(v_dotprod(v_reinterpret_as_s16(b.slopes), away)); // of b to a
    const v_int16x8 depths = SurfaceMean::limit(v_pack(add(depth_a, rise), subtract(depth_b, fall)));
    const v_uint16x8 steps = v_absdiff(depths, v_pack(depth_b, depth_a));
    v_uint32x4 nearest, others;
    v_expand(v_min(steps, v_extract<4>(steps, steps)), nearest, others);
    return v_reinterpret_as_s32(nearest);
}

//! The squared differences of normals with a weight, where both are known.
static v_int32x4 squaredTurn(const v_int32x4& a, const v_int32x4& b, int share)
{
    const v_int16x8 first = v_reinterpret_as_s16(a), second = v_reinterpret_as_s16(b);
    const v_int16x8 known = v_sub_wrap(v_setzero_s16(), v_min(v_min(first, second), v_setall_s16(1)));
    const v_int16x8 turn = bitAnd(v_sub_wrap(first, second), known);
    const v_int32x4 x = v_dotprod(turn, makePairs(share, 0)), y = v_dotprod(turn, makePairs(0, share));
    const v_int16x8 weighted = makePairs(v_shr<FULL_WEIGHT_LOG2>(x), v_shr<FULL_WEIGHT_LOG2>(y));
    return v_dotprod(weighted, weighted);
}

//! From squared distances of colours those with depth, which some may not have, and surfaces, with the weights of the
//! flood. In 1/256 of a squared level.
v_int32x4 UnionCost::addDepth(const v_int32x4& of_colors, const FourRegions& a, const FourRegions& b) const
{
    const v_int32x4 depth_a = v_shr<16>(a.last_mean), depth_b = v_shr<16>(b.last_mean);
    const float share = float(distance_.color_share) / FULL_WEIGHT;
    v_int32x4 sum = v_trunc(multiply(v_cvt_f32(of_colors), v_setall_f32(share * share))), step;
    if (distance_.with_surfaces)
    {
        const FourSurfaces surface_a(surfaces_, records_, a.regions), surface_b(surfaces_, records_, b.regions);
        step = depthBetween(surface_a, surface_b, depth_a, depth_b);
        sum = add(sum, squaredTurn(surface_a.normals, surface_b.normals, distance_.normal_share));
    }
    else
        step = v_reinterpret_as_s32(v_absdiff(depth_a, depth_b));
    const v_int32x4 weighted = v_dotprod(lowerHalves(step), makePairs(distance_.depth_share, 0));
    const v_int32x4 depth = v_shr<FULL_WEIGHT_LOG2>(weighted);
    sum = v_dotprod(lowerHalves(depth), lowerHalves(depth), sum);
    const v_int32x4 missing = v_shr<31>(v_min(depth_a, depth_b)); // all bits
    return add(sum, bitAnd(subtract(of_colors, sum), missing));
}

//! What a slope that both regions are parts of explains of their squared distance, as far as it counts. Where it rises,
//! regions beside each other differ by as much as it does from one centre to the next, and across it they do not.
//! Shades of colour that differ by much more are no slope, but lie at an edge.
v_int32x4 UnionCost::ofSlopes(const FourRegions& a, const FourRegions& b, const v_int32x4& share_a_cell,
                              const v_int32x4& squared_distance) const
{
    const v_int16x8 slope_a = v_reinterpret_as_s16(a.slopes), slope_b = v_reinterpret_as_s16(b.slopes);
    const v_uint16x8 difference = v_min(v_absdiff(slope_a, slope_b), v_setall_u16(STEEPEST_SLOPE));
    const v_int32x4 zero = v_setzero_s32(), roughness = v_max(a.rough, b.rough), of_shades = v_min(roughness, zero);
    const v_int16x8 rounding = v_sub_wrap(rounding_, v_reinterpret_as_s16(of_shades));
    const v_int16x8 turn = v_max(v_sub_wrap(v_reinterpret_as_s16(difference), rounding), v_setzero_s16());
    const v_int16x8 rough = v_reinterpret_as_s16(v_max(roughness, zero));
    const v_int32x4 smaller = v_min(v_dotprod(slope_a, slope_a), v_dotprod(slope_b, slope_b));
    const v_int32x4 not_common = add(v_dotprod(turn, turn), v_dotprod(rough, rough));
    const v_float32x4 common = v_cvt_f32(v_max(subtract(smaller, not_common), zero));
    const v_float32x4 explained = v_min(multiply(common, v_min(a.area, b.area)), v_setall_f32(1e9f));
    const v_int32x4 most = v_trunc(multiply(explained, v_setall_f32(float(MOST_OF_SHADE) / 256)));
    const v_int32x4 is_edge = v_shr<31>(bitAnd(subtract(most, squared_distance), roughness));
    const v_float32x4 weight = v_select(v_reinterpret_as_f32(share_a_cell), slope_in_cell_, slope_);
    return v_select(is_edge, zero, v_trunc(multiply(explained, weight)));
}

//! How much more than five times as rough one of two regions is as the other one, as far as it is smaller than a fifth
//! of the usual area.
v_int32x4 UnionCost::mixtureOf(const v_int16x8& textures, const v_int16x8& others, const v_int32x4& smaller_area) const
{
    const int FIVE = 594; // its logarithm
    const v_int16x8 rougher = v_sub_wrap(v_max(textures, others), v_min(textures, others));
    const v_int32x4 roughness = v_reinterpret_as_s32(lowerHalves(v_reinterpret_as_s32(rougher)));
    const v_int32x4 smallness = subtract(log_usual_area_, smaller_area);
    return v_max(v_min(subtract(roughness, v_setall_s32(FIVE)), subtract(smallness, v_setall_s32(FIVE))),
                 v_setzero_s32());
}

//! What colours and textures that have spread add. Slopes explain as much of their distance.
v_int32x4 UnionCost::addContexts(const MergeEdge* e, const v_int32x4& slopes, const v_int32x4& noise,
                                 const v_int32x4& sum) const
{
    const auto of = [&](int a, int b) { return v_load_halves(contexts_[a].color, contexts_[b].color); };
    v_int32x4 first, last; // the last pairs have the textures in their upper halves
    splitPairs(v_sub_wrap(of(e[0].a, e[1].a), of(e[0].b, e[1].b)), v_sub_wrap(of(e[2].a, e[3].a), of(e[2].b, e[3].b)),
               first, last);
    const v_int16x8 of_first = v_reinterpret_as_s16(first), of_last = lowerHalves(last);
    const v_int32x4 squared = v_dotprod(of_first, of_first, v_dotprod(of_last, of_last));
    const v_int32x4 distance = logarithm(add(v_max(add(squared, slopes), v_setzero_s32()), noise));
    const v_int32x4 of_textures = v_reinterpret_as_s32(v_abs(v_shr<16>(last)));
    return weigh(distance, logarithm(add(of_textures, v_setall_s32(LOG_ONE / 10))), spread_, sum);
}

//! What colours add to the cost, and depths and surfaces with them.
v_int32x4 UnionCost::addColors(const MergeEdge* edges, const FourRegions& a, const FourRegions& b,
                               const FourAreas& areas, const v_int32x4& sum) const
{
    const v_int32x4 zero = v_setzero_s32();
    const v_int16x8 differences = v_sub_wrap(v_reinterpret_as_s16(a.first_means), v_reinterpret_as_s16(b.first_means));
    const v_int16x8 last_differences = v_sub_wrap(lowerHalves(a.last_mean), lowerHalves(b.last_mean));
    v_int32x4 squared_distance = v_dotprod(differences, differences, v_dotprod(last_differences, last_differences));
    if (distance_.with_depth)
        squared_distance = addDepth(squared_distance, a, b);
    const v_int32x4 share_a_cell = equal(a.cell, b.cell); // all bits, or none
    const v_int32x4 slopes = ofSlopes(a, b, share_a_cell, squared_distance);
    const v_int32x4 noise = v_select(share_a_cell, noise_in_cell_, noise_);
    const v_int32x4 distance = logarithm(add(v_max(add(squared_distance, slopes), zero), noise));
    const v_int32x4 with_contexts = contexts_ ? addContexts(edges, slopes, noise, sum) : sum;

    const v_int32x4 steps = v_reinterpret_as_s32(v_abs(differences)); // of two channels in a word
    const v_int32x4 last_steps = v_reinterpret_as_s32(v_abs(last_differences));
    const v_int32x4 lightness = logarithm(add(v_reinterpret_as_s32(lowerHalves(steps)), light_level_));
    const v_int32x4 chroma = logarithm(add(add(v_shr<16>(steps), last_steps), v_setall_s32(STEPS_PER_LEVEL)));
    const v_int32x4 brightness = subtract(logarithm(add(a.light, b.light)), areas.both);
    return weigh(brightness, chroma, brightness_and_chroma_,
                 weigh(distance, lightness, distance_and_lightness_, with_contexts));
}

//! What areas and the common boundary add.
v_int32x4 UnionCost::addShapes(const MergeEdge* edges, const FourAreas& areas, const v_int32x4& sum) const
{
    const v_int32x4 zero = v_setzero_s32();
    float contrasts[4];
    for (int k = 0; k < 4; k++)
        contrasts[k] = float(edges[k].contrast + STEPS_PER_LEVEL * int64(edges[k].length));
    const v_int32x4 length = logarithm(v_int32x4(edges[0].length, edges[1].length, edges[2].length, edges[3].length));
    const v_int32x4 contrast = subtract(logarithm(v_load(contrasts)), length);
    const v_int32x4 relative_length = subtract(length, v_shr<1>(areas.smaller));
    const v_int32x4 compactness = bitAnd(v_min(v_shr<1>(relative_length), zero), if_they_grow_);
    const v_int32x4 excess = v_max(subtract(subtract(areas.both, compactness), log_usual_area_), zero);
    const v_int32x4 comes_last = v_shr<31>(subtract(log_most_area_, areas.both)); // all bits, or none
    const v_int32x4 with_last = add(sum, bitAnd(comes_last, v_setall_s32(LAST)));
    return weigh(relative_length, contrast, length_and_contrast_,
                 weigh(areas.product, excess, areas_and_excess_, with_last));
}

//! What textures add.
v_int32x4 UnionCost::addTextures(const FourRegions& a, const FourRegions& b, const FourAreas& areas,
                                 const v_int32x4& sum) const
{
    const v_int16x8 textures = v_reinterpret_as_s16(a.textures), others = v_reinterpret_as_s16(b.textures);
    const v_int32x4 smoother = v_reinterpret_as_s32(v_min(textures, others));
    const v_int32x4 turn = v_shr<16>(v_reinterpret_as_s32(v_abs(v_sub_wrap(textures, others))));
    const v_int32x4 mixture = mixtureOf(textures, others, areas.smaller);
    return weigh(mixture, v_setzero_s32(), mixed_, weigh(smoother, turn, texture_and_direction_, sum));
}

//! @note Sums are those of integers: compilers may round a product and a sum of floats once or twice.
void UnionCost::findFour(MergeEdge* edges) const
{
    const MergeRegion *first[4], *second[4];
    for (int k = 0; k < 4; k++)
    {
        first[k] = records_ + edges[k].a;
        second[k] = records_ + edges[k].b;
    }
    const FourRegions a(first), b(second);
    const FourAreas areas(a, b);
    int costs[4];
    v_store(costs, addTextures(a, b, areas, addShapes(edges, areas, addColors(edges, a, b, areas, v_setzero_s32()))));
    for (int k = 0; k < 4; k++)
        edges[k].cost = costs[k];
}

UnionCost::UnionCost(const RegionDistance& distance, const MergeRules& rules, const MergeRegion* records,
                     const MergeContext* contexts, const SurfaceMean* surfaces, int log_usual_area,
                     int log_most_area)
    : distance_(distance), records_(records), contexts_(contexts), surfaces_(surfaces),
      noise_(v_setall_s32(4 * rules.noise)), noise_in_cell_(v_setall_s32(4 * rules.noise_in_cell)),
      slope_(v_setall_f32(float(distance.shareOfColor(rules.slope)) / 256)),
      slope_in_cell_(v_setall_f32(float(distance.shareOfColor(rules.slope_in_cell)) / 256)),
      rounding_(v_setall_s16(short(cvRound(rules.rounding * float(SLOPE_OF_LEVEL))))),
      log_usual_area_(v_setall_s32(log_usual_area)), log_most_area_(v_setall_s32(log_most_area)),
      if_they_grow_(v_setall_s32(-int(rules.grow))),
      light_level_(v_setall_s32((distance.weights[0][0] * STEPS_PER_LEVEL) / FULL_WEIGHT)),
      distance_and_lightness_(makePairs(distance.with_depth ? rules.with_depth : rules.distance,
                                        -distance.shareOfColor(rules.lightness))),
      brightness_and_chroma_(makePairs(-distance.shareOfColor(rules.brightness),
                                       distance.shareOfDetails(rules.chroma))),
      areas_and_excess_(makePairs(rules.areas, EXCESS)),
      length_and_contrast_(makePairs(-rules.length, rules.contrast)),
      texture_and_direction_(makePairs(-distance.shareOfDetails(rules.texture),
                                       distance.shareOfDetails(rules.direction))),
      mixed_(makePairs(-distance.shareOfDetails(rules.mixed), 0)),
      spread_(makePairs(rules.spread, rules.spread_texture))
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
