// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_GRID_MARKERS_HPP
#define OPENCV_GWATERSHED_GRID_MARKERS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! How many squares with a side an image has: as many rows and columns as fit, each number rounded up or down, so that
//! their product is near to that of the areas; where none is within 5 %, the number of areas, rounded.
int countSquares(Size size, int side);

//! A grid of cells, nearly square, whose rows differ by at most one cell. Each cell has the same number of parts, with
//! a marker in each. Markers have consecutive numbers in a cell.
struct MarkerGrid
{
    //! One marker in each cell.
    MarkerGrid(Size size, int num_cells);
    //! A symmetric grid of blocks, at most one marker for each. extent is the size in parts of a block, of which a
    //! whole one has `unit` on each side. If cells are too small for so many markers, each has fewer; if there is room
    //! for one only, there are as many cells as markers.
    MarkerGrid(Size size, Size extent, int unit, int num_cells, int markers_in_cell);

    int numMarkers() const { return num_cells * parts.area(); }
    //! The i-th of the n + 1 limits that divide the image into n parts of equal width, or of equal height.
    int limitOfColumns(int i, int n) const;
    int limitOfRows(int i, int n) const;

    Size size, extent; //!< of the image, in pixels, or in blocks and in parts of them
    int unit;
    int num_cells, rows;
    Size parts;     //!< of each cell
    bool symmetric; //!< a mirrored image has the mirrored grid
};

void placeGridMarkers(const Mat& gradient, const MarkerGrid& grid, std::vector<Point>& markers);

//! The same, and twice the places that distances from markers count from: for a marker at the centre of its part just
//! that centre, which may lie between pixels, so that what is nearest to it is the part; the place of any other marker.
void placeGridMarkers(const Mat& gradient, const MarkerGrid& grid, std::vector<Point>& markers,
                      std::vector<Point>& middles);

//! The pixel with the smallest gradient, up to a quarter of the cell (at least one pixel) away from the centre of the
//! cell. Of equal ones the nearest to the centre, then, in a symmetric grid, to that of the image, then the first in
//! raster order. It lies in the cell, so no two markers are at the same place.
Point findMarkerInCell(const Mat& gradient, const Rect& cell, bool symmetric = false);

//! Some rows of an image, and the markers in them.
struct MarkerBand
{
    Range rows, markers;
};

//! All rows and all markers.
inline MarkerBand wholeBand(Size size, int num_markers)
{
    return { Range(0, size.height), Range(0, num_markers) };
}

//! Divides the grid into bands of whole rows of cells, each at least `height` rows of elements high if the grid is.
void divideIntoBands(const MarkerGrid& grid, int height, std::vector<MarkerBand>& bands);

}}} // namespace

#endif
