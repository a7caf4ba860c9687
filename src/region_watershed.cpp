// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_watershed.hpp"
#include "similar_merger.hpp"
#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Constants found on one half of the photographs of BSDS500's train split and checked on the other;
// doc/log.md has the figures.

static const int MARKERS_PER_SUPERPIXEL = 4;   // the flood makes as many regions, which are merged
static const int BLOCKS_PER_SUPERPIXEL = 12;   // at least, twice as many at ruler 0, or smaller blocks are flooded
static const double FLOOD_RULER = 0.4;         // height in levels, by ruler, one grid step from the marker
static const int SWEEPS_BEFORE_MERGING = 2;
static const int SWEEPS_OF_BLOCKS = 2;         // on each level between the flood and the pixels
static const int SWEEPS_OF_PIXELS = 1;
static const int SWEEPS_PER_ITERATION = 2;     // of pixels, for each iteration after the first

// For frames that follow others: sweeps of blocks that move the regions along, and the squared error of a region,
// for what it was when it was made and for each of its blocks, from which on it has changed.
static const int SWEEPS_TO_FOLLOW = 3;
static const int ERROR_GROWTH = 2, ERROR_FLOOR = 32;

// Weights of lightness and of the colour differences, in 1/256. Lightness varies most within
// things, by shading, so it leads less in finding regions than in settling their boundaries.
static const int FLOOD_LIGHTNESS = 128, FLOOD_CHROMA = 256;
static const int SWEEP_LIGHTNESS = 150, SWEEP_CHROMA = 218;

// Price of boundary, in squared levels for a quarter of an edge: at ruler 10, for superpixels of a
// side of 17 pixels. It grows with their area, so that small superpixels may follow the image as well.
static const double PRICE_BEFORE_MERGING = 10, PRICE = 24;

//! Height of one block of distance from the marker, as floodFromPoints() takes it.
static int floodRuler(double blocks, int num_markers, float ruler)
{
    return cvRound(std::min(4096 * ruler * FLOOD_RULER / std::sqrt(blocks / num_markers), double(INT_MAX)));
}

static int boundaryPrice(double price, double side, float ruler)
{
    const double PART_WITHOUT_RULER = 0.1;
    const double scale = std::min(std::max(side * side / 289, 0.25), 4.);
    return cvRound(std::min(price * scale * (PART_WITHOUT_RULER + (1 - PART_WITHOUT_RULER) * ruler / 10), 1e6));
}

//! Weight of long common boundaries in merging, in 1/16: long ones make compact superpixels.
static int lengthExponent(float ruler)
{
    return cvRound(4 + 8 * std::min(ruler / 10, 1.f));
}

//! How many blocks a number of superpixels must keep, more if their boundary may be irregular.
static double fewestBlocks(int num_superpixels, float ruler)
{
    return num_superpixels * BLOCKS_PER_SUPERPIXEL * (2 - std::min(ruler / 10, 1.f));
}

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

void RegionWatershed::reserve(Size size)
{
    for (int level = 0; level <= MAX_LEVEL; level++)
    {
        features_[level].reserve(size);
        labels_[level].reserve(size);
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
    }
}

RegionDistance RegionWatershed::floodDistance(float alpha)
{
    return RegionDistance(FLOOD_LIGHTNESS, FLOOD_CHROMA, alpha);
}

void RegionWatershed::sweep(int level, int count, int length_price, const RegionDistance& distance,
                            const Frame& frame, VariationGuard* guard)
{
    for (int i = 0; i < count; i++)
    {
        if (!frame.markers.empty())
            keepMarkers(frame.markers, labels_[0], boundary_);
        sweepBoundary(features_[level], distance, length_price, guard, labels_[level], regions_,
                      sweep_buffers_, boundary_);
    }
}

