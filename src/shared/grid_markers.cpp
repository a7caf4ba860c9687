// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/grid_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! @note The paper asks for local minima of the gradient and gives no rule.
Point findMarker(const Mat& gradient, const Rect& cell)
{
    const Point center2(2 * cell.x + cell.width - 1, 2 * cell.y + cell.height - 1); // twice the centre
    const int rx = cell.width > 2 ? std::max(cell.width / 4, 1) : 0;
    const int ry = cell.height > 2 ? std::max(cell.height / 4, 1) : 0;
    const Rect window(Point(center2.x / 2 - rx, center2.y / 2 - ry),
                      Point((center2.x + 1) / 2 + rx + 1, (center2.y + 1) / 2 + ry + 1));
    Point best;
    int smallest = INT_MAX;
    int64 nearest = 0;
    for (int y = window.y; y < window.br().y; y++)
    {
        const ushort* row = gradient.ptr<ushort>(y);
        for (int x = window.x; x < window.br().x; x++)
        {
            if (row[x] > smallest)
                continue;
            const int64 dx = 2 * x - center2.x, dy = 2 * y - center2.y, away = dx * dx + dy * dy;
            if (row[x] < smallest || away < nearest)
            {
                best = Point(x, y);
                smallest = row[x];
                nearest = away;
            }
        }
    }
    return best;
}

//! The i-th of the n + 1 limits that divide a length into n equal parts.
static int divide(int length, int i, int n)
{
    return int(int64(length) * i / n);
}

//! Number of rows of a grid of n cells that are nearly square.
static int countRows(Size size, int n)
{
    const int fewest = (n + size.width - 1) / size.width; // rows, at least, for n cells
    const int square = cvRound(std::sqrt(double(n) * size.height / size.width));
    return std::max(fewest, std::min(square, std::min(size.height, n)));
}

void divideIntoBands(Size size, int num_markers, int height, std::vector<MarkerBand>& bands)
{
    const int rows = countRows(size, num_markers);
    bands.clear();
    for (int i = 0, first = 0; i < rows; i++)
    {
        const int top = divide(size.height, first, rows), bottom = divide(size.height, i + 1, rows);
        if (i + 1 < rows && std::min(bottom - top, size.height - bottom) < height)
            continue;
        const MarkerBand band = { Range(top, bottom),
                                  Range(divide(num_markers, first, rows), divide(num_markers, i + 1, rows)) };
        bands.push_back(band);
        first = i + 1;
    }
}

//! Rows of cells may differ by one cell.
void placeGridMarkers(const Mat& gradient, int num_markers, std::vector<Point>& markers)
{
    CV_TRACE_FUNCTION();
    const Size size = gradient.size();
    const int rows = countRows(size, num_markers);
    markers.resize(num_markers);
    parallel_for_(Range(0, rows), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
        {
            const int first = divide(num_markers, i, rows), last = divide(num_markers, i + 1, rows);
            const int top = divide(size.height, i, rows), bottom = divide(size.height, i + 1, rows);
            for (int k = first, left = 0, right; k < last; k++, left = right)
            {
                right = divide(size.width, k - first + 1, last - first);
                markers[k] = findMarker(gradient, Rect(Point(left, top), Point(right, bottom)));
            }
        }
    });
}

}}} // namespace
