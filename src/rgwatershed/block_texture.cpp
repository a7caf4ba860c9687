// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/block_texture.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { AT_ONCE = 4 }; // blocks

static v_uint8x16 load(const Feature* row, const int* places)
{
    unsigned words[AT_ONCE];
    for (int k = 0; k < AT_ONCE; k++)
        memcpy(&words[k], row + places[k], sizeof(Feature));
    return v_reinterpret_as_u8(v_uint32x4(words[0], words[1], words[2], words[3]));
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

//! Steps between the corners of the blocks of a row: across in the lower half of a word, down in the upper one.
static void findSteps(const Feature* upper, const Feature* lower, const int* lefts, const int* rights, int n,
                      const v_int16x8& weights, int* steps)
{
    for (int x = 0; x < n; x += AT_ONCE)
    {
        const v_uint8x16 a = load(upper, lefts + x), b = load(upper, rights + x);
        const v_uint8x16 c = load(lower, lefts + x), d = load(lower, rights + x);
        const v_int32x4 across = meanStep(v_absdiff(a, b), v_absdiff(c, d), weights);
        const v_int32x4 down = meanStep(v_absdiff(a, c), v_absdiff(b, d), weights);
        v_store(steps + x, add(across, v_shl<16>(down)));
    }
}

//! @note The steps are found in parallel; what is left are few additions for each block.
void measureBlockTextures(const FeatureMap& elements, const BlockGrid& grid, const RegionDistance& distance,
                          const Padded<int>& labels, int num_regions, Mat& steps,
                          std::vector<RegionTexture>& textures)
{
    CV_TRACE_FUNCTION();
    const Size size = labels.size();
    const int padded_width = int(alignSize(size.width, AT_ONCE));
    const short* w = distance.weights[0];
    const v_int16x8 weights(w[0], w[1], w[2], 0, w[0], w[1], w[2], 0);
    std::vector<int> lefts(padded_width, 0), rights(padded_width, 0);
    for (int x = 0; x < size.width; x++)
    {
        lefts[x] = grid.columns.start(x);
        rights[x] = grid.columns.start(x + 1) - 1;
    }
    steps.create(size.height, padded_width, CV_32SC1);
    parallel_for_(Range(0, size.height), [&](const Range& rows)
    {
        for (int y = rows.start; y < rows.end; y++)
            findSteps(elements.row(grid.rows.start(y)), elements.row(grid.rows.start(y + 1) - 1), lefts.data(),
                      rights.data(), size.width, weights, steps.ptr<int>(y));
    });
    textures.assign(num_regions, RegionTexture());
    for (int y = 0; y < size.height; y++)
    {
        const int *row = labels.row(y), *of_row = steps.ptr<int>(y);
        for (int x = 0; x < size.width; x++)
            if (row[x] >= 0)
            {
                textures[row[x]].across += of_row[x] & 0xFFFF;
                textures[row[x]].down += of_row[x] >> 16;
            }
    }
}

}}} // namespace
