// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "gwatershed/pixel_map.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! cn is the number of channels. A gray image has one, which becomes all three colours.
static void packRow(const uchar* color, int cn, const uchar* depth, FloodPixel* pixels, int cols)
{
    const int green = cn == 1 ? 0 : 1, red = cn == 1 ? 0 : 2;
    for (int x = 0; x < cols; x++, color += cn)
    {
        const Pixel pixel = { color[0], color[green], color[red], depth ? depth[x] : uchar(0) };
        pixels[x].state = UNLABELLED;
        pixels[x].value = pixel;
    }
}

void makePixelMap(const Mat& color, const Mat& depth, PixelMap& pixels)
{
    CV_TRACE_FUNCTION();
    const FloodPixel frame = { FRAME, { 0, 0, 0, 0 } };
    pixels.create(color.size(), frame);
    parallel_for_(Range(0, color.rows), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
        {
            const uchar* depth_row = depth.empty() ? 0 : depth.ptr(y);
            packRow(color.ptr(y), color.channels(), depth_row, pixels.row(y), color.cols);
        }
    });
}

void closeOutside(const Mat& mask, PixelMap& pixels)
{
    for (int y = 0; y < mask.rows; y++)
        for (int x = 0; x < mask.cols; x++)
            if (!mask.at<uchar>(y, x))
                pixels.row(y)[x].state = FRAME;
}

void labelMarkers(const std::vector<Point>& markers, PixelMap& pixels)
{
    for (size_t i = 0; i < markers.size(); i++)
        pixels.row(markers[i].y)[markers[i].x].state = int(i) + 1;
}

void labelMarkers(const Mat& markers, PixelMap& pixels)
{
    for (int y = 0; y < markers.rows; y++)
        for (int x = 0; x < markers.cols; x++)
            if (markers.at<int>(y, x) >= 0)
                pixels.row(y)[x].state = markers.at<int>(y, x) + 1;
}

void extractLabels(PixelMap& pixels, Mat& labels)
{
    CV_TRACE_FUNCTION();
    labels.create(pixels.size(), CV_32SC1);
    parallel_for_(Range(0, labels.rows), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
        {
            const FloodPixel* from = pixels.row(y);
            int* to = labels.ptr<int>(y);
            for (int x = 0; x < labels.cols; x++)
                to[x] = std::max(from[x].state, 0) - 1;
        }
    });
}

}}} // namespace
