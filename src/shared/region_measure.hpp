// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_MEASURE_HPP
#define OPENCV_GWATERSHED_REGION_MEASURE_HPP

#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! How rough a region is: sums of the differences of colour between its pixels and those of it beside them, and those
//! below them, weighted, in 1/16 of a level, in every second row; of blocks, what lies in them. It grows with details,
//! but hardly with shading. And how its lightness rises: sums of the same differences with their signs, in 1/256.
//! @note Sums of floats depend on their order, which is the same for every number of threads.
struct RegionTexture
{
    float across, down;
    float rise_across, rise_down;

    void add(const v_float32x4& sums) { v_store(&across, gws::add(v_load(&across), sums)); }
    void add(const RegionTexture& t) { add(v_load(&t.across)); }
};

//! Computes sums and means of all regions of a CV_32SC1 label map. Labels below 0 do not count.
void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions);

//! The same, and the texture of each region.
void measureRegions(const FeatureMap& features, const Mat& labels, const RegionDistance& distance, Regions& regions,
                    std::vector<RegionTexture>& textures);

//! Computes the surfaces of regions whose other sums are known, and all means.
void measureSurfaces(const FeatureMap& features, const Mat& labels, Regions& regions);

}}} // namespace

#endif
