// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/features.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { STRIDE = 16 }; // pixels that are converted at once

//! The mean of two bytes, rounded up: compilers know this as one instruction for sixteen of them.
static inline uchar meanOf(uchar a, uchar b) { return uchar((a + b + 1) >> 1); }

//! 255 - a. The mean of turned bytes is the turned mean, rounded down.
static inline uchar turned(uchar a) { return uchar(~a); }

//! The opponent space: lightness (R + 2G + B) / 4, and the differences of red against green, (R - G) / 2, and of yellow
//! against blue, (R + G - 2B) / 4, both shifted by 128; rounded up at a half, 255 at most.
//! @note As good as CIELAB for superpixels (measured, doc/log.md), and only a few means of bytes. A mean of a mean is
//! rounded right if the first one is rounded down.
static inline void convertFromBGR(v_uint8x16& b, v_uint8x16& g, v_uint8x16& r)
{
    uchar blue[STRIDE], green[STRIDE], red[STRIDE];
    v_store(blue, b);
    v_store(green, g);
    v_store(red, r);
    for (int i = 0; i < STRIDE; i++)
    {
        const uchar not_red = turned(red[i]), not_green = turned(green[i]);
        const uchar of_both_ends = turned(meanOf(turned(blue[i]), not_red)), not_yellow = meanOf(not_red, not_green);
        const uchar lightness = meanOf(of_both_ends, green[i]), against_green = meanOf(red[i], not_green);
        red[i] = meanOf(not_yellow, blue[i]);
        blue[i] = lightness;
        green[i] = against_green;
    }
    b = v_load(blue);
    g = v_load(green);
    r = subtract(v_setall_u8(255), subtract(v_load(red), v_setall_u8(1))); // 256 less it, 255 at most: it is turned
}

//! 16 pixels at once.
static inline void convertStride(const uchar* color, int channels, bool opponents, const uchar* depth, Feature* to)
{
    v_uint8x16 c0, c1, c2, alpha;
    if (channels == 1)
    {
        c0 = v_load(color);
        c1 = c2 = v_setall_u8(128);
    }
    else if (channels == 3)
        v_load_deinterleave(color, c0, c1, c2);
    else
        v_load_deinterleave(color, c0, c1, c2, alpha);
    if (opponents)
        convertFromBGR(c0, c1, c2);
    v_store_interleave(to->color, c0, c1, c2, depth ? v_load(depth) : v_setzero_u8());
}

static void makeFeatureRow(const uchar* color, int channels, bool lab_input, const uchar* depth, int cols, Feature* to)
{
    const bool opponents = channels > 1 && !lab_input;
    int x = 0;
    for (; x <= cols - STRIDE; x += STRIDE)
        convertStride(color + size_t(x) * channels, channels, opponents, depth ? depth + x : 0, to + x);
    if (x == cols)
        return;
    uchar last_color[4 * STRIDE] = {}, last_depth[STRIDE] = {};
    Feature last[STRIDE];
    memcpy(last_color, color + size_t(x) * channels, (cols - x) * channels);
    if (depth)
        memcpy(last_depth, depth + x, cols - x);
    convertStride(last_color, channels, opponents, last_depth, last);
    memcpy(to + x, last, (cols - x) * sizeof(Feature));
}

void makeFeatures(const Mat& color, const Mat& depth, bool lab_input, const Range& rows, Padded<Feature>& features)
{
    for (int y = rows.start; y < rows.end; y++)
        makeFeatureRow(color.ptr(y), color.channels(), lab_input, depth.empty() ? 0 : depth.ptr(y), color.cols,
                       features.row(y));
}

}}} // namespace
