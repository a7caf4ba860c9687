// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/rgwatershed.hpp"
#include "rgwatershed/block_gradient.hpp"
#include "rgwatershed/block_texture.hpp"
#include "rgwatershed/feature_pyramid.hpp"
#include "rgwatershed/image_contrast.hpp"
#include "rgwatershed/region_labels.hpp"
#include "rgwatershed/similar_merge.hpp"
#include "shared/region_measure.hpp"

namespace cv { namespace ximgproc { namespace gws {

void RGWatershed::reserve(Size size)
{
    for (int level = 0; level <= MAX_LEVEL; level++)
    {
        features_[level].reserve(size);
        labels_[level].reserve(size);
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
    }
}

//! The five steps of the class documentation. Steps 2 to 4 work on blocks, of which a video keeps the regions.
int RGWatershed::run(const Frame& frame, const Parameters& parameters, int num_iterations, MergeBuffers& merge_buffers)
{
    CV_TRACE_FUNCTION();
    if (!frame.mask.empty())
        masks_.build(frame.mask);
    Plan plan(frame, parameters, masks_);
    const int top = plan.levels.top;
    const Mat mask = frame.mask.empty() ? Mat() : masks_.mask(top);

    makePyramid(frame, parameters.lab_input, plan.levels, masks_, features_);
    plan.limitPrices(mostPriceFor(features_, top, frame.mask, mask, plan.sweep.distance));
    regions_.surfaces.present = false; // until they are measured, after the flood
    std::vector<int> first_markers;
    if (!frame.markers.empty())
        floodFromUserMarkers(frame, plan);
    else if (!track(frame, mask, merge_buffers, plan))
    {
        first_markers = findRegions(plan, mask, merge_buffers);
        if (parameters.temporal)
        {
            tracker_.start(plan, features_[top], labels_[top], regions_);
            normal_trust_.start(features_[0].normals);
        }
    }
    settle(frame, plan, num_iterations);
    if (plan.merges_pixels)
        mergePixels(frame, plan, first_markers, num_iterations, merge_buffers);
    iterateMore(frame, plan, num_iterations);
    if (parameters.temporal)
        tracker_.keep(plan, labels_[top].view());
    return regions_.size();
}

//! A frame that continues from the last one takes the regions of that along. From then on, normals count as far as they
//! can be trusted. Returns false, with the plan as it was, if there is nothing to take.
bool RGWatershed::track(const Frame& frame, const Mat& mask, MergeBuffers& merge_buffers, Plan& plan)
{
    if (!frame.continues)
        return false;
    const int top = plan.levels.top;
    Plan of_video = plan;
    of_video.sweep.distance.trustNormals(normal_trust_.next(features_[0].normals));
    if (!tracker_.track(of_video, features_, mask, sweepers_[top], merge_buffers, labels_[top], regions_))
        return false;
    plan = of_video;
    return true;
}

//! Steps 2 to 4. Returns the first markers of the regions that merging left; none if nothing was merged.
std::vector<int> RGWatershed::findRegions(const Plan& plan, const Mat& mask, MergeBuffers& merge_buffers)
{
    const int top = plan.levels.top;
    clearLabels(features_[top].size(), mask, labels_[top]);
    if (plan.takes_sides)
        edge_blocks_.takeSides(labels_[top], features_[top]);
    floodBlocks(plan, mask);
    const std::vector<int> first_markers = sweepAndMerge(plan, merge_buffers);
    if (plan.takes_sides)
        edge_blocks_.takeBack(labels_[top], features_[top], regions_);
    return first_markers;
}

//! Steps 2 and 3: more regions than asked for.
void RGWatershed::floodBlocks(const Plan& plan, const Mat& mask)
{
    CV_TRACE_FUNCTION();
    const FeatureMap& features = features_[plan.levels.top];
    Padded<int>& labels = labels_[plan.levels.top];
    computeBlockGradient(features, plan.flood_distance, mask, gradient_);
    placeBlockMarkers(plan, features, features_[0].size(), mask, gradient_, markers_);
    regions_.resize(0);
    const int num_markers = int(markers_.places.size());
    floodFromPoints(features, markers_.places, markers_.middles, markers_.bands, plan.flood_distance,
                    plan.floodRuler(plan.blocks, num_markers), plan.usualFloodArea(plan.blocks, num_markers),
                    flood_buffers_, labels, regions_);
}

//! Step 4, if there are more regions than asked for. Merging leaves regions that are small where the image varies, and
//! large where it does not.
std::vector<int> RGWatershed::sweepAndMerge(const Plan& plan, MergeBuffers& merge_buffers)
{
    CV_TRACE_FUNCTION();
    if (regions_.size() <= plan.num_regions)
        return std::vector<int>();
    MergeRules rules = plan.merge_rules;
    rules.in_cell = markers_.in_cell;
    const FeatureMap& features = features_[plan.levels.top];
    Padded<int>& labels = labels_[plan.levels.top];
    BoundarySweeper& sweeper = sweepers_[plan.levels.top];
    if (plan.sweeps_before_merging > 0)
        sweeper.sweepAll(plan.sweeps_before_merging, features, plan.sweep_before_merging, labels, regions_);
    measureBlockTextures(features_, plan.levels, plan.flood_distance, labels, regions_.size(), steps_,
                         merge_buffers.textures);
    return merge(plan, plan.levels.top, plan.num_regions, rules, UnionPlan(), merge_buffers);
}

//! Regions of a level. Large buffers are given back, before others are needed. Returns which regions are left.
std::vector<int> RGWatershed::merge(const Plan& plan, int level, int num_regions, const MergeRules& rules,
                                    const UnionPlan& of_unions, MergeBuffers& merge_buffers)
{
    const std::vector<int> left = mergeSimilarRegions(num_regions, features_[level], plan.flood_distance, rules,
                                                      of_unions, merge_buffers, labels_[level], regions_);
    if (hasLargeMergeBuffers(plan.num_markers, features_[0].size().area()))
        merge_buffers = MergeBuffers();
    return left;
}

//! Many small markers are seeds of superpixels, as those of a grid, and have a ruler as these: one that begins with the
//! noise of its pixel would get nothing. Parts of a few markers are on things of any size, and have none.
static int rulerOfMarkers(const Frame& frame, const Plan& plan, const Regions& regions)
{
    const int SMALL = 8; // so many of one cover the share of one superpixel at most
    int largest = 0;
    for (const RegionSum& sum : regions.sums)
        largest = std::max(largest, sum.area);
    const bool are_seeds = frame.owners.empty() && double(largest) * SMALL * regions.size() <= frame.num_pixels;
    return are_seeds ? plan.floodRuler(frame.num_pixels, regions.size()) : 0;
}

//! The markers of the user are regions from the start; what none of them reaches is no superpixel.
void RGWatershed::floodFromUserMarkers(const Frame& frame, const Plan& plan)
{
    CV_TRACE_FUNCTION();
    clearLabels(frame.color.size(), frame.mask, labels_[0]);
    frame.markers.copyTo(labels_[0].view(), frame.markers >= 0);
    regions_.resize(frame.num_superpixels);
    measureRegions(features_[0], labels_[0].view(), regions_);
    const int ruler = rulerOfMarkers(frame, plan, regions_);
    floodFromRegions(features_[0], plan.sweep.distance, ruler, flood_buffers_, labels_[0], regions_);
}

//! Step 5: level by level from the blocks that were flooded down to the pixels.
void RGWatershed::settle(const Frame& frame, const Plan& plan, int num_iterations)
{
    CV_TRACE_FUNCTION();
    const int top = plan.levels.top;
    for (int level = top; level >= 0; level--)
    {
        const int num_sweeps = level == top ? plan.sweeps_after_merging
                             : level > 0 ? SWEEPS_OF_BLOCKS : plan.sweeps_of_pixels;
        SweepRules rules = plan.sweepOn(level);
        if (level == 0 && top > 0)
            rules.distance.normal_share = 0; // pixels have none of their own, and leave blocks across an edge here
        rules.last = level == 0 && num_iterations == 1 && !plan.merges_pixels;
        if (level < top)
            descend(frame, plan, level);
        if (level < top && frame.mask.empty())
            sweepers_[level].sweepBlocks(num_sweeps, sweepers_[level + 1], labels_[level + 1],
                                         plan.levels.grid(level + 1, frame.color.size()), features_[level], rules,
                                         labels_[level], regions_);
        else
            sweepers_[level].sweepAll(num_sweeps, features_[level], rules, labels_[level], regions_);
    }
}

//! To smaller blocks. Where there is a mask, they get the labels of the larger ones, and so does what of it lies
//! outside of these.
void RGWatershed::descend(const Frame& frame, const Plan& plan, int level)
{
    regions_.divideBlocks(plan.levels.ratio(level + 1));
    addLostDepths(features_[level + 1], labels_[level + 1], regions_);
    if (frame.mask.empty())
        return;
    spreadLabels(labels_[level + 1], plan.levels.grid(level + 1, frame.color.size()), features_[level].size(),
                 labels_[level]);
    fitToMask(masks_.mask(level), labels_[level]);
    const int NO_RULER = 0;
    floodFromRegions(features_[level], plan.sweep.distance, NO_RULER, flood_buffers_, labels_[level], regions_);
    if (level > 0)
        return;
    const int num_regions = labelUnseen(regions_.size(), labels_[0]);
    if (num_regions > regions_.size())
    {
        regions_.resize(num_regions);
        measureRegions(features_[0], labels_[0].view(), regions_);
    }
}

//! Where time matters least: the last unions are chosen when boundaries are settled, by the textures of regions, too.
//! This follows what people see more than any number of smaller blocks. Where colours are even, cells of markers unite.
void RGWatershed::mergePixels(const Frame& frame, const Plan& plan, const std::vector<int>& first_markers,
                              int num_iterations, MergeBuffers& merge_buffers)
{
    CV_TRACE_FUNCTION();
    const Mat labels = labels_[0].view();
    measureRegions(features_[0], labels, plan.flood_distance, regions_, merge_buffers.textures);
    merge(plan, 0, frame.num_superpixels, plan.pixel_merge_rules,
          planUnions(first_markers, markers_.in_cell, regions_.size()), merge_buffers);
    if (!frame.depth.empty())
        regions_.update(); // few depths do not count any more: pixels at the end of depth do not go over
    SweepRules rules = plan.sweepOn(0);
    rules.last = num_iterations == 1;
    sweepers_[0].sweepAll(1, features_[0], rules, labels_[0], regions_);
}

//! Each iteration after the first moves pixels where that explains the colours better. Here normals of their blocks
//! count: edges are where they should be, and a superpixel does not grow around them.
void RGWatershed::iterateMore(const Frame& frame, const Plan& plan, int num_iterations)
{
    CV_TRACE_FUNCTION();
    if (num_iterations == 1)
        return;
    VariationGuard guard(frame.color, labels_[0], regions_.size(), frame.owners);
    SweepRules rules = plan.sweepOn(0);
    rules.guard = &guard;
    for (int i = 1; i < num_iterations && sweepers_[0].moved(); i++)
    {
        if (i == ITERATIONS_WITH_TIES)
            guard.forbidTies();
        rules.last = i + 1 == num_iterations;
        sweepers_[0].sweepAgain(SWEEPS_PER_ITERATION, features_[0], rules, labels_[0], regions_);
    }
}

}}} // namespace
