// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

void measureRegions(const Padded<Feature>& features, const Mat& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    regions.clear(regions.size());
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        const Feature* feature = features.row(y);
        for (int x = 0; x < labels.cols;)
        {
            const int label = row[x];
            RegionSum run = RegionSum();
            for (; x < labels.cols && row[x] == label; x++)
                run.add(feature[x]);
            if (label >= 0)
                regions.sums[label].add(run);
        }
    }
    regions.update();
}

}}} // namespace
