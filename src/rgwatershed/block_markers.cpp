// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/block_markers.hpp"
#include "rgwatershed/adaptive_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Each superpixel has a cell, and all of its markers are in that, if there is room.
static void placeInGrid(const Plan& plan, Size size, Size image_size, const Mat& gradient, BlockMarkers& markers)
{
    const bool fill_cells = plan.num_markers == plan.num_superpixels * plan.markers_per_superpixel;
    const int in_cell = fill_cells ? plan.markers_per_superpixel : 1;
    const MarkerGrid grid(size, image_size, plan.levels.side(plan.levels.top), plan.num_markers / in_cell, in_cell);
    placeGridMarkers(gradient, grid, markers.places, markers.middles);
    divideIntoBands(grid, plan.band_height, markers.bands);
    markers.in_cell = grid.parts.area();
}

void placeBlockMarkers(const Plan& plan, const FeatureMap& features, Size image_size, const Mat& mask,
                       const Mat& gradient, BlockMarkers& markers)
{
    CV_TRACE_FUNCTION();
    if (mask.empty() && !plan.depth_adaptive)
    {
        placeInGrid(plan, features.size(), image_size, gradient, markers);
        return;
    }
    if (mask.empty())
        placeAdaptiveMarkers(gradient, features, plan.num_markers, markers.places);
    else
        placeShapeMarkers(gradient, mask, plan.num_markers, markers.buffers, markers.places);
    markers.middles.clear();
    markers.bands.assign(1, wholeBand(features.size(), int(markers.places.size())));
    markers.in_cell = 1;
}

}}} // namespace