//! More regions than asked for, merged to the number asked for: they are small where the image
//! varies and large where it does not.
void RegionWatershed::floodAndMerge(const Frame& frame, int level, double side, const Parameters& parameters)
{
    const Padded<Feature>& features = features_[level];
    const bool masked = !frame.mask.empty();
    const Mat mask = masked ? masks_.mask(level) : Mat();
    const double blocks = masked ? masks_.blocks(level) : double(features.size().width) * features.size().height;
    const int num_superpixels = frame.num_superpixels - (masked ? masks_.lost(level) : 0);
    const int num_markers = int(std::min(double(num_superpixels) * MARKERS_PER_SUPERPIXEL, blocks));
    const RegionDistance distance = floodDistance(parameters.alpha);

    computeGradient(features, distance, gradient_);
    if (masked)
    {
        forgetGradients(mask, gradient_);
        placeMarkers(gradient_, mask, num_markers, markers_);
    }
    else
        placeMarkers(gradient_, num_markers, markers_);
    clearLabels(features.size(), mask, labels_[level]);
    regions_.resize(0);
    floodFromPoints(features, markers_, distance, floodRuler(blocks, num_markers, parameters.ruler), flood_buffers_,
                    labels_[level], regions_);
    listBoundary(labels_[level], boundary_);
    sweep(level, SWEEPS_BEFORE_MERGING, boundaryPrice(PRICE_BEFORE_MERGING, side, parameters.ruler), distance,
          frame, 0);
    mergeSimilarRegions(num_superpixels, distance, lengthExponent(parameters.ruler), merge_buffers_,
                        labels_[level], regions_);
}

//! The regions of the last frame, moved to where their things are now. What they explain much worse than when
//! they were made is flooded anew, and the most similar ones make room for it. Returns false, with nothing
//! that can be used, if most of the scene is new.
bool RegionWatershed::follow(const Frame& frame, int level, int length_price, const Parameters& parameters)
{
    const Padded<Feature>& features = features_[level];
    const RegionDistance distance(SWEEP_LIGHTNESS, SWEEP_CHROMA, parameters.alpha);
    const int num_regions = int(errors_.size());
    regions_.resize(num_regions);
    measureRegions(features, labels_[level].view(CV_32SC1), regions_);
    listBoundary(labels_[level], boundary_);
    sweep(level, SWEEPS_TO_FOLLOW, length_price, distance, frame, 0);

    std::vector<int64> errors;
    std::vector<uchar> changed(num_regions);
    measureErrors(features, distance, labels_[level], regions_, errors);
    double area = 0, changed_area = 0;
    for (int i = 0; i < num_regions; i++)
    {
        changed[i] = errors[i] > ERROR_GROWTH * errors_[i] + ERROR_FLOOR * regions_.sums[i].area;
        area += regions_.sums[i].area;
        changed_area += changed[i] ? regions_.sums[i].area : 0;
    }
    if (changed_area > area / 2)
        return false;
    if (changed_area > 0)
        renew(level, changed, parameters);
    return true;
}

