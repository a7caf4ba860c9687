// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_STATISTICS_HPP
#define OPENCV_GWATERSHED_STATISTICS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Area, bounding box and centroid of each superpixel, and its mean colour and mean depth if image and depth are not
//! empty. The tables are those of SuperpixelGWatershed::getStatistics().
void measureSuperpixels(const Mat& labels, int num_labels, const Mat& image, const Mat& depth, Mat& stats,
                        Mat& centroids, Mat& mean_colors, Mat& mean_depths);

}}} // namespace

#endif
