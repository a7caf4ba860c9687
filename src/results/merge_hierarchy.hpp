// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_HIERARCHY_HPP
#define OPENCV_GWATERSHED_MERGE_HIERARCHY_HPP

#include "shared/region_merge.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! A label map and the order in which its superpixels are merged, the most similar first.
class MergeHierarchy
{
public:
    bool empty() const { return num_labels_ == 0; }

    //! Finds the order for all superpixels of a CV_32SC1 label map that touch. -1 stays. The map is
    //! not copied, so what it is cut to must be another one.
    void build(const FeatureMap& features, const RegionDistance& distance, const Mat& labels, int num_labels,
               MergeBuffers& buffers);

    //! Whether the memory of a map is that of the label map.
    bool holds(const Mat& map) const { return labels_.datastart == map.datastart; }

    //! Writes the label map with num_labels superpixels, or with more if the order ends before. Returns their number.
    int cut(int num_labels, Mat& labels) const;

private:
    Mat labels_;
    int num_labels_ = 0;
    std::vector<Vec2i> unions_; // a superpixel, and the one that it becomes a part of
};

}}} // namespace

#endif
