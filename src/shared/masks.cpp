// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/masks.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! From the first non-zero element to the one after the last; {0, 0} if there is none.
static Range findRange(const Mat& line)
{
    const uchar* const begin = line.ptr();
    const uchar* const end = begin + line.total();
    const uchar* first = begin;
    while (first < end && !*first)
        first++;
    const uchar* last = end;
    while (last > first && !last[-1])
        last--;
    return first == end ? Range(0, 0) : Range(int(first - begin), int(last - begin));
}

//! @note As boundingRect(), which OpenCV 5 has in a module of its own.
Rect findBounds(const Mat& mask)
{
    Mat columns, rows;
    reduce(mask, columns, 0, REDUCE_MAX);
    reduce(mask, rows, 1, REDUCE_MAX);
    const Range x = findRange(columns), y = findRange(rows);
    return Rect(x.start, y.start, x.size(), y.size());
}

void forgetGradients(const Mat& mask, Mat& gradient)
{
    CV_TRACE_FUNCTION();
    Mat inside;
    erode(mask, inside, Mat(), Point(-1, -1), 1, BORDER_REPLICATE | BORDER_ISOLATED); // 0: one is outside
    gradient.setTo(Scalar(UNKNOWN_GRADIENT), inside == 0);
}

}}} // namespace
