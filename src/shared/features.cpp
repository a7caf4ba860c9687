// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/features.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { STRIDE = 16 }; // pixels that are converted at once

//! Of numbers up to 255, which need no saturation.
static inline v_uint8x16 packBytes(const v_uint16x8& low, const v_uint16x8& high)
{
    return v_pack_u(v_reinterpret_as_s16(low), v_reinterpret_as_s16(high));
}

//! The opponent space: lightness (R + 2G + B) / 4, and the differences of red against green and
//! of yellow against blue, halved and shifted to 0..255.
//! @note As good as CIELAB for superpixels (measured, doc/log.md), and only a few additions.
static inline void convertFromBGR(const v_uint16x8& b, const v_uint16x8& g, const v_uint16x8& r, v_uint16x8* color)
{
    const v_uint16x8 red_and_green = v_add_wrap(r, g), blue_and_green = v_add_wrap(b, g);
    const v_uint16x8 sum = v_add_wrap(red_and_green, blue_and_green);
    color[0] = v_shr<2>(v_add_wrap(sum, v_setall_u16(2)));
    color[1] = v_shr<1>(v_sub_wrap(v_add_wrap(r, v_setall_u16(256)), g));
    color[2] = v_shr<2>(v_sub_wrap(v_add_wrap(red_and_green, v_setall_u16(512 + 2)), v_shl<1>(b)));
}

static inline void convertFromBGR(v_uint8x16& b, v_uint8x16& g, v_uint8x16& r)
{
    const Halves blue(b), green(g), red(r);
    v_uint16x8 low[3], high[3];
    convertFromBGR(blue.low, green.low, red.low, low);
    convertFromBGR(blue.high, green.high, red.high, high);
    b = packBytes(low[0], high[0]);
    g = packBytes(low[1], high[1]);
    r = packBytes(low[2], high[2]);
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
