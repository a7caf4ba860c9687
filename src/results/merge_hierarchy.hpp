// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_HIERARCHY_HPP
#define OPENCV_GWATERSHED_MERGE_HIERARCHY_HPP

#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The order in which the superpixels of a label map are merged, most similar first, and the map.
class MergeHierarchy
{
public:
    bool empty() const { return num_labels_ == 0; }

    //! Merges all superpixels, as far as they touch, of a CV_32SC1 label map; labels below 0 stay.
    void build(const Padded<Feature>& features, const RegionDistance& distance, const Mat& labels, int num_labels);

    //! Labels with num_labels superpixels, or as few as the order has. Returns their number.
    int cut(int num_labels, Mat& labels) const;

private:
    Mat labels_;
    int num_labels_ = 0;
    std::vector<Vec2i> unions_; // a superpixel and the one that takes it in
};

}}} // namespace

#endif
