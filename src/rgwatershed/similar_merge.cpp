// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/similar_merge.hpp"
#include "shared/renumber.hpp"

namespace cv { namespace ximgproc { namespace gws {

std::vector<int> mergeSimilarRegions(int num_regions, const Padded<Feature>& features, const RegionDistance& distance,
                                     const MergeRules& rules, const UnionPlan& plan, MergeBuffers& buffers,
                                     Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    std::vector<int> left;
    if (regions.size() <= num_regions)
        return left;
    Mat map = labels.view();
    SimilarMerger merger(map, features, distance, rules, buffers, regions, plan);
    merger.run(num_regions);

    const std::vector<int>& parents = merger.parents();
    std::vector<int> numbers;
    left.resize(numberRegions(parents, numbers));
    for (int i = 0; i < regions.size(); i++)
        if (parents[i] == i)
        {
            regions.copy(i, numbers[i]);
            left[numbers[i]] = i;
        }
    regions.resize(int(left.size()));
    renumber(numbers, map);
    return left;
}

}}} // namespace
