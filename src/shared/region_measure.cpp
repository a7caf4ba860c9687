// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/region_measure.hpp"
#include "shared/label_sums.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! Colour and depth of some pixels, as a region sums them up, and their texture.
struct ColorSum
{
    uint64 channels[4];
    int64 across, down, rises[3][2]; // of the texture, rises in whole levels
    int area, depth_area;

    void add(const ColorSum& s)
    {
        for (int k = 0; k < 4; k++)
            channels[k] += s.channels[k];
        across += s.across;
        down += s.down;
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 2; i++)
                rises[k][i] += s.rises[k][i];
        area += s.area;
        depth_area += s.depth_area;
    }

    RegionSum toRegion() const
    {
        return { { int64(channels[0]), int64(channels[1]), int64(channels[2]) }, int64(channels[3]), area, depth_area };
    }

    //! weights are those of the channels, in 1/256.
    RegionTexture toTexture(const short* weights) const
    {
        RegionTexture texture = { {}, float(across), float(down), {} };
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 2; i++)
                texture.rises[k][i] = float(rises[k][i]);
        texture.scaleRises(weights, 1);
        return texture;
    }
};

//! Pixels of a row, and those below them.
struct PixelRows
{
    const Feature *features, *below;
    const int* labels_below;

    void skip(int count)
    {
        features += count;
        below += count;
        labels_below += count;
    }
};

inline v_uint8x16 loadFour(const Feature* features) { return v_load(reinterpret_cast<const uchar*>(features)); }

inline void addTo(uint64* sums, const v_uint64x2& values) { v_store(sums, add(v_load(sums), values)); }

//! Sums of the channels of a few features, or of differences between them, four at a time.
class ChannelSums
{
public:
    ChannelSums() : sums_(v_setzero_u16()) {}

    void add(const v_uint8x16& four)
    {
        v_uint16x8 first, second;
        v_expand(four, first, second);
        sums_ = v_add_wrap(sums_, v_add_wrap(first, second));
    }

    void addTo(uint64* channels) const
    {
        v_uint32x4 even, odd;
        v_expand(sums_, even, odd);
        v_uint64x2 first, second;
        v_expand(gws::add(even, odd), first, second);
        gws::addTo(channels, first);
        gws::addTo(channels + 2, second);
    }

    void add(const ChannelSums& others) { sums_ = v_add_wrap(sums_, others.sums_); }

    //! How much the sums are larger than those of others, as rises down.
    void addRisesTo(const ChannelSums& others, int64 (*rises)[2]) const
    {
        v_int32x4 even, odd;
        v_expand(v_reinterpret_as_s16(v_sub_wrap(sums_, others.sums_)), even, odd);
        int of_channels[4];
        v_store(of_channels, gws::add(even, odd));
        for (int k = 0; k < 3; k++)
            rises[k][1] += of_channels[k];
    }

    int weighted(const v_int16x8& weights) const
    {
        return v_reduce_sum(v_dotprod(v_reinterpret_as_s16(sums_), weights));
    }

private:
    v_uint16x8 sums_;
};

enum { AT_ONCE = 12 };

//! As many of AT_ONCE words are all bits as are asked for, the others none.
inline const int* firstWords(int count)
{
    static const int MASKS[2 * AT_ONCE] = { -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1 };
    return MASKS + AT_ONCE - count;
}

inline v_uint8x16 loadMask(const int* words) { return v_reinterpret_as_u8(v_load(words)); }

//! Adds the first ones of some pixels.
inline void addColors(const Feature* features, int count, ColorSum& to)
{
    const int* mask = firstWords(count);
    ChannelSums sums;
    for (int k = 0; k < AT_ONCE; k += 4)
        sums.add(bitAnd(loadFour(features + k), loadMask(mask + k)));
    sums.addTo(to.channels);
}

