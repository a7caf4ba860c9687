// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/feature_pyramid.hpp"
#include "rgwatershed/block_normals.hpp"
#include "rgwatershed/depth_step.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Depth of a block of side * side elements: the mean of those that are valid. Where a step, more than `step` levels,
//! goes through the block, that of the side which has more of it, or the near one. A mean of both would be a depth that
//! is nowhere, and regions of it would lie astride. `lost` becomes what the sum over the elements has more than that of
//! as many of this depth.
static uchar depthOfBlock(const Feature* const* rows, int side, int x, int step, int& lost)
{
    int sum = 0, count = 0, low = 255, high = 0;
    for (int i = 0; i < side * side; i++)
    {
        const int depth = rows[i / side][x + i % side].depth;
        sum += depth;
        count += depth != 0;
        low = depth != 0 ? std::min(low, depth) : low;
        high = std::max(high, depth);
    }
    lost = 0;
    if (high - low <= step)
        return count > 0 ? uchar((sum + count / 2) / count) : uchar(0);
    int sums[2] = {}, counts[2] = {}; // of the far and of the near side
    for (int i = 0; i < side * side; i++)
    {
        const int depth = rows[i / side][x + i % side].depth, is_near = 2 * depth > low + high;
        sums[is_near] += depth;
        counts[is_near] += depth != 0;
    }
    const int larger = counts[1] >= counts[0], mean = (sums[larger] + counts[larger] / 2) / counts[larger];
    lost = sum - count * mean;
    return uchar(mean);
}

//! 12 over the number of elements that count: all four for colours, those with depth for depth. It is the largest of
//! three lines over the numbers 1 to 4.
static inline v_uint8x16 twelfths(const v_uint8x16& a, const v_uint8x16& b, const v_uint8x16& c, const v_uint8x16& d)
{
    const v_uint8x16 one = v_reinterpret_as_u8(v_setall_u32(1u << 24)); // for depth, the last byte of a feature
    const v_uint8x16 known = v_add_wrap(v_add_wrap(v_min(a, one), v_min(b, one)),
                                        v_add_wrap(v_min(c, one), v_min(d, one)));
    const v_uint8x16 number = v_add_wrap(known, v_reinterpret_as_u8(v_setall_u32(0x040404)));
    const v_uint8x16 twice = v_add_wrap(number, number), six_times = v_add_wrap(v_add_wrap(twice, twice), twice);
    return v_max(subtract(v_setall_u8(18), six_times),
                 v_max(subtract(v_setall_u8(10), twice), subtract(v_setall_u8(7), number)));
}

//! Sums in twelfths, divided by 12 and rounded.
static inline v_int16x8 divideByTwelve(const v_uint16x8& sums, const v_uint16x8& factors)
{
    const int TWELFTH = 5462; // in 1/65536: rounded up, which makes the quotients of all sums right
    const v_uint16x8 rounded = v_add_wrap(v_mul_wrap(sums, factors), v_setall_u16(6));
    return v_reinterpret_as_s16(v_mul_hi(rounded, v_setall_u16(TWELFTH)));
}

static inline v_int16x8 divideByFour(const v_uint16x8& sums)
{
    return v_reinterpret_as_s16(v_shr<2>(v_add_wrap(sums, v_setall_u16(2))));
}

//! Whether a step of more levels goes through one of four blocks. What is missing, 0, is above all others less 1.
static inline bool haveStep(const v_uint8x16& a, const v_uint8x16& b, const v_uint8x16& c, const v_uint8x16& d,
                            int step)
{
    const v_uint8x16 one = v_setall_u8(1), high = v_max(v_max(a, b), v_max(c, d));
    const v_uint8x16 low = v_min(v_min(v_sub_wrap(a, one), v_sub_wrap(b, one)),
                                 v_min(v_sub_wrap(c, one), v_sub_wrap(d, one)));
    const v_uint8x16 steps = subtract(subtract(high, one), low);
    return v_reduce_max(v_shr<24>(v_reinterpret_as_u32(steps))) > unsigned(step);
}

//! The sums of the channels over two blocks of 2x2 elements.
static inline v_uint16x8 sumOfTwo(const Feature* upper, const Feature* lower)
{
    const Halves above(v_load(upper->color)), below(v_load(lower->color));
    const v_uint16x8 first = v_add_wrap(above.low, below.low), second = v_add_wrap(above.high, below.high);
    return v_add_wrap(v_combine_low(first, second), v_combine_high(first, second));
}

