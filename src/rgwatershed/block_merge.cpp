// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/block_merge.hpp"
#include "shared/renumber.hpp"

namespace cv { namespace ximgproc { namespace gws {

void mergeSimilarRegions(int num_regions, const RegionDistance& distance, int length_exponent,
                         MergeBuffers& buffers, Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    if (regions.size() <= num_regions)
        return;
    SimilarMerger merger(distance, length_exponent, 0, buffers, regions);
    Mat map = labels.view(CV_32SC1);
    merger.run(map, num_regions);

    std::vector<int> parents, numbers;
    applyUnions(merger.unions(), merger.unions().size(), regions.size(), parents);
    const int left = numberRegions(parents, numbers);
    for (int i = 0; i < regions.size(); i++)
        if (parents[i] == i)
        {
            regions.sums[numbers[i]] = regions.sums[i];
            regions.means[numbers[i]] = regions.means[i];
        }
    regions.resize(left);
    renumber(numbers, map);
}

}}} // namespace
