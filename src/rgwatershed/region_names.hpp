// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_NAMES_HPP
#define OPENCV_GWATERSHED_REGION_NAMES_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Labels for the groups of regions that were merged. parents name the region that took each one in, areas are from
//! before. Regions below num_kept are kept, and names[i] is the label of region i. The others are new, and names[i] is
//! the label that lay there. A group gets the name of its largest kept region; without one that of its largest new
//! region, if that is still free; or else a free label. There are as many labels as groups.
void nameGroups(const std::vector<int>& parents, const std::vector<int>& areas, const std::vector<int>& names,
                int num_kept, std::vector<int>& labels);

}}} // namespace

#endif
