// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/neighbor_masks.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! All bits of the bytes where 16 labels are the same.
static inline v_uint8x16 isSame(const v_int32x4* labels, const int* others)
{
    v_int32x4 same[4];
    for (int k = 0; k < 4; k++)
        same[k] = equal(labels[k], v_load(others + 4 * k));
    return v_reinterpret_as_u8(v_pack(v_pack(same[0], same[1]), v_pack(same[2], same[3])));
}

//! The masks of a row of pixels with their own labels.
static void findMasksOfRow(const int* row, int step, int n, uchar* masks)
{
    const int AT_ONCE = 16, offsets[8] = { -step - 1, -step, -step + 1, 1, step + 1, step, step - 1, -1 };
    int x = 0;
    for (; x + AT_ONCE <= n; x += AT_ONCE)
    {
        v_int32x4 labels[4];
        for (int k = 0; k < 4; k++)
            labels[k] = v_load(row + x + 4 * k);
        v_uint8x16 found = v_setzero_u8();
        for (int k = 0; k < 8; k++)
            found = v_add_wrap(found, bitAnd(isSame(labels, row + x + offsets[k]), v_setall_u8(uchar(1 << k))));
        v_store(masks + x, found);
    }
    const MaskTable& table = maskTable();
    for (; x < n; x++)
        masks[x] = uchar(table.neighborMask(row + x, step, row[x]));
}

static const int DX[8] = { -1, 0, 1, 1, 1, 0, -1, -1 }, DY[8] = { -1, -1, -1, 0, 1, 1, 1, 0 };

//! Each neighbour of a pixel lies in its block or in one of the neighbours of that: clockwise the same, the next
//! one, or the one before.
static MaskTable::InBlock findInBlock(int side, int x, int y)
{
    MaskTable::InBlock result = { 0, 0, 0, 0 };
    for (int k = 0; k < 8; k++)
    {
        const int block_x = (x + DX[k] + side) / side - 1, block_y = (y + DY[k] + side) / side - 1;
        const auto isIn = [&](int j) { return DX[j & 7] == block_x && DY[j & 7] == block_y; };
        uchar& bits = isIn(k) ? result.as_it_is
                    : isIn(k + 7) ? result.left : isIn(k + 1) ? result.right : result.inside;
        bits |= uchar(1 << k);
    }
    return result;
}

MaskTable::MaskTable() : of_windows_(), in_block_(), changes_()
{
    const int BITS[12] = { 1, 2, 4, 0, 128, 0, 8, 0, 0, 64, 32, 16 };
    for (int window = 0; window < 4096; window++)
        for (int i = 0; i < 12; i++)
            of_windows_[window] |= uchar((window >> i) & 1 ? BITS[i] : 0);
    for (int mask = 0; mask < 256; mask++)
    {
        int agreement = 0, four = 0, pieces = 0;
        first_[mask] = last_[mask] = 0;
        for (int k = 7; k >= 0; k--)
            first_[mask] = (mask >> k) & 1 ? uchar(k) : first_[mask];
        for (int k = 0; k < 8; k++)
        {
            last_[mask] = (mask >> k) & 1 ? uchar(k) : last_[mask];
            const bool here = (mask >> k) & 1, corner = (mask >> ((k + 7) & 7)) & 1;
            const bool before = (mask >> ((k + 6) & 7)) & 1;
            agreement += here ? 1 + (k & 1) : 0;
            four += (k & 1) && here;
            // A 4-neighbour begins a piece unless the one before it reaches it over the corner.
            pieces += (k & 1) && here && !(corner && before);
        }
        agreement_[mask] = uchar(agreement);
        is_tip_[mask] = four == 1;
        can_leave_[mask] = pieces == 1 && (mask & FOUR_NEIGHBORS) != FOUR_NEIGHBORS;
        for (int k = 0; k < 8; k++)
            changes_[mask][1 + DY[k]][1 + DX[k] + (DY[k] == 1)] = uchar(((mask >> k) & 1) << ((k + 4) & 7));
    }
    for (int side = 2; side <= 3; side++)
        for (int y = 0; y < side; y++)
            for (int x = 0; x < side; x++)
                in_block_[side - 2][y][x] = findInBlock(side, x, y);
}

const MaskTable& maskTable()
{
    static const MaskTable table;
    return table;
}

