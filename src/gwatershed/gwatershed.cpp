// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "gwatershed/gradient_map.hpp"
#include "gwatershed/gwatershed.hpp"
#include "gwatershed/marker_tracking.hpp"
#include "shared/grid_markers.hpp"
#include "shared/mask_pyramid.hpp"

namespace cv { namespace ximgproc { namespace gws {

void GWatershed::reserve(Size size)
{
    gray_.create(size, CV_8UC1);
    gradient_.create(size, CV_16UC1);
    pixels_.reserve(size);
}

int GWatershed::run(const Frame& frame, const Parameters& parameters, Mat& labels)
{
    CV_TRACE_FUNCTION();
    const int alpha = parameters.alphaWeight();
    int num_superpixels = frame.num_superpixels;
    channels_ = std::min(frame.color.channels(), 3);
    if (frame.continues)
        extractLabels(pixels_, last_labels_);
    computeGradientMap(frame.color, frame.depth, alpha, gray_, gradient_);
    makePixelMap(frame.color, frame.depth, pixels_);
    if (!frame.mask.empty())
    {
        forgetGradients(frame.mask, gradient_);
        closeOutside(frame.mask, pixels_);
    }
    if (!frame.markers.empty())
        labelMarkers(frame.markers, pixels_);
    else
    {
        if (frame.continues)
            trackMarkers(gradient_, last_labels_, !frame.mask.empty(), marker_buffers_, markers_);
        else if (frame.mask.empty())
            placeGridMarkers(gradient_, num_superpixels, markers_);
        else
            placeShapeMarkers(gradient_, frame.mask, num_superpixels, marker_buffers_, markers_);
        labelMarkers(markers_, pixels_);
        num_superpixels = int(markers_.size());
    }
    floodFromMarkers(gradient_, parameters.border_threshold, alpha, pixels_, flood_buffers_);
    absorbLines(alpha, pixels_, line_buffers_);
    extractLabels(pixels_, labels);
    return num_superpixels;
}

Padded<Feature> GWatershed::features(bool lab_input) const
{
    const Size size = pixels_.size();
    Padded<Feature> features;
    features.create(size, Feature());
    parallel_for_(Range(0, size.height), [&](const Range& rows)
    {
        std::vector<uchar> color(size_t(channels_) * size.width), depth(size.width);
        for (int y = rows.start; y < rows.end; y++)
        {
            const FloodPixel* row = pixels_.row(y);
            for (int x = 0; x < size.width; x++)
            {
                const Pixel& pixel = row[x].value;
                const uchar values[3] = { pixel.b, pixel.g, pixel.r };
                std::copy(values, values + channels_, &color[size_t(channels_) * x]);
                depth[x] = pixel.depth;
            }
            makeFeatureRow(color.data(), channels_, lab_input, depth.data(), size.width, features.row(y));
        }
    });
    return features;
}

void GWatershed::drawLines(Mat& mask) const
{
    for (size_t i = 0; i < line_buffers_.lines.size(); i++)
        if (pixels_.data()[line_buffers_.lines[i]].state > 0)
            mask.at<uchar>(pixels_.point(line_buffers_.lines[i])) = 255;
}

}}} // namespace
