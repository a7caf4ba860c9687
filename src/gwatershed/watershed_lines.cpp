// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "gwatershed/watershed_lines.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Label of the neighbour at the smallest distance, of equal ones the first of left, top, right, bottom. UNLABELLED
//! if no neighbour has a label.
static int nearestLabel(const FloodPixel* pixel, const Vec4i& neighbors, int alpha)
{
    int label = UNLABELLED, smallest = INT_MAX;
    for (int k = 0; k < 4; k++)
    {
        const FloodPixel& neighbor = pixel[neighbors[k]];
        const int away = distance(pixel->value, neighbor.value, alpha);
        const bool nearer = (neighbor.state > 0) & (away < smallest);
        smallest = nearer ? away : smallest;
        label = nearer ? neighbor.state : label;
    }
    return label;
}

//! All pixels without a label, in raster order.
static void collectLines(PixelMap& map, std::vector<int>& lines)
{
    const Size size = map.size();
    size_t count = 0;
    for (int y = 0; y < size.height; y++)
    {
        const FloodPixel* row = map.row(y);
        const int first = map.index(Point(0, y));
        lines.resize(std::max(lines.size(), count + size.width));
        for (int x = 0; x < size.width; x++) // no unpredictable branch: an entry that is no line is overwritten
        {
            lines[count] = first + x;
            count += (row[x].state <= 0) & (row[x].state != FRAME);
        }
    }
    lines.resize(count);
}

//! In each round, all pixels that have a labelled neighbour at its start get a label. Wide lines, and the pixels that
//! they enclose, take several rounds. The order within a round does not matter: no pixel sees the new label of
//! another.
//! @note Not in the paper, whose result has lines.
void absorbLines(int alpha, PixelMap& map, LineBuffers& buffers)
{
    CV_TRACE_FUNCTION();
    FloodPixel* pixels = map.data();
    const Vec4i neighbors = map.neighbors();
    std::vector<int>& lines = buffers.lines;
    std::vector<int>& round = buffers.round;
    std::vector<int>& chosen = buffers.chosen;
    std::vector<int>& later = buffers.later;
    collectLines(map, lines);

    for (round = lines; !round.empty(); round.swap(later))
    {
        chosen.resize(round.size());
        parallel_for_(Range(0, int(round.size())), [&](const Range& range)
        {
            for (int i = range.start; i < range.end; i++)
                chosen[i] = nearestLabel(pixels + round[i], neighbors, alpha);
        });
        for (size_t i = 0; i < round.size(); i++)
            if (chosen[i] != UNLABELLED)
                pixels[round[i]].state = chosen[i];

        later.clear();
        for (size_t i = 0; i < round.size(); i++)
            for (int k = 0; k < 4 && chosen[i] != UNLABELLED; k++)
            {
                const int a = round[i] + neighbors[k];
                if (pixels[a].state == LINE || pixels[a].state == UNLABELLED)
                {
                    pixels[a].state = IN_QUEUE;
                    later.push_back(a);
                }
            }
    }
}

}}} // namespace