//! Floods the regions that have changed anew, from as many markers as a new image would have there, and merges
//! the most similar regions wherever they are. New regions take the labels of those that went.
void RegionWatershed::renew(int level, const std::vector<uchar>& changed, const Parameters& parameters)
{
    const Padded<Feature>& features = features_[level];
    const RegionDistance distance = floodDistance(parameters.alpha);
    const int num_regions = regions_.size();
    Mat map = labels_[level].view(CV_32SC1), before = map.clone();
    std::vector<int> names, numbers(num_regions, int(UNSEEN));
    int changed_area = 0, area = 0;
    for (int i = 0; i < num_regions; i++)
    {
        area += regions_.sums[i].area;
        if (changed[i])
        {
            changed_area += regions_.sums[i].area;
            continue;
        }
        numbers[i] = int(names.size());
        regions_.sums[names.size()] = regions_.sums[i];
        names.push_back(i);
    }
    const int num_kept = int(names.size());
    regions_.resize(num_kept);
    renumber(numbers, map);

    const int fewest = std::max(num_regions - num_kept, cvRound(double(changed_area) * num_regions / area));
    const int num_markers = std::min(changed_area, MARKERS_PER_SUPERPIXEL * fewest);
    computeGradient(features, distance, gradient_);
    placeMarkers(gradient_, map == UNSEEN, num_markers, markers_);
    floodFromPoints(features, markers_, distance, floodRuler(changed_area, num_markers, parameters.ruler),
                    flood_buffers_, labels_[level], regions_);
    for (size_t i = 0; i < markers_.size(); i++)
        names.push_back(before.at<int>(markers_[i]));

    std::vector<int> areas(regions_.size());
    for (int i = 0; i < regions_.size(); i++)
        areas[i] = regions_.sums[i].area;
    SimilarMerger merger(distance, lengthExponent(parameters.ruler), 0, merge_buffers_, regions_);
    addBoundaries(map, NoHeight(), merger.graph());
    merger.run(num_regions);
    nameGroups(merger.graph().parents(), areas, names, num_kept, numbers);
    renumber(numbers, map);

    // What was made anew has its error now as the measure of later ones.
    std::vector<int64> errors;
    std::vector<uchar> renewed(changed);
    const std::vector<Vec2i>& unions = merger.unions();
    for (size_t i = 0; i < unions.size(); i++)
        renewed[numbers[unions[i][1]]] = 1;
    regions_.resize(num_regions);
    measureRegions(features, map, regions_);
    measureErrors(features, RegionDistance(SWEEP_LIGHTNESS, SWEEP_CHROMA, parameters.alpha), labels_[level],
                  regions_, errors);
    for (int i = 0; i < num_regions; i++)
        if (renewed[i])
            errors_[i] = errors[i];
}

//! The markers of the user are regions from the start; what none of them reaches is no superpixel.
void RegionWatershed::floodFromMarkers(const Frame& frame, const RegionDistance& distance)
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
void RegionWatershed::descend(const Frame& frame, int level, const RegionDistance& distance)
{
    doubleLabels(labels_[level + 1], features_[level].size(), labels_[level]);
    if (frame.mask.empty())
        return;
    openUnlabelled(masks_.mask(level), labels_[level]);
    floodFromRegions(features_[level], distance, flood_buffers_, labels_[level], regions_);
    if (level > 0)
        closeUnseen(labels_[level]);
    else
        regions_.resize(labelUnseen(regions_.size(), labels_[0]));
}

int RegionWatershed::run(const Frame& frame, const Parameters& parameters, int num_iterations, Mat& labels)
{
    CV_TRACE_FUNCTION();
    const bool masked = !frame.mask.empty();
    const double side = std::sqrt(double(frame.num_pixels) / frame.num_superpixels);
    const double fewest_blocks = fewestBlocks(frame.num_superpixels, parameters.ruler);
    const RegionDistance distance(SWEEP_LIGHTNESS, SWEEP_CHROMA, parameters.alpha);
    const int price = boundaryPrice(PRICE, side, parameters.ruler);

    int top = 0;
    if (masked)
        masks_.build(frame.mask, MAX_LEVEL);
    if (frame.markers.empty())
        top = masked ? chooseLevel(masks_, frame.num_superpixels, fewest_blocks, MAX_LEVEL)
                     : chooseLevel(frame.color.size(), fewest_blocks, MAX_LEVEL);

    makeFeatures(frame.color, frame.depth, parameters.uniform_color, features_[0]);
    for (int level = 1; level <= top; level++)
        halveFeatures(features_[level - 1], features_[level]);
    if (!frame.markers.empty())
        floodFromMarkers(frame, distance);
    else if (!frame.follows || top != top_ || !follow(frame, top, price, parameters))
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
        measureRegions(features_[level], labels_[level].view(CV_32SC1), regions_);
        listBoundary(labels_[level], boundary_);
        sweep(level, level > 0 ? SWEEPS_OF_BLOCKS : SWEEPS_OF_PIXELS, price, distance, frame, 0);
    }
    if (num_iterations > 1)
    {
        VariationGuard guard(frame.color, labels_[0], regions_.size());
        for (int i = 1; i < num_iterations && !boundary_.empty(); i++)
            sweep(0, SWEEPS_PER_ITERATION, price, distance, frame, &guard);
    }
    labels_[0].view(CV_32SC1).copyTo(labels);
    return regions_.size();
}

}}} // namespace
