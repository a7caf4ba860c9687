// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_GRID_MARKERS_HPP
#define OPENCV_GWATERSHED_GRID_MARKERS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Divides the image into a grid of num_markers cells and places one marker in each. num_markers <= pixels.
void placeGridMarkers(const Mat& gradient, int num_markers, std::vector<Point>& markers);

//! The pixel with the smallest gradient, up to a quarter of the cell (at least one pixel) away from the centre of the
//! cell. Of equal ones the nearest to the centre, then the first in raster order. It lies in the cell, so no two
//! markers are at the same place.
Point findMarker(const Mat& gradient, const Rect& cell);

//! Some rows of an image, and the markers in them.
struct MarkerBand
{
    Range rows, markers;
};

//! All rows and all markers.
inline MarkerBand wholeBand(Size size, int num_markers)
{
    const MarkerBand band = { Range(0, size.height), Range(0, num_markers) };
    return band;
}

//! Divides the grid into bands of whole rows of cells, each at least `height` pixels high if the image is.
void divideIntoBands(Size size, int num_markers, int height, std::vector<MarkerBand>& bands);

}}} // namespace

#endif
