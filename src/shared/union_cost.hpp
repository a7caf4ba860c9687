// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_UNION_COST_HPP
#define OPENCV_GWATERSHED_UNION_COST_HPP

#include "shared/merge_graph.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What makes the union of two regions expensive or cheap: the exponents of its cost, in 1/64.
struct MergeRules
{
    int distance;   //!< of the means
    int areas;      //!< n1 n2 / (n1 + n2)
    int contrast;   //!< across the common boundary
    int length;     //!< of the boundary: long ones make it cheap
    int lightness;  //!< a difference of it makes it cheap, because shading varies within things
    int brightness; //!< makes it cheap, because bright colours differ more
    int texture;    //!< the larger variance: rough regions should not take in others
    float usual;    //!< areas of unions, in mean areas at the end; larger ones are expensive
    int noise;      //!< a squared distance that means little, in 1/256 of the variance
    int in_cell;    //!< so many regions of consecutive numbers share a cell of a grid
    bool on_surface; //!< areas are those on the surface, not in the image
    int num_kept;    //!< so many regions, the first ones, stay apart rather than any others
    bool grow;       //!< what is united grows broader later, when boundaries are settled
};

//! For regions of pixels whose variances are measured. Found by measurement, see doc/log.md.
static const MergeRules MERGE_BY_VARIANCES = { 64, 83, 62, 65, 54, 56, 39, 2.7f, 320, 1, false, 0, false };

//! What the cost of a union reads of a region: two vectors of four words.
struct MergeRegion
{
    short mean[4]; //!< colour, weighted, and depth, as it is, in 1/16 of a level
    float area;
    int log_area;  //!< in 1/256 of a doubling
    int variance;  //!< of its colour, weighted, in 1/256 of a squared level; the same for all if not measured
    float light;   //!< sum of the lightness of its pixels, each of them 16 levels lighter than it is
    int cell;      //!< of the grid of markers, in which the region began
    int index;     //!< of the region
};

//! log2 in 1/256 for value >= 1, linear between the powers of two: the bits of a float are just that.
inline int logarithm(float value)
{
    Cv32suf bits;
    bits.f = value;
    return (bits.i >> 15) - (127 << 8);
}

struct FourRegions;

//! The cost of a union: a product of powers, as the sum of logarithms. Exponents are factors then, and there are no
//! roots and no divisions. With d the distance of the means, v the variances, n the areas, h the mean contrast across
//! the boundary, l its length, L the lightness of the means, m that of the union:
//!     (64 d^2 / V + noise)^distance (n1 n2 / (n1 + n2))^areas (h + 1)^contrast (l / root of the smaller n)^-length
//!     (|L1 - L2| + 1)^-lightness (m + 16)^-brightness (larger v + 8)^texture
//!     max(1, (n1 + n2) s / usual area)^32,   V = v1 + v2 + 16,   s = root of max(1, root of the smaller n / l)
//! The first two factors are Ward's criterion, of colours as they vary; the constants let small regions go first where
//! colours are equal. Variances that are not measured are all the same: then V is, and (64 d^2 / V + noise) is as good
//! as (d^2 + 4 noise). Without the last factor, what holds both colours of a pattern is nearer to all around it than
//! these are to each other, and takes in one after the other. Where regions grow later, s makes strips that meet end to
//! end too large earlier, because one of single blocks may become twice as broad; else it is 1. The cost is the same
//! for both orders of the regions.
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
    v_int32x4 addDepth(const v_int32x4& of_colors, const FourRegions& a, const FourRegions& b,
                       const MergeRegion* const* first, const MergeRegion* const* second) const;
    int noiseBetween(const MergeRegion& a, const MergeRegion& b) const;

    const RegionDistance distance_;
    const MergeRegion* const records_;
    const SurfaceMean* const surfaces_;
    const int noise_;
    v_int32x4 log_usual_area_; // above it, unions are expensive
    v_int32x4 if_they_grow_;   // all bits, or none
    v_int32x4 light_level_;    // 1 level of lightness, as means have it
    v_int16x8 distance_and_excess_, areas_and_contrast_, length_and_lightness_, brightness_and_texture_; // exponents
};

}}} // namespace

#endif
