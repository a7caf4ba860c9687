// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/edge_blocks.hpp"
#include "rgwatershed/region_labels.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { GROUP = 4 }; // blocks at once, so a row has as many, or none of it takes sides

namespace {

//! The steps from four colours to four others.
struct ColorSteps
{
    ColorSteps(const v_uint8x16& from, const v_uint8x16& to)
    {
        const Halves f(from), t(to);
        low = v_reinterpret_as_s16(v_sub_wrap(t.low, f.low));
        high = v_reinterpret_as_s16(v_sub_wrap(t.high, f.high));
    }

    //! Their products with others, weighted as the flood weighs colours.
    v_float32x4 times(const ColorSteps& others) const
    {
        const short L = FLOOD_LIGHTNESS / WEIGHT_STEP, C = FLOOD_CHROMA / WEIGHT_STEP;
        const v_int16x8 weights(L, C, C, 0, L, C, C, 0);
        v_int32x4 first, second;
        splitPairs(v_dotprod(v_mul_wrap(low, weights), others.low), v_dotprod(v_mul_wrap(high, weights), others.high),
                   first, second);
        return v_cvt_f32(add(first, second));
    }

    enum { WEIGHT_STEP = 16 }; // products of weights with steps fit into 16 bits
    v_int16x8 low, high;
};

//! Four blocks, each between two neighbours.
struct Crossings
{
    //! Asks whether an edge goes through a block: its neighbours, which are not OUTSIDE, differ much, and its colour
    //! lies on the straight line between theirs.
    Crossings(const Feature* blocks, const int* labels, int step)
    {
        const int LARGE = EDGE_STEP * EDGE_STEP * (FULL_WEIGHT / ColorSteps::WEIGHT_STEP);
        const v_uint32x4 before = v_reinterpret_as_u32(v_load(blocks[-step].color));
        const v_uint32x4 after = v_reinterpret_as_u32(v_load(blocks[step].color));
        const v_uint8x16 first = v_reinterpret_as_u8(v_min(before, after)); // the same in a mirrored image
        const v_uint8x16 second = v_reinterpret_as_u8(v_max(before, after));
        const ColorSteps whole(first, second), part(first, v_load(blocks[0].color));
        const v_float32x4 length = whole.times(whole), along = whole.times(part);
        const v_float32x4 aside = subtract(multiply(length, part.times(part)), multiply(along, along));
        const v_float32x4 most_aside = multiply(multiply(length, length), v_setall_f32(EDGE_ASIDE * EDGE_ASIDE));
        const v_float32x4 in_between = v_min(along, subtract(length, along));
        const v_float32x4 least = v_min(v_min(subtract(length, v_setall_f32(float(LARGE))), in_between),
                                        subtract(most_aside, aside));
        const v_int32x4 lowest_label = v_min(v_load(labels - step), v_load(labels + step));
        const v_int32x4 crossed = bitAnd(isPositive(v_reinterpret_as_s32(least)),
                                         equal(lowest_label, v_setall_s32(UNSEEN)));
        strength = bitAnd(crossed, v_reinterpret_as_s32(length));
        side = v_select(isPositive(v_reinterpret_as_s32(subtract(length, add(along, along)))),
                        v_reinterpret_as_s32(first), v_reinterpret_as_s32(second));
    }

    v_int32x4 strength; //!< the squared difference of the neighbours, bits of a float, or 0
    v_int32x4 side;     //!< the feature of the one that the block is more like
};

} // namespace

//! Whether neighbours of one of four blocks may differ enough: by this much in one channel, at least.
static inline bool mayBeCrossed(const Feature* blocks, int step)
{
    const int LEAST = EDGE_STEP * 5 / 8, HIGHEST_BIT = 128; // three weights, of which one is half, make a root of 1.6
    const v_uint8x16 beside = v_absdiff(v_load(blocks[-1].color), v_load(blocks[1].color));
    const v_uint8x16 upright = v_absdiff(v_load(blocks[-step].color), v_load(blocks[step].color));
    return v_check_any(add(v_max(beside, upright), v_setall_u8(uchar(HIGHEST_BIT - LEAST))));
}

static void exchangeColors(EdgeBlock& block, Padded<Feature>& blocks)
{
    for (int k = 0; k < 3; k++)
        std::swap(blocks.data()[block.at].color[k], block.other.color[k]);
}

//! The blocks of a row through which an edge goes, by rows or by columns: where it is stronger.
static void findInRow(const Padded<Feature>& blocks, const Padded<int>& labels, int y, std::vector<EdgeBlock>& found)
{
    const int width = blocks.size().width, step = blocks.step();
    const Feature* const row = blocks.row(y);
    const int* const labels_of_row = labels.row(y);
    for (int x = 0; x < width; x += GROUP)
    {
        const int start = std::min(x, width - GROUP);
        const Feature* const group = row + start;
        const int* const of_group = labels_of_row + start;
        if (!mayBeCrossed(group, step))
            continue;
        const Crossings beside(group, of_group, 1), upright(group, of_group, step);
        const v_int32x4 strength = v_max(beside.strength, upright.strength);
        if (!v_check_any(isPositive(strength)))
            continue;
        int strengths[GROUP];
        Feature sides[GROUP];
        v_store(strengths, strength);
        v_store(sides[0].color, v_reinterpret_as_u8(v_select(isPositive(subtract(upright.strength, beside.strength)),
                                                             upright.side, beside.side)));
        for (int i = x - start; i < GROUP; i++)
            if (strengths[i] != 0 && of_group[i] == UNSEEN)
                found.push_back({ blocks.index(Point(start + i, y)), sides[i] });
    }
}

void EdgeBlocks::takeSides(const Padded<int>& labels, Padded<Feature>& blocks)
{
    CV_TRACE_FUNCTION();
    const int ROWS = 16; // of a chunk: enough to be worth a task
    const RowChunks chunks(blocks.size().width < GROUP ? 0 : blocks.size().height, ROWS);
    found_.resize(chunks.size());
    chunks.forAll([&](int k, const Range& rows)
    {
        found_[k].clear();
        for (int y = rows.start; y < rows.end; y++)
            findInRow(blocks, labels, y, found_[k]);
    });
    for (std::vector<EdgeBlock>& chunk : found_)
        for (EdgeBlock& block : chunk)
            exchangeColors(block, blocks);
}

void EdgeBlocks::takeBack(const Padded<int>& labels, Padded<Feature>& blocks, Regions& regions)
{
    for (std::vector<EdgeBlock>& chunk : found_)
        for (EdgeBlock& block : chunk)
        {
            const Feature& feature = blocks.data()[block.at];
            RegionSum& sum = regions.sums[labels.data()[block.at]]; // all are in one: each component has a marker
            sum.add(feature, -1);
            exchangeColors(block, blocks);
            sum.add(feature);
        }
    regions.update();
}

}}} // namespace
