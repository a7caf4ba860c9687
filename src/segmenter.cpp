// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "segmenter.hpp"
#include "conversion.hpp"
#include "depth_scale.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/user_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

Mat convertInside(const Mat& image, const Mat& mask, const Parameters& parameters, Mat& buffer)
{
    const FloatRange range = { parameters.low_value, parameters.high_value };
    return convertImage(image, mask, range, buffer);
}

Mat scaleInside(const Mat& depth, const Mat& mask, const Parameters& parameters, Mat& buffer)
{
    const FloatRange range = { parameters.near_depth, parameters.far_depth };
    if (depth.empty() || mask.empty())
        return scaleDepth(depth, range, buffer);
    Mat inside(depth.size(), depth.type(), Scalar(0));
    depth.copyTo(inside, mask);
    return scaleDepth(inside, range, buffer);
}

void Segmenter::reserve(int algorithm, Size size)
{
    if (algorithm == GWATERSHED)
        gwatershed_.reserve(size);
    else
        rgwatershed_.reserve(size);
}

void Segmenter::segment(const Mat& image, const Mat& depth, const Mat& markers, const Mask& mask,
                        const Parameters& parameters, int num_iterations, Segmentation& result)
{
    CV_TRACE_FUNCTION();
    const Last last = last_;
    last_ = Last();
    result.start(image.size(), parameters, mask);
    const Rect bounds = result.bounds;
    if (!bounds.empty())
        run(makeFrame(image(bounds), depth.empty() ? Mat() : depth(bounds), markers.empty() ? Mat() : markers(bounds),
                      result), last, num_iterations, result);
    result.complete = true;
}

//! Frame of what is inside of the bounds. A mask without a pixel outside is left out.
Frame Segmenter::makeFrame(const Mat& image, const Mat& depth, const Mat& markers, const Segmentation& result)
{
    const Rect bounds = result.bounds;
    Frame frame;
    frame.num_pixels = result.mask.empty() ? bounds.area() : result.mask.area;
    if (frame.num_pixels < bounds.area())
        frame.mask = result.mask.pixels(bounds);
    frame.color = convertInside(image, frame.mask, result.parameters, converted_);
    frame.depth = scaleInside(depth, frame.mask, result.parameters, scaled_);
    frame.num_superpixels = result.parameters.countSuperpixels(frame.num_pixels);
    if (!markers.empty())
    {
        frame.num_superpixels = numberMarkers(markers, frame.mask, numbered_);
        frame.markers = numbered_;
    }
    return frame;
}

void Segmenter::run(Frame frame, const Last& last, int num_iterations, Segmentation& result)
{
    const Parameters& parameters = result.parameters;
    Mat labels = result.labels(result.bounds);
    result.with_depth = !frame.depth.empty();
    if (frame.num_superpixels == 0)
    {
        labels.setTo(Scalar(-1));
        return;
    }
    Last now;
    now.algorithm = parameters.algorithm;
    now.size = result.labels.size();
    now.num_superpixels = frame.num_superpixels;
    const bool temporal = parameters.temporal && frame.markers.empty();
    frame.continues = temporal && now == last;
    result.number = parameters.algorithm == GWATERSHED ? gwatershed_.run(frame, parameters, labels)
                                                       : rgwatershed_.run(frame, parameters, num_iterations, labels);
    if (!frame.mask.empty())
        max(labels, Scalar(-1), labels);
    if (temporal)
        last_ = now;
}

void Segmenter::drawLines(const Segmentation& result, Mat& mask) const
{
    if (result.number == 0 || result.parameters.algorithm != GWATERSHED)
        return;
    Mat part = mask(result.bounds);
    gwatershed_.drawLines(part);
}

void Segmenter::buildHierarchy(Segmentation& result) const
{
    const Parameters& used = result.parameters;
    const Padded<Feature> features = used.algorithm == GWATERSHED ? gwatershed_.features(used.lab_input)
                                                                  : rgwatershed_.features();
    result.hierarchy.build(features, floodDistance(used.alpha, result.with_depth), result.labels(result.bounds),
                           result.number);
}

}}} // namespace
