// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_UNION_COST_HPP
#define OPENCV_GWATERSHED_UNION_COST_HPP

#include "shared/merge_graph.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The unit of the exponents of costs.
enum { EXPONENT_ONE = 64 };

//! What makes the union of two regions expensive or cheap: the exponents of its cost, in 1/EXPONENT_ONE.
struct MergeRules
{
    int distance = 0;      //!< of the means
    int with_depth = 0;    //!< the same where there is depth
    int areas = 0;         //!< n1 n2 / (n1 + n2)
    int contrast = 0;      //!< across the common boundary
    int length = 0;        //!< of the boundary: long ones make it cheap
    int lightness = 0;     //!< a difference of it makes it cheap, because shading varies within things
    int brightness = 0;    //!< makes it cheap, because bright colours differ more
    int chroma = 0;        //!< a difference of it makes it expensive
    int texture = 0;       //!< of the smoother region makes it cheap: differences mean less there
    int direction = 0;     //!< of textures that run in different ones
    int mixed = 0;         //!< makes it cheap for a small region that is much rougher than the other one
    int slope = 0;         //!< weight: what a squared slope that both have adds to the squared distance, or takes away
    int slope_in_cell = 0; //!< the same between regions of one cell of the grid of markers, or part of a plan
    float grain = 1.5f;    //!< steps for each pixel, in levels, that are noise, and neither slope nor roughness
    float rounding = 0;    //!< differences of slopes, in levels for each pixel, that are none
    float uneven = 0;      //!< steps for each pixel, in levels, that a shade of colours has beside its slope
    float chroma_slope = 1; //!< how much more a rise of chroma is in a slope
    int roughness = 0;     //!< so much of it, in 1/64, is no slope
    float usual = 1;       //!< areas of unions, in mean areas at the end; larger ones are expensive
    int noise = 0;         //!< a squared distance that means little, in 1/64 of a squared level
    int noise_in_cell = 24; //!< the same in a cell, or part of a plan
    int in_cell = 1;       //!< so many regions of consecutive numbers share a cell of a grid
    bool on_surface = false; //!< areas are those on the surface, not in the image
    int num_kept = 0;      //!< so many regions, the first ones, stay apart rather than any others
    bool grow = false;     //!< what is united grows broader later, when boundaries are settled
};

//! For regions of pixels whose textures are measured. Found by measurement, see doc/log.md.
inline MergeRules mergeByTextures()
{
    MergeRules rules;
    rules.distance = 37;
    rules.with_depth = 56;
    rules.areas = 64;
    rules.contrast = 61;
    rules.length = 42;
    rules.lightness = 25;
    rules.brightness = 30;
    rules.chroma = 10;
    rules.texture = 75;
    rules.direction = 32;
    rules.uneven = 0.75f;
    rules.chroma_slope = 3;
    rules.slope = 4; // but none in a part of a plan: so the plan holds on a ramp, too
    rules.grain = 2.5f; // with less, two levels of noise make strips of a ramp
    rules.roughness = 64;
    rules.usual = 2.9f;
    rules.noise = 96;
    rules.noise_in_cell = 12;
    return rules;
}

//! Units of slopes in a level for each pixel; steeper ones count as the steepest.
enum { SLOPE_OF_LEVEL = 256, STEEPEST_SLOPE = 64 * SLOPE_OF_LEVEL };
//! Differences of slopes that are none where colours shade, in addition to the others; and minus that in both halves of
//! a word, for what shades.
enum { SHADE_ROUNDING = SLOPE_OF_LEVEL * 35 / 100, IS_SHADE = 0x10000 - SHADE_ROUNDING * 0x10001 };
static_assert(short(IS_SHADE & 0xFFFF) == -SHADE_ROUNDING && (IS_SHADE >> 16) == -SHADE_ROUNDING, "in both halves");

//! What the cost of a union reads of a region: two vectors of four words.
struct MergeRegion
{
    short mean[4]; //!< colour, weighted, and depth, as it is, in 1/16 of a level
    float area;
    short slope[2]; //!< of lightness across and down, or where colours shade of all channels, without signs
    short texture;  //!< logarithm of the steps of colour for each pixel
    short direction; //!< logarithm of those across over those down
    float light;    //!< sum of the lightness of its pixels, each of them 16 levels lighter than it is
    int cell;       //!< of the grid of markers, in which the region began, or the part of the plan of unions
    int rough;      //!< steps that are no slope, as far as they count, in the unit of slopes; or IS_SHADE
};
static_assert(sizeof(MergeRegion) == 32, "it is read as two vectors");

//! Logarithms to the base 2 are in 1/LOG_ONE, and linear between the powers of two. The bits of a float are just that:
//! its exponent, plus 127, with 23 bits behind the point.
enum { LOG_ONE_LOG2 = 8, LOG_ONE = 1 << LOG_ONE_LOG2, LOG_SHIFT = 23 - LOG_ONE_LOG2, LOG_BIAS = 127 * LOG_ONE };

