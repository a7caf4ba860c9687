// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/depth_step.hpp"
#include "shared/region_distance.hpp"
#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The median difference of two neighbours in someRows(): on surfaces there is little but noise between pixels, and
//! edges are too few to matter. 0 if there are none.
static int medianDifference(const Mat& depth)
{
    const Mat rows = someRows(depth);
    int counts[256] = {}, pairs = 0;
    for (int y = 0; y < rows.rows; y++)
    {
        const uchar* row = rows.ptr(y);
        for (int x = 1; x < rows.cols; x++)
        {
            const int known = (row[x - 1] != 0) & (row[x] != 0);
            counts[std::abs(row[x] - row[x - 1])] += known;
            pairs += known;
        }
    }
    int median = 0;
    for (int up_to = counts[0]; 2 * up_to < pairs; up_to += counts[median])
        median++;
    return median;
}

//! @note In noise alone four pixels differ by more than four times the median difference of two in one of 30 blocks.
int stepOfDepth(const Mat& depth)
{
    const int TIMES = 4;
    return std::max<int>(STEP_OF_DEPTH, TIMES * medianDifference(depth));
}

}}} // namespace
