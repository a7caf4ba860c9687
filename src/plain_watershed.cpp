// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plain_watershed.hpp"

namespace cv { namespace ximgproc { namespace gws {

void PlainWatershed::reserve(Size size)
{
    gray_.create(size, CV_8UC1);
    gradient_.create(size, CV_16UC1);
    nodes_.reserve(size);
}

void PlainWatershed::run(const Mat& color, const Mat& depth, const Parameters& parameters, Mat& labels)
{
    CV_TRACE_FUNCTION();
    const int alpha = parameters.alphaWeight();
    computeGradient(color, depth, alpha, gray_, gradient_);
    placeMarkers(gradient_, parameters.countSuperpixels(color.size()), markers_);
    makeNodes(color, depth, nodes_);
    floodFromMarkers(markers_, gradient_, parameters.border_threshold, alpha, nodes_);
    absorbLines(alpha, nodes_, line_buffers_);
    extractLabels(nodes_, labels);
}

void PlainWatershed::drawLines(Mat& mask) const
{
    for (size_t i = 0; i < line_buffers_.lines.size(); i++)
        mask.at<uchar>(nodes_.point(line_buffers_.lines[i])) = 255;
}

}}} // namespace
