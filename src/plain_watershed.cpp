// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plain_watershed.hpp"
#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

void PlainWatershed::reserve(Size size)
{
    gray_.create(size, CV_8UC1);
    gradient_.create(size, CV_16UC1);
    nodes_.reserve(size);
}

int PlainWatershed::run(const Frame& frame, const Parameters& parameters, Mat& labels)
{
    CV_TRACE_FUNCTION();
    const int alpha = parameters.alphaWeight();
    int num_superpixels = frame.num_superpixels;
    channels_ = frame.color.channels();
    if (frame.follows)
        extractLabels(nodes_, last_labels_);
    computeGradient(frame.color, frame.depth, alpha, gray_, gradient_);
    makeNodes(frame.color, frame.depth, nodes_);
    if (!frame.mask.empty())
    {
        forgetGradients(frame.mask, gradient_);
        closeOutside(frame.mask, nodes_);
    }
    if (!frame.markers.empty())
        labelMarkers(frame.markers, nodes_);
    else
    {
        if (frame.follows)
            followMarkers(gradient_, last_labels_, !frame.mask.empty(), marker_buffers_, markers_);
        else if (frame.mask.empty())
            placeMarkers(gradient_, num_superpixels, markers_);
        else
            placeMarkers(gradient_, frame.mask, num_superpixels, marker_buffers_, markers_);
        labelMarkers(markers_, nodes_);
        num_superpixels = int(markers_.size());
    }
    floodFromMarkers(gradient_, parameters.border_threshold, alpha, nodes_, flood_buffers_);
    absorbLines(alpha, nodes_, line_buffers_);
    extractLabels(nodes_, labels);
    return num_superpixels;
}

void PlainWatershed::makeFeatures(bool uniform_color, Padded<Feature>& features) const
{
    const Size size = nodes_.size();
    Mat color(size, CV_8UC3), depth(size, CV_8UC1);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
        {
            const Pixel& pixel = nodes_.row(y)[x].pixel;
            color.at<Vec3b>(y, x) = Vec3b(pixel.b, pixel.g, pixel.r);
            depth.at<uchar>(y, x) = pixel.depth;
        }
    if (channels_ == 1)
        extractChannel(color, color, 0);
    makePyramid(color, depth, uniform_color, 0, &features);
}

void PlainWatershed::drawLines(Mat& mask) const
{
    for (size_t i = 0; i < line_buffers_.lines.size(); i++)
        if (nodes_.data()[line_buffers_.lines[i]].state > 0)
            mask.at<uchar>(nodes_.point(line_buffers_.lines[i])) = 255;
}

}}} // namespace
