// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PLAIN_WATERSHED_HPP
#define OPENCV_GWATERSHED_PLAIN_WATERSHED_HPP

#include "parameters.hpp"
#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! GWATERSHED, Algorithm 1 of the paper, from the 8-bit image and the scaled depth to the labels.
//! Holds the buffers.
class PlainWatershed
{
public:
    //! Makes room for images of a size.
    void reserve(Size size);

    //! color is 8-bit with 1, 3 or 4 channels, depth CV_8UC1 or empty; labels become CV_32SC1.
    void run(const Mat& color, const Mat& depth, const Parameters& parameters, Mat& labels);

    //! Sets the watershed lines of the last run in a mask of its size.
    void drawLines(Mat& mask) const;

private:
    Mat gray_, gradient_;
    std::vector<Point> markers_;
    NodeMap nodes_;
    LineBuffers line_buffers_;
};

}}} // namespace

#endif
