// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ADAPTIVE_MARKERS_HPP
#define OPENCV_GWATERSHED_ADAPTIVE_MARKERS_HPP

#include "shared/features.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Places markers at low gradients in cells of about equal area on the surface, for features whose depth is nearness.
//! num_markers <= elements.
void placeAdaptiveMarkers(const Mat& gradient, const FeatureMap& features, int num_markers,
                          std::vector<Point>& markers);

}}} // namespace

#endif
