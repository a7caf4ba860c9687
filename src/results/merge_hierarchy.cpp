// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/merge_hierarchy.hpp"
#include "shared/region_measure.hpp"
#include "shared/renumber.hpp"
#include <numeric>

namespace cv { namespace ximgproc { namespace gws {

//! @note Not in the paper. Merging of the region adjacency graph, the cheapest pairs first. Two factors of the cost are
//! Ward's criterion, which J.-M. Beaulieu, M. Goldberg, Hierarchy in picture segmentation: a stepwise optimization
//! approach (1989), merge by; shared/union_cost.hpp has all of them.
void MergeHierarchy::build(const FeatureMap& features, const RegionDistance& distance, const Mat& labels,
                           int num_labels, MergeBuffers& buffers)
{
    CV_TRACE_FUNCTION();
    Regions regions;
    regions.resize(num_labels);
    measureRegions(features, labels, distance, regions, buffers.textures);
    const MergeRules rules = distance.with_depth ? mergeByTextures() : mergeByContext();
    SimilarMerger merger(labels, features, distance, rules, buffers, regions, planUnions(labels, num_labels));
    unions_ = merger.runToTheEnd();

    labels_ = labels;
    num_labels_ = num_labels;
}

int MergeHierarchy::cut(int num_labels, Mat& labels) const
{
    const size_t count = std::min(size_t(std::max(num_labels_ - num_labels, 0)), unions_.size());
    std::vector<int> parents(num_labels_), numbers;
    std::iota(parents.begin(), parents.end(), 0);
    for (size_t i = 0; i < count; i++)
        parents[unions_[i][0]] = unions_[i][1];
    const int left = numberRegions(parents, numbers);
    copyNumbered(labels_, numbers, labels);
    return left;
}

}}} // namespace
