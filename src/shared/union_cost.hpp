// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_UNION_COST_HPP
#define OPENCV_GWATERSHED_UNION_COST_HPP

#include "shared/merge_graph.hpp"
#include "shared/merge_region.hpp"

namespace cv { namespace ximgproc { namespace gws {

struct FourAreas;
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
    v_int32x4 addColors(const FourRegions& a, const FourRegions& b, const FourAreas& areas, const v_int32x4& sum) const;
    v_int32x4 addShapes(const MergeEdge* edges, const FourAreas& areas, const v_int32x4& sum) const;
    v_int32x4 addTextures(const FourRegions& a, const FourRegions& b, const FourAreas& areas,
                          const v_int32x4& sum) const;
    v_int32x4 addDepth(const v_int32x4& of_colors, const FourRegions& a, const FourRegions& b) const;
    v_int32x4 ofSlopes(const FourRegions& a, const FourRegions& b, const v_int32x4& share_a_cell,
                       const v_int32x4& squared_distance) const;
    v_int32x4 mixtureOf(const v_int16x8& textures, const v_int16x8& others, const v_int32x4& smaller_area) const;

    const RegionDistance distance_;
    const MergeRegion* const records_;
    const SurfaceMean* const surfaces_;
    v_int32x4 noise_, noise_in_cell_;
    v_float32x4 slope_, slope_in_cell_; // of a squared slope, to a squared distance
    v_int16x8 rounding_; // of slopes
    v_int32x4 log_usual_area_; // above it, unions are expensive
    v_int32x4 if_they_grow_;   // all bits, or none
    v_int32x4 light_level_;    // 1 level of lightness, as means have it
    v_int16x8 distance_and_lightness_, brightness_and_chroma_, areas_and_excess_, length_and_contrast_,
            texture_and_direction_, mixed_; // exponents
};

}}} // namespace

#endif
