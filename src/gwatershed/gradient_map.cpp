// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "gwatershed/gradient_map.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Rows of one task. Its derivatives fit into the cache up to the width of a 4K image.
static const int BAND = 32;

//! Sobel magnitude of one band, CV_16UC1. Reads the rows above and below the band, if there are any.
static void sobelMagnitude(const Mat& band, Mat& magnitude)
{
    Mat dx, dy;
    Sobel(band, dx, CV_16S, 1, 0);
    Sobel(band, dy, CV_16S, 0, 1);
    for (int y = 0; y < band.rows; y++)
    {
        const short* px = dx.ptr<short>(y);
        const short* py = dy.ptr<short>(y);
        ushort* to = magnitude.ptr<ushort>(y);
        for (int x = 0; x < band.cols; x++)
            to[x] = ushort(std::sqrt(float(px[x] * px[x] + py[x] * py[x])) + 0.5f);
    }
}

//! Combines the gradients of colour and depth with the weights alpha and 1 - alpha, where the 3x3 window has no missing
//! depth.
static void addDepthGradient(const Mat& band, int alpha, Mat& gradient)
{
    Mat lowest, depth_gradient(band.size(), CV_16UC1);
    sobelMagnitude(band, depth_gradient);
    erode(band, lowest, Mat()); // 0 if the 3x3 window has a missing depth
    for (int y = 0; y < band.rows; y++)
    {
        const ushort* from = depth_gradient.ptr<ushort>(y);
        const uchar* complete = lowest.ptr(y);
        ushort* to = gradient.ptr<ushort>(y);
        for (int x = 0; x < band.cols; x++)
            if (complete[x])
                to[x] = ushort((alpha * to[x] + (256 - alpha) * from[x] + 128) >> 8);
    }
}

//! Section III.A of the paper. Each band of rows is one task.
void computeGradientMap(const Mat& color, const Mat& depth, int alpha, Mat& gray, Mat& gradient)
{
    CV_TRACE_FUNCTION();
    if (color.channels() == 1)
        color.copyTo(gray);
    else
        cvtColor(color, gray, color.channels() == 3 ? COLOR_BGR2GRAY : COLOR_BGRA2GRAY);

    gradient.create(gray.size(), CV_16UC1);
    parallel_for_(Range(0, (gray.rows + BAND - 1) / BAND), [&](const Range& bands)
    {
        for (int i = bands.start; i < bands.end; i++)
        {
            const Range rows(i * BAND, std::min((i + 1) * BAND, gray.rows));
            Mat band = gradient.rowRange(rows);
            sobelMagnitude(gray.rowRange(rows), band);
            if (!depth.empty())
                addDepthGradient(depth.rowRange(rows), alpha, band);
        }
    });
}

}}} // namespace
