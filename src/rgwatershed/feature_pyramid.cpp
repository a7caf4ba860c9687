// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/feature_pyramid.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! Mean of the values that are not 0.
static uchar meanOfKnown(int a, int b, int c, int d)
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
        to[i / 2].depth = meanOfKnown(upper[i].depth, upper[i + 1].depth, lower[i].depth, lower[i + 1].depth);
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

//! All bits for each of 8 features with depth, as 16 bits.
static v_uint16x8 maskOfDepth(const Feature* features)
{
    const v_uint32x4 ones = v_setall_u32(1);
    const unsigned* words = reinterpret_cast<const unsigned*>(features);
    const v_uint16x8 has_depth = v_pack(v_min(v_shr<24>(v_load(words)), ones), v_min(v_shr<24>(v_load(words + 4)), ones));
    return v_sub_wrap(v_setzero_u16(), has_depth);
}

//! Pixels have the normal of their block if they have depth.
static void spreadNormals(const Mat& blocks, const Range& rows, FeatureMap& pixels)
{
    for (int y = rows.start; y < rows.end; y++)
    {
        const Normal* from = blocks.ptr<Normal>(y / 2);
        const Feature* features = pixels.row(y);
        Normal* to = pixels.normals.row(y);
        int x = 0;
        for (; x <= pixels.size().width - 16; x += 16)
        {
            v_uint16x8 left, right;
            const v_uint16x8 normals = v_load(reinterpret_cast<const ushort*>(from + x / 2));
            v_zip(normals, normals, left, right);
            v_store(reinterpret_cast<ushort*>(to + x), v_min(left, maskOfDepth(features + x)));
            v_store(reinterpret_cast<ushort*>(to + x + 8), v_min(right, maskOfDepth(features + x + 8)));
        }
        for (; x < pixels.size().width; x++)
            to[x] = features[x].depth ? from[x / 2] : Normal();
    }
}

//! Means of 2x2, of those that are known.
static void halveNormals(const Padded<Normal>& normals, const Range& rows, Padded<Normal>& halved)
{
    const Size size = normals.size();
    for (int y = rows.start; y < rows.end; y++)
    {
        const Normal* upper = normals.row(2 * y);
        const Normal* lower = normals.row(std::min(2 * y + 1, size.height - 1));
        Normal* to = halved.row(y);
        for (int x = 0; x < halved.size().width; x++)
        {
            const int left = 2 * x, right = std::min(2 * x + 1, size.width - 1);
            to[x].x = meanOfKnown(upper[left].x, upper[right].x, lower[left].x, lower[right].x);
            to[x].y = meanOfKnown(upper[left].y, upper[right].y, lower[left].y, lower[right].y);
        }
    }
}

//! Normals of some rows of a level, when its features are there.
static void makeNormals(const Mat& blocks, int level, const Range& rows, FeatureMap* levels)
{
    if (level == 0)
        spreadNormals(blocks, rows, levels[0]);
    else if (level == 1)
        for (int y = rows.start; y < rows.end; y++)
            std::copy(blocks.ptr<Normal>(y), blocks.ptr<Normal>(y) + blocks.cols, levels[1].normals.row(y));
    else
        halveNormals(levels[level - 1].normals, rows, levels[level].normals);
}

static void createLevels(const Frame& frame, int top, FeatureMap* levels)
{
    Size size = frame.color.size();
    Camera camera = frame.camera;
    for (int level = 0; level <= top; level++)
    {
        levels[level].create(size, Feature());
        levels[level].with_normals = !frame.normals.empty();
        levels[level].camera = camera;
        if (!frame.normals.empty())
            levels[level].normals.create(size, Normal());
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
                if (!frame.normals.empty())
                    makeNormals(frame.normals, level, rows, levels);
            }
    });
}

}}} // namespace
