// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/feature_pyramid.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! Mean of the depths that are valid.
static uchar meanDepth(int a, int b, int c, int d)
{
    const int valid = (a != 0) + (b != 0) + (c != 0) + (d != 0);
    return valid ? uchar((a + b + c + d + valid / 2) / valid) : uchar(0);
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
        to[i / 2].depth = meanDepth(upper[i].depth, upper[i + 1].depth, lower[i].depth, lower[i + 1].depth);
}

static void halveFeatures(const FeatureMap& features, bool with_depth, const Range& rows, FeatureMap& halved)
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

void makePyramid(const Mat& color, const Mat& depth, const Mat& normals, bool lab_input, int top, FeatureMap* levels)
{
    CV_TRACE_FUNCTION();
    const int BAND_HEIGHT = 16; // while its rows are in the cache
    CV_DbgAssert(BAND_HEIGHT % (1 << top) == 0); // a band has whole blocks on every level
    Size size = color.size();
    for (int level = 0; level <= top; level++, size = Size((size.width + 1) / 2, (size.height + 1) / 2))
    {
        levels[level].create(size, Feature());
        if (!normals.empty())
            levels[level].normals.create(size, Normal());
    }
    parallel_for_(Range(0, (color.rows + BAND_HEIGHT - 1) / BAND_HEIGHT), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            for (int level = 0; level <= top; level++)
            {
                const Range rows((i * BAND_HEIGHT) >> level,
                                 std::min(((i + 1) * BAND_HEIGHT) >> level, levels[level].size().height));
                if (level == 0)
                    for (int y = rows.start; y < rows.end; y++)
                        makeFeatureRow(color.ptr(y), color.channels(), lab_input, depth.empty() ? 0 : depth.ptr(y),
                                       color.cols, levels[0].row(y));
                else
                    halveFeatures(levels[level - 1], !depth.empty(), rows, levels[level]);
            }
    });
    for (int level = 0; !normals.empty() && level <= top; level++)
        for (int y = 0; y < levels[level].size().height; y++)
            for (int x = 0; x < levels[level].size().width; x++)
            {
                Normal& n = levels[level].normals.row(y)[x];
                if (level == 0)
                    n = levels[0].row(y)[x].depth ? normals.at<Normal>(y / 2, x / 2) : Normal();
                else if (level == 1)
                    n = normals.at<Normal>(y, x);
                else
                {
                    const Size before = levels[level - 1].size();
                    int sx = 0, sy = 0, count = 0;
                    for (int k = 0; k < 4; k++)
                    {
                        const Normal& f = levels[level - 1].normals.row(std::min(2 * y + k / 2, before.height - 1))[std::min(2 * x + k % 2, before.width - 1)];
                        sx += f.x; sy += f.y; count += f.known();
                    }
                    n.x = uchar(count ? (sx + count / 2) / count : 0);
                    n.y = uchar(count ? (sy + count / 2) / count : 0);
                }
            }
}

}}} // namespace
