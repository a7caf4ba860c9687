// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/boundary_list.hpp"

namespace cv { namespace ximgproc { namespace gws {

template <typename T> static T* roomFor(size_t n, std::vector<T>& buffer)
{
    buffer.resize(std::max(buffer.size(), n));
    return buffer.data();
}

//! The masks of a row of pixels with their own labels, in a loop that compilers vectorise.
static void findMasks(const int* row, int step, int n, int* masks)
{
    for (int x = 0; x < n; x++)
        masks[x] = neighborMask(row + x, step, row[x]);
}

static void append(const BoundaryPixel* found, int count, BoundaryList& list)
{
    list.pixels.insert(list.pixels.end(), found, found + count);
}

// The lists are made without branches on what no one could foresee: what is not listed is written over by the next.

//! @note The pixels at the border of the image are listed, too: the frame has another label.
void listBoundary(const Padded<int>& labels, const Range& rows, BoundaryList& list)
{
    const MaskTable& table = maskTable();
    const int width = labels.size().width;
    int* masks = roomFor(width, list.masks);
    BoundaryPixel* found = roomFor(width, list.found);
    for (int y = rows.start; y < rows.end; y++)
    {
        const int* row = labels.row(y);
        const int first = labels.index(Point(0, y));
        findMasks(row, labels.step(), width, masks);
        int count = 0;
        for (int x = 0; x < width; x++)
        {
            const BoundaryPixel pixel = { first + x, masks[x] };
            found[count] = pixel;
            count += table.canLeave(pixel.mask) & (row[x] >= 0);
        }
        append(found, count, list);
    }
}

void listBoundaryOfBlocks(const Padded<int>& blocks, const Padded<int>& labels, const Range& rows, BoundaryList& list)
{
    const int INTERIOR = 255;
    const MaskTable& table = maskTable();
    const Size size = labels.size();
    const int width = blocks.size().width, offsets[4] = { 0, 1, labels.step(), labels.step() + 1 };
    int *masks = roomFor(width, list.masks), *columns = roomFor(width, list.columns);
    BoundaryPixel* found = roomFor(4 * size_t(width), list.found);
    for (int y = rows.start; y < rows.end; y += 2)
    {
        findMasks(blocks.row(y / 2), blocks.step(), width, masks);
        int num_columns = 0, count = 0;
        for (int x = 0; x < width; x++)
        {
            columns[num_columns] = x;
            num_columns += masks[x] != INTERIOR;
        }
        for (int i = 0; i < num_columns; i++)
        {
            const Point corner(2 * columns[i], y);
            const bool has_right = corner.x + 1 < size.width, has_lower = y + 1 < size.height;
            const bool inside[4] = { true, has_right, has_lower, has_right && has_lower };
            for (int k = 0; k < 4; k++)
            {
                const BoundaryPixel pixel = { labels.index(corner) + offsets[k],
                                              table.maskInBlock(masks[columns[i]], k) };
                found[count] = pixel;
                count += table.canLeave(pixel.mask) & inside[k];
            }
        }
        append(found, count, list);
    }
}

//! Marks what touches some of the moves and lies in [first, last).
static void markAround(const std::vector<Move>& moves, int first, int last, int step, std::vector<uchar>& marks)
{
    for (size_t i = 0; i < moves.size(); i++)
        for (int p = moves[i].index - step; p <= moves[i].index + step; p += step)
            if (p >= first && p < last)
                marks[p - 1] = marks[p] = marks[p + 1] = 1;
}

//! Lists the columns of a row that are marked.
static int listMarked(const uchar* marks, int width, int* columns)
{
    int count = 0;
    for (int x = 0; x < width; x++)
    {
        uint64 next_marks = 1; // of 8 columns: most rows have few marks
        if (x % sizeof(next_marks) == 0 && x + int(sizeof(next_marks)) <= width)
            memcpy(&next_marks, marks + x, sizeof(next_marks));
        if (!next_marks)
        {
            x += int(sizeof(next_marks)) - 1;
            continue;
        }
        columns[count] = x;
        count += marks[x];
    }
    return count;
}

void listBoundaryAroundMoves(const Padded<int>& labels, const Range& rows, const std::vector<std::vector<Move> >& moves,
                             std::vector<uchar>& marks, BoundaryList& list)
{
    const MaskTable& table = maskTable();
    const int width = labels.size().width, step = labels.step();
    const int first = labels.index(Point(-1, rows.start)), last = labels.index(Point(-1, rows.end));
    std::fill(marks.begin() + first, marks.begin() + last, uchar(0));
    const int band = rows.start / SWEEP_BAND_HEIGHT, num_bands = int(moves.size());
    for (int i = std::max(band - 1, 0); i <= std::min(band + 1, num_bands - 1); i++)
        markAround(moves[i], first, last, step, marks);

    int* columns = roomFor(width, list.columns);
    BoundaryPixel* found = roomFor(width, list.found);
    for (int y = rows.start; y < rows.end; y++)
    {
        const int left = labels.index(Point(0, y)), num_columns = listMarked(&marks[left], width, columns);
        int count = 0;
        for (int i = 0; i < num_columns; i++)
        {
            const int index = left + columns[i], label = labels.data()[index];
            const BoundaryPixel pixel = { index, neighborMask(labels.data() + index, step, label) };
            found[count] = pixel;
            count += table.canLeave(pixel.mask) & (label != OUTSIDE);
        }
        append(found, count, list);
    }
}

void keepMarkers(const Mat& markers, const Padded<int>& labels, BoundaryList& list)
{
    list.pixels.erase(std::remove_if(list.pixels.begin(), list.pixels.end(), [&](const BoundaryPixel& pixel)
    {
        return markers.at<int>(labels.point(pixel.index)) >= 0;
    }), list.pixels.end());
}

}}} // namespace