//! Adds the steps to the next pixels of the row, where there are so many of the same label, and to those below.
inline void addSteps(const PixelRows& pixels, int label, int count, int count_across, const v_int16x8& weights,
                     ColorSum& to)
{
    const int *mask = firstWords(count), *mask_across = firstWords(count_across);
    const v_int32x4 own = v_setall_s32(label);
    ChannelSums across, rises, falls;
    for (int k = 0; k < AT_ONCE; k += 4)
    {
        const v_uint8x16 four = loadFour(pixels.features + k);
        const v_uint8x16 same = v_reinterpret_as_u8(equal(v_load(pixels.labels_below + k), own));
        across.add(bitAnd(v_absdiff(four, loadFour(pixels.features + k + 1)), loadMask(mask_across + k)));
        const v_uint8x16 counted = bitAnd(same, loadMask(mask + k)), below = loadFour(pixels.below + k);
        rises.add(bitAnd(subtract(below, four), counted)); // saturated: where it falls, nothing
        falls.add(bitAnd(subtract(four, below), counted));
    }
    rises.addRisesTo(falls, to.rises);
    rises.add(falls);
    to.across += across.weighted(weights);
    to.down += rises.weighted(weights);
}

//! A few pixels at the end of a row, with room behind them.
template <bool WITH_TEXTURE> struct LastPixels
{
    Feature features[AT_ONCE + 1], below[AT_ONCE + 1];
    int labels_below[AT_ONCE];

    LastPixels(const PixelRows& from, int count) : features()
    {
        std::copy_n(from.features, count, features);
        if (!WITH_TEXTURE)
            return;
        std::fill_n(below, AT_ONCE + 1, Feature());
        std::fill_n(labels_below, int(AT_ONCE), 0);
        std::copy_n(from.below, count, below);
        std::copy_n(from.labels_below, count, labels_below);
    }
    PixelRows rows() const { return { features, below, labels_below }; }
};

template <bool WITH_TEXTURE>
inline void addPixels(const PixelRows& pixels, int label, int count, int count_across, const v_int16x8& weights,
                      ColorSum& to)
{
    addColors(pixels.features, count, to);
    if (WITH_TEXTURE)
        addSteps(pixels, label, count, count_across, weights, to);
}

//! Adds a run of pixels of one label. Most are short: so many are read at once, with those behind the end masked, which
//! takes less time than a branch that is not foreseen. `room` pixels may be read.
template <bool WITH_TEXTURE>
void addRun(PixelRows pixels, int label, int count, int room, const v_int16x8& weights, ColorSum& to)
{
    if (WITH_TEXTURE)
        for (int k = 0; k < 3; k++)
            to.rises[k][0] += pixels.features[count - 1].color[k] - pixels.features[0].color[k];
    for (; count > 0; count -= AT_ONCE, room -= AT_ONCE, pixels.skip(AT_ONCE))
    {
        const int now = std::min<int>(count, AT_ONCE), now_across = std::min<int>(count - 1, AT_ONCE);
        if (room >= AT_ONCE)
            addPixels<WITH_TEXTURE>(pixels, label, now, now_across, weights, to);
        else
            addPixels<WITH_TEXTURE>(LastPixels<WITH_TEXTURE>(pixels, room).rows(), label, now, now_across, weights, to);
    }
}

int countDepths(const Feature* features, int count)
{
    int with_depth = 0;
    for (int i = 0; i < count; i++)
        with_depth += features[i].depth != 0;
    return with_depth;
}

//! Adds up the runs of a row, with their textures or without.
class RowAdder
{
public:
    RowAdder(const FeatureMap& features, const Mat& labels, int y, bool with_texture, const v_int16x8& weights)
        : cols_(labels.cols), with_texture_(with_texture), weights_(weights), labels_(labels.ptr<int>(y))
    {
        const int below = y + 1 < labels.rows ? y + 1 : y; // no steps down from the last row
        pixels_ = { features.row(y), features.row(below), labels.ptr<int>(below) };
    }

