// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/flood_region.hpp"
#include "rgwatershed/tuning.hpp"

namespace cv { namespace ximgproc { namespace gws {

void FloodRegion::update()
{
    const RegionMean mean = sum.mean();
    const short values[4] = { mean.color[0], mean.color[2], mean.color[1], mean.depth };
    std::copy(values, values + 4, means);
    if (rise != 0 && sum.depth_area > 0)
        means[3] = saturate_cast<short>(mean.depth - rise / (int64(SurfaceMean::PLANE_UNIT) * sum.depth_area));
    next_update = int(std::min<int64>(int64(sum.area) + sum.area / MEAN_GROWTH + 1, INT_MAX));
}

}}} // namespace
