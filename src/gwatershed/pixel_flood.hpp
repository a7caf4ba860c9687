// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PIXEL_FLOOD_HPP
#define OPENCV_GWATERSHED_PIXEL_FLOOD_HPP

#include "gwatershed/pixel_map.hpp"
#include "shared/bucket_queue.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The 256 queues of Algorithm 1.
typedef BucketQueue<256> PixelQueue;

//! Algorithm 1: floods from the pixels that have a label, and those beside them, which are IN_QUEUE. Leaves LINE and
//! UNLABELLED pixels. The queues are a buffer.
void floodFromMarkers(PixelMap& pixels, PixelQueue& queues);

}}} // namespace

#endif
