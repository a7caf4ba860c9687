// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/neighbor_masks.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Compilers make vectors of the following two, which is why the first of them is not inlined into loops.

static inline int bitIfSame(int label, int other, int bit)
{
    return -int(label == other) & bit;
}

int neighborMask(const int* pixel, int step, int label)
{
    // Four columns at once. The one too many is to the left below, and to the right else: there are always labels.
    // (To the left in the middle, a label may have been written just before, which makes loads slow.)
    const int UPPER[4] = { 1, 2, 4, 0 }, MIDDLE[4] = { 128, 0, 8, 0 }, LOWER[4] = { 0, 64, 32, 16 };
    const int *upper = pixel - step - 1, *middle = pixel - 1, *lower = pixel + step - 2;
    int mask = 0;
    for (int i = 0; i < 4; i++)
        mask |= bitIfSame(upper[i], label, UPPER[i]) | bitIfSame(middle[i], label, MIDDLE[i]) |
                bitIfSame(lower[i], label, LOWER[i]);
    return mask;
}

void findMasksOfRow(const int* row, int step, int n, int* masks)
{
    const int *upper = row - step, *lower = row + step;
    for (int x = 0; x < n; x++)
        masks[x] = bitIfSame(upper[x - 1], row[x], 1) | bitIfSame(upper[x], row[x], 2) |
                   bitIfSame(upper[x + 1], row[x], 4) | bitIfSame(row[x + 1], row[x], 8) |
                   bitIfSame(lower[x + 1], row[x], 16) | bitIfSame(lower[x], row[x], 32) |
                   bitIfSame(lower[x - 1], row[x], 64) | bitIfSame(row[x - 1], row[x], 128);
}

static const int DX[8] = { -1, 0, 1, 1, 1, 0, -1, -1 }, DY[8] = { -1, -1, -1, 0, 1, 1, 1, 0 };

//! Each neighbour of a pixel lies in its block or in one of the neighbours of that.
static uchar findMaskInBlock(int side, int block_mask, int x, int y)
{
    int mask = 0;
    for (int k = 0; k < 8; k++)
    {
        const int block_x = (x + DX[k] + side) / side - 1, block_y = (y + DY[k] + side) / side - 1;
        bool same = block_x == 0 && block_y == 0;
        for (int j = 0; j < 8 && !same; j++)
            same = DX[j] == block_x && DY[j] == block_y && ((block_mask >> j) & 1);
        mask |= same << k;
    }
    return uchar(mask);
}

MaskTable::MaskTable() : in_block_(), changes_()
{
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
            changes_[mask][1 + DY[k]][1 + DX[k]] = (mask >> k) & 1 ? uchar(1 << ((k + 4) & 7)) : uchar(0);
    }
    for (int side = 2; side <= 3; side++)
        for (int mask = 0; mask < 256; mask++)
            for (int y = 0; y < side; y++)
                for (int x = 0; x < side; x++)
                    in_block_[side - 2][y][mask].masks[x] = findMaskInBlock(side, mask, x, y);
}

const MaskTable& maskTable()
{
    static const MaskTable table;
    return table;
}

}}} // namespace
