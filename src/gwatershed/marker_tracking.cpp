// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "gwatershed/marker_tracking.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Takes the markers of small regions (below a quarter of the mean area, the smallest first) and gives each of them to
//! a large region (above two and a half times the mean, the largest first), which then has two. So superpixels follow
//! a camera that turns on and on: what comes into view belongs to a few large ones at first.
//! @note Not in the paper.
static void exchangeMarkers(const Mat& gradient, MarkerBuffers& buffers, std::vector<Point>& markers)
{
    typedef std::pair<int, int> AreaAndLabel;
    const int n = int(markers.size());
    std::vector<Point>& points = buffers.points;
    const std::vector<int>& starts = buffers.starts;
    std::vector<AreaAndLabel> small, large;
    const double mean_area = double(points.size()) / n;
    for (int i = 0; i < n; i++)
    {
        const int area = starts[i + 1] - starts[i];
        if (area < mean_area / 4)
            small.push_back(AreaAndLabel(area, i));
        else if (area > mean_area * 2.5)
            large.push_back(AreaAndLabel(-area, i));
    }
    std::sort(small.begin(), small.end());
    std::sort(large.begin(), large.end());

    std::vector<Point> pair;
    for (size_t i = 0; i < std::min(small.size(), large.size()); i++)
    {
        const int label = large[i].second;
        pair.clear();
        placeInRegion(gradient, points.begin() + starts[label], points.begin() + starts[label + 1], 2, pair);
        markers[label] = pair[0];
        markers[small[i].second] = pair[1];
    }
}

void trackMarkers(const Mat& gradient, const Mat& labels, bool masked, MarkerBuffers& buffers,
                  std::vector<Point>& markers)
{
    CV_TRACE_FUNCTION();
    const int n = int(markers.size());
    listPoints(labels, 0, n, buffers);
    for (int i = 0; i < n; i++)
        markers[i] = findMarkerInRegion(gradient, buffers.points.begin() + buffers.starts[i],
                                        buffers.points.begin() + buffers.starts[i + 1], 4);
    if (!masked) // in a mask, a small region may be a component of its own
        exchangeMarkers(gradient, buffers, markers);
}

}}} // namespace