void findMasks(const Padded<int>& labels, const Range& rows, Padded<uchar>& masks)
{
    const int width = labels.size().width;
    for (int y = rows.start; y < rows.end; y++)
    {
        const int* row = labels.row(y);
        uchar* found = masks.row(y);
        findMasksOfRow(row, labels.step(), width, found);
        for (int x = 0; x < width; x++)
            found[x] |= uchar(row[x] < 0 ? int(INTERIOR) : 0);
    }
}

enum { BLOCKS_AT_ONCE = 16 };

template <int BITS> static inline v_uint8x16 rotateLeft(const v_uint8x16& bytes)
{
    const v_uint16x8 pairs = v_reinterpret_as_u16(bytes);
    const uchar low = uchar((1 << BITS) - 1);
    return v_add_wrap(bitAnd(v_reinterpret_as_u8(v_shl<BITS>(pairs)), v_setall_u8(uchar(~low))),
                      bitAnd(v_reinterpret_as_u8(v_shr<8 - BITS>(pairs)), v_setall_u8(low)));
}

//! The masks of the pixels at a place in some blocks.
static inline v_uint8x16 findInBlocks(const v_uint8x16& masks, const MaskTable::InBlock& of)
{
    const v_uint8x16 left = bitAnd(rotateLeft<1>(masks), v_setall_u8(of.left));
    const v_uint8x16 right = bitAnd(rotateLeft<7>(masks), v_setall_u8(of.right));
    return v_add_wrap(v_add_wrap(bitAnd(masks, v_setall_u8(of.as_it_is)), v_setall_u8(of.inside)),
                      v_add_wrap(left, right));
}

//! The masks in row y of a row of whole blocks. Behind the blocks and the line is room for some more blocks.
static void fillLine(const std::vector<uchar>& masks_of_blocks, int count, int side, int y, uchar* line)
{
    const MaskTable::InBlock first = maskTable().inBlock(side, 0, y), second = maskTable().inBlock(side, 1, y);
    const MaskTable::InBlock third = maskTable().inBlock(side, side - 1, y);
    for (int i = 0; i < count; i += BLOCKS_AT_ONCE, line += side * BLOCKS_AT_ONCE)
    {
        const v_uint8x16 masks = v_load(masks_of_blocks.data() + i);
        const v_uint8x16 left = findInBlocks(masks, first), middle = findInBlocks(masks, second);
        if (side == 2)
            v_store_interleave(line, left, middle);
        else
            v_store_interleave(line, left, middle, findInBlocks(masks, third));
    }
}

//! A mask that has some bits of another one.
static inline uchar putBits(uchar mask, uchar other, uchar bits) { return uchar((mask & ~bits) | (other & bits)); }

//! The last row of a short block has the neighbours below that the last row of a whole one would have. The same holds
//! for columns.
void findMasksInBlocks(const Padded<uchar>& of_blocks, const BlockGrid& grid, const Range& rows, Padded<uchar>& masks)
{
    const uchar RIGHT = 0x1C, BELOW = 0x70;
    const BlockAxis& columns = grid.columns;
    const int side = grid.side, width = columns.count, next = columns.short_block + 1, end = columns.start(next);
    const size_t room = width + BLOCKS_AT_ONCE;
    std::vector<uchar> masks_of_blocks(room), line(side * room), last_line(side * room);
    for (int y = rows.start, known = -1; y < rows.end; y++)
    {
        const int block = grid.rows.blockOf(y), i = y - grid.rows.start(block);
        if (block != known)
            std::copy_n(of_blocks.row(block), width, masks_of_blocks.data());
        known = block;
        fillLine(masks_of_blocks, width, side, i, line.data());
        if (y + 1 == grid.rows.start(block + 1) && i + 1 < side)
        {
            fillLine(masks_of_blocks, width, side, side - 1, last_line.data());
            for (int x = 0; x < side * width; x++)
                line[x] = putBits(line[x], last_line[x], BELOW);
        }
        line[end - 1] = putBits(line[end - 1], line[side * next - 1], RIGHT);
        std::copy_n(line.data(), end, masks.row(y));
        std::copy_n(line.data() + side * next, masks.size().width - end, masks.row(y) + end);
    }
}

}}} // namespace
