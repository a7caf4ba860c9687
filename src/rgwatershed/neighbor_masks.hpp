// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_NEIGHBOR_MASKS_HPP
#define OPENCV_GWATERSHED_NEIGHBOR_MASKS_HPP

#include "rgwatershed/block_grid.hpp"
#include "shared/padded.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

// The 8 neighbours of a pixel, clockwise from the upper left, are the bits of a mask; those with an odd number are
// its 4-neighbours. A mask tells which of them have a label.

enum { INTERIOR = 255 }; //!< the mask of a pixel whose neighbours all have its label: it cannot leave

//! What a pixel must know of the mask of its neighbours with one label.
class MaskTable
{
public:
    enum { FOUR_NEIGHBORS = 0xAA };

    MaskTable();

    //! The neighbours of a pixel that have a label.
    int neighborMask(const int* pixel, int step, int label) const
    {
        // Four columns at once. The one too many is to the left below, and to the right else: there are always labels.
        // (To the left in the middle, a label may have been written just before, which makes loads slow.)
        const v_int32x4 labels = v_setall_s32(label);
        const v_int32x4 upper = equal(v_load(pixel - step - 1), labels), middle = equal(v_load(pixel - 1), labels);
        const v_int32x4 lower = equal(v_load(pixel + step - 2), labels);
        return of_windows_[v_signmask(v_pack(v_pack(upper, middle), v_pack(lower, lower))) & 4095];
    }

    //! Whether a region that has the neighbours in the mask stays one piece if it loses the pixel in the middle, which
    //! is at its boundary: the 4-neighbours are connected within the window, and there is one.
    bool canLeave(int mask) const { return can_leave_[mask]; }

    //! Boundary that the pixel would not have if it had the label, too, in quarters of an edge: two
    //! for each 4-neighbour and one for each diagonal one.
    int agreement(int mask) const { return agreement_[mask]; }

    //! The lowest and the highest bit of a mask that is not 0.
    int first(int mask) const { return first_[mask]; }
    int last(int mask) const { return last_[mask]; }

    //! Whether three of the 4-neighbours are not in the mask.
    bool isTip(int mask) const { return is_tip_[mask]; }

    //! How the mask of a pixel in a block follows from that of the block: `inside` are neighbours in the block. Others
    //! have bits of the block's mask: as they are, rotated to the left by one, or to the right.
    struct InBlock
    {
        uchar inside, as_it_is, left, right;
    };

    //! Of a pixel at a place in a block of 2x2 or 3x3 pixels, which has a side.
    const InBlock& inBlock(int side, int x, int y) const { return in_block_[side - 2][y][x]; }

    //! What changes in the masks of the neighbours if the pixel in the middle changes its label, and the neighbours of
    //! the mask have the old or the new one: 4 bytes for each row. One too many, 0, is the last, or below the first.
    const uchar* changes(int mask, int row) const { return changes_[mask][row]; }

private:
    uchar of_windows_[4096]; // by the upper, the middle and the lower four labels that are the same
    uchar can_leave_[256], agreement_[256], first_[256], last_[256], is_tip_[256];
    InBlock in_block_[2][3][3];
    uchar changes_[256][3][4];
};

const MaskTable& maskTable();

//! For each pixel the mask of its neighbours with its own label, INTERIOR where there is no label.
void findMasks(const Padded<int>& labels, const Range& rows, Padded<uchar>& masks);

//! The same where pixels have the labels of blocks of 2x2 or 3x3 pixels, from the masks of the blocks. None is without
//! a label.
void findMasksInBlocks(const Padded<uchar>& of_blocks, const BlockGrid& grid, const Range& rows, Padded<uchar>& masks);

}}} // namespace

#endif
