// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "mask.hpp"
#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The opponent space: lightness (R + 2G + B) / 4, and the differences of red against green and
//! of yellow against blue, halved and shifted to 0..255.
//! @note Measured level with CIELAB as the space of superpixels (doc/log.md), and a few additions.
static void convertFromBGR(const uchar* from, int cn, Feature* to, int cols)
{
    for (int x = 0; x < cols; x++, from += cn)
    {
        const int b = from[0], g = from[1], r = from[2];
        to[x].color[0] = uchar((r + 2 * g + b + 2) >> 2);
        to[x].color[1] = uchar((r - g + 256) >> 1);
        to[x].color[2] = uchar((r + g - 2 * b + 512 + 2) >> 2);
        to[x].depth = 0;
    }
}

static void copyColor(const uchar* from, int cn, Feature* to, int cols)
{
    for (int x = 0; x < cols; x++, from += cn)
    {
        const Feature f = { { from[0], from[1], from[2] }, 0 };
        to[x] = f;
    }
}

static void copyGray(const uchar* from, Feature* to, int cols)
{
    for (int x = 0; x < cols; x++)
    {
        const Feature f = { { from[x], 128, 128 }, 0 };
        to[x] = f;
    }
}

void makeFeatures(const Mat& color, const Mat& depth, bool uniform_color, Padded<Feature>& features)
{
    CV_TRACE_FUNCTION();
    const int cn = color.channels();
    features.create(color.size(), Feature());
    parallel_for_(Range(0, color.rows), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
        {
            Feature* to = features.row(y);
            if (cn == 1)
                copyGray(color.ptr(y), to, color.cols);
            else if (uniform_color)
                copyColor(color.ptr(y), cn, to, color.cols);
            else
                convertFromBGR(color.ptr(y), cn, to, color.cols);
            for (int x = 0; x < color.cols && !depth.empty(); x++)
                to[x].depth = depth.at<uchar>(y, x);
        }
    });
}

//! Mean of the depths that are valid.
static uchar meanDepth(int a, int b, int c, int d)
{
    const int valid = (a != 0) + (b != 0) + (c != 0) + (d != 0);
    return valid ? uchar((a + b + c + d + valid / 2) / valid) : uchar(0);
}

void halveFeatures(const Padded<Feature>& features, Padded<Feature>& halved)
{
    CV_TRACE_FUNCTION();
    const Size size = features.size(), half((size.width + 1) / 2, (size.height + 1) / 2);
    halved.create(half, Feature());
    parallel_for_(Range(0, half.height), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
        {
            const Feature* upper = features.row(2 * y);
            const Feature* lower = features.row(std::min(2 * y + 1, size.height - 1));
            Feature* to = halved.row(y);
            for (int x = 0; x < half.width; x++)
            {
                const int left = 2 * x, right = std::min(2 * x + 1, size.width - 1);
                for (int k = 0; k < 3; k++)
                    to[x].color[k] = uchar((upper[left].color[k] + upper[right].color[k] +
                                            lower[left].color[k] + lower[right].color[k] + 2) >> 2);
                to[x].depth = meanDepth(upper[left].depth, upper[right].depth,
                                        lower[left].depth, lower[right].depth);
            }
        }
    });
}

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
void computeGradient(const Padded<Feature>& features, const RegionDistance& distance, Mat& gradient)
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
}

}}} // namespace
