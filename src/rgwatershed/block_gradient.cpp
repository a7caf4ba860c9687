// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/block_gradient.hpp"
#include "shared/mask_pyramid.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Sum of the absolute differences of the neighbours to both sides, in steps so large that markers
//! leave the centres of their cells for real edges only.
static int gradientAt(const Feature* f, int step, const RegionDistance& distance)
{
    const int STEP = 32;
    int color = 0;
    for (int k = 0; k < 3; k++)
        color += std::abs(f[1].color[k] - f[-1].color[k]) + std::abs(f[step].color[k] - f[-step].color[k]);
    if (!f[1].depth || !f[-1].depth || !f[step].depth || !f[-step].depth)
        return color / STEP;
    const int depth = std::abs(f[1].depth - f[-1].depth) + std::abs(f[step].depth - f[-step].depth);
    return (distance.color_share * color + distance.depth_share * depth) / (256 * STEP);
}

//! The pixels at the border of the image have no neighbours to both sides: they count as edges.
void computeBlockGradient(const Padded<Feature>& features, const RegionDistance& distance, const Mat& mask,
                          Mat& gradient)
{
    CV_TRACE_FUNCTION();
    gradient.create(features.size(), CV_16UC1);
    gradient.setTo(Scalar(UNKNOWN_GRADIENT));
    parallel_for_(Range(1, std::max(1, gradient.rows - 1)), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
            for (int x = 1; x < gradient.cols - 1; x++)
            {
                const int height = gradientAt(features.row(y) + x, features.step(), distance);
                gradient.at<ushort>(y, x) = ushort(height);
            }
    });
    if (!mask.empty())
        forgetGradients(mask, gradient);
}

}}} // namespace
