// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/neighbor_lists.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Pieces are listed without branches that no one could foresee: what is none is written over by the next.

//! Room for the pieces of one more row, behind those that are there.
static BoundaryPiece* roomForRow(int cols, BoundaryBand& band)
{
    if (band.pieces.size() < band.count + cols)
        band.pieces.resize(2 * (band.count + cols));
    return band.pieces.data();
}

//! Edges between a row and the one below, of which those side by side between the same regions are one piece.
static void addEdgesBelow(const Mat& labels, int y, BoundaryBand& band)
{
    const int *row = labels.ptr<int>(y), *below = labels.ptr<int>(y + 1);
    size_t count = band.count;
    BoundaryPiece* pieces = roomForRow(labels.cols, band);
    for (int x = 0, begin = 0; x < labels.cols; x++)
    {
        const bool ends = x + 1 == labels.cols || row[x + 1] != row[x] || below[x + 1] != below[x];
        const BoundaryPiece piece = { { row[x], below[x] }, x + 1 - begin };
        pieces[count] = piece;
        count += ends & (row[x] != below[x]) & ((row[x] | below[x]) >= 0);
        begin = ends ? x + 1 : begin;
    }
    band.count = count;
}

//! Edges between a pixel and the one at its right.
static void addEdgesRight(const Mat& labels, int y, BoundaryBand& band)
{
    const int* row = labels.ptr<int>(y);
    size_t count = band.count;
    BoundaryPiece* pieces = roomForRow(labels.cols, band);
    for (int x = 0; x + 1 < labels.cols; x++)
    {
        const BoundaryPiece piece = { { row[x], row[x + 1] }, 1 };
        pieces[count] = piece;
        count += (row[x] != row[x + 1]) & ((row[x] | row[x + 1]) >= 0);
    }
    band.count = count;
}

//! Regions that touch the rows of a band mostly have numbers that are near each other.
static void countEntries(BoundaryBand& band)
{
    band.positions.clear();
    if (band.count == 0)
        return;
    int last = 0;
    band.first = INT_MAX;
    for (size_t i = 0; i < band.count; i++)
    {
        const int* regions = band.pieces[i].regions;
        band.first = std::min(band.first, std::min(regions[0], regions[1]));
        last = std::max(last, std::max(regions[0], regions[1]));
    }
    band.positions.assign(last + 1 - band.first, 0);
    for (size_t i = 0; i < band.count; i++)
        for (int side = 0; side < 2; side++)
            band.positions[band.pieces[i].regions[side] - band.first]++;
}

//! Lists of regions one after the other, in each of them the entries of the bands one after the other.
static void placeEntries(int num_regions, std::vector<BoundaryBand>& bands, NeighborLists& lists)
{
    lists.counts.assign(num_regions, 0);
    lists.starts.resize(num_regions);
    for (size_t k = 0; k < bands.size(); k++)
        for (size_t i = 0; i < bands[k].positions.size(); i++)
        {
            int& count = lists.counts[bands[k].first + i];
            const int in_band = bands[k].positions[i];
            bands[k].positions[i] = count; // in the list, as yet
            count += in_band;
        }
    int start = 0;
    for (int i = 0; i < num_regions; i++)
    {
        lists.starts[i] = start;
        start += lists.counts[i];
    }
    lists.neighbors.resize(start);
}

static void writeEntries(BoundaryBand& band, NeighborLists& lists)
{
    for (size_t i = 0; i < band.count; i++)
        for (int side = 0; side < 2; side++)
        {
            const int region = band.pieces[i].regions[side];
            const int position = lists.starts[region] + band.positions[region - band.first]++;
            const Neighbor neighbor = { band.pieces[i].regions[!side], band.pieces[i].length };
            lists.neighbors[position] = neighbor;
        }
}

void listNeighbors(const Mat& labels, int num_regions, std::vector<BoundaryBand>& bands, NeighborLists& lists)
{
    CV_TRACE_FUNCTION();
    const int LOWEST = 16, MOST = 16; // bands do not depend on the number of threads
    const int height = std::max(LOWEST, (labels.rows + MOST - 1) / MOST);
    const int num_bands = (labels.rows + height - 1) / height;
    bands.resize(num_bands);
    parallel_for_(Range(0, num_bands), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; k++)
        {
            bands[k].count = 0;
            for (int y = k * height; y < std::min((k + 1) * height, labels.rows); y++)
            {
                addEdgesRight(labels, y, bands[k]);
                if (y + 1 < labels.rows)
                    addEdgesBelow(labels, y, bands[k]);
            }
            countEntries(bands[k]);
        }
    });
    placeEntries(num_regions, bands, lists);
    lists.contrasts.clear();
    parallel_for_(Range(0, num_bands), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; k++)
            writeEntries(bands[k], lists);
    });
}

}}} // namespace
