// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/grid_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Distance from the middle of a gradient, twice in each direction.
static int64 fromMiddle(const Mat& gradient, Point p)
{
    return std::abs(2 * int64(p.x) + 1 - gradient.cols) + std::abs(2 * int64(p.y) + 1 - gradient.rows);
}

//! The nearest coordinate to the middle of a cell, or of two the one nearer to the middle of the image, if it has one
//! that counts, else the first. `center2` is twice the middle.
static int nearestTo(int center2, int length, bool symmetric)
{
    return (center2 + int(symmetric && center2 + 1 < length)) / 2;
}

//! @note The paper asks for local minima of the gradient and gives no rule.
Point findMarkerInCell(const Mat& gradient, const Rect& cell, bool symmetric)
{
    const Point center2(2 * cell.x + cell.width - 1, 2 * cell.y + cell.height - 1); // twice the centre
    const int rx = cell.width > 2 ? std::max(cell.width / 4, 1) : 0;
    const int ry = cell.height > 2 ? std::max(cell.height / 4, 1) : 0;
    const Rect window(Point(center2.x / 2 - rx, center2.y / 2 - ry),
                      Point((center2.x + 1) / 2 + rx + 1, (center2.y + 1) / 2 + ry + 1));
    const Point nearest(nearestTo(center2.x, gradient.cols, symmetric), nearestTo(center2.y, gradient.rows, symmetric));
    if (gradient.at<ushort>(nearest) == 0)
        return nearest;
    // Both in one number: the gradient counts first, then the distance.
    const int AWAY_BITS = 44;
    const int64 FARTHEST = (int64(1) << AWAY_BITS) - 1;
    Point best;
    int64 lowest = INT64_MAX;
    for (int y = window.y; y < window.br().y; y++)
    {
        const ushort* row = gradient.ptr<ushort>(y);
        const int64 dy = 2 * y - center2.y;
        for (int x = window.x; x < window.br().x; x++)
        {
            const int64 dx = 2 * x - center2.x;
            const int64 key = (int64(row[x]) << AWAY_BITS) + std::min(dx * dx + dy * dy, FARTHEST);
            if (key > lowest)
                continue;
            if (key < lowest ||
                (symmetric && fromMiddle(gradient, Point(x, y)) < fromMiddle(gradient, best)))
                best = Point(x, y);
            lowest = key;
        }
    }
    return best;
}

//! The i-th of the n + 1 limits that divide a length into n equal parts.
static int divide(int length, int i, int n)
{
    return int(int64(length) * i / n);
}

//! The same limit for `count` elements with a length of length / unit, in whole elements. Halves lie away from the
//! middle, so that a mirrored image has the same limits.
static int divideEvenly(int count, int length, int unit, int i, int n)
{
    if (2 * i == n)
        return (count + 1) / 2;
    const int64 nearer = std::min(i, n - i); // to its end of the image
    const int limit = int((2 * length * nearer + int64(n) * unit - 1) / (2 * int64(n) * unit));
    return 2 * i < n ? limit : count - limit;
}

//! Most that cells are stretched in each direction so that all rows have the same number of them.
static const double MOST_STRETCHED = 0.08;

//! Number of rows of n square cells.
static double squareRows(Size size, double n) { return std::sqrt(n * size.height / size.width); }

static double stretchOf(int rows, double square) { return std::max(rows / square, square / rows) - 1; }

//! Number of rows of a grid of n cells that are nearly square. If a number near to it divides n, it is taken in a
//! symmetric grid, so that cells lie one below the other and a transposed image has the transposed grid.
static int countRows(Size size, int n, bool symmetric)
{
    const int fewest = (n + size.width - 1) / size.width; // rows, at least, for n cells
    const int most = std::min(size.height, n);
    const double square = squareRows(size, n);
    int best = std::max(fewest, std::min(cvRound(square), most));
    double least = symmetric ? MOST_STRETCHED : 0;
    const int last = std::min(most, cvFloor(square * (1 + least)));
    for (int rows = std::max(fewest, cvCeil(square / (1 + least))); rows <= last; rows++)
    {
        const double stretched = stretchOf(rows, square);
        if (n % rows != 0 || stretched >= least)
            continue;
        best = rows;
        least = stretched;
    }
    return best;
}

int countSquares(Size size, int side)
{
    const double FARTHEST = 0.05, wanted = double(size.width) / side * size.height / side;
    int best = cvRound(wanted);
    double least = FARTHEST * wanted;
    for (int rows = size.height / side; rows <= (size.height - 1) / side + 1; rows++)
        for (int columns = size.width / side; columns <= (size.width - 1) / side + 1; columns++)
        {
            const int n = rows * columns;
            const double away = std::abs(n - wanted);
            if (away >= least || stretchOf(rows, squareRows(size, n)) >= MOST_STRETCHED)
                continue;
            best = n;
            least = away;
        }
    return best;
}

static bool fits(Size inner, Size outer) { return inner.width <= outer.width && inner.height <= outer.height; }

