// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/feature_pyramid.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! Mean of the values that are not 0.
static uchar meanOfKnown(int a, int b, int c, int d)
{
    const int known = (a != 0) + (b != 0) + (c != 0) + (d != 0);
    return known ? uchar((a + b + c + d + known / 2) / known) : uchar(0);
}

//! The same of 16-bit values up to 255. The sum is multiplied by 12 / known, which is the largest of three lines over the
//! numbers 1 to 4, and divided by 12.
static inline v_uint16x8 meanOfKnown(const v_uint16x8& a, const v_uint16x8& b, const v_uint16x8& c, const v_uint16x8& d)
{
    const v_uint16x8 one = v_setall_u16(1), sum = v_add_wrap(v_add_wrap(a, b), v_add_wrap(c, d));
    const v_int16x8 known = v_reinterpret_as_s16(v_add_wrap(v_add_wrap(v_min(a, one), v_min(b, one)),
                                                            v_add_wrap(v_min(c, one), v_min(d, one))));
    const v_int16x8 twice = v_shl<1>(known);
    const v_int16x8 factor = v_max(v_sub_wrap(v_setall_s16(18), v_add_wrap(v_shl<2>(known), twice)),
                                   v_max(v_sub_wrap(v_setall_s16(10), twice), v_sub_wrap(v_setall_s16(7), known)));
    const v_uint16x8 product = v_mul_wrap(sum, v_reinterpret_as_u16(factor));
    return v_mul_hi(v_add_wrap(product, v_setall_u16(6)), v_setall_u16(5462));
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

//! Depths of 4 features, as 32-bit numbers.
static inline v_uint16x8 depthOf(const v_uint32x4& features)
{
    return v_reinterpret_as_u16(v_shr<24>(features));
}

//! Means of blocks of 2x2 pixels, 4 blocks at a time.
static inline void halveRow(const Feature* upper, const Feature* lower, bool with_depth, Feature* to)
{
    v_uint32x4 a, b, c, d; // the pixels of a block
    v_load_deinterleave(reinterpret_cast<const unsigned*>(upper), a, b);
    v_load_deinterleave(reinterpret_cast<const unsigned*>(lower), c, d);
    const Halves ha(v_reinterpret_as_u8(a)), hb(v_reinterpret_as_u8(b));
    const Halves hc(v_reinterpret_as_u8(c)), hd(v_reinterpret_as_u8(d));
    const v_uint8x16 means = v_pack(quarter(ha.low, hb.low, hc.low, hd.low), quarter(ha.high, hb.high, hc.high, hd.high));
    if (!with_depth)
        return v_store(to->color, means);
    const v_uint16x8 depth = meanOfKnown(depthOf(a), depthOf(b), depthOf(c), depthOf(d));
    const v_uint32x4 colors = v_shr<8>(v_shl<8>(v_reinterpret_as_u32(means)));
    v_store(to->color, v_add_wrap(v_reinterpret_as_u8(colors), v_reinterpret_as_u8(v_shl<24>(v_reinterpret_as_u32(depth)))));
}

static void halveFeatures(const Padded<Feature>& features, bool with_depth, const Range& rows,
                          Padded<Feature>& halved)
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

//! Means of 2x2, of those that are known.
static void halveNormals(const Mat& normals, Mat& halved)
{
    halved.create((normals.rows + 1) / 2, (normals.cols + 1) / 2, CV_8UC2);
    parallel_for_(Range(0, halved.rows), [&](const Range& rows)
    {
        for (int y = rows.start; y < rows.end; y++)
        {
            const Normal* upper = normals.ptr<Normal>(2 * y);
            const Normal* lower = normals.ptr<Normal>(std::min(2 * y + 1, normals.rows - 1));
            Normal* to = halved.ptr<Normal>(y);
            for (int x = 0; x < halved.cols; x++)
            {
                const int left = 2 * x, right = std::min(2 * x + 1, normals.cols - 1);
                to[x].x = meanOfKnown(upper[left].x, upper[right].x, lower[left].x, lower[right].x);
                to[x].y = meanOfKnown(upper[left].y, upper[right].y, lower[left].y, lower[right].y);
            }
        }
    });
}

static void createLevels(const Frame& frame, int top, FeatureMap* levels)
{
    Size size = frame.color.size();
    Camera camera = frame.camera;
    for (int level = 0; level <= top; level++)
    {
        levels[level].create(size, Feature());
        levels[level].camera = camera;
        levels[level].normal_shift = level == 0;
        if (level <= 1 || frame.normals.empty())
            levels[level].normals = frame.normals;
        else
            halveNormals(levels[level - 1].normals, levels[level].normals);
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
        camera = camera.halved();
    }
}

void makePyramid(const Frame& frame, bool lab_input, int top, FeatureMap* levels)
{
    CV_TRACE_FUNCTION();
    const int BAND_HEIGHT = 16; // while its rows are in the cache
    CV_DbgAssert(BAND_HEIGHT % (1 << top) == 0); // a band has whole blocks on every level
    const Mat &color = frame.color, &depth = frame.depth;
    createLevels(frame, top, levels);
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
}

}}} // namespace
