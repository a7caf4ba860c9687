// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "gwatershed/gradient_map.hpp"
#include "shared/alpha.hpp"
#include "shared/row_chunks.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Rows of an 8-bit image in grey, with a frame of one pixel; beyond the borders of the image it is mirrored.
static Mat makeGray(const Mat& image, const Range& rows)
{
    const Mat part = image.rowRange(std::max(rows.start - 1, 0), std::min(rows.end + 1, image.rows));
    Mat gray = part, framed;
    if (image.channels() > 1)
        cvtColor(part, gray, image.channels() == 3 ? COLOR_BGR2GRAY : COLOR_BGRA2GRAY);
    copyMakeBorder(gray, framed, rows.start == 0, rows.end == image.rows, 1, 1, BORDER_REFLECT_101 | BORDER_ISOLATED);
    return framed;
}

static inline v_int16x8 loadGray(const uchar* gray) { return v_reinterpret_as_s16(v_load_expand(gray)); }

//! Rounded lengths of four vectors (x, y), which lie in turns.
static inline v_int32x4 lengthOf(const v_int16x8& vectors)
{
    const v_float32x4 length = v_sqrt(v_cvt_f32(v_dotprod(vectors, vectors)));
    return v_trunc(add(length, v_setall_f32(0.5f)));
}

//! Sobel magnitude of 8 pixels; the rows begin at their neighbours to the upper left, left and lower left.
static inline v_int16x8 sobelMagnitude(const uchar* above, const uchar* row, const uchar* below)
{
    const v_int16x8 top_left = loadGray(above), top = loadGray(above + 1), top_right = loadGray(above + 2);
    const v_int16x8 left = loadGray(row), right = loadGray(row + 2);
    const v_int16x8 bottom_left = loadGray(below), bottom = loadGray(below + 1), bottom_right = loadGray(below + 2);
    const v_int16x8 falling = v_sub_wrap(bottom_right, top_left), rising = v_sub_wrap(top_right, bottom_left);
    const v_int16x8 dx = v_add_wrap(v_add_wrap(falling, rising), v_shl<1>(v_sub_wrap(right, left)));
    const v_int16x8 dy = v_add_wrap(v_sub_wrap(falling, rising), v_shl<1>(v_sub_wrap(bottom, top)));
    v_int16x8 low, high;
    v_zip(dx, dy, low, high);
    return v_pack(lengthOf(low), lengthOf(high));
}

//! The same of one row. What is left over at its end is taken from a copy.
static void sobelRow(const uchar* above, const uchar* row, const uchar* below, int cols, short* to)
{
    const int STRIDE = 8;
    int x = 0;
    for (; x <= cols - STRIDE; x += STRIDE)
        v_store(to + x, sobelMagnitude(above + x, row + x, below + x));
    if (x == cols)
        return;
    uchar last[3][STRIDE + 2 + STRIDE] = {};
    short last_to[STRIDE];
    std::copy(above + x, above + cols + 2, last[0]);
    std::copy(row + x, row + cols + 2, last[1]);
    std::copy(below + x, below + cols + 2, last[2]);
    v_store(last_to, sobelMagnitude(last[0], last[1], last[2]));
    std::copy(last_to, last_to + (cols - x), to + x);
}

//! Sobel magnitude of some rows, CV_16UC1.
static void sobelMagnitude(const Mat& image, const Range& rows, Mat& magnitude)
{
    const Mat gray = makeGray(image, rows);
    for (int y = 0; y < rows.size(); y++)
        sobelRow(gray.ptr(y), gray.ptr(y + 1), gray.ptr(y + 2), image.cols, magnitude.ptr<short>(y));
}

//! Adds the gradient of depth with the weight 1 - alpha, where no depth is missing in the window.
static void addDepthGradient(const Mat& depth, const Range& rows, int alpha, Mat& gradient)
{
    const Mat part = depth.rowRange(rows);
    Mat lowest, depth_gradient(part.size(), CV_16UC1);
    sobelMagnitude(depth, rows, depth_gradient);
    erode(part, lowest, Mat()); // 0: the 3x3 window holds a missing depth
    for (int y = 0; y < part.rows; y++)
    {
        const ushort* from = depth_gradient.ptr<ushort>(y);
        const uchar* complete = lowest.ptr(y);
        ushort* to = gradient.ptr<ushort>(y);
        for (int x = 0; x < part.cols; x++)
            if (complete[x])
                to[x] = ushort(weighByAlpha(alpha, to[x], from[x]));
    }
}

//! Section III.A.
void computeGradientMap(const Mat& color, const Mat& depth, int alpha, Mat& gradient)
{
    CV_TRACE_FUNCTION();
    const int ROWS = 32; // what is made of them stays in the cache up to a width of 4K
    gradient.create(color.size(), CV_16UC1);
    RowChunks(color.rows, ROWS).forAll([&](int, const Range& rows)
    {
        Mat part = gradient.rowRange(rows);
        sobelMagnitude(color, rows, part);
        if (!depth.empty())
            addDepthGradient(depth, rows, alpha, part);
    });
}

}}} // namespace
