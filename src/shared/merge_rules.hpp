// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_RULES_HPP
#define OPENCV_GWATERSHED_MERGE_RULES_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The unit of the exponents of costs.
enum { EXPONENT_ONE = 64 };

//! A union of more mean areas comes last.
static const int LARGEST_UNION = 4;

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
    int spread = 0;        //!< of colours that have spread to like neighbours; 0: nothing spreads
    int spread_texture = 0; //!< of textures that have spread
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
    bool few_depths_count = false; //!< also where most of a region has no depth, see Regions::update()
    bool on_surface = false; //!< areas are those on the surface, not in the image
    int num_kept = 0;      //!< so many regions, the first ones, stay apart rather than any others
    bool grow = false;     //!< what is united grows broader later, when boundaries are settled
};

//! For regions of pixels whose textures are measured. Found by measurement, see doc/log.md.
inline MergeRules mergeByTextures()
{
    MergeRules rules;
    rules.few_depths_count = true; // of sparse depth they are all that there is
    rules.distance = 37;
    rules.with_depth = 56;
    rules.areas = 64;
    rules.contrast = 61;
    rules.length = 42;
    rules.lightness = 25;
    rules.brightness = 30;
    rules.chroma = 10;
    rules.texture = 75;
    rules.direction = 40;
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

//! The same for superpixels that are merged later: what lies around them counts, too.
inline MergeRules mergeByContext()
{
    MergeRules rules = mergeByTextures();
    rules.spread = 11;
    rules.spread_texture = 34;
    rules.distance = 30;
    rules.length = 41;
    rules.lightness = 20;
    rules.chroma = 12;
    rules.usual = 3.8f; // a union is put off until it is no larger than LARGEST_UNION
    rules.slope = 7; // differences of lightness, which slopes are too, count more than without contexts
    return rules;
}

}}} // namespace

#endif
