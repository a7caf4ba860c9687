// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/depth_noise.hpp"
#include "depth/depth_rows.hpp"

namespace cv { namespace ximgproc { namespace gws {

double noiseOfDepth(const Mat& depth, FloatRange limits, bool of_inverse)
{
    const Mat rows = someRows(depth);
    std::vector<float> row(rows.cols);
    std::vector<double> steps; // the inverse of the smallest depths is no float
    for (int y = 0; y < rows.rows; y++)
    {
        readDepthRow(rows.row(y), row.data());
        clipRow(limits, row);
        for (int x = 1; x < rows.cols; x++)
            if (row[x - 1] > 0 && row[x] > 0)
                steps.push_back(std::abs(of_inverse ? 1. / row[x] - 1. / row[x - 1] : double(row[x]) - row[x - 1]));
    }
    if (steps.empty())
        return 0;
    const auto middle = steps.begin() + ptrdiff_t(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return *middle;
}

}}} // namespace
