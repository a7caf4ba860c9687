// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "segmenter.hpp"
#include "conversion.hpp"
#include "depth/depth_scale.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/renumber.hpp"
#include "user_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Depth that is missing outside of the mask.
static Mat keepInside(const Mat& depth, const Mat& mask)
{
    if (depth.empty() || mask.empty())
        return depth;
    Mat inside(depth.size(), depth.type(), Scalar(0));
    depth.copyTo(inside, mask);
    return inside;
}

Mat scaleInside(const Mat& depth, const Mat& mask, const Parameters& parameters, Mat& buffer)
{
    return scaleDepth(keepInside(depth, mask), parameters.depthRange(), buffer);
}

//! Whether depth is metric, or shall be taken as such, and wide enough for normals. Planes are measured at places of 16
//! bits, which are more than any camera has.
static bool usesSurfaces(const Mat& depth, const Parameters& parameters)
{
    const int NARROWEST = 16, WIDEST = SHRT_MAX;
    const bool is_metric = depth.depth() != CV_8U && depth.depth() != CV_16S;
    return std::min(depth.rows, depth.cols) >= NARROWEST && std::max(depth.rows, depth.cols) <= WIDEST &&
           parameters.algorithm == RGWATERSHED && parameters.normal_weight > 0 && (is_metric || parameters.focal_x > 0);
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
    result.parameters.lab_input &= image.channels() != 2; // none of two is lightness
    const Rect bounds = result.bounds;
    const Mat depth_inside = depth.empty() ? Mat() : depth(bounds);
    const bool adapts_to_depth = parameters.depth_adaptive && markers.empty() && usesSurfaces(depth_inside, parameters);
    const bool uses_depth = parameters.alpha < 1 || adapts_to_depth;
    if (!bounds.empty())
        run(makeFrame(image(bounds), uses_depth ? depth_inside : Mat(), markers.empty() ? Mat() : markers(bounds),
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
    frame.color = convertImage(image, frame.mask, result.parameters.valueRange(), converted_);
    if (usesSurfaces(depth, result.parameters))
        addSurface(depth, result, frame);
    else
        frame.depth = scaleInside(depth, frame.mask, result.parameters, scaled_);
    frame.num_superpixels = result.parameters.countSuperpixels(bounds.size(), frame.num_pixels);
    if (!markers.empty())
    {
        frame.num_superpixels = numberMarkers(markers, frame.mask, numbered_);
        if (result.parameters.algorithm == RGWATERSHED)
            frame.num_superpixels = divideMarkers(frame.num_superpixels, numbered_, frame.owners);
        frame.markers = numbered_;
    }
    return frame;
}

//! Nearness and normals. The optical axis meets the middle of what is segmented: another place would shear space, in
//! which planes stay planes.
void Segmenter::addSurface(const Mat& depth, const Segmentation& result, Frame& frame)
{
    const Parameters& parameters = result.parameters;
    const Size size = result.bounds.size();
    frame.camera.focal = parameters.focalLength(size);
    frame.camera.center = Point2f(float(size.width - 1) / 2, float(size.height - 1) / 2);
    findSurface(keepInside(depth, frame.mask), parameters.depthRange(), frame.camera, surface_, frame.depth,
                frame.normals);
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
    if (parameters.algorithm == GWATERSHED)
        result.number = gwatershed_.run(frame, parameters, labels);
    else
    {
        result.number = rgwatershed_.run(frame, parameters, num_iterations, merge_buffers_);
        Mat found = rgwatershed_.labels();
        if (!frame.owners.empty())
        {
            renumber(frame.owners, found);
            result.number = 1 + *std::max_element(frame.owners.begin(), frame.owners.end());
        }
        result.take(found);
    }
    if (!frame.mask.empty())
    {
        labels = result.labels(result.bounds);
        max(labels, Scalar(-1), labels);
    }
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

void Segmenter::buildHierarchy(Segmentation& result)
{
    const Parameters& used = result.parameters;
    const FeatureMap features = used.algorithm == GWATERSHED ? gwatershed_.features(used.lab_input)
                                                             : rgwatershed_.features();
    result.hierarchy.build(features, floodDistance(used, result.with_depth, features.withNormals()),
                           result.labels(result.bounds), result.number, merge_buffers_);
    if (hasLargeMergeBuffers(result.number, result.bounds.area()))
        merge_buffers_ = MergeBuffers();
}

}}} // namespace
