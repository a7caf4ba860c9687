// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MIXTURES_HPP
#define OPENCV_GWATERSHED_MIXTURES_HPP

#include "shared/merge_graph.hpp"
#include "shared/pair_choice.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Finds regions that are nothing but an edge: narrow ones between two others, with a colour on the straight line
//! between theirs. Each of them shall unite with the one that it is more like and that is no mixture itself. The
//! edges of the graph are joined. The smallest regions come first.
void findMixtures(const MergeGraph& graph, const std::vector<MergeRegion>& records, std::vector<MergePair>& pairs);

}}} // namespace

#endif
