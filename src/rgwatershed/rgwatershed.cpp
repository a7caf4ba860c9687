// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/block_gradient.hpp"
#include "rgwatershed/block_merge.hpp"
#include "rgwatershed/feature_pyramid.hpp"
#include "rgwatershed/region_labels.hpp"
#include "rgwatershed/region_names.hpp"
#include "rgwatershed/rgwatershed.hpp"
#include "rgwatershed/tuning.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! How often the image is halved before it is flooded.
static int chooseLevel(Size size, double fewest_blocks, int max_level)
{
    int level = 0;
    while (level < max_level)
    {
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
        if (double(size.width) * size.height < fewest_blocks)
            break;
        level++;
    }
    return level;
}

//! The same for a mask: the blocks must hold most of it, and fall into few enough components that
//! merging can reach the number of superpixels.
static int chooseLevel(const MaskPyramid& masks, int num_superpixels, double fewest_blocks, int max_level)
{
    const double SHARE_IN_BLOCKS = 0.75;
    int level = max_level;
    while (level > 0 && (masks.blocks(level) < fewest_blocks ||
                         (double(masks.blocks(level)) * (1 << 2 * level)) < SHARE_IN_BLOCKS * masks.blocks(0) ||
                         masks.components(level) + masks.lost(level) > std::max(num_superpixels, masks.components(0))))
        level--;
    return level;
}

void RGWatershed::reserve(Size size)
{
    for (int level = 0; level <= MAX_LEVEL; level++)
    {
        features_[level].reserve(size);
        labels_[level].reserve(size);
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
    }
}

//! One sweep over what is listed, but for the pixels of markers.
void RGWatershed::sweep(const ListBoundary& list, int level, int length_price, const RegionDistance& distance,
                            const Frame& frame, VariationGuard* guard)
{
    const ListBoundary list_movable = [&](const Range& rows, BoundaryList& boundary)
    {
        list(rows, boundary);
        if (!frame.markers.empty())
            keepMarkers(frame.markers, labels_[0], boundary);
    };
    sweepBoundary(features_[level], distance, length_price, guard, list_movable, sweep_buffers_, labels_[level],
                  regions_);
}

void RGWatershed::sweepAll(int level, int length_price, const RegionDistance& distance, const Frame& frame)
{
    sweep([&](const Range& rows, BoundaryList& boundary) { listBoundary(labels_[level], rows, boundary); },
          level, length_price, distance, frame, 0);
}

//! On a level that descend() came to.
void RGWatershed::sweepAllOfBlocks(int level, int length_price, const RegionDistance& distance, const Frame& frame)
{
    sweep([&](const Range& rows, BoundaryList& boundary)
    {
        listBoundaryOfBlocks(labels_[level + 1], labels_[level], rows, boundary);
    }, level, length_price, distance, frame, 0);
}

//! Sweeps around the pixels that moved in the last one.
void RGWatershed::sweepAgain(int count, int level, int length_price, const RegionDistance& distance,
                                 const Frame& frame, VariationGuard* guard)
{
    if (count > 0)
        sweep_buffers_.marks.resize(size_t(labels_[level].step()) * (labels_[level].size().height + 2));
    for (int i = 0; i < count && sweep_buffers_.moved(); i++)
        sweep([&](const Range& rows, BoundaryList& boundary)
        {
            listBoundaryAroundMoves(labels_[level], rows, sweep_buffers_, boundary);
        }, level, length_price, distance, frame, guard);
}

//! Gradients beside what is outside of the mask are not known.
void RGWatershed::makeGradient(const Frame& frame, int level, const RegionDistance& distance)
{
    computeBlockGradient(features_[level], distance, gradient_);
    if (!frame.mask.empty())
        forgetGradients(masks_.mask(level), gradient_);
}

