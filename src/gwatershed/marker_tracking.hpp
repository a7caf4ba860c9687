// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MARKER_TRACKING_HPP
#define OPENCV_GWATERSHED_MARKER_TRACKING_HPP

#include "shared/shape_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Moves each marker to the middle of its region in the last frame. labels is the label map of that frame. Markers of
//! regions that have become small move into regions that are too large.
void trackMarkers(const Mat& gradient, const Mat& labels, bool masked, MarkerBuffers& buffers,
                  std::vector<Point>& markers);

}}} // namespace

#endif
