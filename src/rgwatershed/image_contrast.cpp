// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/image_contrast.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Ten rows of an image, or some more, equally far apart, in the same memory; all if it has fewer.
static Mat someRows(const Mat& image)
{
    const int ROWS = 10, apart = std::max(image.rows / ROWS, 1), first = apart / 2;
    return Mat((image.rows - first + apart - 1) / apart, image.cols, image.type(),
               const_cast<uchar*>(image.ptr(first)), image.step * size_t(apart));
}

//! Half of the mean squared steps of the channels from one pixel to the next on the right.
static Scalar noiseOf(const Mat& rows, const Mat& mask)
{
    const Range left(0, rows.cols - 1), right(1, rows.cols);
    if (left.empty())
        return Scalar();
    Mat steps, both;
    absdiff(rows.colRange(right), rows.colRange(left), steps);
    if (!mask.empty())
        bitwise_and(mask.colRange(right), mask.colRange(left), both);
    Scalar mean, deviation;
    meanStdDev(steps, mean, deviation, both);
    return 0.5 * (mean.mul(mean) + deviation.mul(deviation));
}

//! A pixel that leaves a straight boundary pays for eight quarters of an edge, which takes contrast of colours. What
//! noise adds to a square is paid for in full, and so is a level, or boundaries would follow them.
double mostPriceFor(const FeatureMap& pixels, const Mat& mask, const RegionDistance& distance)
{
    CV_TRACE_FUNCTION();
    const int QUARTERS = 8;
    const Mat rows = someRows(pixels.view()), inside = mask.empty() ? Mat() : someRows(mask);
    Scalar mean, contrast;
    meanStdDev(rows, mean, contrast, inside);
    const Scalar noise = noiseOf(rows, inside);
    const short* const colors = distance.weights[0];
    const int weights[] = { colors[0], colors[1], colors[2], distance.depth_share };
    contrast[3] = 0; // depth has enough, and colours are to be followed beside it
    double price = 1;
    for (int k = 0; k < 4; k++)
    {
        const double weight = double(weights[k]) / FULL_WEIGHT;
        price += weight * weight * (contrast[k] * contrast[k] / QUARTERS + noise[k]);
    }
    return price;
}

}}} // namespace
