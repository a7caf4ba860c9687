// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SHAPE_MARKERS_HPP
#define OPENCV_GWATERSHED_SHAPE_MARKERS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Buffers for placing markers in regions of any shape.
struct MarkerBuffers
{
    Mat components;
    std::vector<Point> points;
    std::vector<int> starts;
};

//! Places markers at low gradients inside of a mask: at least one in each of its connected components, and more than
//! num_markers if there are more components. num_markers <= pixels inside.
void placeShapeMarkers(const Mat& gradient, const Mat& mask, int num_markers, MarkerBuffers& buffers,
                       std::vector<Point>& markers);

typedef std::vector<Point>::iterator PointIterator;

//! Lists the points of the regions first, first + 1..., each in raster order. Those of region first + i begin at
//! starts[i].
void listPoints(const Mat& labels, int first, int num_regions, MarkerBuffers& buffers);

//! The point with the smallest gradient in a disc around the centre of the points; of equal ones the nearest to the
//! centre. The area of the disc is about that of the region divided by part^2.
Point findMarkerInRegion(const Mat& gradient, PointIterator begin, PointIterator end, int part);

//! Places n markers in a region whose points are in raster order. n <= number of points.
void placeInRegion(const Mat& gradient, PointIterator begin, PointIterator end, int n, std::vector<Point>& markers);

}}} // namespace

#endif
