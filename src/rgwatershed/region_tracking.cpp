// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/region_tracking.hpp"
#include "rgwatershed/block_gradient.hpp"
#include "rgwatershed/block_texture.hpp"
#include "rgwatershed/region_labels.hpp"
#include "rgwatershed/region_names.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/region_measure.hpp"
#include "shared/renumber.hpp"

namespace cv { namespace ximgproc { namespace gws {

static int errorAt(const FeatureMap& features, Point p, const RegionDistance& distance, const Regions& regions,
                   int region)
{
    const Feature& feature = features.row(p.y)[p.x];
    const RegionMean& mean = regions.means[region];
    if (!regions.surfaces.present)
        return distance.squared(feature, mean);
    return distance.squared(feature, features.normalAt(p), mean, regions.surfaces.means[region], p);
}

//! Sum of the squared distances of the pixels of each region to its mean, in squared levels.
static void measureErrors(const FeatureMap& features, const RegionDistance& distance, const Padded<int>& labels,
                          const Regions& regions, std::vector<int64>& errors)
{
    CV_TRACE_FUNCTION();
    errors.assign(regions.size(), 0);
    const Size size = labels.size();
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
        {
            const int label = labels.row(y)[x];
            if (label >= 0)
                errors[label] += errorAt(features, Point(x, y), distance, regions, label);
        }
}

//! The sum of the squared colours of blocks that are in a region.
static double sumOfSquares(const FeatureMap& features, const Padded<int>& labels)
{
    int64 sum = 0;
    const Size size = labels.size();
    for (int y = 0; y < size.height; y++)
    {
        const Feature* const row = features.row(y);
        const int* const labels_of_row = labels.row(y);
        for (int x = 0; x < size.width; x++)
            for (int k = 0; k < 3; k++)
                sum += labels_of_row[x] < 0 ? 0 : row[x].color[k] * row[x].color[k];
    }
    return double(sum);
}

//! What the mean of a region explains of the sum of its squared colours.
static double explainedBy(const RegionSum& region)
{
    double squares = 0;
    for (int k = 0; k < 3; k++)
        squares += double(region.color[k]) * double(region.color[k]);
    return squares / std::max(region.area, 1);
}

//! @note Noise has hardly any share of its variation between regions. A light that changes, changes no shares.
RegionTracker::Variation RegionTracker::variationOf(double squares, const Regions& regions)
{
    Variation variation;
    RegionSum all = RegionSum();
    variation.left = squares;
    for (const RegionSum& region : regions.sums)
    {
        all.add(region);
        variation.left -= explainedBy(region);
    }
    variation.all = squares - explainedBy(all);
    return variation;
}

void RegionTracker::start(const Plan& plan, const FeatureMap& features, const Padded<int>& labels,
                          const Regions& regions)
{
    measureErrors(features, plan.sweep.distance, labels, regions, last_.errors);
    last_.variation = variationOf(sumOfSquares(features, labels), regions);
}

void RegionTracker::keep(const Plan& plan, const Mat& labels)
{
    last_.side = plan.levels.side(plan.levels.top);
    last_.centered = plan.levels.centered;
    labels.copyTo(last_.labels);
}

//! Normals come and go with depth, and with them short blocks move, if there are any.
bool RegionTracker::hasSameBlocks(const BlockLevels& levels, Size image) const
{
    const int side = levels.side(levels.top);
    const bool has_short_ones = image.width % side != 0 || image.height % side != 0;
    return side == last_.side && (levels.centered == last_.centered || !has_short_ones);
}

bool RegionTracker::track(const Plan& plan, const PyramidLevel* pyramid, const Mat& mask, BoundarySweeper& sweeper,
                          MergeBuffers& merge_buffers, Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    const FeatureMap& features = pyramid[plan.levels.top];
    if (!hasSameBlocks(plan.levels, pyramid[0].size()))
        return false;
    std::vector<int64> errors;
    labels.create(last_.labels.size(), OUTSIDE);
    last_.labels.copyTo(labels.view());
    regions.resize(int(last_.errors.size()));
    measureRegions(features, last_.labels, regions);
    sweeper.sweepAll(SWEEPS_TO_TRACK, features, plan.sweepOn(plan.levels.top), labels, regions);
    measureErrors(features, plan.sweep.distance, labels, regions, errors);

    Change change = findChange(errors, regions);
    const double squares = sumOfSquares(features, labels);
    const Variation before = last_.variation, now = variationOf(squares, regions);
    const double even = ERROR_FLOOR * change.area; // so little variation, and colours tell nothing of regions
    const bool was_noise = plan.sweep.distance.shareOfColor(FULL_WEIGHT) > 0 &&
                           before.left * now.all > ERROR_GROWTH * now.left * before.all + even * now.all;
    const bool was_even = !plan.sweep.distance.with_depth && before.all <= even && now.all > even;
    if (change.changed_area > change.area / 2 || was_noise || was_even)
        return false;
    if (change.changed_area > 0)
        replaceChanged(plan, pyramid, mask, merge_buffers, change, labels, regions);
    if (now.all > even)
        last_.variation = variationOf(squares, regions);
    return true;
}

RegionTracker::Change RegionTracker::findChange(const std::vector<int64>& errors, const Regions& regions) const
{
    Change change = { std::vector<uchar>(errors.size()), 0, 0, {} };
    for (int i = 0; i < regions.size(); i++)
    {
        const int64 area = regions.sums[i].area;
        change.changed[i] = errors[i] > ERROR_GROWTH * last_.errors[i] + ERROR_FLOOR * area;
        change.area += double(area);
        change.changed_area += change.changed[i] ? double(area) : 0;
    }
    return change;
}

//! The errors of the new regions are what later ones are measured by.
void RegionTracker::replaceChanged(const Plan& plan, const PyramidLevel* pyramid, const Mat& mask,
                                   MergeBuffers& merge_buffers, Change& change, Padded<int>& labels, Regions& regions)
{
    const FeatureMap& features = pyramid[plan.levels.top];
    const int num_kept = floodChanged(plan, features, mask, change, labels, regions);
    mergeAll(plan, pyramid, num_kept, merge_buffers, change, labels, regions);
    std::vector<int64> errors;
    measureErrors(features, plan.sweep.distance, labels, regions, errors);
    for (size_t i = 0; i < errors.size(); i++)
        if (change.changed[i])
            last_.errors[i] = errors[i];
}

//! Dissolves the regions that have changed. Those that are kept get the first numbers, and stay under their names.
void RegionTracker::dissolveChanged(Change& change, Mat& labels, Regions& regions)
{
    std::vector<int> numbers(regions.size(), int(UNSEEN));
    for (int i = 0; i < regions.size(); i++)
        if (!change.changed[i])
        {
            numbers[i] = int(change.names.size());
            regions.copy(i, numbers[i]);
            change.names.push_back(i);
        }
    regions.resize(int(change.names.size()));
    renumber(numbers, labels);
}

//! Floods where regions have changed, from as many markers as a new image would have there. Returns how many regions
//! are kept.
int RegionTracker::floodChanged(const Plan& plan, const FeatureMap& features, const Mat& mask, Change& change,
                                Padded<int>& labels, Regions& regions)
{
    const int num_regions = regions.size();
    Mat map = labels.view(), before, dissolved;
    map.copyTo(before);
    dissolveChanged(change, map, regions);
    const int num_kept = regions.size();
    const double fewest = std::max(double(num_regions - num_kept), change.changed_area * num_regions / change.area);
    const int num_markers = int(std::min(change.changed_area, plan.markers_per_superpixel * fewest));
    std::vector<Point> markers;
    computeBlockGradient(features, plan.flood_distance, mask, gradient_);
    compare(map, Scalar(UNSEEN), dissolved, CMP_EQ);
    placeShapeMarkers(gradient_, dissolved, num_markers, marker_buffers_, markers);
    const std::vector<MarkerBand> bands(1, wholeBand(features.size(), int(markers.size())));
    floodFromPoints(features, markers, std::vector<Point>(), bands, plan.flood_distance,
                    plan.floodRuler(change.changed_area, num_markers),
                    plan.usualFloodArea(change.changed_area, num_markers), flood_buffers_, labels, regions);
    for (Point marker : markers)
        change.names.push_back(before.at<int>(marker));
    return num_kept;
}

//! Merges the most similar regions, wherever they are, until as many are left as there were, and gives them their
//! labels. What was merged has changed, too.
void RegionTracker::mergeAll(const Plan& plan, const PyramidLevel* pyramid, int num_kept, MergeBuffers& buffers,
                             Change& change, Padded<int>& labels, Regions& regions)
{
    const FeatureMap& features = pyramid[plan.levels.top];
    Mat map = labels.view();
    std::vector<int> areas(regions.size()), numbers;
    for (int i = 0; i < regions.size(); i++)
        areas[i] = regions.sums[i].area;
    measureBlockTextures(pyramid, plan.levels, plan.flood_distance, labels, regions.size(), steps_, buffers.textures);
    SimilarMerger merger(map, features, plan.flood_distance, trackedMergeRules(plan.merge_rules, num_kept), buffers,
                         regions);
    merger.run(int(change.changed.size()));
    const std::vector<int>& parents = merger.parents();
    nameGroups(parents, areas, change.names, num_kept, numbers);
    renumber(numbers, map);
    for (size_t i = 0; i < parents.size(); i++)
        if (parents[i] != int(i))
            change.changed[numbers[i]] = 1;
    regions.resize(int(change.changed.size()));
    measureRegions(features, map, regions);
}

}}} // namespace
