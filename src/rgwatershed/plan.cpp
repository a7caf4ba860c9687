// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/plan.hpp"
#include "rgwatershed/tuning.hpp"

namespace cv { namespace ximgproc { namespace gws {

static double countBlocks(Size size, int level)
{
    for (; level > 0; level--)
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
    return double(size.width) * size.height;
}

//! How often the image is halved before it is flooded: as often as it keeps the fewest blocks.
static int chooseLevel(Size size, double fewest_blocks)
{
    int level = 0;
    while (level < MAX_LEVEL && countBlocks(size, level + 1) >= fewest_blocks)
        level++;
    return level;
}

//! The same for a mask: the blocks must hold most of it, and lie in so few components that merging can reach the
//! number of superpixels.
static int chooseLevel(const MaskPyramid& masks, int num_superpixels, double fewest_blocks)
{
    int level = MAX_LEVEL;
    while (level > 0 && (masks.blocks(level) < fewest_blocks ||
                         (double(masks.blocks(level)) * (1 << 2 * level)) < SHARE_IN_BLOCKS * masks.blocks(0) ||
                         masks.components(level) + masks.lost(level) > std::max(num_superpixels, masks.components(0))))
        level--;
    return level;
}

static int chooseLevel(const Frame& frame, float ruler, const MaskPyramid& masks)
{
    const double fewest_blocks = fewestBlocks(frame.num_superpixels, ruler);
    if (!frame.markers.empty())
        return 0;
    return frame.mask.empty() ? chooseLevel(frame.color.size(), fewest_blocks)
                              : chooseLevel(masks, frame.num_superpixels, fewest_blocks);
}

//! @note Components of a mask that are too small for a block become superpixels when the pixels are settled.
Plan::Plan(const Frame& frame, const Parameters& parameters, const MaskPyramid& masks)
    : level(chooseLevel(frame, parameters.ruler, masks)), ruler(parameters.ruler),
      merge_rules(mergeRules(ruler)), flood_distance(floodDistance(parameters.alpha, !frame.depth.empty())),
      sweep_before_merging(flood_distance, Mat()),
      sweep(sweepDistance(parameters.alpha, !frame.depth.empty()), frame.markers)
{
    const bool masked = !frame.mask.empty();
    const double side = std::sqrt(double(frame.num_pixels) / frame.num_superpixels);
    blocks = masked ? masks.blocks(level) : countBlocks(frame.color.size(), level);
    num_superpixels = masked ? std::max(frame.num_superpixels - masks.lost(level), masks.components(level))
                             : frame.num_superpixels;
    num_markers = int(std::min(double(num_superpixels) * MARKERS_PER_SUPERPIXEL, blocks));
    markers_in_cell = num_markers == num_superpixels * MARKERS_PER_SUPERPIXEL ? MARKERS_PER_SUPERPIXEL : 1;
    most_area = frame.markers.empty() ? MOST_AREA * frame.num_pixels / frame.num_superpixels : double(INT_MAX);
    band_height = floodBandHeight(blocks, num_superpixels);
    sweep_before_merging.length_price = boundaryPrice(PRICE_BEFORE_MERGING, side, ruler);
    sweep.length_price = boundaryPrice(PRICE, side, ruler);
}

int Plan::floodRuler(double num_blocks, int num_markers_there) const
{
    return cvRound(std::min(4096 * ruler * FLOOD_RULER / std::sqrt(num_blocks / num_markers_there), double(INT_MAX)));
}

int Plan::usualFloodArea(double num_blocks, int num_markers_there)
{
    return int(USUAL_FLOOD_AREA * num_blocks / num_markers_there);
}

SweepRules Plan::sweepOn(int some_level) const
{
    SweepRules rules = sweep;
    rules.most_area = int(std::min(most_area, double(INT_MAX))) >> 2 * some_level;
    return rules;
}

}}} // namespace
