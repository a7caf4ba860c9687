// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SIMILAR_MERGE_HPP
#define OPENCV_GWATERSHED_SIMILAR_MERGE_HPP

#include "shared/region_merge.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Merges the most similar neighbours, regions of blocks or of pixels, until num_regions are left. The plan may be
//! empty. Returns the number that each of those that are left had before, that of its root, if any were merged.
std::vector<int> mergeSimilarRegions(int num_regions, const Padded<Feature>& features, const RegionDistance& distance,
                                     const MergeRules& rules, const UnionPlan& plan, MergeBuffers& buffers,
                                     Padded<int>& labels, Regions& regions);

}}} // namespace

#endif
