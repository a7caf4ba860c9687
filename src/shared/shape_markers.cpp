// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/shape_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! If no point is in the disc, as in a region that is not convex, the point nearest to the centre is taken.
Point findMarkerInRegion(const Mat& gradient, PointIterator begin, PointIterator end, int part)
{
    const int64 area = end - begin;
    int64 sum_x = 0, sum_y = 0;
    for (PointIterator p = begin; p != end; ++p)
    {
        sum_x += p->x;
        sum_y += p->y;
    }
    const Point center(int(sum_x / area), int(sum_y / area));
    const int64 near_enough = std::max<int64>(area / (4 * part * part), 2); // radius, squared

    Point best;
    int64 best_away = INT64_MAX;
    int best_gradient = INT_MAX;
    for (PointIterator p = begin; p != end; ++p)
    {
        const int64 dx = p->x - center.x, dy = p->y - center.y, away = dx * dx + dy * dy;
        const int value = away <= near_enough ? gradient.at<ushort>(*p) : INT_MAX;
        if (value < best_gradient || (value == best_gradient && away < best_away))
        {
            best = *p;
            best_away = away;
            best_gradient = value;
        }
    }
    return best;
}

//! Sorts by columns. Points of a column keep their order.
static void sortByColumns(PointIterator begin, PointIterator end, std::vector<Point>& sorted)
{
    int left = INT_MAX, right = 0;
    for (PointIterator p = begin; p != end; ++p)
    {
        left = std::min(left, p->x);
        right = std::max(right, p->x);
    }
    std::vector<int> starts(right - left + 2, 0);
    for (PointIterator p = begin; p != end; ++p)
        starts[p->x - left + 1]++;
    for (size_t i = 1; i < starts.size(); i++)
        starts[i] += starts[i - 1];
    sorted.resize(end - begin);
    for (PointIterator p = begin; p != end; ++p)
        sorted[starts[p->x - left]++] = *p;
}

static bool isLeftOf(Point a, Point b)
{
    return a.x < b.x;
}

//! Divides the region into rows of cells. All cells have the same area and are nearly square.
void placeInRegion(const Mat& gradient, PointIterator begin, PointIterator end, int n,
                   std::vector<Point>& markers)
{
    const auto sides = std::minmax_element(begin, end, isLeftOf);
    const int width = sides.second->x - sides.first->x + 1;
    const int height = (end - 1)->y - begin->y + 1;
    const int square = cvRound(std::sqrt(double(n) * height / width));
    const int rows = std::max(1, std::min(square, std::min(n, height)));
    const int64 area = end - begin;
    std::vector<Point> row;
    for (int i = 0; i < rows; i++)
    {
        const int64 first = int64(n) * i / rows, last = int64(n) * (i + 1) / rows;
        sortByColumns(begin + area * first / n, begin + area * last / n, row);
        const int64 row_area = int64(row.size()), cells = last - first;
        for (int64 k = 0; k < cells; k++)
            markers.push_back(findMarkerInRegion(gradient, row.begin() + row_area * k / cells,
                                                 row.begin() + row_area * (k + 1) / cells, 2));
    }
}

void listPoints(const Mat& labels, int first, int num_regions, MarkerBuffers& buffers)
{
    std::vector<Point>& points = buffers.points;
    std::vector<int>& starts = buffers.starts;
    starts.assign(num_regions + 1, 0);
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        for (int x = 0; x < labels.cols; x++)
            if (row[x] >= first)
                starts[row[x] - first + 1]++;
    }
    for (int i = 0; i < num_regions; i++)
        starts[i + 1] += starts[i];

    std::vector<int> ends(starts);
    points.resize(starts[num_regions]);
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        for (int x = 0; x < labels.cols; x++)
            if (row[x] >= first)
                points[ends[row[x] - first]++] = Point(x, y);
    }
}

//! Each component gets one marker. The other markers are shared out in proportion to the areas.
void placeShapeMarkers(const Mat& gradient, const Mat& mask, int num_markers, MarkerBuffers& buffers,
                       std::vector<Point>& markers)
{
    CV_TRACE_FUNCTION();
    std::vector<Point>& points = buffers.points;
    const std::vector<int>& starts = buffers.starts;
    const int count = connectedComponents(mask, buffers.components, 4, CV_32S) - 1, area = countNonZero(mask);
    listPoints(buffers.components, 1, count, buffers);
    markers.clear();
    const int64 others = std::max(num_markers - count, 0), other_area = std::max(area - count, 1);
    for (int i = 0; i < count; i++)
    {
        const int64 share = others * (starts[i + 1] - (i + 1)) / other_area - others * (starts[i] - i) / other_area;
        placeInRegion(gradient, points.begin() + starts[i], points.begin() + starts[i + 1], int(1 + share), markers);
    }
}

}}} // namespace
