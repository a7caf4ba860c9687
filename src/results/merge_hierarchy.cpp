// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "results/merge_hierarchy.hpp"
#include "shared/region_merge.hpp"
#include "shared/renumber.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Found as those of RGWATERSHED; doc/log.md has the figures.
static const int LENGTH_EXPONENT = 16, CONTRAST_EXPONENT = 8; // in 1/16

//! Distance of neighbouring pixels in colour and depth, in 1/16 of a level.
class FeatureContrasts CV_FINAL : public EdgeContrasts
{
public:
    FeatureContrasts(const Padded<Feature>& features, const RegionDistance& distance)
        : features_(features), distance_(distance)
    {
    }

    int right(Point p) const CV_OVERRIDE { return contrast(p, Point(p.x + 1, p.y)); }
    int below(Point p) const CV_OVERRIDE { return contrast(p, Point(p.x, p.y + 1)); }

private:
    int contrast(Point p, Point q) const
    {
        return distance_(features_.row(p.y)[p.x], meanOf(features_.row(q.y)[q.x]));
    }

    const Padded<Feature>& features_;
    const RegionDistance& distance_;
};

//! @note Not in the paper. Merging of the region adjacency graph by Ward's criterion, which is that of
//! S. Beaulieu, M. Goldberg, Hierarchy in picture segmentation: a stepwise optimization approach (1989).
void MergeHierarchy::build(const Padded<Feature>& features, const RegionDistance& distance, const Mat& labels,
                           int num_labels)
{
    CV_TRACE_FUNCTION();
    Regions regions;
    regions.resize(num_labels);
    measureRegions(features, labels, regions);
    MergeBuffers buffers;
    SimilarMerger merger(distance, LENGTH_EXPONENT, CONTRAST_EXPONENT, buffers, regions);
    const FeatureContrasts contrasts(features, distance);
    merger.runToTheEnd(labels, contrasts);

    labels.copyTo(labels_);
    unions_ = merger.unions();
    num_labels_ = num_labels;
}

int MergeHierarchy::cut(int num_labels, Mat& labels) const
{
    const size_t count = std::min(size_t(std::max(num_labels_ - num_labels, 0)), unions_.size());
    std::vector<int> parents, numbers;
    applyUnions(unions_, count, num_labels_, parents);
    const int left = numberRegions(parents, numbers);
    labels_.copyTo(labels);
    renumber(numbers, labels);
    return left;
}

}}} // namespace
