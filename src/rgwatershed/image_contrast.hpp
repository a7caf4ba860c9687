// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_IMAGE_CONTRAST_HPP
#define OPENCV_GWATERSHED_IMAGE_CONTRAST_HPP

#include "shared/features.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The highest price of boundary that the contrast of an image can pay, in squared levels for a quarter of an edge:
//! with a higher one, no pixel would leave a straight boundary. From some rows of the pixels inside of a mask; if it is
//! empty, of all.
double mostPriceFor(const FeatureMap& pixels, const Mat& mask, const RegionDistance& distance);

}}} // namespace

#endif
