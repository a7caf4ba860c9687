// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/block_texture.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { AT_ONCE = 4 }; // blocks

static v_uint8x16 load(const Feature* row, const int* places)
{
    return loadFour(row[places[0]], row[places[1]], row[places[2]], row[places[3]]);
}

//! Half of the mean of two steps of each of four blocks, in 1/16 of a level.
static v_int32x4 meanStep(const v_uint8x16& first, const v_uint8x16& second, const v_int16x8& weights)
{
    v_uint16x8 low, high, more_low, more_high;
    v_expand(first, low, high);
    v_expand(second, more_low, more_high);
    const v_int32x4 a = v_dotprod(v_reinterpret_as_s16(v_add_wrap(low, more_low)), weights);
    const v_int32x4 b = v_dotprod(v_reinterpret_as_s16(v_add_wrap(high, more_high)), weights);
    v_int32x4 first_halves, second_halves; // two sums of channels for each block
    splitPairs(a, b, first_halves, second_halves);
    return v_shr<6>(add(first_halves, second_halves)); // of 2 * FULL_WEIGHT for a level
}

//! Half of the mean of two rises of lightness of each of four blocks, in 1/256 of a level.
static v_int32x4 meanRise(const v_uint8x16& from, const v_uint8x16& to, const v_uint8x16& more_from,
                          const v_uint8x16& more_to, const v_int16x8& weight)
{
    const v_uint32x4 lightness = v_setall_u32(255);
    const auto of = [&](const v_uint8x16& features)
    {
        return v_reinterpret_as_s32(bitAnd(v_reinterpret_as_u32(features), lightness));
    };
    const v_int32x4 sum = subtract(add(of(to), of(more_to)), add(of(from), of(more_from)));
    return v_shr<2>(v_dotprod(v_reinterpret_as_s16(sum), weight));
}

//! Steps between the corners of the blocks of a row, four for each: across, down, and the same of lightness with signs.
static void findSteps(const Feature* upper, const Feature* lower, const int* lefts, const int* rights, int n,
                      const v_int16x8& weights, const v_int16x8& of_lightness, short* steps)
{
    for (int x = 0; x < n; x += AT_ONCE)
    {
        const v_uint8x16 a = load(upper, lefts + x), b = load(upper, rights + x);
        const v_uint8x16 c = load(lower, lefts + x), d = load(lower, rights + x);
        const v_int32x4 across = meanStep(v_absdiff(a, b), v_absdiff(c, d), weights);
        const v_int32x4 down = meanStep(v_absdiff(a, c), v_absdiff(b, d), weights);
        const v_int32x4 rise_across = meanRise(a, b, c, d, of_lightness);
        const v_int32x4 rise_down = meanRise(a, c, b, d, of_lightness);
        v_int32x4 first, second;
        v_zip(v_reinterpret_as_s32(makePairs(across, down)), v_reinterpret_as_s32(makePairs(rise_across, rise_down)),
              first, second);
        v_store(steps + 4 * x, v_reinterpret_as_s16(first));
        v_store(steps + 4 * x + 8, v_reinterpret_as_s16(second));
    }
}

//! @note The steps are found in parallel; what is left are few additions for each block.
void measureBlockTextures(const FeatureMap* pyramid, const BlockLevels& levels, const RegionDistance& distance,
                          const Padded<int>& labels, int num_regions, Mat& steps,
                          std::vector<RegionTexture>& textures)
{
    CV_TRACE_FUNCTION();
    textures.clear();
    if (levels.top == 0)
        return;
    const FeatureMap& elements = pyramid[levels.top - 1];
    const BlockGrid grid = levels.grid(levels.top, pyramid[0].size());
    const Size size = labels.size();
    const int padded_width = int(alignSize(size.width, AT_ONCE));
    short w[3]; // corners of blocks of 3x3 are 2/3 of their side apart, those of 2x2 half of it
    for (int k = 0; k < 3; k++)
        w[k] = short(distance.weights[0][k] * grid.side / (2 * (grid.side - 1)));
    const v_int16x8 weights(w[0], w[1], w[2], 0, w[0], w[1], w[2], 0);
    const v_int16x8 of_lightness(w[0], 0, w[0], 0, w[0], 0, w[0], 0);
    std::vector<int> lefts(padded_width, 0), rights(padded_width, 0);
    for (int x = 0; x < size.width; x++)
    {
        lefts[x] = grid.columns.start(x);
        rights[x] = grid.columns.start(x + 1) - 1;
    }
    steps.create(size.height, padded_width, CV_16SC4);
    parallel_for_(Range(0, size.height), [&](const Range& rows)
    {
        for (int y = rows.start; y < rows.end; y++)
            findSteps(elements.row(grid.rows.start(y)), elements.row(grid.rows.start(y + 1) - 1), lefts.data(),
                      rights.data(), size.width, weights, of_lightness, steps.ptr<short>(y));
    });
    textures.resize(num_regions);
    for (int y = 0; y < size.height; y++)
    {
        const int* row = labels.row(y);
        const short* of_block = steps.ptr<short>(y);
        for (int x = 0; x < size.width; x++, of_block += 4)
            if (row[x] >= 0)
                textures[row[x]].add(v_cvt_f32(v_load_expand(of_block)));
    }
}

}}} // namespace
