// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "nodes.hpp"

namespace cv { namespace ximgproc { namespace gws {

static_assert(sizeof(Node) == 8, "a Node fills an element of CV_32SC2");

//! cn is the number of channels; green and red are the channels 1 and 2, or 0 in a gray image.
static void packRow(const uchar* color, int cn, const uchar* depth, Node* nodes, int cols)
{
    const int green = cn == 1 ? 0 : 1, red = cn == 1 ? 0 : 2;
    for (int x = 0; x < cols; x++, color += cn)
    {
        const Pixel pixel = { color[0], color[green], color[red], depth ? depth[x] : uchar(0) };
        nodes[x].state = UNLABELLED;
        nodes[x].pixel = pixel;
    }
}

void NodeMap::create(const Mat& color, const Mat& depth)
{
    reserve(color.size());
    const Node frame = { FRAME, { 0, 0, 0, 0 } };
    const int cols = color.cols;

    std::fill_n(row(-1) - 1, cols + 2, frame);
    std::fill_n(row(color.rows) - 1, cols + 2, frame);
    parallel_for_(Range(0, color.rows), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
        {
            Node* nodes = row(y);
            nodes[-1] = nodes[cols] = frame;
            packRow(color.ptr(y), color.channels(), depth.empty() ? 0 : depth.ptr(y), nodes, cols);
        }
    });
}

}}} // namespace
