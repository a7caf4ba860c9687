// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "gwatershed/gradient_map.hpp"
#include "gwatershed/gwatershed.hpp"
#include "gwatershed/marker_tracking.hpp"
#include "shared/grid_markers.hpp"
#include "shared/masks.hpp"

namespace cv { namespace ximgproc { namespace gws {

void GWatershed::reserve(Size size)
{
    gradient_.create(size, CV_16UC1);
    pixels_.reserve(size);
}

int GWatershed::run(const Frame& frame, const Parameters& parameters, Mat& labels)
{
    CV_TRACE_FUNCTION();
    const int alpha = parameters.alphaWeight();
    int num_superpixels = frame.num_superpixels;
    if (frame.continues)
        extractLabels(pixels_, last_labels_);
    frame.color.copyTo(color_);
    frame.depth.copyTo(depth_);
    computeGradientMap(frame.color, frame.depth, alpha, gradient_);
    if (!frame.mask.empty())
        forgetGradients(frame.mask, gradient_);
    makePixelMap(frame.color, frame.depth, alpha, gradient_, parameters.border_threshold, pixels_);
    if (!frame.mask.empty())
        closeOutside(frame.mask, pixels_);
    if (!frame.markers.empty())
        labelMarkers(frame.markers, pixels_);
    else
    {
        if (frame.continues)
            trackMarkers(gradient_, last_labels_, !frame.mask.empty(), marker_buffers_, markers_);
        else if (frame.mask.empty())
            placeGridMarkers(gradient_, MarkerGrid(gradient_.size(), num_superpixels), markers_);
        else
            placeShapeMarkers(gradient_, frame.mask, num_superpixels, marker_buffers_, markers_);
        labelMarkers(markers_, pixels_);
        num_superpixels = int(markers_.size());
    }
    floodFromMarkers(pixels_, queues_);
    absorbLines(pixels_, line_buffers_);
    extractLabels(pixels_, labels);
    return num_superpixels;
}

FeatureMap GWatershed::features(bool lab_input) const
{
    FeatureMap features;
    features.create(color_.size(), Feature());
    parallel_for_(Range(0, color_.rows), [&](const Range& rows)
    {
        makeFeatures(color_, depth_, lab_input, rows, features);
    });
    return features;
}

void GWatershed::drawLines(Mat& mask) const
{
    for (const LineBuffers::Chunk& chunk : line_buffers_.chunks)
        for (int pixel : chunk.lines)
            if (pixels_.data()[pixel].state > 0)
                mask.at<uchar>(pixels_.point(pixel)) = 255;
}

}}} // namespace
