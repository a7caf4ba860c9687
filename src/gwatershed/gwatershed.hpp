// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_GWATERSHED_HPP
#define OPENCV_GWATERSHED_GWATERSHED_HPP

#include "gwatershed/pixel_flood.hpp"
#include "gwatershed/watershed_lines.hpp"
#include "shared/features.hpp"
#include "shared/frame.hpp"
#include "shared/parameters.hpp"
#include "shared/shape_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! GWATERSHED: Algorithm 1 of the paper, from the 8-bit image and the scaled depth to the labels. An object keeps the
//! buffers from image to image.
class GWatershed
{
public:
    //! Allocates buffers for images of a size.
    void reserve(Size size);

    //! labels become CV_32SC1, below 0 where there is no label. Returns the number of superpixels.
    int run(const Frame& frame, const Parameters& parameters, Mat& labels);

    //! Marks the watershed lines of the last run in a mask of the size of its image.
    void drawLines(Mat& mask) const;

    //! Features of the pixels of the last run.
    FeatureMap features(bool lab_input) const;

private:
    Mat color_, depth_; // of the last run
    Mat gradient_;
    std::vector<Point> markers_;
    MarkerBuffers marker_buffers_;
    Mat last_labels_;
    PixelMap pixels_;
    PixelQueue queues_;
    LineBuffers line_buffers_;
};

}}} // namespace

#endif