MarkerGrid::MarkerGrid(Size size_, int num_cells_)
    : size(size_), extent(size_), unit(1), num_cells(num_cells_), rows(countRows(size_, num_cells_, false)),
      parts(1, 1), symmetric(false)
{
}

MarkerGrid::MarkerGrid(Size size_, Size extent_, int unit_, int num_cells_, int markers_in_cell)
    : size(size_), extent(extent_), unit(unit_), num_cells(num_cells_), rows(countRows(size_, num_cells_, true)),
      parts(1, 1), symmetric(true)
{
    const Size smallest_cell(size.width / ((num_cells + rows - 1) / rows), size.height / rows);
    for (int count = markers_in_cell; count > 1; count--)
    {
        int shorter = int(std::sqrt(double(count)));
        while (count % shorter != 0)
            shorter--;
        Size usual(count / shorter, shorter), turned(shorter, count / shorter);
        if (extent.height > extent.width)
            std::swap(usual, turned); // a transposed image has the transposed grid
        parts = fits(usual, smallest_cell) ? usual : fits(turned, smallest_cell) ? turned : parts;
        if (parts.area() == count)
            return;
    }
    num_cells *= markers_in_cell;
    rows = countRows(size, num_cells, true);
}

int MarkerGrid::limitOfColumns(int i, int n) const
{
    return symmetric ? divideEvenly(size.width, extent.width, unit, i, n) : divide(size.width, i, n);
}

int MarkerGrid::limitOfRows(int i, int n) const
{
    return symmetric ? divideEvenly(size.height, extent.height, unit, i, n) : divide(size.height, i, n);
}

void divideIntoBands(const MarkerGrid& grid, int height, std::vector<MarkerBand>& bands)
{
    const int in_cell = grid.parts.area();
    bands.clear();
    for (int i = 0, first = 0; i < grid.rows; i++)
    {
        const int top = grid.limitOfRows(first, grid.rows);
        const int bottom = grid.limitOfRows(i + 1, grid.rows);
        if (i + 1 < grid.rows && std::min(bottom - top, grid.size.height - bottom) < height)
            continue;
        bands.push_back({ Range(top, bottom), Range(in_cell * divide(grid.num_cells, first, grid.rows),
                                                    in_cell * divide(grid.num_cells, i + 1, grid.rows)) });
        first = i + 1;
    }
}

//! The n + 1 limits of columns, if they are not known from the row before: divisions take time.
static void findLimits(const MarkerGrid& grid, int n, std::vector<int>& limits)
{
    if (int(limits.size()) == n + 1)
        return;
    limits.resize(n + 1);
    for (int i = 0; i <= n; i++)
        limits[i] = grid.limitOfColumns(i, n);
}

//! Calls body(marker, part) for all parts of a row of cells, number first..last-1.
template <typename Body>
static void forPartsInRow(const MarkerGrid& grid, int row, int first, int last, std::vector<int>& limits,
                          const Body& body)
{
    const Size parts = grid.parts;
    findLimits(grid, (last - first) * parts.width, limits);
    for (int i = 0; i < parts.height; i++)
    {
        const int part_row = row * parts.height + i;
        const int top = grid.limitOfRows(part_row, grid.rows * parts.height);
        const int bottom = grid.limitOfRows(part_row + 1, grid.rows * parts.height);
        for (int cell = first, k = 0; cell < last; cell++)
            for (int j = 0; j < parts.width; j++, k++)
                body(cell * parts.area() + i * parts.width + j,
                     Rect(Point(limits[k], top), Point(limits[k + 1], bottom)));
    }
}

//! The same for all parts, some of them at the same time.
template <typename Body> static void forParts(const MarkerGrid& grid, const Body& body)
{
    parallel_for_(Range(0, grid.rows), [&](const Range& range)
    {
        std::vector<int> limits;
        for (int i = range.start; i < range.end; i++)
            forPartsInRow(grid, i, divide(grid.num_cells, i, grid.rows), divide(grid.num_cells, i + 1, grid.rows),
                          limits, body);
    });
}

void placeGridMarkers(const Mat& gradient, const MarkerGrid& grid, std::vector<Point>& markers)
{
    CV_TRACE_FUNCTION();
    markers.resize(grid.numMarkers());
    forParts(grid, [&](int i, const Rect& part) { markers[i] = findMarkerInCell(gradient, part, grid.symmetric); });
}

void placeGridMarkers(const Mat& gradient, const MarkerGrid& grid, std::vector<Point>& markers,
                      std::vector<Point>& middles)
{
    CV_TRACE_FUNCTION();
    markers.resize(grid.numMarkers());
    middles.resize(grid.numMarkers());
    forParts(grid, [&](int i, const Rect& part)
    {
        markers[i] = findMarkerInCell(gradient, part, grid.symmetric);
        const Point center(2 * part.x + part.width - 1, 2 * part.y + part.height - 1), marker = 2 * markers[i];
        const bool central = std::abs(marker.x - center.x) <= 1 && std::abs(marker.y - center.y) <= 1;
        middles[i] = central ? center : marker;
    });
}

}}} // namespace
