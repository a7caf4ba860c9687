// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/adaptive_markers.hpp"
#include "shared/grid_markers.hpp"
#include "shared/surfaces.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! Divides an image into cells of equal weight, again and again across the longer side.
class CellDivider
{
public:
    CellDivider(const Mat& weights, const Mat& gradient, std::vector<Point>& markers)
        : gradient_(gradient), markers_(markers)
    {
        integral(weights, sums_, CV_64F); // of integers, so sums are exact
    }

    //! Places n markers in the image, which has as many elements.
    void divide(int n)
    {
        parts_.assign(1, { Rect(Point(), gradient_.size()), n });
        while (!parts_.empty())
        {
            const Part part = parts_.back();
            parts_.pop_back();
            if (part.num_markers > 1)
                halve(part.rect, part.num_markers);
            else
                markers_.push_back(findMarkerInCell(gradient_, part.rect));
        }
    }

private:
    //! A part of the image, and the number of markers in it.
    struct Part
    {
        Rect rect;
        int num_markers;
    };

    //! Half of the markers go to each half of the weight, as far as there is room.
    void halve(const Rect& part, int n)
    {
        const bool upright = part.height > part.width;
        const int length = upright ? part.height : part.width, breadth = upright ? part.width : part.height;
        const int half = n / 2, least = (half + breadth - 1) / breadth, rest = (n - half + breadth - 1) / breadth;
        int cut = std::min(least, length - 1);
        const double wanted = sum(part) * half / n;
        while (cut < length - rest && sum(firstPart(part, upright, cut)) < wanted)
            cut++;
        const Rect first = firstPart(part, upright, cut);
        const Rect second = upright ? Rect(part.x, first.br().y, part.width, part.height - cut)
                                    : Rect(first.br().x, part.y, part.width - cut, part.height);
        const int in_first = std::min(std::max(half, n - second.area()), first.area()); // there may be no room for half
        parts_.push_back({ second, n - in_first });
        parts_.push_back({ first, in_first }); // comes next
    }

    static Rect firstPart(const Rect& part, bool upright, int cut)
    {
        return upright ? Rect(part.x, part.y, part.width, cut) : Rect(part.x, part.y, cut, part.height);
    }

    double sum(const Rect& r) const
    {
        const double *top = sums_.ptr<double>(r.y), *bottom = sums_.ptr<double>(r.br().y);
        return bottom[r.br().x] - bottom[r.x] - top[r.br().x] + top[r.x];
    }

    const Mat& gradient_;
    std::vector<Point>& markers_;
    Mat sums_;
    std::vector<Part> parts_; // that are still to be divided
};

} // namespace

void placeAdaptiveMarkers(const Mat& gradient, const FeatureMap& features, int num_markers,
                          std::vector<Point>& markers)
{
    CV_TRACE_FUNCTION();
    const int UNIT = 16; // the weight of the nearest element, and of those without depth
    Mat weights(features.size(), CV_16UC1);
    for (int y = 0; y < weights.rows; y++)
        for (int x = 0; x < weights.cols; x++)
        {
            const int depth = features.row(y)[x].depth;
            const float scale = depth ? areaScale(STEPS_PER_LEVEL * depth, features.camera) : 1.f;
            weights.at<ushort>(y, x) = saturate_cast<ushort>(UNIT * scale);
        }
    markers.clear();
    CellDivider(weights, gradient, markers).divide(num_markers);
}

}}} // namespace
