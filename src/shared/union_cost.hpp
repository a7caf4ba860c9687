// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_UNION_COST_HPP
#define OPENCV_GWATERSHED_UNION_COST_HPP

#include "shared/merge_context.hpp"
#include "shared/merge_graph.hpp"
#include "shared/merge_region.hpp"

namespace cv { namespace ximgproc { namespace gws {

struct FourAreas;
struct FourRegions;

//! The cost of a union: the sum of the logarithms of these factors, each times the exponent that MergeRules has under
//! its name. So there are no powers, roots and divisions. It is the same for both orders of the regions.
//!     factor                                  exponent     with
//!     d^2 + slope e + noise                   distance     d the distance of the means
//!     n1 n2 / (n1 + n2)                       areas        n the areas; the first two are Ward's cost if these are 1
//!     h + 1                                   contrast     h the mean contrast across the boundary
//!     l / root of the smaller n               -length      l the length of the boundary
//!     |L1 - L2| + 1                           -lightness   L the lightness of the means
//!     m + 16                                  -brightness  m the lightness of the mean of the union
//!     C + 1                                   chroma       C the distance of the means in the two other channels
//!     smaller T                               -texture     T = a + b + 1, a and b the steps across and down of a
//!     larger r / smaller r                    direction    RegionTexture for each pixel; r = (a + 0.5) / (b + 0.5)
//!     c^2 + slope e + noise                   spread       c the distance of colours that have spread (MergeContexts)
//!     |log2 U1 - log2 U2| + 0.1               spread_texture   U the textures T that have spread
//!     max(1, s (n1 + n2) / usual area)        32           s = root of max(1, root of the smaller n / l), or 1
//!     max(1, min(larger T / smaller T, usual area / smaller n) / 5)   -mixed
//!     e = max(0, smaller g^2 - t^2 - larger q^2) * smaller n: what a slope that both are parts of explains of d^2
//!     g  mean rises of lightness across and down, half of those from one element to the next
//!     t  max(0, |g1 - g2| - rounding)
//!     q  roughness * max(0, a + b - |gx| - |gy| - grain), steps that are no slope; of blocks, q^2 is more by the mean
//!        of the squares of their rises less g^2, less a squared third of a level: at an edge a few rise much
//! A union above 4 mean areas of all that are left is dearer by 2^32, so that it is done if there is no other.
//! Noise lets small regions go first where colours are equal; it is less in a cell of the grid of markers or a part of
//! a plan. Between rough regions, differences mean less; texture that is not measured is none. Without the limit of
//! areas, a region with both colours of a pattern, nearer to all around it than these to each other, would take in one
//! after the other. s is more than 1 only where regions grow later, for strips that meet end to end: they may become
//! twice as broad. `mixed` lets go what is made of blocks astride of an edge, or a sliver would be left of it.
//! slope < 0 lets parts of a shaded area unite in all directions; > 0 keeps a ramp from becoming strips, as all of them
//! differ like those along the slope. Parts of a plan are compact without it. Colours shade where chroma rises by 0.1
//! to 3 levels, and a + b is at most the rises of all channels, `uneven` and a twentieth of those of chroma. Then g is
//! the root of their squares, chroma times `chroma_slope`, and q is 0; between two such regions more of |g1 - g2| is
//! rounding, and e is 0 if it explains less than an eighth of d^2, as at a blurred edge. In noise colours shade where
//! the rises of blocks are less unlike than those of chroma are high, and g is less by that part of their square.
class UnionCost
{
public:
    //! `surfaces` are read if the distance has surfaces. `contexts` are null if they do not count.
    UnionCost(const RegionDistance& distance, const MergeRules& rules, const MergeRegion* records,
              const MergeContext* contexts, const SurfaceMean* surfaces, int log_usual_area,
              int log_most_area);

    //! Finds the costs of the edges from one on.
    void find(EdgeList& list, size_t first) const;

private:
    void findFour(MergeEdge* edges) const;
    v_int32x4 addColors(const MergeEdge* edges, const FourRegions& a, const FourRegions& b, const FourAreas& areas,
                        const v_int32x4& sum) const;
    v_int32x4 addShapes(const MergeEdge* edges, const FourAreas& areas, const v_int32x4& sum) const;
    v_int32x4 addTextures(const FourRegions& a, const FourRegions& b, const FourAreas& areas,
                          const v_int32x4& sum) const;
    v_int32x4 addContexts(const MergeEdge* edges, const v_int32x4& slopes, const v_int32x4& noise,
                          const v_int32x4& sum) const;
    v_int32x4 addDepth(const v_int32x4& of_colors, const FourRegions& a, const FourRegions& b) const;
    v_int32x4 ofSlopes(const FourRegions& a, const FourRegions& b, const v_int32x4& share_a_cell,
                       const v_int32x4& squared_distance) const;
    v_int32x4 mixtureOf(const v_int16x8& textures, const v_int16x8& others, const v_int32x4& smaller_area) const;

    const RegionDistance distance_;
    const MergeRegion* const records_;
    const MergeContext* const contexts_; // or null
    const SurfaceMean* const surfaces_;
    v_int32x4 noise_, noise_in_cell_;
    v_float32x4 slope_, slope_in_cell_; // of a squared slope, to a squared distance
    v_int16x8 rounding_; // of slopes
    v_int32x4 log_usual_area_; // above it, unions are expensive
    v_int32x4 log_most_area_;  // above it, they come last
    v_int32x4 if_they_grow_;   // all bits, or none
    v_int32x4 light_level_;    // 1 level of lightness, as means have it
    v_int16x8 distance_and_lightness_, brightness_and_chroma_, areas_and_excess_, length_and_contrast_,
            texture_and_direction_, mixed_, spread_; // exponents
};

}}} // namespace

#endif