//! Means of blocks of 2x2 elements, 4 blocks at a time. Returns whether a step of depth goes through one of them; none
//! is looked for without depth, where it is 0.
static inline bool halveRow(const Feature* upper, const Feature* lower, int step, Feature* to)
{
    const v_uint16x8 low = sumOfTwo(upper, lower), high = sumOfTwo(upper + 4, lower + 4);
    if (step == 0)
    {
        v_store(to->color, v_pack_u(divideByFour(low), divideByFour(high)));
        return false;
    }
    v_uint32x4 first, second, third, fourth;
    v_load_deinterleave(reinterpret_cast<const unsigned*>(upper), first, second);
    v_load_deinterleave(reinterpret_cast<const unsigned*>(lower), third, fourth);
    const v_uint8x16 a = v_reinterpret_as_u8(first), b = v_reinterpret_as_u8(second);
    const v_uint8x16 c = v_reinterpret_as_u8(third), d = v_reinterpret_as_u8(fourth);
    const Halves factors(twelfths(a, b, c, d));
    v_store(to->color, v_pack_u(divideByTwelve(low, factors.low), divideByTwelve(high, factors.high)));
    return haveStep(a, b, c, d, step);
}

//! The elements of a row as if all blocks were whole: the last one of the short block stands for those that it misses.
//! Returns the row itself if there is none.
static const Feature* fillBlocks(const Feature* row, const BlockAxis& blocks, AutoBuffer<Feature>& filled)
{
    if (blocks.missing == 0)
        return row;
    const int end = blocks.start(blocks.short_block + 1), length = blocks.start(blocks.count);
    filled.allocate(blocks.side * blocks.count);
    std::copy_n(row, end, filled.data());
    std::fill_n(filled.data() + end, blocks.missing, row[end - 1]);
    std::copy_n(row + end, length - end, filled.data() + end + blocks.missing);
    return filled.data();
}

namespace {

//! The rows of elements of a row of blocks.
class RowsOfBlocks
{
public:
    RowsOfBlocks(const Padded<Feature>& features, const BlockGrid& grid) : features_(features), grid_(grid) {}

    //! Row i of those of row y of blocks. It is valid until the same i is asked for again.
    const Feature* row(int y, int i)
    {
        const int last = grid_.rows.start(y + 1) - 1;
        return fillBlocks(features_.row(std::min(grid_.rows.start(y) + i, last)), grid_.columns, filled_[i]);
    }

private:
    const Padded<Feature>& features_;
    const BlockGrid& grid_;
    AutoBuffer<Feature> filled_[3];
};

} // namespace

//! Takes the depths of some blocks one by one. Elements of theirs begin with the rows.
static void takeDepths(const Feature* const* rows, int side, const Range& blocks, int y, int step, Feature* to,
                       std::vector<LostDepth>& lost_depths)
{
    for (int x = blocks.start; x < blocks.end; x++)
    {
        LostDepth lost = { Point(x, y), 0 };
        to[x].depth = depthOfBlock(rows, side, side * x, step, lost.sum);
        if (lost.sum != 0)
            lost_depths.push_back(lost);
    }
}