//! For value >= 1.
inline int logarithm(float value)
{
    Cv32suf bits;
    bits.f = value;
    return (bits.i >> LOG_SHIFT) - LOG_BIAS;
}

struct FourRegions;

//! The cost of a union: a product of powers, as the sum of logarithms. Exponents are factors then, and there are no
//! roots and no divisions. With d the distance of the means, n the areas, h the mean contrast across the boundary, l
//! its length, L the lightness of the means, m that of the union, C their distance in the two other channels, and a and
//! b the steps across and down of a RegionTexture, for each pixel of the region:
//!     (d^2 + slope e + noise)^distance (n1 n2 / (n1 + n2))^areas (h + 1)^contrast (l / root of the smaller n)^-length
//!     (|L1 - L2| + 1)^-lightness (m + 16)^-brightness (C + 1)^chroma
//!     (smaller a + b + 1)^-texture (larger r / smaller r)^direction,   r = (a + 0.5) / (b + 0.5)
//!     max(1, (n1 + n2) s / usual area)^32,   s = root of max(1, root of the smaller n / l)
//!     max(1, min((larger a + b + 1) / (smaller a + b + 1), usual area / smaller n) / 5)^-mixed
//! e is what a slope that both regions are parts of explains of d^2: with g the mean rises of lightness across and
//! down, half of those from one element to the next, and q = roughness * max(0, a + b - |gx| - |gy| - grain), the steps
//! that are no slope, it is
//!     e = (smaller g^2 - t^2 - (larger q)^2) * smaller n,   not below 0,   t = max(0, |g1 - g2| - rounding)
//! Of blocks, q^2 is more by how unlike their rises of lightness are: the mean of their squares less g^2, less a
//! squared third of a level. On a slope all of them rise alike, at an edge a few rise much.
//! Colours shade where chroma rises by a tenth of a level to three levels, and a + b is hardly more than the rises of
//! all channels, by `uneven` and a twentieth of those of chroma. Then g is, across and down, the root of the squares of
//! all rises, those of chroma times `chroma_slope`; q is 0, and between two such regions more of |g1 - g2| is rounding.
//! At a blurred edge colours shade, too, so e is 0 there if it explains less than an eighth of d^2.
//! A weight below 0 takes it from d^2, so that parts of a shaded area unite in all directions; one above 0 adds it, so
//! that all of them differ as much as in the direction of the slope. Without it, superpixels of a ramp would be strips.
//! Parts of a plan are compact as they are, so no slope need count inside of them.
//! With exponents of 1, the first two factors would be Ward's criterion; the noise lets small regions go first where
//! colours are equal, and is less in a cell of the grid of markers or a part of a plan. Between rough regions, the same
//! differences mean less. Without the limit of areas, what holds both colours of a pattern is nearer to all around it
//! than these are to each other, and takes in one after the other. Where regions grow later, s makes strips that meet
//! end to end too large earlier, because one of single blocks may become twice as broad; else it is 1. The last factor
//! lets go what is made of blocks astride of an edge: its colour is that of no thing, and a sliver would be left of it.
//! Texture that is not measured is none. The cost is the same for both orders of the regions.
class UnionCost
{
public:
    //! `surfaces` are read if the distance has surfaces.
    UnionCost(const RegionDistance& distance, const MergeRules& rules, const MergeRegion* records,
              const SurfaceMean* surfaces, int log_usual_area);

    //! Finds the costs of the edges from one on.
    void find(EdgeList& list, size_t first) const;

private:
    void findFour(MergeEdge* edges) const;
    v_int32x4 mixtureOf(const v_int16x8& textures, const v_int16x8& others, const v_int32x4& smaller_area) const;
    v_int32x4 addDepth(const v_int32x4& of_colors, const FourRegions& a, const FourRegions& b,
                       const MergeRegion* const* first, const MergeRegion* const* second) const;

    v_int32x4 ofSlopes(const FourRegions& a, const FourRegions& b, const v_int32x4& share_a_cell,
                       const v_int32x4& squared_distance) const;

    const RegionDistance distance_;
    const MergeRegion* const records_;
    const SurfaceMean* const surfaces_;
    v_int32x4 noise_, noise_in_cell_;
    v_float32x4 slope_, slope_in_cell_; // of a squared slope, to a squared distance
    v_int16x8 rounding_; // of slopes
    v_int32x4 log_usual_area_; // above it, unions are expensive
    v_int32x4 if_they_grow_;   // all bits, or none
    v_int32x4 light_level_;    // 1 level of lightness, as means have it
    v_int16x8 distance_and_excess_, areas_and_contrast_, length_and_lightness_, brightness_and_chroma_,
            texture_and_direction_, mixed_; // exponents
};

}}} // namespace

#endif
