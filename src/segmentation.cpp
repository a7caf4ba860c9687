// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "segmentation.hpp"
#include "shared/masks.hpp"

namespace cv { namespace ximgproc { namespace gws {

Mask::Mask(const Mat& pixels_)
    : pixels(pixels_.empty() ? Mat() : Mat(pixels_ != 0)), bounds(pixels.empty() ? Rect() : findBounds(pixels)),
      area(pixels.empty() ? 0 : countNonZero(pixels))
{
}

bool Mask::operator==(const Mask& other) const
{
    return pixels.size() == other.pixels.size() && (empty() || countNonZero(pixels != other.pixels) == 0);
}

//! Makes labels of the size of an image, which are -1 outside of the bounds.
static void createLabels(Size size, const Rect& bounds, Mat& labels)
{
    labels.create(size, CV_32SC1);
    if (bounds.size() != size)
        labels.setTo(Scalar(-1));
}

void Segmentation::start(Size size, const Parameters& parameters_, const Mask& mask_)
{
    complete = false;
    number = 0;
    hierarchy = MergeHierarchy();
    parameters = parameters_;
    mask = mask_;
    bounds = mask.empty() ? Rect(Point(), size) : mask.bounds;
    createLabels(size, bounds, labels);
}

void Segmentation::take(const Mat& labels_inside)
{
    if (bounds.size() == labels.size())
        labels = labels_inside;
    else
        labels_inside.copyTo(labels(bounds));
}

void Segmentation::cut(int num_superpixels)
{
    Mat whole = labels;
    if (hierarchy.holds(labels))
    {
        whole = Mat();
        createLabels(labels.size(), bounds, whole);
    }
    Mat part = whole(bounds);
    number = hierarchy.cut(num_superpixels, part);
    labels = whole;
}

}}} // namespace
