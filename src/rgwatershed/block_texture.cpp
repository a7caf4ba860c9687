// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/block_texture.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { AT_ONCE = 4 }; // blocks
enum { SUMS = 8 };     // of a RegionTexture

namespace {

//! Two steps from corners to others in each of two blocks, channel by channel: without their signs, and with them.
struct Steps
{
    Steps(const v_uint16x8& from, const v_uint16x8& to, const v_uint16x8& more_from, const v_uint16x8& more_to)
    {
        const v_int16x8 first = v_reinterpret_as_s16(v_sub_wrap(to, from));
        const v_int16x8 second = v_reinterpret_as_s16(v_sub_wrap(more_to, more_from));
        sum = v_reinterpret_as_s16(v_add_wrap(v_abs(first), v_abs(second)));
        rise = v_add_wrap(first, second);
    }

    v_int16x8 sum, rise;
};

} // namespace

//! Half of the mean step of each of four blocks, in 1/16 of a level.
static v_int32x4 meanStep(const Steps& low, const Steps& high, const v_int16x8& weights)
{
    v_int32x4 first_halves, second_halves; // two sums of channels for each block
    splitPairs(v_dotprod(low.sum, weights), v_dotprod(high.sum, weights), first_halves, second_halves);
    // Two steps, with weights: a quarter of them is half of their mean.
    return v_shr<2 + FULL_WEIGHT_LOG2 - STEPS_PER_LEVEL_LOG2>(add(first_halves, second_halves));
}

//! The rises of two blocks, across and down in turns, and in the place of those of depth a word of steps.
static void storeSteps(const Steps& across, const Steps& down, const int* words, short* to)
{
    v_int16x8 first, second;
    v_zip(across.rise, down.rise, first, second);
    v_store(to, first);
    v_store(to + SUMS, second);
    memcpy(to + SUMS - 2, words, sizeof(*words));
    memcpy(to + 2 * SUMS - 2, words + 1, sizeof(*words));
}

//! Steps between the corners of the blocks of a row, as RegionTexture has them, but rises not weighted.
static void findSteps(const Feature* upper, const Feature* lower, const int* lefts, const int* rights, int n,
                      const v_int16x8& weights, short* steps)
{
    for (int x = 0; x < n; x += AT_ONCE, steps += AT_ONCE * SUMS)
    {
        const Halves a(gather(upper, lefts + x)), b(gather(upper, rights + x));
        const Halves c(gather(lower, lefts + x)), d(gather(lower, rights + x));
        const Steps across(a.low, b.low, c.low, d.low), more_across(a.high, b.high, c.high, d.high);
        const Steps down(a.low, c.low, b.low, d.low), more_down(a.high, c.high, b.high, d.high);
        int words[AT_ONCE];
        v_store(words, v_reinterpret_as_s32(makePairs(meanStep(across, more_across, weights),
                                                      meanStep(down, more_down, weights))));
        storeSteps(across, down, words, steps);
        storeSteps(more_across, more_down, words + 2, steps + 2 * SUMS);
    }
}

//! The steps of all blocks. The elements are those that blocks are made of.
static void findSteps(const Padded<Feature>& elements, const BlockGrid& grid, const v_int16x8& weights, Mat& steps)
{
    const int width = grid.columns.count, padded_width = int(alignSize(width, AT_ONCE));
    std::vector<int> lefts(padded_width, 0), rights(padded_width, 0);
    for (int x = 0; x < width; x++)
    {
        lefts[x] = grid.columns.start(x);
        rights[x] = grid.columns.start(x + 1) - 1;
    }
    steps.create(grid.rows.count, padded_width, CV_16SC(SUMS));
    forRows(Range(0, grid.rows.count), [&](int y)
    {
        findSteps(elements.row(grid.rows.start(y)), elements.row(grid.rows.start(y + 1) - 1), lefts.data(),
                  rights.data(), width, weights, steps.ptr<short>(y));
    });
}

static void addSteps(const Mat& steps, const Padded<int>& labels, std::vector<RegionTexture>& textures)
{
    const Size size = labels.size();
    for (int y = 0; y < size.height; y++)
    {
        const int* row = labels.row(y);
        const short* of_block = steps.ptr<short>(y);
        for (int x = 0; x < size.width; x++, of_block += SUMS)
            if (row[x] >= 0)
                textures[row[x]].add(v_cvt_f32(v_load_expand(of_block)), v_cvt_f32(v_load_expand(of_block + SUMS / 2)));
    }
}

//! @note The steps are found in parallel; what is left are few additions for each block.
void measureBlockTextures(const PyramidLevel* pyramid, const BlockLevels& levels, const RegionDistance& distance,
                          const Padded<int>& labels, int num_regions, Mat& steps,
                          std::vector<RegionTexture>& textures)
{
    CV_TRACE_FUNCTION();
    textures.clear();
    if (levels.top == 0)
        return;
    const BlockGrid grid = levels.grid(levels.top, pyramid[0].size());
    short w[3]; // corners of blocks of 3x3 are 2/3 of their side apart, those of 2x2 half of it
    for (int k = 0; k < 3; k++)
        w[k] = short(distance.weights[0][k] * grid.side / (2 * (grid.side - 1)));
    findSteps(pyramid[levels.top - 1], grid, v_int16x8(w[0], w[1], w[2], 0, w[0], w[1], w[2], 0), steps);
    textures.resize(num_regions);
    addSteps(steps, labels, textures);
    for (int i = 0; i < num_regions; i++)
        textures[i].scaleRises(w, 0.25f); // half of the mean of two
}

}}} // namespace
