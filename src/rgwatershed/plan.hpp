// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PLAN_HPP
#define OPENCV_GWATERSHED_PLAN_HPP

#include "rgwatershed/feature_pyramid.hpp"
#include "rgwatershed/mask_pyramid.hpp"
#include "rgwatershed/sweep_rules.hpp"
#include "shared/frame.hpp"
#include "shared/merge_rules.hpp"
#include "shared/parameters.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! All that a call decides before it looks at a pixel.
struct Plan
{
    //! masks are those of the frame, or not used if it has no mask.
    Plan(const Frame& frame, const Parameters& parameters, const MaskPyramid& masks);

    //! The ruler of a flood of some blocks from some markers, as floodFromPoints() takes it.
    int floodRuler(double num_blocks, int num_markers_there) const;
    //! The area of a region of it that is not larger than usual; any is where areas follow depth.
    int usualFloodArea(double num_blocks, int num_markers_there) const;
    //! Boundary costs no more than a price at ruler 10, see mostPriceFor().
    void limitPrices(double most);
    //! The rules of sweeps on a level after merging.
    SweepRules sweepOn(int some_level) const;

    BlockLevels levels;     //!< the blocks of the top level are flooded; it is 0 for markers of the user
    double blocks;          //!< of that level, inside of the mask
    int num_superpixels;    //!< on that level
    int num_regions;        //!< that merging leaves there: more if those of pixels are merged, too
    bool merges_pixels;
    int markers_per_superpixel, num_markers;
    bool takes_sides;       //!< blocks astride of an edge, while regions are found
    double most_area;       //!< of a superpixel that gains pixels
    bool depth_adaptive;    //!< superpixels of about equal area on the surface
    int band_height;        //!< rows of blocks, at least, that are flooded by themselves
    float ruler;
    MergeRules merge_rules, pixel_merge_rules;
    RegionDistance flood_distance;       //!< leads in finding regions
    SweepRules sweep_before_merging, sweep; //!< lead in settling boundaries
    int sweeps_before_merging, sweeps_after_merging; //!< of the blocks that were flooded
    int sweeps_of_pixels;
};

}}} // namespace

#endif
