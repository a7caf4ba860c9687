// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/feature_pyramid.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! Mean of the depths that are valid.
static uchar meanDepth(const Feature* const* elements, int n)
{
    int sum = 0, valid = 0;
    for (int i = 0; i < n; i++)
    {
        sum += elements[i]->depth;
        valid += elements[i]->depth != 0;
    }
    return valid ? uchar((sum + valid / 2) / valid) : uchar(0);
}

//! Sums of up to 1024, so 16 bits hold them.
struct Halves
{
    explicit Halves(const v_uint8x16& v) { v_expand(v, low, high); }
    v_uint16x8 low, high;
};

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
    {
        const Feature* const elements[4] = { upper + i, upper + i + 1, lower + i, lower + i + 1 };
        to[i / 2].depth = meanDepth(elements, 4);
    }
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

//! Sums over three rows of pixels, channel by channel.
static void addRows(const Feature* const rows[3], int cols, ushort* sums)
{
    const uchar *a = rows[0]->color, *b = rows[1]->color, *c = rows[2]->color;
    for (int i = 0; i < cols * int(sizeof(Feature)); i++)
        sums[i] = ushort(a[i] + b[i] + c[i]);
}

//! Means of blocks of 3x3 pixels, from the sums of its columns, for two blocks at once.
static inline void meanOfColumns(const ushort* sums, Feature* to)
{
    const int NINTH = 7282; // in 1/65536: rounded up, which makes the quotients of all sums right
    const v_uint16x8 first = v_load_halves(sums, sums + 12), second = v_load_halves(sums + 4, sums + 16);
    const v_uint16x8 third = v_load_halves(sums + 8, sums + 20);
    const v_uint16x8 sum = v_add_wrap(v_add_wrap(first, second), v_add_wrap(third, v_setall_u16(4)));
    v_pack_store(to->color, v_mul_hi(sum, v_setall_u16(NINTH)));
}

static void thirdFeatures(const Padded<Feature>& features, bool with_depth, const Range& rows, Padded<Feature>& thirds)
{
    const Size size = features.size();
    const int width = thirds.size().width, CHANNELS = int(sizeof(Feature));
    std::vector<ushort> sums(CHANNELS * 3 * (width + 1)); // blocks are taken in pairs
    std::vector<Feature> means(width + 1);
    for (int y = rows.start; y < rows.end; y++)
    {
        const Feature* from[3];
        for (int i = 0; i < 3; i++)
            from[i] = features.row(std::min(3 * y + i, size.height - 1));
        addRows(from, size.width, sums.data());
        for (int x = size.width; x < 3 * width; x++)
            std::copy_n(&sums[CHANNELS * (size.width - 1)], CHANNELS, &sums[CHANNELS * x]);
        for (int x = 0; x < width; x += 2)
            meanOfColumns(&sums[3 * CHANNELS * x], &means[x]);
        for (int x = 0; with_depth && x < width; x++)
        {
            const Feature* elements[9];
            for (int i = 0; i < 9; i++)
                elements[i] = from[i / 3] + std::min(3 * x + i % 3, size.width - 1);
            means[x].depth = meanDepth(elements, 9);
        }
        std::copy(means.begin(), means.begin() + width, thirds.row(y));
    }
}

void makePyramid(const Mat& color, const Mat& depth, bool lab_input, const BlockLevels& levels,
                 Padded<Feature>* features)
{
    CV_TRACE_FUNCTION();
    const int BAND_HEIGHT = 24; // while its rows are in the cache
    CV_DbgAssert(BAND_HEIGHT % levels.side(levels.top) == 0); // a band has whole blocks on every level
    for (int level = 0; level <= levels.top; level++)
        features[level].create(levels.sizeOf(level, color.size()), Feature());
    parallel_for_(Range(0, (color.rows + BAND_HEIGHT - 1) / BAND_HEIGHT), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            for (int level = 0; level <= levels.top; level++)
            {
                const int height = BAND_HEIGHT / levels.side(level);
                const Range rows(i * height, std::min((i + 1) * height, features[level].size().height));
                if (level == 0)
                    for (int y = rows.start; y < rows.end; y++)
                        makeFeatureRow(color.ptr(y), color.channels(), lab_input, depth.empty() ? 0 : depth.ptr(y),
                                       color.cols, features[0].row(y));
                else if (levels.ratio(level) == 3)
                    thirdFeatures(features[level - 1], !depth.empty(), rows, features[level]);
                else
                    halveFeatures(features[level - 1], !depth.empty(), rows, features[level]);
            }
    });
}

}}} // namespace
