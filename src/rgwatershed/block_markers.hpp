// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BLOCK_MARKERS_HPP
#define OPENCV_GWATERSHED_BLOCK_MARKERS_HPP

#include "rgwatershed/plan.hpp"
#include "shared/grid_markers.hpp"
#include "shared/shape_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The markers of the blocks, and what the flood and merging need to know of them.
struct BlockMarkers
{
    std::vector<Point> places;
    std::vector<Point> middles;    //!< twice the places that distances count from; empty: these are the markers
    std::vector<MarkerBand> bands; //!< that are flooded by themselves
    int in_cell;                   //!< so many, of consecutive numbers, began in the same cell
    MarkerBuffers buffers;
};

//! Places the markers where the gradient is low: in a grid, or, where there is a mask, in its components, or by areas
//! on the surface. They may be fewer than planned, where cells have no room for them.
void placeBlockMarkers(const Plan& plan, const FeatureMap& features, Size image_size, const Mat& mask,
                       const Mat& gradient, BlockMarkers& markers);

}}} // namespace

#endif
