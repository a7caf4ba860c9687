// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/boundary_list.hpp"

namespace cv { namespace ximgproc { namespace gws {

// The lists are made without unpredictable branches: every pixel is written, and the next one overwrites what does not
// belong to the list.

void BoundaryList::begin(int first_row, size_t most_quads)
{
    first_row_ = first_row;
    for (int c = 0; c < NUM_CLASSES; c++)
    {
        pixels_[c].clear();
        pixels_[c].reserve(most_quads);
        ends_[c].assign(1, 0);
    }
}

void BoundaryList::addRow(const Quad* quads, int n, int first, int step)
{
    int* next[NUM_CLASSES];
    for (int c = 0; c < NUM_CLASSES; c++)
    {
        pixels_[c].resize(ends_[c].back() + n);
        next[c] = pixels_[c].data() + ends_[c].back();
    }
    for (int i = 0; i < n; i++)
    {
        const int upper = first + 2 * quads[i].x, lower = upper + step, classes = quads[i].classes;
        *next[0] = upper;
        *next[1] = upper + 1;
        *next[2] = lower;
        *next[3] = lower + 1;
        for (int c = 0; c < NUM_CLASSES; c++)
            next[c] += (classes >> c) & 1;
    }
    for (int c = 0; c < NUM_CLASSES; c++)
        ends_[c].push_back(int(next[c] - pixels_[c].data()));
}

void findMasks(const Padded<int>& labels, const Range& rows, Padded<uchar>& masks)
{
    const int width = labels.size().width;
    std::vector<int> found(width);
    for (int y = rows.start; y < rows.end; y++)
    {
        const int* row = labels.row(y);
        findMasksOfRow(row, labels.step(), width, found.data());
        for (int x = 0; x < width; x++)
            masks.row(y)[x] = uchar(found[x] | (row[x] < 0 ? int(INTERIOR) : 0));
    }
}

//! Where a size is odd, the last pixels have no neighbours in their blocks.
static void cutOddEnds(const Range& rows, Padded<uchar>& masks)
{
    const uchar WITHOUT_RIGHT = 0xE3, WITHOUT_LOWER = 0x8F;
    const Size size = masks.size();
    const int end = std::min(2 * rows.end, size.height);
    for (int y = 2 * rows.start; size.width % 2 && y < end; y++)
    {
        masks.row(y)[size.width - 1] &= WITHOUT_RIGHT;
        masks.row(y)[size.width] = INTERIOR;
    }
    if (2 * rows.end <= size.height)
        return;
    for (int x = 0; x < size.width; x++)
        masks.row(size.height - 1)[x] &= WITHOUT_LOWER;
    std::fill_n(masks.row(size.height) - 1, masks.step(), uchar(INTERIOR));
}

//! Which pixels of a quad can leave.
static int findLeavers(const MaskTable& table, const uchar* upper, const uchar* lower)
{
    return table.canLeave(upper[0]) | table.canLeave(upper[1]) << 1 | table.canLeave(lower[0]) << 2 |
           table.canLeave(lower[1]) << 3;
}

void listBoundary(const Padded<uchar>& masks, const Range& rows, BoundaryList& list)
{
    const MaskTable& table = maskTable();
    std::vector<Quad> quads((masks.size().width + 1) / 2);
    for (int y = rows.start; y < rows.end; y++)
    {
        const uchar *upper = masks.row(2 * y), *lower = masks.row(2 * y + 1);
        int count = 0;
        for (int x = 0; x < int(quads.size()); x++)
        {
            const Quad quad = { x, findLeavers(table, upper + 2 * x, lower + 2 * x) };
            quads[count] = quad;
            count += quad.classes != 0;
        }
        list.addRow(quads.data(), count, masks.index(Point(0, 2 * y)), masks.step());
    }
}

void listBoundaryOfBlocks(const Padded<int>& blocks, const Range& rows, Padded<uchar>& masks, BoundaryList& list)
{
    const MaskTable& table = maskTable();
    const int UPPER = 3, LEFT = 5; // classes
    const Size size = masks.size();
    const int width = blocks.size().width;
    std::vector<int> masks_of_blocks(width);
    std::vector<Quad> quads(width);
    for (int y = rows.start; y < rows.end; y++)
    {
        findMasksOfRow(blocks.row(y), blocks.step(), width, masks_of_blocks.data());
        uchar *upper = masks.row(2 * y), *lower = masks.row(2 * y + 1);
        const int inside = 2 * y + 1 < size.height ? int(ALL_CLASSES) : UPPER;
        int count = 0;
        for (int x = 0; x < width; x++)
        {
            const int mask = masks_of_blocks[x];
            memcpy(upper + 2 * x, table.masksInBlock(mask), 2);
            memcpy(lower + 2 * x, table.masksInBlock(mask) + 2, 2);
            const Quad quad = { x, table.leaversInBlock(mask) & inside };
            quads[count] = quad;
            count += quad.classes != 0;
        }
        if (size.width % 2 && count > 0 && quads[count - 1].x == width - 1)
            quads[count - 1].classes &= LEFT;
        list.addRow(quads.data(), count, masks.index(Point(0, 2 * y)), masks.step());
    }
    cutOddEnds(rows, masks);
}

void listMarked(const Padded<uchar>& masks, const Range& rows, Padded<uchar>& marks, BoundaryList& list)
{
    const MaskTable& table = maskTable();
    const int width = marks.size().width;
    std::vector<Quad> quads(width);
    for (int y = rows.start; y < rows.end; y++)
    {
        uchar* row = marks.row(y);
        const uchar *upper = masks.row(2 * y), *lower = masks.row(2 * y + 1);
        int count = 0;
        for (int x = 0; x < width; x++)
        {
            uint64 next_marks = 1; // of 8 quads: most rows have few marks
            if (x % sizeof(next_marks) == 0 && x + int(sizeof(next_marks)) <= width)
                memcpy(&next_marks, row + x, sizeof(next_marks));
            if (!next_marks)
            {
                x += int(sizeof(next_marks)) - 1;
                continue;
            }
            const Quad quad = { x, row[x] & findLeavers(table, upper + 2 * x, lower + 2 * x) };
            quads[count] = quad;
            count += quad.classes != 0;
        }
        std::fill_n(row, width, uchar(0));
        list.addRow(quads.data(), count, masks.index(Point(0, 2 * y)), masks.step());
    }
}

}}} // namespace