    void operator()(ColorSum& sum, const Range& xs) const
    {
        PixelRows pixels = pixels_;
        pixels.skip(xs.start);
        const uint64 depth = sum.channels[3];
        const int room = cols_ - xs.start;
        if (with_texture_)
            addRun<true>(pixels, labels_[xs.start], xs.size(), room, weights_, sum);
        else
            addRun<false>(pixels, 0, xs.size(), room, weights_, sum);
        sum.area += xs.size();
        if (sum.channels[3] != depth)
            sum.depth_area += countDepths(pixels.features, xs.size());
    }

private:
    const int cols_;
    const bool with_texture_;
    const v_int16x8 weights_; // of steps
    const int* const labels_;
    PixelRows pixels_;
};

//! Colours and depths of regions, and their textures if they are asked for: of every second row, which is enough. Even
//! and odd ones take turns, so that rows that alternate are no slope.
void sumColors(const FeatureMap& features, const Mat& labels, bool with_textures, const v_int16x8& weights,
               std::vector<ColorSum>& sums)
{
    sumByLabel(labels, [&](int y)
    {
        return RowAdder(features, labels, y, with_textures && ((y ^ (y >> 2)) & 1) == 0, weights);
    }, sums);
}

void setSums(const FeatureMap& features, const Mat& labels, const std::vector<ColorSum>& sums, bool few_depths_count,
             Regions& regions)
{
    regions.surfaces.present = false;
    regions.resize(regions.size());
    for (int i = 0; i < regions.size(); i++)
        regions.sums[i] = sums[i].toRegion();
    if (features.withNormals())
        measureSurfaces(features, labels, regions, few_depths_count);
    else
        regions.update(few_depths_count);
}

} // namespace

void measureRegions(const FeatureMap& features, const Mat& labels, const RegionDistance& distance, Regions& regions,
                    std::vector<RegionTexture>& textures)
{
    CV_TRACE_FUNCTION();
    short weights[8] = {}; // of two features, for steps
    for (int k = 0; k < 8; k++)
        weights[k] = short(distance.weights[0][k % 4] * STEPS_PER_LEVEL / FULL_WEIGHT);
    std::vector<ColorSum> sums(regions.size());
    sumColors(features, labels, true, v_load(weights), sums);
    setSums(features, labels, sums, true, regions);
    textures.resize(regions.size());
    for (int i = 0; i < regions.size(); i++)
        textures[i] = sums[i].toTexture(distance.weights[0]);
}

void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    std::vector<ColorSum> sums(regions.size());
    sumColors(features, labels, false, v_setzero_s16(), sums);
    setSums(features, labels, sums, false, regions);
}

//! Sums of places and normals fit into 32 bits in a row, whose places are those of 16 bits.
static void addRun(const FeatureMap& features, int y, const Range& xs, SurfaceSum& to)
{
    const Feature* row = features.row(y);
    const Normal* normals = features.normalsOfRow(y);
    int normal_x = 0, normal_y = 0, normal_area = 0, x_sum = 0, count = 0;
    for (int x = xs.start; x < xs.end; x++)
    {
        const Normal& n = normals[x >> features.normal_shift];
        const int has_depth = row[x].depth != 0;
        normal_x += n.x;
        normal_y += n.y;
        normal_area += n.known();
        x_sum += x & -has_depth;
        count += has_depth;
    }
    to.normal_x += normal_x;
    to.normal_y += normal_y;
    to.normal_area += normal_area;
    to.x += x_sum;
    to.y += int64(count) * y;
}

void measureSurfaces(const FeatureMap& features, const Mat& labels, Regions& regions, bool few_depths_count)
{
    CV_TRACE_FUNCTION();
    regions.surfaces.start(features.camera, regions.size());
    sumByLabel(labels, [&](int y)
    {
        return [&features, y](SurfaceSum& sum, const Range& xs) { addRun(features, y, xs, sum); };
    }, regions.surfaces.sums);
    regions.update(few_depths_count);
}

}}} // namespace
