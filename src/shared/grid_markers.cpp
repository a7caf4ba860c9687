// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/grid_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Distance from the middle of a gradient, twice in each direction.
static int64 fromMiddle(const Mat& gradient, Point p)
{
    return std::abs(2 * int64(p.x) + 1 - gradient.cols) + std::abs(2 * int64(p.y) + 1 - gradient.rows);
}

//! @note The paper asks for local minima of the gradient and gives no rule.
Point findMarker(const Mat& gradient, const Rect& cell, bool symmetric)
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
        const int64 dy = 2 * y - center2.y;
        for (int x = window.x; x < window.br().x; x++)
        {
            if (row[x] > smallest)
                continue;
            const int64 dx = 2 * x - center2.x, away = dx * dx + dy * dy;
            if (row[x] < smallest || away < nearest ||
                (away == nearest && symmetric && fromMiddle(gradient, Point(x, y)) < fromMiddle(gradient, best)))
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

//! The same limit for lengths of an image: halves lie away from its middle, so that a mirrored one has the same limits.
static int divideEvenly(int length, int i, int n)
{
    return int((2 * int64(length) * i + n - (2 * i < n)) / (2 * n));
}

//! Number of rows of a grid of n cells that are nearly square. If a number near to it divides n, it is taken in a
//! symmetric grid, so that cells lie one below the other and a transposed image has the transposed grid.
static int countRows(Size size, int n, bool symmetric)
{
    const double MOST_STRETCHED = symmetric ? 0.08 : 0;
    const int fewest = (n + size.width - 1) / size.width; // rows, at least, for n cells
    const int most = std::min(size.height, n);
    const double square = std::sqrt(double(n) * size.height / size.width);
    int best = std::max(fewest, std::min(cvRound(square), most));
    double least = MOST_STRETCHED;
    const int last = std::min(most, cvFloor(square * (1 + least)));
    for (int rows = std::max(fewest, cvCeil(square / (1 + least))); rows <= last; rows++)
    {
        const double stretched = std::max(rows / square, square / rows) - 1;
        if (n % rows != 0 || stretched >= least)
            continue;
        best = rows;
        least = stretched;
    }
    return best;
}

MarkerGrid::MarkerGrid(Size size_, int num_cells_)
    : size(size_), num_cells(num_cells_), rows(countRows(size_, num_cells_, false)), parts(1, 1), symmetric(false)
{
}

MarkerGrid::MarkerGrid(Size size_, int num_cells_, int markers_in_cell)
    : size(size_), num_cells(num_cells_), rows(countRows(size_, num_cells_, true)), parts(1, 1), symmetric(true)
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
    rows = countRows(size, num_cells, true);
}

int MarkerGrid::limit(int length, int i, int n) const
{
    return symmetric ? divideEvenly(length, i, n) : divide(length, i, n);
}

void divideIntoBands(const MarkerGrid& grid, int height, std::vector<MarkerBand>& bands)
{
    const int in_cell = grid.parts.area();
    bands.clear();
    for (int i = 0, first = 0; i < grid.rows; i++)
    {
        const int top = grid.limit(grid.size.height, first, grid.rows);
        const int bottom = grid.limit(grid.size.height, i + 1, grid.rows);
        if (i + 1 < grid.rows && std::min(bottom - top, grid.size.height - bottom) < height)
            continue;
        const MarkerBand band = { Range(top, bottom), Range(in_cell * divide(grid.num_cells, first, grid.rows),
                                                            in_cell * divide(grid.num_cells, i + 1, grid.rows)) };
        bands.push_back(band);
        first = i + 1;
    }
}

//! Places the markers of a row of cells, number first..last-1.
static void placeInRow(const Mat& gradient, const MarkerGrid& grid, int row, int first, int last, Point* markers)
{
    const Size parts = grid.parts;
    const int columns = (last - first) * parts.width;
    for (int i = 0; i < parts.height; i++)
    {
        const int part_row = row * parts.height + i;
        const int top = grid.limit(grid.size.height, part_row, grid.rows * parts.height);
        const int bottom = grid.limit(grid.size.height, part_row + 1, grid.rows * parts.height);
        for (int k = 0, left = 0, right; k < columns; k++, left = right)
        {
            right = grid.limit(grid.size.width, k + 1, columns);
            markers[(first + k / parts.width) * parts.area() + i * parts.width + k % parts.width] =
                    findMarker(gradient, Rect(Point(left, top), Point(right, bottom)), grid.symmetric);
        }
    }
}

void placeGridMarkers(const Mat& gradient, const MarkerGrid& grid, std::vector<Point>& markers)
{
    CV_TRACE_FUNCTION();
    markers.resize(grid.numMarkers());
    parallel_for_(Range(0, grid.rows), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            placeInRow(gradient, grid, i, divide(grid.num_cells, i, grid.rows),
                       divide(grid.num_cells, i + 1, grid.rows), markers.data());
    });
}

}}} // namespace
