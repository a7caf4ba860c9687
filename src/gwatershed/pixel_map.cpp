// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "gwatershed/pixel_map.hpp"
#include "shared/alpha.hpp"
#include "shared/masks.hpp"
#include "shared/row_chunks.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

enum { STRIDE = 16 }; // pixels that are compared at once

namespace {

//! Colours of 16 pixels, by channel.
struct Colors
{
    Colors(const uchar* color, int channels)
    {
        if (channels == 1)
            b = g = r = v_load(color);
        else if (channels == 3)
            v_load_deinterleave(color, b, g, r);
        else
        {
            v_uint8x16 transparency;
            v_load_deinterleave(color, b, g, r, transparency);
        }
    }
    v_uint8x16 b, g, r;
};

} // namespace

//! Equation (1), of 16 pairs of pixels.
static inline void compareColors(const uchar* p, const uchar* q, int channels, uchar* distances)
{
    const Colors a(p, channels), b(q, channels);
    v_store(distances, v_max(v_max(v_absdiff(a.b, b.b), v_absdiff(a.g, b.g)), v_absdiff(a.r, b.r)));
}

//! Equation (1), of n pairs of pixels.
static void compareColors(const uchar* p, const uchar* q, int channels, int n, uchar* distances)
{
    int x = 0;
    for (; x <= n - STRIDE; x += STRIDE)
        compareColors(p + size_t(x) * channels, q + size_t(x) * channels, channels, distances + x);
    if (x == n)
        return;
    uchar last_p[4 * STRIDE] = {}, last_q[4 * STRIDE] = {}, last[STRIDE];
    memcpy(last_p, p + size_t(x) * channels, size_t(n - x) * channels);
    memcpy(last_q, q + size_t(x) * channels, size_t(n - x) * channels);
    compareColors(last_p, last_q, channels, last);
    memcpy(distances + x, last, n - x);
}

//! Equation (3), where both pixels have depth.
static void weighDepth(const uchar* p, const uchar* q, int n, int alpha, uchar* distances)
{
    for (int x = 0; x < n; x++)
    {
        const int weighed = weighByAlpha(alpha, distances[x], std::abs(p[x] - q[x]));
        distances[x] = uchar(((p[x] != 0) & (q[x] != 0)) ? weighed : distances[x]);
    }
}

namespace {

//! Compares the pixels of two rows, or of one row with those beside them.
class RowComparison
{
public:
    RowComparison(const Mat& color, const Mat& depth, int alpha) : color_(color), depth_(depth), alpha_(alpha) {}

    //! distances: of the pixel at the left, and the frame at both ends, in cols + 1 elements.
    void compareBeside(int y, uchar* distances) const
    {
        distances[0] = distances[color_.cols] = 0;
        compare(y, y, 1, distances + 1);
    }

    //! To the row above; nothing is compared at the borders of the image.
    void compareAbove(int y, uchar* distances) const
    {
        if (y > 0 && y < color_.rows)
            compare(y - 1, y, 0, distances);
        else
            std::fill_n(distances, color_.cols, uchar(0));
    }

private:
    //! Row y with another one, whose pixels lie `shift` to the right.
    void compare(int y, int other, int shift, uchar* distances) const
    {
        const int n = color_.cols - shift, cn = color_.channels();
        compareColors(color_.ptr(y), color_.ptr(other) + shift * cn, cn, n, distances);
        if (!depth_.empty())
            weighDepth(depth_.ptr(y), depth_.ptr(other) + shift, n, alpha_, distances);
    }

    const Mat& color_;
    const Mat& depth_;
    const int alpha_;
};

} // namespace

//! beside: distances of the pixels of a row to those at the left, and one more.
static void packRow(const uchar* beside, const uchar* above, const uchar* below, const ushort* gradient, int threshold,
                    int cols, FloodPixel* to)
{
    for (int x = 0; x < cols; x++)
    {
        const bool is_line = (gradient[x] >= threshold) & (gradient[x] != UNKNOWN_GRADIENT);
        to[x].state = is_line * LINE;
        to[x].distances = beside[x] | above[x] << 8 | beside[x + 1] << 16 | unsigned(below[x]) << 24;
    }
}

void makePixelMap(const Mat& color, const Mat& depth, int alpha, const Mat& gradient, float border_threshold,
                  PixelMap& pixels)
{
    CV_TRACE_FUNCTION();
    const int ROWS = 32, cols = color.cols; // of a chunk: its first row is compared with the one above once more
    const int threshold = border_threshold > 0 ? cvCeil(std::min(border_threshold, 65535.f)) : 65535;
    const RowComparison rows(color, depth, alpha);
    const RowChunks chunks(color.rows, ROWS);
    const FloodPixel frame = { FRAME, 0 };
    pixels.create(color.size(), frame);
    parallel_for_(Range(0, chunks.size()), [&](const Range& range)
    {
        std::vector<uchar> beside(cols + 1), above(cols), below(cols);
        const int first = chunks[range.start].start, end = chunks[range.end - 1].end;
        rows.compareAbove(first, above.data());
        for (int y = first; y < end; y++)
        {
            rows.compareBeside(y, beside.data());
            rows.compareAbove(y + 1, below.data());
            packRow(beside.data(), above.data(), below.data(), gradient.ptr<ushort>(y), threshold, cols, pixels.row(y));
            above.swap(below);
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

static void labelPixel(int p, int label, PixelMap& pixels)
{
    pixels.data()[p].state = label;
    for (int k = 0; k < 4; k++)
    {
        int& state = pixels.data()[p + pixels.neighbors()[k]].state;
        state = state == UNLABELLED ? int(IN_QUEUE) : state;
    }
}

void labelMarkers(const std::vector<Point>& markers, PixelMap& pixels)
{
    for (size_t i = 0; i < markers.size(); i++)
        labelPixel(pixels.index(markers[i]), int(i) + 1, pixels);
}

void labelMarkers(const Mat& markers, PixelMap& pixels)
{
    for (int y = 0; y < markers.rows; y++)
        for (int x = 0; x < markers.cols; x++)
            if (markers.at<int>(y, x) >= 0)
                labelPixel(pixels.index(Point(x, y)), markers.at<int>(y, x) + 1, pixels);
}

void extractLabels(const PixelMap& pixels, Mat& labels)
{
    CV_TRACE_FUNCTION();
    labels.create(pixels.size(), CV_32SC1);
    forRows(Range(0, labels.rows), [&](int y)
    {
        const FloodPixel* from = pixels.row(y);
        int* to = labels.ptr<int>(y);
        for (int x = 0; x < labels.cols; x++)
            to[x] = std::max(from[x].state, 0) - 1;
    });
}

}}} // namespace
