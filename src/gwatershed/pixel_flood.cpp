// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "gwatershed/pixel_flood.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

//! Lines 4 to 14: the pixels beside a marker are queued at the priority of equation (4).
static void fillQueues(PixelMap& map, PixelQueue& queues)
{
    const Vec4i neighbors = map.neighbors();
    for (int y = 0; y < map.size().height; y++)
        for (int x = 0, p = map.index(Point(0, y)); x < map.size().width; x++, p++)
        {
            const FloodPixel* pixel = map.data() + p;
            if (pixel->state != IN_QUEUE)
                continue;
            int priority = INT_MAX;
            for (int k = 0; k < 4; k++)
                if (pixel[neighbors[k]].state > 0)
                    priority = std::min(priority, pixel->distance(k));
            queues.push(p, priority);
        }
}

//! The label that the labelled neighbours of a queued pixel share, or LINE if they differ. As unsigned numbers,
//! labels less 1 are smaller than all other states less 1.
static inline int commonLabel(const FloodPixel* pixel, int step)
{
    const int left = pixel[-1].state, top = pixel[-step].state;
    const int right = pixel[1].state, bottom = pixel[step].state;
    const int last = std::max(std::max(left, top), std::max(right, bottom));
    const unsigned first = std::min(std::min(left - 1u, top - 1u), std::min(right - 1u, bottom - 1u));
    return last - 1u == first ? last : int(LINE);
}

//! Reads a pixel that will be needed soon, so that it is in the cache by then.
static inline void touch(const FloodPixel& pixel)
{
    const volatile int& state = pixel.state;
    static_cast<void>(int(state));
}

//! Reads the rows that some pixels of a batch will need. They lie anywhere in the image: so they are
//! fetched at the same time, instead of one after the other.
static void touchRows(const FloodPixel* pixels, int step, const int* batch, int begin, int end)
{
    for (int i = begin; i < end; i++)
        for (int row = -step; row <= step; row += step)
            touch(pixels[batch[i] + row]);
}

//! The neighbours that no one has reached yet, as bits.
static inline unsigned findUnlabelled(const FloodPixel* pixel, int step)
{
    return unsigned(pixel[-1].state == UNLABELLED) | unsigned(pixel[-step].state == UNLABELLED) << 1 |
           unsigned(pixel[1].state == UNLABELLED) << 2 | unsigned(pixel[step].state == UNLABELLED) << 3;
}

//! Lines 15 to 36. Invariant: a pixel enters a queue once, from the first labelled neighbour that
//! is taken out; it gets its label, or becomes a line, when it is taken out itself. A pixel queued
//! below the current priority waits until the priorities begin again at 0, and one queued at that priority
//! goes behind those that are there. So the order of the queues alone decides, and neither lines nor
//! the frame pass the flood on.
static void flood(FloodPixel* pixels, int step, PixelQueue& queues)
{
    const int AHEAD = 8;
    int batch[PixelQueue::CHUNK];
    const int offsets[4] = { -1, -step, 1, step };
    while (const int count = queues.take(batch))
    {
        touchRows(pixels, step, batch, 0, std::min(AHEAD, count));
        for (int i = 0; i < count; i++)
        {
            if (i % AHEAD == 0)
                touchRows(pixels, step, batch, i + AHEAD, std::min(i + 2 * AHEAD, count));
            FloodPixel* pixel = pixels + batch[i];
            pixel->state = commonLabel(pixel, step);
            unsigned reached = pixel->state == LINE ? 0 : findUnlabelled(pixel, step);
            for (; reached; reached &= reached - 1)
            {
                const int k = int(trailingZeros32(reached));
                pixel[offsets[k]].state = IN_QUEUE;
                queues.push(batch[i] + offsets[k], pixel->distance(k));
            }
        }
    }
}

void floodFromMarkers(PixelMap& pixels, PixelQueue& queues)
{
    CV_TRACE_FUNCTION();
    queues.clear();
    fillQueues(pixels, queues);
    flood(pixels.data(), pixels.step(), queues);
}

}}} // namespace
