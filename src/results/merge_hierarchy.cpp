// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/merge_hierarchy.hpp"
#include "shared/region_measure.hpp"
#include "shared/renumber.hpp"
#include <functional>
#include <numeric>
#include <queue>

namespace cv { namespace ximgproc { namespace gws {

static std::vector<int> areasOf(const Regions& regions)
{
    std::vector<int> areas;
    for (const RegionSum& sum : regions.sums)
        areas.push_back(sum.area);
    return areas;
}

//! An order in which no union has more than LARGEST_UNION mean areas of the superpixels that are left, as long as there
//! are others: what is united first is part of larger ones later, so it may be larger than anything is to be when it is
//! united. Such unions wait until the mean is large enough. Each is larger than its parts, so these come first.
static std::vector<Vec2i> putOffLarge(const std::vector<Vec2i>& unions, std::vector<int> areas)
{
    typedef std::pair<int, size_t> Union; // area and number: of equal ones, no library may choose which is first
    std::priority_queue<Union, std::vector<Union>, std::greater<Union> > waiting;
    std::vector<Vec2i> ordered;
    const int64 most = LARGEST_UNION * std::accumulate(areas.begin(), areas.end(), int64(0));
    const auto isTooLarge = [&](int area) { return area * int64(areas.size() - ordered.size()) > most; };
    const auto takeWaiting = [&](bool all)
    {
        for (; !waiting.empty() && (all || !isTooLarge(waiting.top().first)); waiting.pop())
            ordered.push_back(unions[waiting.top().second]);
    };
    for (size_t i = 0; i < unions.size(); i++)
    {
        takeWaiting(false);
        const int area = areas[unions[i][1]] += areas[unions[i][0]];
        waiting.push(Union(area, i));
    }
    takeWaiting(true);
    return ordered;
}

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
    const std::vector<int> areas = areasOf(regions); // merging changes them
    unions_ = putOffLarge(merger.runToTheEnd(), areas);

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
