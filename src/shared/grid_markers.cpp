// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/grid_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The pixel with the smallest gradient, up to a quarter of the cell (at least one pixel) away from the centre of the
//! cell. Of equal ones the nearest to the centre, then the first in raster order. It lies in the cell, so no two
//! markers are at the same place.
//! @note The paper asks for local minima of the gradient and gives no rule.
static Point findMarker(const Mat& gradient, const Rect& cell)
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

//! Number of rows of a grid of n cells that are nearly square. If a number near to it divides n, it is taken, so that
//! cells lie one below the other and a transposed image has the transposed grid.
static int countRows(Size size, int n)
{
    const double MOST_STRETCHED = 0.08;
    const int fewest = (n + size.width - 1) / size.width; // rows, at least, for n cells
    const int most = std::min(size.height, n);
    const double square = std::sqrt(double(n) * size.height / size.width);
    int best = std::max(fewest, std::min(cvRound(square), most));
    double least = MOST_STRETCHED;
    for (int rows = std::max(fewest, cvCeil(square / (1 + least))); rows <= std::min(most, cvFloor(square * (1 + least)));
         rows++)
    {
        const double stretched = std::max(rows / square, square / rows) - 1;
        if (n % rows != 0 || stretched >= least)
            continue;
        best = rows;
        least = stretched;
    }
    return best;
}

MarkerGrid::MarkerGrid(Size size_, int num_cells_, int markers_in_cell)
    : size(size_), num_cells(num_cells_), rows(countRows(size_, num_cells_)), parts(1, 1)
{
    int height = int(std::sqrt(double(markers_in_cell)));
    while (markers_in_cell % height != 0)
        height--;
    const Size wanted(markers_in_cell / height, height);
    if (size.height / rows >= wanted.height && size.width / ((num_cells + rows - 1) / rows) >= wanted.width)
    {
        parts = wanted;
        return;
    }
    num_cells *= markers_in_cell;
    rows = countRows(size, num_cells);
}

void divideIntoBands(const MarkerGrid& grid, int height, std::vector<MarkerBand>& bands)
{
    const int in_cell = grid.parts.area();
    bands.clear();
    for (int i = 0, first = 0; i < grid.rows; i++)
    {
        const int top = divide(grid.size.height, first, grid.rows);
        const int bottom = divide(grid.size.height, i + 1, grid.rows);
        if (i + 1 < grid.rows && std::min(bottom - top, grid.size.height - bottom) < height)
            continue;
        const MarkerBand band = { Range(top, bottom), Range(in_cell * divide(grid.num_cells, first, grid.rows),
                                                            in_cell * divide(grid.num_cells, i + 1, grid.rows)) };
        bands.push_back(band);
        first = i + 1;
    }
}

//! One marker in each part of a cell.
static void placeInCell(const Mat& gradient, const Rect& cell, Size parts, Point* markers)
{
    for (int i = 0; i < parts.height; i++)
        for (int k = 0; k < parts.width; k++)
        {
            const Point first(divide(cell.width, k, parts.width), divide(cell.height, i, parts.height));
            const Point last(divide(cell.width, k + 1, parts.width), divide(cell.height, i + 1, parts.height));
            *markers++ = findMarker(gradient, Rect(cell.tl() + first, cell.tl() + last));
        }
}

void placeGridMarkers(const Mat& gradient, const MarkerGrid& grid, std::vector<Point>& markers)
{
    CV_TRACE_FUNCTION();
    markers.resize(grid.numMarkers());
    parallel_for_(Range(0, grid.rows), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
        {
            const int first = divide(grid.num_cells, i, grid.rows), last = divide(grid.num_cells, i + 1, grid.rows);
            const int top = divide(grid.size.height, i, grid.rows), bottom = divide(grid.size.height, i + 1, grid.rows);
            for (int k = first, left = 0, right; k < last; k++, left = right)
            {
                right = divide(grid.size.width, k - first + 1, last - first);
                placeInCell(gradient, Rect(Point(left, top), Point(right, bottom)), grid.parts,
                            markers.data() + k * grid.parts.area());
            }
        }
    });
}

}}} // namespace
