// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SWEEP_RULES_HPP
#define OPENCV_GWATERSHED_SWEEP_RULES_HPP

#include "rgwatershed/variation_guard.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What a sweep goes by.
struct SweepRules
{
    SweepRules(const RegionDistance& distance_, const Mat& markers_) : distance(distance_), markers(markers_) {}

    RegionDistance distance;
    int length_price = 0;      //!< energy, in squared grey levels, of a quarter of a pixel edge of boundary
    Mat markers;               //!< of the user: pixels with a value of 0 or more stay; may be empty
    VariationGuard* guard = 0; //!< may be 0
    int most_area = INT_MAX;   //!< a larger region gains no pixel, or one with both colours of a pattern would grow on
    bool last = false;         //!< nothing follows, and the sums and means of the regions are not needed any more
};

}}} // namespace

#endif
