// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_MEASURE_HPP
#define OPENCV_GWATERSHED_REGION_MEASURE_HPP

#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Computes sums and means of all regions of a CV_32SC1 label map. Labels below 0 do not count.
void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions);

//! The same, and of each region the sum of its squared colours, weighted, in 1/256 of a squared level.
void measureRegions(const FeatureMap& features, const Mat& labels, const RegionDistance& distance, Regions& regions,
                    std::vector<int64>& squares);

//! Computes the surfaces of regions whose other sums are known, and all means.
void measureSurfaces(const FeatureMap& features, const Mat& labels, Regions& regions);

}}} // namespace

#endif
