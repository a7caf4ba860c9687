// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/plan.hpp"
#include "rgwatershed/tuning.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The largest blocks of which an image has as many as it must keep.
static BlockLevels chooseLevels(Size size, double fewest_blocks, bool centered)
{
    const BlockLevels CHOICES[] = { { 2, 2, centered }, { 1, 3, centered }, { 1, 2, centered } };
    for (const BlockLevels& levels : CHOICES)
        if (double(levels.sizeOf(levels.top, size).area()) >= fewest_blocks)
            return levels;
    return { 0, 2, centered };
}

//! The same for a mask: as many pixels may lie outside of the blocks as there are blocks, and what these cut off must
//! not take many of the superpixels.
static BlockLevels chooseLevels(const MaskPyramid& masks, int num_superpixels, double fewest_blocks)
{
    const int num_components = masks.components(0); // these are superpixels in any case
    const int num_others = std::max(num_superpixels - num_components, 0);
    const int most = num_components + (num_others + SUPERPIXELS_FOR_CUT_OFF - 1) / SUPERPIXELS_FOR_CUT_OFF;
    int level = MAX_LEVEL;
    while (level > 0 && (masks.blocks(level) < fewest_blocks ||
                         double(masks.blocks(level)) * ((1 << 2 * level) + 1) < masks.blocks(0) ||
                         masks.components(level) + masks.lost(level) > most))
        level--;
    return { level, 2, false };
}

//! Regions of pixels are not merged in a video, which moves those of blocks along, nor where they adapt to depth, or
//! their areas on the surface would be less even. From markers of the user, nothing is flooded in blocks or merged.
static const EffortRules& effortRules(const Frame& frame, const Parameters& parameters)
{
    const int MOST_ON_BLOCKS = 2;
    if (!frame.markers.empty())
        return effortRules(Parameters().effort);
    const bool stays_on_blocks = parameters.temporal || (parameters.depth_adaptive && !frame.normals.empty());
    return effortRules(stays_on_blocks ? std::min(parameters.effort, MOST_ON_BLOCKS) : parameters.effort);
}

//! Of a superpixel of mean area, in pixels.
static double sideOf(const Frame& frame) { return std::sqrt(double(frame.num_pixels) / frame.num_superpixels); }

static BlockLevels chooseLevels(const Frame& frame, const Parameters& parameters, const MaskPyramid& masks)
{
    const double fewest_blocks =
            !frame.markers.empty() ? DBL_MAX : fewestBlocks(frame.num_pixels, frame.num_superpixels, parameters.ruler,
                                                            effortRules(frame, parameters));
    return frame.mask.empty() ? chooseLevels(frame.color.size(), fewest_blocks, frame.normals.empty())
                              : chooseLevels(masks, frame.num_superpixels, fewest_blocks);
}

//! @note Components of a mask that are too small for a block become superpixels when the pixels are settled.
Plan::Plan(const Frame& frame, const Parameters& parameters, const MaskPyramid& masks)
    : levels(chooseLevels(frame, parameters, masks)), ruler(parameters.ruler),
      pixel_merge_rules(pixelMergeRules(ruler, !frame.depth.empty())),
      flood_distance(floodDistance(parameters, !frame.depth.empty(), !frame.normals.empty())),
      sweep_before_merging(flood_distance, Mat()),
      sweep(sweepDistance(parameters, !frame.depth.empty(), !frame.normals.empty()), frame.markers)
{
    const EffortRules& effort = effortRules(frame, parameters);
    const bool masked = !frame.mask.empty();
    const double side = sideOf(frame);
    const int top = levels.top;
    blocks = masked ? masks.blocks(top) : levels.sizeOf(top, frame.color.size()).area();
    num_superpixels = masked ? std::max(frame.num_superpixels - masks.lost(top), masks.components(top))
                             : frame.num_superpixels;
    markers_per_superpixel = markersPerSuperpixel(blocks / num_superpixels, side * side, effort);
    const BlockSweeps sweeps = sweepsOfBlocks(blocks / num_superpixels, markers_per_superpixel);
    sweeps_before_merging = sweeps.before_merging;
    sweeps_after_merging = sweeps.after_merging;
    depth_adaptive = parameters.depth_adaptive && !frame.normals.empty();
    merge_rules = mergeRules(ruler, blocks / num_superpixels, levels.side(top));
    merge_rules.on_surface = depth_adaptive;
    merge_rules.texture = flood_distance.shareOfColor(merge_rules.texture);
    merge_rules.direction = flood_distance.shareOfColor(merge_rules.direction);
    merge_rules.mixed = flood_distance.shareOfColor(merge_rules.mixed);
    num_markers = int(std::min(double(num_superpixels) * markers_per_superpixel, blocks));
    merges_pixels = effort.regions_on_pixels > 1 && frame.markers.empty();
    num_regions = merges_pixels ? int(std::min(num_superpixels * effort.regions_on_pixels, double(num_markers)))
                                : num_superpixels;
    takes_sides = top > 0 && num_markers > num_regions && !parameters.temporal &&
                  takesSides(blocks / num_superpixels, flood_distance);
    sweeps_of_pixels = sweepsOfPixels(levels.side(top), double(frame.num_pixels) / num_regions, effort);
    const double pixels_in_blocks = blocks * levels.side(top) * levels.side(top); // more than there are, at the edges
    const double most = sweeps_of_pixels == 1 ? MOST_AREA : MOST_AREA_IN_TWO;
    most_area = frame.markers.empty() && !depth_adaptive ? most * pixels_in_blocks / num_superpixels : double(INT_MAX);
    band_height = floodBandHeight(blocks, num_superpixels);
    sweep_before_merging.length_price = boundaryPrice(effort.price_before_merging, side, ruler);
    sweep.length_price = boundaryPrice(PRICE * sweeps.price, side, ruler);
}

void Plan::limitPrices(double most)
{
    for (SweepRules* rules : { &sweep_before_merging, &sweep })
        rules->length_price = std::min(rules->length_price, boundaryPrice(most, ruler));
}

int Plan::floodRuler(double num_blocks, int num_markers_there) const
{
    const double priority = FLOOD_RULER * std::max(ruler, 10.f); // less makes fringes along the lines of a ramp
    const double of_level = STEPS_PER_LEVEL * FULL_WEIGHT, blocks_apart = std::sqrt(num_blocks / num_markers_there);
    return cvRound(std::min(of_level * priority / blocks_apart, double(INT_MAX)));
}

int Plan::usualFloodArea(double num_blocks, int num_markers_there) const
{
    return depth_adaptive ? INT_MAX : int(std::min(USUAL_FLOOD_AREA * num_blocks / num_markers_there, double(INT_MAX)));
}

SweepRules Plan::sweepOn(int some_level) const
{
    SweepRules rules = sweep;
    rules.most_area = int(std::min(most_area / (levels.side(some_level) * levels.side(some_level)), double(INT_MAX)));
    return rules;
}

}}} // namespace
