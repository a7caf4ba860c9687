// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/block_gradient.hpp"
#include "rgwatershed/region_names.hpp"
#include "rgwatershed/rgwatershed.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/renumber.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Of regions that have changed much.
struct Change
{
    std::vector<uchar> changed; //!< by region
    double changed_area, area;
};

static Change findChange(const std::vector<int64>& errors, const std::vector<int64>& errors_before,
                         const Regions& regions)
{
    Change change = { std::vector<uchar>(errors.size()), 0, 0 };
    for (int i = 0; i < regions.size(); i++)
    {
        const int64 area = regions.sums[i].area;
        change.changed[i] = errors[i] > ERROR_GROWTH * errors_before[i] + ERROR_FLOOR * area;
        change.area += double(area);
        change.changed_area += change.changed[i] ? double(area) : 0;
    }
    return change;
}

//! The regions of the last frame, moved to where their things are now. What they explain much worse than when
//! they were made is made anew. Returns false, with nothing that can be used, if most of the scene is new.
bool RGWatershed::track(const Frame& frame, int level, int length_price, const Parameters& parameters)
{
    const RegionDistance distance = sweepDistance(parameters.alpha, !frame.depth.empty());
    std::vector<int64> errors;
    regions_.resize(int(errors_.size()));
    measureRegions(features_[level], labels_[level].view(CV_32SC1), regions_);
    sweepAll(level, length_price, distance, frame);
    sweepAgain(SWEEPS_TO_TRACK - 1, level, length_price, distance, frame, 0);
    measureErrors(features_[level], distance, labels_[level], regions_, errors);

    Change change = findChange(errors, errors_, regions_);
    if (change.changed_area > change.area / 2)
        return false;
    if (change.changed_area == 0)
        return true;
    const RegionDistance flood_distance = floodDistance(parameters.alpha, !frame.depth.empty());
    const int num_kept = floodAnew(frame, level, change.changed, change.changed_area, change.area, flood_distance,
                                   parameters.ruler);
    mergeAnew(level, num_kept, change.changed, flood_distance, parameters.ruler);
    measureErrors(features_[level], distance, labels_[level], regions_, errors);
    for (size_t i = 0; i < errors.size(); i++)
        if (change.changed[i])
            errors_[i] = errors[i]; // the measure of later ones
    return true;
}

//! Dissolves the regions that have changed, and floods there from as many markers as a new image would have. Regions
//! are numbered anew: those that are left first; names_ are their labels, and those that were where the new ones are.
//! Returns how many are left.
int RGWatershed::floodAnew(const Frame& frame, int level, const std::vector<uchar>& changed, double changed_area,
                               double area, const RegionDistance& distance, float ruler)
{
    const Padded<Feature>& features = features_[level];
    const int num_regions = regions_.size();
    Mat map = labels_[level].view(CV_32SC1);
    map.copyTo(last_map_);
    names_.clear();
    numbers_.assign(num_regions, int(UNSEEN));
    for (int i = 0; i < num_regions; i++)
        if (!changed[i])
        {
            numbers_[i] = int(names_.size());
            regions_.sums[names_.size()] = regions_.sums[i];
            names_.push_back(i);
        }
    const int num_kept = int(names_.size());
    regions_.resize(num_kept);
    renumber(numbers_, map);

    const double fewest = std::max(double(num_regions - num_kept), changed_area * num_regions / area);
    const int num_markers = int(std::min(changed_area, MARKERS_PER_SUPERPIXEL * fewest));
    makeGradient(frame, level, distance);
    compare(map, Scalar(UNSEEN), dissolved_, CMP_EQ);
    placeShapeMarkers(gradient_, dissolved_, num_markers, marker_buffers_, markers_);
    bands_.assign(1, wholeBand(features.size(), markers_));
    floodFromPoints(features, markers_, bands_, distance, floodRuler(changed_area, num_markers, ruler),
                    flood_buffers_, labels_[level], regions_);
    for (size_t i = 0; i < markers_.size(); i++)
        names_.push_back(last_map_.at<int>(markers_[i]));
    return num_kept;
}

//! Merges the most similar regions, wherever they are, until as many are left as there were, and gives them their
//! labels. What was merged has changed, too.
void RGWatershed::mergeAnew(int level, int num_kept, std::vector<uchar>& changed, const RegionDistance& distance,
                                float ruler)
{
    Mat map = labels_[level].view(CV_32SC1);
    std::vector<int> areas(regions_.size());
    for (int i = 0; i < regions_.size(); i++)
        areas[i] = regions_.sums[i].area;
    SimilarMerger merger(distance, lengthExponent(ruler), 0, merge_buffers_, regions_);
    merger.run(map, int(changed.size()));
    std::vector<int> parents;
    applyUnions(merger.unions(), merger.unions().size(), regions_.size(), parents);
    nameGroups(parents, areas, names_, num_kept, numbers_);
    renumber(numbers_, map);
    for (size_t i = 0; i < merger.unions().size(); i++)
        changed[numbers_[merger.unions()[i][1]]] = 1;
    regions_.resize(int(changed.size()));
    measureRegions(features_[level], map, regions_);
}

}}} // namespace
