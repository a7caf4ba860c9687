// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_STATISTICS_HPP
#define OPENCV_GWATERSHED_STATISTICS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What superpixels are measured by beside their labels, and what for. There are always areas, boxes and centroids.
struct StatisticsInput
{
    Mat image; //!< for mean colours; empty: there are none
    Mat depth; //!< empty: there is nothing of what follows
    bool with_mean_depths = true, with_positions = true, with_normals = true;
    Point2f focal = Point2f(1, 1); //!< in pixels; the optical axis meets the middle of the image
};

//! The tables of SuperpixelGWatershed::getStatistics(). Those that were not asked for have no rows.
struct Statistics
{
    Mat stats, centroids, mean_colors, mean_depths, positions, normals;
};

void measureSuperpixels(const Mat& labels, int num_labels, const StatisticsInput& input, Statistics& tables);

}}} // namespace

#endif
