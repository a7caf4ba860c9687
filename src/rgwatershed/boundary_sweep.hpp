// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP
#define OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP

#include "rgwatershed/boundary_list.hpp"
#include "rgwatershed/variation_guard.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! One pass over the boundary: the pixels that are listed go to the neighbouring region of the lowest energy, while
//! each region stays one piece.
//! length_price is the energy, in squared levels, of a quarter of a pixel edge of boundary.
//! guard may be 0.
CV_EXPORTS void sweepBoundary(const Padded<Feature>& features, const RegionDistance& distance, int length_price,
                   VariationGuard* guard, const ListBoundary& list, SweepBuffers& buffers, Padded<int>& labels,
                   Regions& regions);

}}} // namespace

#endif
