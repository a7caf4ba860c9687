// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "mask.hpp"
#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Rows that one task takes, so that they are still in the cache when they are converted.
static const int BAND = 16;

//! The opponent space: lightness (R + 2G + B) / 4, and the differences of red against green and
//! of yellow against blue, halved and shifted to 0..255.
//! @note Measured level with CIELAB as the space of superpixels (doc/log.md), and a few additions.
static void convertFromBGR(Feature* row, int cols)
{
    for (int x = 0; x < cols; x++)
    {
        const int b = row[x].color[0], g = row[x].color[1], r = row[x].color[2];
        row[x].color[0] = uchar((r + 2 * g + b + 2) >> 2);
        row[x].color[1] = uchar((r - g + 256) >> 1);
        row[x].color[2] = uchar((r + g - 2 * b + 512 + 2) >> 2);
        row[x].depth = 0;
    }
}

static void copyGray(const uchar* from, Feature* to, int cols)
{
    for (int x = 0; x < cols; x++)
    {
        to[x].color[0] = from[x];
        to[x].color[1] = to[x].color[2] = 128;
        to[x].depth = 0;
    }
}

static void clearDepth(Feature* to, int cols)
{
    for (int x = 0; x < cols; x++)
        to[x].depth = 0;
}

static void copyDepth(const uchar* from, Feature* to, int cols)
{
    for (int x = 0; x < cols; x++)
        to[x].depth = from[x];
}

void makeFeatures(const Mat& color, const Mat& depth, bool uniform_color, Padded<Feature>& features)
{
    CV_TRACE_FUNCTION();
    features.create(color.size(), Feature());
    const Mat map = features.view(CV_8UC4);
    parallel_for_(Range(0, (color.rows + BAND - 1) / BAND), [&](const Range& bands)
    {
        const Range rows(bands.start * BAND, std::min(bands.end * BAND, color.rows));
        for (int top = rows.start; top < rows.end; top += BAND)
        {
            const Range band(top, std::min(top + BAND, rows.end));
            Mat part = map.rowRange(band);
            if (color.channels() == 3)
                cvtColor(color.rowRange(band), part, COLOR_BGR2BGRA);
            else if (color.channels() == 4)
                color.rowRange(band).copyTo(part);
            for (int y = band.start; y < band.end; y++)
            {
                if (color.channels() == 1)
                    copyGray(color.ptr(y), features.row(y), color.cols);
                else if (uniform_color)
                    clearDepth(features.row(y), color.cols);
                else
                    convertFromBGR(features.row(y), color.cols);
                if (!depth.empty())
                    copyDepth(depth.ptr(y), features.row(y), color.cols);
            }
        }
    });
}

//! Mean of the depths that are valid.
static uchar meanDepth(int a, int b, int c, int d)
{
    const int valid = (a != 0) + (b != 0) + (c != 0) + (d != 0);
    return valid ? uchar((a + b + c + d + valid / 2) / valid) : uchar(0);
}

//! Means of 2x2 pixels without depth.
static void halveColors(const Feature* upper, const Feature* lower, Feature* to, int cols)
{
    for (int x = 0; x < cols; x++)
    {
        for (int k = 0; k < 3; k++)
            to[x].color[k] = uchar((upper[2 * x].color[k] + upper[2 * x + 1].color[k] +
                                    lower[2 * x].color[k] + lower[2 * x + 1].color[k] + 2) >> 2);
        to[x].depth = 0;
    }
}

static void halveDepths(const Feature* upper, const Feature* lower, Feature* to, int cols)
{
    for (int x = 0; x < cols; x++)
        to[x].depth = meanDepth(upper[2 * x].depth, upper[2 * x + 1].depth, lower[2 * x].depth, lower[2 * x + 1].depth);
}

void halveFeatures(const Padded<Feature>& features, bool with_depth, Padded<Feature>& halved)
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
            halveColors(upper, lower, halved.row(y), size.width / 2);
            if (with_depth)
                halveDepths(upper, lower, halved.row(y), size.width / 2);
            if (size.width % 2)
            {
                const Feature last_upper[2] = { upper[size.width - 1], upper[size.width - 1] };
                const Feature last_lower[2] = { lower[size.width - 1], lower[size.width - 1] };
                halveColors(last_upper, last_lower, halved.row(y) + half.width - 1, 1);
                halveDepths(last_upper, last_lower, halved.row(y) + half.width - 1, 1);
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
