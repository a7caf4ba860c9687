// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "gwatershed/watershed_lines.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Label of the nearest labelled neighbour by distance, the first of left, top, right, bottom if
//! equal; UNLABELLED if none has a label.
static inline int nearestLabel(const FloodPixel* pixel, int step)
{
    const int offsets[4] = { -1, -step, 1, step };
    int label = UNLABELLED, smallest = INT_MAX;
    for (int k = 0; k < 4; k++)
    {
        const int state = pixel[offsets[k]].state, away = pixel->distance(k);
        const bool nearer = (state > 0) & (away < smallest);
        smallest = nearer ? away : smallest;
        label = nearer ? state : label;
    }
    return label;
}

//! All pixels of some rows without a label, in raster order.
static void collectLines(const PixelMap& map, const Range& rows, std::vector<int>& lines)
{
    const int width = map.size().width;
    lines.resize(size_t(width) * rows.size());
    size_t count = 0;
    for (int y = rows.start; y < rows.end; y++)
    {
        const FloodPixel* row = map.row(y);
        const int first = map.index(Point(0, y));
        for (int x = 0; x < width; x++) // without a branch that no one could foresee: the next one goes over it
        {
            lines[count] = first + x;
            count += (row[x].state <= 0) & (row[x].state != FRAME);
        }
    }
    lines.resize(count);
}

//! Labels for some pixels, as the map is.
static void chooseLabels(const PixelMap& map, const Range& range, const std::vector<int>& lines,
                         std::vector<int>& labels)
{
    for (int i = range.start; i < range.end; i++)
        labels[i] = nearestLabel(map.data() + lines[i], map.step());
}

//! Gives the pixels their labels; those that have none yet go to rest.
static void setLabels(const std::vector<int>& lines, const std::vector<int>& labels, PixelMap& map,
                      std::vector<int>& rest)
{
    rest.clear();
    for (size_t i = 0; i < lines.size(); i++)
        if (labels[i] != UNLABELLED)
            map.data()[lines[i]].state = labels[i];
        else
            rest.push_back(lines[i]);
}

//! The first round, of all lines. Each chunk of rows chooses by itself, before any pixel changes. The pixels of the
//! next round are those that have a labelled neighbour now.
static void labelThinLines(PixelMap& map, LineBuffers& buffers)
{
    const int ROWS = 32; // of a chunk: enough to be worth a task
    const RowChunks chunks(map.size().height, ROWS);
    buffers.chunks.resize(chunks.size());
    chunks.forAll([&](int k, const Range& rows)
    {
        LineBuffers::Chunk& chunk = buffers.chunks[k];
        collectLines(map, rows, chunk.lines);
        chunk.labels.resize(chunk.lines.size());
        chooseLabels(map, Range(0, int(chunk.lines.size())), chunk.lines, chunk.labels);
    });
    chunks.forAll([&](int k, const Range&)
    {
        LineBuffers::Chunk& chunk = buffers.chunks[k];
        setLabels(chunk.lines, chunk.labels, map, chunk.rest);
    });
    buffers.round.clear();
    for (const LineBuffers::Chunk& chunk : buffers.chunks)
        for (int pixel : chunk.rest)
            if (nearestLabel(map.data() + pixel, map.step()) != UNLABELLED)
            {
                map.data()[pixel].state = IN_QUEUE;
                buffers.round.push_back(pixel);
            }
}

//! @note The paper ends with the lines. Here each round gives a label to all pixels that have a
//! labelled neighbour when it begins; wide lines, and what they enclose, take several rounds. The
//! pixels of a round need not be sorted, because none of them sees what the others get.
void absorbLines(PixelMap& map, LineBuffers& buffers)
{
    CV_TRACE_FUNCTION();
    std::vector<int>& round = buffers.round;
    std::vector<int>& labels = buffers.labels;
    std::vector<int>& later = buffers.later;
    for (labelThinLines(map, buffers); !round.empty(); round.swap(later))
    {
        labels.resize(round.size());
        parallel_for_(Range(0, int(round.size())), [&](const Range& range)
        {
            chooseLabels(map, range, round, labels);
        });
        for (size_t i = 0; i < round.size(); i++)
            map.data()[round[i]].state = labels[i];

        later.clear();
        for (int pixel : round)
            for (int k = 0; k < 4; k++)
            {
                const int a = pixel + map.neighbors()[k];
                int& state = map.data()[a].state;
                if (state != LINE && state != UNLABELLED)
                    continue;
                state = IN_QUEUE;
                later.push_back(a);
            }
    }
}

}}} // namespace
