// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/region_labels.hpp"

namespace cv { namespace ximgproc { namespace gws {

template <int SIDE> static void spreadPart(const int* blocks, int cols, int* labels)
{
    for (int x = 0; x < cols / SIDE; x++)
        for (int i = 0; i < SIDE; i++)
            labels[SIDE * x + i] = blocks[x];
    for (int x = cols / SIDE * SIDE; x < cols; x++)
        labels[x] = blocks[x / SIDE];
}

//! Up to the end of the short block, then the rest.
template <int SIDE> static void spreadRow(const int* blocks, const BlockAxis& columns, int* labels)
{
    const int next = columns.short_block + 1, end = columns.start(next);
    spreadPart<SIDE>(blocks, end, labels);
    spreadPart<SIDE>(blocks + next, columns.start(columns.count) - end, labels + end);
}

void spreadLabels(const Padded<int>& blocks, const BlockGrid& grid, const Range& rows, Padded<int>& labels)
{
    for (int y = rows.start; y < rows.end; y++)
    {
        const int* from = blocks.row(grid.rows.blockOf(y));
        if (grid.side == 3)
            spreadRow<3>(from, grid.columns, labels.row(y));
        else
            spreadRow<2>(from, grid.columns, labels.row(y));
    }
}

void spreadLabels(const Padded<int>& blocks, const BlockGrid& grid, Size size, Padded<int>& labels)
{
    CV_TRACE_FUNCTION();
    labels.create(size, OUTSIDE);
    parallel_for_(Range(0, size.height), [&](const Range& rows) { spreadLabels(blocks, grid, rows, labels); });
}

void clearLabels(Size size, const Mat& mask, Padded<int>& labels)
{
    labels.create(size, OUTSIDE);
    Mat map = labels.view();
    map.setTo(Scalar(UNSEEN));
    if (!mask.empty())
        map.setTo(Scalar(OUTSIDE), mask == 0);
}

void fitToMask(const Mat& mask, Padded<int>& labels)
{
    for (int y = 0; y < mask.rows; y++)
    {
        int* row = labels.row(y);
        const uchar* inside = mask.ptr(y);
        for (int x = 0; x < mask.cols; x++)
            row[x] = !inside[x] ? int(OUTSIDE) : row[x] < 0 ? int(UNSEEN) : row[x];
    }
}

int labelUnseen(int num_regions, Padded<int>& labels)
{
    Mat map = labels.view(), components;
    const Mat unseen = map == UNSEEN;
    if (countNonZero(unseen) == 0)
        return num_regions;
    const int count = connectedComponents(unseen, components, 4, CV_32S) - 1;
    components += Scalar(num_regions - 1);
    components.copyTo(map, unseen);
    return num_regions + count;
}

}}} // namespace
