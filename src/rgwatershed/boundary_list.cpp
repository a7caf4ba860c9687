// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/boundary_list.hpp"
#include "shared/bit_positions.hpp"

namespace cv { namespace ximgproc { namespace gws {

// The lists are made without unpredictable branches: eight pixels of a class are written at once, every other one of a
// row, and the next ones overwrite those that do not belong to the list.

//! Which of 16 bytes are 1 and not 0, as bits: those at even places first.
static inline unsigned toBits(const v_uint8x16& ones)
{
    const v_uint16x8 pairs = v_reinterpret_as_u16(ones);
    return unsigned(v_signmask(v_pack(v_reinterpret_as_s16(v_shl<15>(pairs)), v_reinterpret_as_s16(v_shl<7>(pairs)))));
}

void BoundaryList::begin(int first_row, size_t most_quads)
{
    first_row_ = first_row;
    for (int c = 0; c < NUM_CLASSES; c++)
    {
        pixels_[c].clear();
        pixels_[c].reserve(most_quads + ROOM);
        ends_[c].assign(1, 0);
    }
}

template <typename Find> void BoundaryList::addRow(int cols, int first, int step, const Find& find)
{
    const BitPositions& table = bitPositions();
    int* next[NUM_CLASSES];
    for (int c = 0; c < NUM_CLASSES; c++)
    {
        pixels_[c].resize(ends_[c].back() + (cols + 1) / 2 + ROOM);
        next[c] = pixels_[c].data() + ends_[c].back();
    }
    for (int x = 0; x < cols; x += AT_ONCE)
    {
        v_uint8x16 in_upper, in_lower;
        find(x, in_upper, in_lower);
        const unsigned upper = toBits(in_upper), lower = toBits(in_lower);
        if ((upper | lower) == 0)
            continue;
        const int pixel = first + x;
        next[0] = writePositions<1>(table, upper & 255, pixel, next[0]);
        next[1] = writePositions<1>(table, upper >> 8, pixel + 1, next[1]);
        next[2] = writePositions<1>(table, lower & 255, pixel + step, next[2]);
        next[3] = writePositions<1>(table, lower >> 8, pixel + step + 1, next[3]);
    }
    for (int c = 0; c < NUM_CLASSES; c++)
        ends_[c].push_back(int(next[c] - pixels_[c].data()));
}

//! Some bytes of a row from a column on; those behind its end are `rest`.
static inline v_uint8x16 loadBytes(const uchar* row, int x, int cols, uchar rest)
{
    if (x + BoundaryList::AT_ONCE <= cols)
        return v_load(row + x);
    uchar bytes[BoundaryList::AT_ONCE];
    for (int i = 0; i < BoundaryList::AT_ONCE; i++)
        bytes[i] = x + i < cols ? row[x + i] : rest;
    return v_load(bytes);
}

//! 1 for those of 16 masks that miss one of the 4-neighbours: the pixel is at a boundary.
static inline v_uint8x16 isAtBoundary(const v_uint8x16& masks)
{
    const v_uint8x16 four = v_setall_u8(uchar(MaskTable::FOUR_NEIGHBORS));
    return v_min(subtract(four, bitAnd(masks, four)), v_setall_u8(1));
}

void listBoundary(const Padded<uchar>& masks, const Range& rows, BoundaryList& list)
{
    const int cols = masks.size().width;
    for (int y = rows.start; y < rows.end; y++)
    {
        const uchar *upper = masks.row(2 * y), *lower = masks.row(2 * y + 1);
        const int first = masks.index(Point(0, 2 * y));
        list.addRow(cols, first, masks.step(), [&](int x, v_uint8x16& in_upper, v_uint8x16& in_lower)
        {
            in_upper = isAtBoundary(loadBytes(upper, x, cols, INTERIOR));
            in_lower = isAtBoundary(loadBytes(lower, x, cols, INTERIOR));
        });
    }
}

void listMarked(const Padded<uchar>& masks, const Range& rows, Padded<uchar>& marks, BoundaryList& list)
{
    const int cols = masks.size().width;
    for (int y = rows.start; y < rows.end; y++)
    {
        uchar *upper_marks = marks.row(2 * y), *lower_marks = marks.row(2 * y + 1);
        const uchar *upper = masks.row(2 * y), *lower = masks.row(2 * y + 1);
        const int first = masks.index(Point(0, 2 * y));
        list.addRow(cols, first, masks.step(), [&](int x, v_uint8x16& in_upper, v_uint8x16& in_lower)
        {
            in_upper = loadBytes(upper_marks, x, cols, 0);
            in_lower = loadBytes(lower_marks, x, cols, 0);
            if (toBits(v_max(in_upper, in_lower)))
            {
                in_upper = v_min(in_upper, isAtBoundary(loadBytes(upper, x, cols, INTERIOR)));
                in_lower = v_min(in_lower, isAtBoundary(loadBytes(lower, x, cols, INTERIOR)));
            }
        });
        std::fill_n(upper_marks, cols, uchar(0));
        std::fill_n(lower_marks, cols, uchar(0));
    }
}

}}} // namespace
