// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/image_contrast.hpp"
#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

static Scalar meanSquareOf(const Mat& values, const Mat& mask)
{
    Scalar mean, deviation;
    meanStdDev(values, mean, deviation, mask);
    return mean.mul(mean) + deviation.mul(deviation);
}

//! Half of the mean squared steps of the channels from pixels to others, which are both inside of a mask, if there is
//! one. There is none to depth that is missing.
static Scalar noiseBetween(const Mat& from, const Mat& to, const Mat& inside, bool with_depth)
{
    const int DEPTH = 3;
    Mat steps, depths, depth_steps, known;
    absdiff(from, to, steps);
    Scalar squares = meanSquareOf(steps, inside);
    if (with_depth)
    {
        min(from, to, depths);
        extractChannel(depths, known, DEPTH);
        extractChannel(steps, depth_steps, DEPTH);
        if (!inside.empty())
            min(known, inside, known);
        squares[DEPTH] = meanSquareOf(depth_steps, known)[0];
    }
    return 0.5 * squares;
}

//! The larger one of that across and that down.
static Scalar noiseOf(const Mat& image, const Mat& mask, bool with_depth)
{
    Scalar noise;
    for (const Point& step : { Point(1, 0), Point(0, 1) })
    {
        const Size size(image.cols - step.x, image.rows - step.y);
        if (size.empty())
            continue;
        const Rect from(Point(), size), to(step, size);
        Mat inside;
        if (!mask.empty())
            bitwise_and(someRows(mask(from)), someRows(mask(to)), inside);
        const Scalar found = noiseBetween(someRows(image(from)), someRows(image(to)), inside, with_depth);
        for (int k = 0; k < 4; k++)
            noise[k] = std::max(noise[k], found[k]);
    }
    return noise;
}

//! A pixel that leaves a straight boundary gives up eight quarters of an edge, which takes contrast of colours, here
//! that of blocks. What noise adds to a square is paid for in full, and so is a level, or boundaries would follow them.
double mostPriceFor(const PyramidLevel* pyramid, int top, const Mat& mask, const Mat& mask_of_top,
                    const RegionDistance& distance)
{
    CV_TRACE_FUNCTION();
    const int QUARTERS = 8;
    if (!mask.empty() && countNonZero(someRows(mask)) == 0)
        return DBL_MAX; // its noise is not known
    Scalar mean, contrast;
    meanStdDev(pyramid[top].view(), mean, contrast, mask_of_top);
    const Scalar noise = noiseOf(pyramid[0].view(), mask, distance.with_depth);
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
