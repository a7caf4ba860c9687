// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PLAIN_WATERSHED_HPP
#define OPENCV_GWATERSHED_PLAIN_WATERSHED_HPP

#include "frame.hpp"
#include "parameters.hpp"
#include "region.hpp"
#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! GWATERSHED, Algorithm 1 of the paper, from the 8-bit image and the scaled depth to the labels.
//! Holds the buffers.
class PlainWatershed
{
public:
    //! Makes room for images of a size.
    void reserve(Size size);

    //! labels become CV_32SC1, below 0 where there is none. Returns the number of superpixels.
    int run(const Frame& frame, const Parameters& parameters, Mat& labels);

    //! Sets the watershed lines of the last run in a mask of its size.
    void drawLines(Mat& mask) const;

    //! Features of the pixels of the last run.
    void makeFeatures(bool uniform_color, Padded<Feature>& features) const;

private:
    Mat gray_, gradient_;
    std::vector<Point> markers_;
    MarkerBuffers marker_buffers_;
    Mat last_labels_;
    int channels_ = 0; // of the last image
    NodeMap nodes_;
    PlainFloodBuffers flood_buffers_;
    LineBuffers line_buffers_;
};

}}} // namespace

#endif
