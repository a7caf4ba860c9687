// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "mask.hpp"
#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { STRIDE = 16 }; // pixels that are converted at once

//! Sums of up to 1024, so 16 bits hold them.
struct Halves
{
    explicit Halves(const v_uint8x16& v) { v_expand(v, low, high); }
    v_uint16x8 low, high;
};

//! The opponent space: lightness (R + 2G + B) / 4, and the differences of red against green and
//! of yellow against blue, halved and shifted to 0..255.
//! @note Measured level with CIELAB as the space of superpixels (doc/log.md), and a few additions.
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
    b = v_pack(low[0], high[0]);
    g = v_pack(low[1], high[1]);
    r = v_pack(low[2], high[2]);
}

//! A row of pixels, 16 at a time.
static inline void makeRow(const uchar* color, int channels, bool opponents, const uchar* depth, Feature* to)
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

static void makeFeatures(const Mat& color, const Mat& depth, bool uniform_color, const Range& rows,
                         Padded<Feature>& features)
{
    const int channels = color.channels(), cols = color.cols;
    const bool opponents = channels > 1 && !uniform_color;
    for (int y = rows.start; y < rows.end; y++)
    {
        const uchar *from = color.ptr(y), *depths = depth.empty() ? 0 : depth.ptr(y);
        Feature* to = features.row(y);
        int x = 0;
        for (; x <= cols - STRIDE; x += STRIDE)
            makeRow(from + size_t(x) * channels, channels, opponents, depths ? depths + x : 0, to + x);
        if (x == cols)
            continue;
        uchar last_color[4 * STRIDE] = {}, last_depth[STRIDE] = {};
        Feature last[STRIDE];
        memcpy(last_color, from + size_t(x) * channels, (cols - x) * channels);
        if (depths)
            memcpy(last_depth, depths + x, cols - x);
        makeRow(last_color, channels, opponents, last_depth, last);
        memcpy(to + x, last, (cols - x) * sizeof(Feature));
    }
}

//! Mean of the depths that are valid.
static uchar meanDepth(int a, int b, int c, int d)
{
    const int valid = (a != 0) + (b != 0) + (c != 0) + (d != 0);
    return valid ? uchar((a + b + c + d + valid / 2) / valid) : uchar(0);
}

static inline v_uint16x8 quarter(const v_uint16x8& a, const v_uint16x8& b, const v_uint16x8& c, const v_uint16x8& d)
{
    return v_shr<2>(v_add_wrap(v_add_wrap(v_add_wrap(a, b), v_add_wrap(c, d)), v_setall_u16(2)));
}

//! Means of blocks of 2x2 pixels, 4 blocks at a time.
static inline void halveRow(const Feature* upper, const Feature* lower, bool with_depth, Feature* to)
{
    v_uint32x4 a, b, c, d; // the pixels of a block
    v_load_deinterleave(reinterpret_cast<const unsigned*>(upper), a, b);
    v_load_deinterleave(reinterpret_cast<const unsigned*>(lower), c, d);
    const Halves ha(v_reinterpret_as_u8(a)), hb(v_reinterpret_as_u8(b));
    const Halves hc(v_reinterpret_as_u8(c)), hd(v_reinterpret_as_u8(d));
    v_store(to->color, v_pack(quarter(ha.low, hb.low, hc.low, hd.low), quarter(ha.high, hb.high, hc.high, hd.high)));
    for (int i = 0; with_depth && i < 8; i += 2)
        to[i / 2].depth = meanDepth(upper[i].depth, upper[i + 1].depth, lower[i].depth, lower[i + 1].depth);
}

static void halveFeatures(const Padded<Feature>& features, bool with_depth, const Range& rows, Padded<Feature>& halved)
{
    const Size size = features.size();
    const int width = halved.size().width;
    for (int y = rows.start; y < rows.end; y++)
    {
        const Feature* upper = features.row(2 * y);
        const Feature* lower = features.row(std::min(2 * y + 1, size.height - 1));
        Feature* to = halved.row(y);
        int x = 0;
        for (; x <= size.width / 2 - 4; x += 4)
            halveRow(upper + 2 * x, lower + 2 * x, with_depth, to + x);
        if (x == width)
            continue;
        Feature last_upper[8], last_lower[8], last[4];
        for (int i = 0; i < 8; i++)
        {
            const int from = std::min(2 * x + i, size.width - 1);
            last_upper[i] = upper[from];
            last_lower[i] = lower[from];
        }
        halveRow(last_upper, last_lower, with_depth, last);
        std::copy(last, last + (width - x), to + x);
    }
}

void makePyramid(const Mat& color, const Mat& depth, bool uniform_color, int top, Padded<Feature>* levels)
{
    CV_TRACE_FUNCTION();
    const int BAND_HEIGHT = 64; // while its rows are in the cache
    Size size = color.size();
    for (int level = 0; level <= top; level++, size = Size((size.width + 1) / 2, (size.height + 1) / 2))
        levels[level].create(size, Feature());
    parallel_for_(Range(0, (color.rows + BAND_HEIGHT - 1) / BAND_HEIGHT), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            for (int level = 0; level <= top; level++)
            {
                const Range rows((i * BAND_HEIGHT) >> level,
                                 std::min(((i + 1) * BAND_HEIGHT) >> level, levels[level].size().height));
                if (level == 0)
                    makeFeatures(color, depth, uniform_color, rows, levels[0]);
                else
                    halveFeatures(levels[level - 1], !depth.empty(), rows, levels[level]);
            }
    });
}

//! Sum of the absolute differences of the neighbours to both sides, in steps so large that markers
//! leave the centres of their cells for real edges only.
static int gradientAt(const Feature* f, int step, const RegionDistance& distance)
{
    const int STEP = 32;
    int color = 0;
    for (int k = 0; k < 3; k++)
        color += std::abs(f[1].color[k] - f[-1].color[k]) + std::abs(f[step].color[k] - f[-step].color[k]);
    if (!f[1].depth || !f[-1].depth || !f[step].depth || !f[-step].depth)
        return color / STEP;
    const int depth = std::abs(f[1].depth - f[-1].depth) + std::abs(f[step].depth - f[-step].depth);
    return (distance.color_share * color + distance.depth_share * depth) / (256 * STEP);
}

//! The pixels at the border of the image have no neighbours to both sides: they count as edges.
void computeGradient(const Padded<Feature>& features, const RegionDistance& distance, Mat& gradient)
{
    CV_TRACE_FUNCTION();
    gradient.create(features.size(), CV_16UC1);
    gradient.setTo(Scalar(UNKNOWN_GRADIENT));
    parallel_for_(Range(1, std::max(1, gradient.rows - 1)), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
            for (int x = 1; x < gradient.cols - 1; x++)
            {
                const int height = gradientAt(features.row(y) + x, features.step(), distance);
                gradient.at<ushort>(y, x) = ushort(height);
            }
    });
}

}}} // namespace