static void halveFeatures(const Padded<Feature>& features, const BlockGrid& grid, int step, const Range& rows,
                          Padded<Feature>& halved, std::vector<LostDepth>& lost_depths)
{
    const int width = halved.size().width;
    RowsOfBlocks elements(features, grid);
    for (int y = rows.start; y < rows.end; y++)
    {
        const Feature* const from[2] = { elements.row(y, 0), elements.row(y, 1) };
        Feature* to = halved.row(y);
        int x = 0;
        for (; x <= width - 4; x += 4)
            if (halveRow(from[0] + 2 * x, from[1] + 2 * x, step, to + x))
                takeDepths(from, 2, Range(x, x + 4), y, step, to, lost_depths);
        if (x == width)
            continue;
        Feature last_upper[8], last_lower[8], last[4];
        for (int i = 0; i < 8; i++)
        {
            const int element = std::min(2 * x + i, 2 * width - 1);
            last_upper[i] = from[0][element];
            last_lower[i] = from[1][element];
        }
        const bool have_step = halveRow(last_upper, last_lower, step, last);
        std::copy(last, last + (width - x), to + x);
        if (have_step)
            takeDepths(from, 2, Range(x, width), y, step, to, lost_depths);
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

static void thirdFeatures(const Padded<Feature>& features, const BlockGrid& grid, int step, const Range& rows,
                          Padded<Feature>& thirds, std::vector<LostDepth>& lost_depths)
{
    const int width = thirds.size().width, CHANNELS = int(sizeof(Feature));
    std::vector<ushort> sums(CHANNELS * 3 * (width + 1)); // blocks are taken in pairs
    std::vector<Feature> means(width + 1);
    RowsOfBlocks elements(features, grid);
    for (int y = rows.start; y < rows.end; y++)
    {
        const Feature* from[3];
        for (int i = 0; i < 3; i++)
            from[i] = elements.row(y, i);
        addRows(from, 3 * width, sums.data());
        for (int x = 0; x < width; x += 2)
            meanOfColumns(&sums[3 * CHANNELS * x], &means[x]);
        if (step > 0)
            takeDepths(from, 3, Range(0, width), y, step, means.data(), lost_depths);
        std::copy(means.begin(), means.begin() + width, thirds.row(y));
    }
}

static void createLevels(const Frame& frame, const BlockLevels& levels, PyramidLevel* features)
{
    for (int level = 0; level <= levels.top; level++)
    {
        const int side = levels.side(level);
        FeatureMap& map = features[level];
        map.create(levels.sizeOf(level, frame.color.size()), Feature());
        map.camera = frame.camera.united(side);
        map.normal_shift = side == 1;
        if (side <= 2 || frame.normals.empty())
            map.normals = frame.normals;
        else
            uniteNormals(frame.normals, side, map.size(), map.normals);
    }
}

//! Some rows of a level, those of a chunk. A step of depth is that of blocks, 0 without depth.
static void makeRows(const Frame& frame, bool lab_input, const BlockLevels& levels, int level, const Range& rows,
                     int chunk, int step, PyramidLevel* features)
{
    const Mat& color = frame.color;
    if (level == 0)
    {
        makeFeatures(color, frame.depth, lab_input, rows, features[0]);
        return;
    }
    const BlockGrid grid = levels.grid(level, color.size());
    const auto makeBlocks = levels.ratio(level) == 3 ? thirdFeatures : halveFeatures;
    std::vector<LostDepth>& lost_depths = features[level].lost_depths[chunk];
    lost_depths.clear();
    makeBlocks(features[level - 1], grid, step, rows, features[level], lost_depths);
}

void addLostDepths(const PyramidLevel& blocks, const Padded<int>& labels, Regions& regions)
{
    for (const std::vector<LostDepth>& chunk : blocks.lost_depths)
        for (const LostDepth& lost : chunk)
        {
            const int label = labels.row(lost.block.y)[lost.block.x];
            if (label >= 0)
                regions.sums[label].depth += lost.sum;
        }
}

//! The element of a block that is outside of a mask is taken for the one beside it, so that only those inside count.
static void fillHoles(const Mat& mask, const Mat& blocks, const Range& rows, Padded<Feature>& features)
{
    for (int y = rows.start; y < rows.end; y++)
    {
        const uchar *inside = mask.ptr(y), *in_block = blocks.ptr(y / 2);
        Feature* row = features.row(y);
        for (int x = 0; x < mask.cols; x++)
            if (!inside[x] && in_block[x / 2])
                row[x] = row[x ^ 1];
    }
}

//! All levels of a chunk, of which the rows of the last level are known; its blocks are whole.
static void makeChunk(const Frame& frame, bool lab_input, const BlockLevels& levels, const MaskPyramid& masks,
                      const Range& top_rows, int chunk, int step, PyramidLevel* features)
{
    Range rows[MAX_LEVEL + 1]; // on each level
    rows[levels.top] = top_rows;
    for (int level = levels.top; level > 0; level--)
    {
        const BlockAxis blocks = levels.grid(level, frame.color.size()).rows;
        rows[level - 1] = Range(blocks.start(rows[level].start), blocks.start(rows[level].end));
    }
    for (int level = 0; level <= levels.top; level++)
    {
        makeRows(frame, lab_input, levels, level, rows[level], chunk, step, features);
        if (!frame.mask.empty() && level < levels.top)
            fillHoles(masks.mask(level), masks.mask(level + 1), rows[level], features[level]);
    }
}

void makePyramid(const Frame& frame, bool lab_input, const BlockLevels& levels, const MaskPyramid& masks,
                 PyramidLevel* features)
{
    CV_TRACE_FUNCTION();
    createLevels(frame, levels, features);
    const int ROWS = 24; // of pixels, about: these stay in the cache
    const RowChunks chunks(features[levels.top].size().height, ROWS / levels.side(levels.top));
    for (int level = 1; level <= levels.top; level++)
        features[level].lost_depths.resize(chunks.size());
    const int step = frame.depth.empty() ? 0 : stepOfDepth(frame.depth);
    chunks.forAll([&](int k, const Range& rows)
    {
        makeChunk(frame, lab_input, levels, masks, rows, k, step, features);
    });
}

}}} // namespace