//! More regions than asked for, merged to the number asked for: they are small where the image
//! varies and large where it does not.
void RGWatershed::floodAndMerge(const Frame& frame, int level, double side, const Parameters& parameters)
{
    const Padded<Feature>& features = features_[level];
    const bool masked = !frame.mask.empty();
    const Mat mask = masked ? masks_.mask(level) : Mat();
    const double blocks = masked ? masks_.blocks(level) : double(features.size().width) * features.size().height;
    const int num_superpixels = masked ? std::max(frame.num_superpixels - masks_.lost(level), masks_.components(level))
                                       : frame.num_superpixels;
    const int num_markers = int(std::min(double(num_superpixels) * MARKERS_PER_SUPERPIXEL, blocks));
    const RegionDistance distance = floodDistance(parameters.alpha, !frame.depth.empty());

    makeGradient(frame, level, distance);
    if (masked)
    {
        placeShapeMarkers(gradient_, mask, num_markers, marker_buffers_, markers_);
        bands_.assign(1, wholeBand(features.size(), markers_));
    }
    else
    {
        placeGridMarkers(gradient_, num_markers, markers_);
        divideIntoBands(features.size(), num_markers, floodBandHeight(blocks, num_superpixels), bands_);
    }
    clearLabels(features.size(), mask, labels_[level]);
    regions_.resize(0);
    floodFromPoints(features, markers_, bands_, distance, floodRuler(blocks, num_markers, parameters.ruler),
                    flood_buffers_, labels_[level], regions_);
    const int price = boundaryPrice(PRICE_BEFORE_MERGING, side, parameters.ruler);
    sweepAll(level, price, distance, frame);
    sweepAgain(SWEEPS_BEFORE_MERGING - 1, level, price, distance, frame, 0);
    mergeSimilarRegions(num_superpixels, distance, lengthExponent(parameters.ruler), merge_buffers_,
                        labels_[level], regions_);
}

//! The markers of the user are regions from the start; what none of them reaches is no superpixel.
void RGWatershed::floodFromUserMarkers(const Frame& frame, const RegionDistance& distance)
{
    clearLabels(frame.color.size(), frame.mask, labels_[0]);
    frame.markers.copyTo(labels_[0].view(CV_32SC1), frame.markers >= 0);
    regions_.resize(frame.num_superpixels);
    measureRegions(features_[0], labels_[0].view(CV_32SC1), regions_);
    floodFromRegions(features_[0], distance, flood_buffers_, labels_[0], regions_);
    if (!frame.mask.empty())
        closeUnseen(labels_[0]);
}

//! The labels of larger blocks, and what of the mask lies outside of these.
void RGWatershed::descend(const Frame& frame, int level, const RegionDistance& distance)
{
    doubleLabels(labels_[level + 1], features_[level].size(), labels_[level]);
    regions_.divideBlocks();
    if (frame.mask.empty())
        return;
    openUnlabelled(masks_.mask(level), labels_[level]);
    floodFromRegions(features_[level], distance, flood_buffers_, labels_[level], regions_);
    if (level > 0)
    {
        closeUnseen(labels_[level]);
        return;
    }
    const int num_regions = labelUnseen(regions_.size(), labels_[0]);
    if (num_regions > regions_.size())
    {
        regions_.resize(num_regions);
        measureRegions(features_[0], labels_[0].view(CV_32SC1), regions_);
    }
}

int RGWatershed::run(const Frame& frame, const Parameters& parameters, int num_iterations, Mat& labels)
{
    CV_TRACE_FUNCTION();
    const bool masked = !frame.mask.empty();
    const double side = std::sqrt(double(frame.num_pixels) / frame.num_superpixels);
    const double fewest_blocks = fewestBlocks(frame.num_superpixels, parameters.ruler);
    const RegionDistance distance = sweepDistance(parameters.alpha, !frame.depth.empty());
    const int price = boundaryPrice(PRICE, side, parameters.ruler);

    int top = 0;
    if (masked)
        masks_.build(frame.mask, MAX_LEVEL);
    if (frame.markers.empty())
        top = masked ? chooseLevel(masks_, frame.num_superpixels, fewest_blocks, MAX_LEVEL)
                     : chooseLevel(frame.color.size(), fewest_blocks, MAX_LEVEL);

    makePyramid(frame.color, frame.depth, parameters.lab_input, top, features_);
    if (!frame.markers.empty())
        floodFromUserMarkers(frame, distance);
    else if (!frame.continues || top != top_ || !track(frame, top, price, parameters))
    {
        floodAndMerge(frame, top, side, parameters);
        if (parameters.temporal)
            measureErrors(features_[top], distance, labels_[top], regions_, errors_);
    }
    top_ = top;

    for (int level = std::max(top - 1, 0); level >= 0; level--)
    {
        if (level < top)
            descend(frame, level, distance);
        if (level < top && !masked)
            sweepAllOfBlocks(level, price, distance, frame);
        else
            sweepAll(level, price, distance, frame);
        sweepAgain((level > 0 ? SWEEPS_OF_BLOCKS : SWEEPS_OF_PIXELS) - 1, level, price, distance, frame, 0);
    }
    if (num_iterations > 1)
    {
        VariationGuard guard(frame.color, labels_[0], regions_.size());
        for (int i = 1; i < num_iterations && sweep_buffers_.moved(); i++)
        {
            if (i == ITERATIONS_WITH_TIES)
                guard.forbidTies();
            sweepAgain(SWEEPS_PER_ITERATION, 0, price, distance, frame, &guard);
        }
    }
    copyLabels(labels_[0], labels);
    return regions_.size();
}

}}} // namespace
