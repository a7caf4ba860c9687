// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_UNION_PLAN_HPP
#define OPENCV_GWATERSHED_UNION_PLAN_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Which unions of regions are wanted where nothing else tells one from another: an image is divided into tiles of
//! about ten regions, these into halves, and these again, down to single regions. Parts are united in the opposite
//! order, so that a tenth of the superpixels of an even image are tiles. Beyond that there is no plan. Or the parts are
//! cells of a grid.
struct UnionPlan
{
    std::vector<int> parts; //!< of each region: the smallest part in which it is not alone; below 0: none
    std::vector<int> above; //!< of each part: the part that it is a half of, or a cell itself; below 0: it is a tile

    //! Once a region has taken in another one: it is the whole part if both were its halves, else still the larger one.
    void unite(int from, int to, bool from_is_larger)
    {
        const int a = parts[from], b = parts[to];
        if (a == b)
            parts[to] = a < 0 ? a : above[a];
        else if (from_is_larger)
            parts[to] = a;
    }
};

//! A plan for the regions of a CV_32SC1 label map. Labels below 0 do not count.
UnionPlan planUnions(const Mat& labels, int num_labels);

//! A plan that unites what is left of each cell of a grid. So many regions of consecutive numbers, of which some are
//! left, were in one; regions that have come since, up to num_regions, in none.
UnionPlan planUnions(const std::vector<int>& left, int in_cell, int num_regions);

}}} // namespace

#endif
