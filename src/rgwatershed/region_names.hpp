// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_NAMES_HPP
#define OPENCV_GWATERSHED_REGION_NAMES_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Labels for the groups of regions that were merged. parents name the region that took each one in, areas are
//! from before, and names are the labels that they had: the first num_kept still have them, the others lie
//! where these were. A group keeps the label of the largest of the former, or else of the latter if it is free, or
//! else gets a free one. There are as many labels as groups.
void nameGroups(const std::vector<int>& parents, const std::vector<int>& areas, const std::vector<int>& names,
                int num_kept, std::vector<int>& labels);

}}} // namespace

#endif
