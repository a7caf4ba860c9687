// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_IMAGE_CONTRAST_HPP
#define OPENCV_GWATERSHED_IMAGE_CONTRAST_HPP

#include "rgwatershed/feature_pyramid.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The highest price of boundary that the contrast of an image can pay, in squared levels for a quarter of an edge:
//! with a higher one, no pixel would leave a straight boundary. The masks are those of the pixels and of the top level
//! of the pyramid; if they are empty, all are inside.
double mostPriceFor(const PyramidLevel* pyramid, int top, const Mat& mask, const Mat& mask_of_top,
                    const RegionDistance& distance);

}}} // namespace

#endif
