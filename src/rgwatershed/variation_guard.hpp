// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_VARIATION_GUARD_HPP
#define OPENCV_GWATERSHED_VARIATION_GUARD_HPP

#include "shared/padded.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Keeps sweeps from making the superpixels worse as an approximation of the colours.
class VariationGuard
{
public:
    //! color is 8-bit with 1, 3 or 4 channels; the first three count. Regions of one owner are one; each is one by
    //! itself if there are no owners.
    VariationGuard(const Mat& color, const Padded<int>& labels, int num_regions, const std::vector<int>& owners);

    //! Whether a pixel is as near to the mean colour of the region `to` as to that of `from`, or nearer.
    bool permits(Point p, int from, int to) const;
    //! From here on it must be nearer.
    void forbidTies() { permits_ties_ = false; }
    //! Adds a pixel to a region, or takes it away where times is -1.
    void add(Point p, int region, int times);
    //! Takes the means of some regions anew.
    void update(const Range& regions);
    //! Then, when all are new, gives regions of one owner the mean of all of them.
    void joinOwned();

private:
    Vec3d colorAt(Point p) const;

    Mat color_;
    std::vector<Vec3d> sums_, means_;
    std::vector<int> areas_;
    const std::vector<int> owners_;
    bool permits_ties_ = true;
};

}}} // namespace

#endif
