// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "gwatershed/pixel_flood.hpp"
#include "shared/mask_pyramid.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Lines 4 to 14: the pixels beside a marker are queued at the priority of equation (4).
static void fillQueues(PixelMap& map, const Mat& gradient, float border_threshold, int alpha,
                       PixelQueue& queues)
{
    FloodPixel* pixels = map.data();
    const Vec4i neighbors = map.neighbors();
    const int threshold = border_threshold > 0 ? cvCeil(std::min(border_threshold, 65535.f)) : 65535;
    for (int y = 0; y < gradient.rows; y++)
    {
        const ushort* gradient_row = gradient.ptr<ushort>(y);
        for (int x = 0, p = map.index(Point(0, y)); x < gradient.cols; x++, p++)
        {
            FloodPixel& pixel = pixels[p];
            const bool is_line = (pixel.state == UNLABELLED) & (gradient_row[x] >= threshold) &
                                 (gradient_row[x] != UNKNOWN_GRADIENT);
            pixel.state = is_line ? int(LINE) : pixel.state;
            const int label = std::max(std::max(pixels[p + neighbors[0]].state, pixels[p + neighbors[1]].state),
                                       std::max(pixels[p + neighbors[2]].state, pixels[p + neighbors[3]].state));
            if (label <= 0 || pixel.state != UNLABELLED)
                continue;
            int priority = INT_MAX;
            for (int k = 0; k < 4; k++)
            {
                const FloodPixel& neighbor = pixels[p + neighbors[k]];
                if (neighbor.state > 0)
                    priority = std::min(priority, distance(pixel.value, neighbor.value, alpha));
            }
            pixel.state = IN_QUEUE;
            queues.push(p, priority);
        }
    }
}

//! The label that the labelled neighbours of a queued pixel share, or LINE if they differ.
static inline int commonLabel(const FloodPixel* pixel, const Vec4i& neighbors)
{
    const int left = pixel[neighbors[0]].state, top = pixel[neighbors[1]].state;
    const int right = pixel[neighbors[2]].state, bottom = pixel[neighbors[3]].state;
    const int label = std::max(std::max(left, top), std::max(right, bottom));
    const bool differ = ((left > 0) & (left != label)) | ((top > 0) & (top != label)) |
                        ((right > 0) & (right != label)) | ((bottom > 0) & (bottom != label));
    return differ ? int(LINE) : label;
}

//! Reads the rows that some pixels of a batch will need. They lie anywhere in the image: so they are
//! fetched at the same time, instead of one after the other.
static void touchRows(const FloodPixel* pixels, int step, const std::vector<int>& batch, size_t begin, size_t end)
{
    for (size_t i = begin; i < std::min(end, batch.size()); i++)
        for (int row = -step; row <= step; row += step)
            touch(pixels[batch[i] + row].state);
}

//! Lines 15 to 36. Invariant: a pixel enters a queue once, from the first labelled neighbour that
//! is taken out; it gets its label, or becomes a line, when it is taken out itself. A pixel queued
//! below the current priority waits until the priorities begin again at 0, and one queued at that priority
//! goes behind those that are there. So the order of the queues alone decides, and neither lines nor
//! the frame pass the flood on.
static void flood(FloodPixel* pixels, const Vec4i& neighbors, int alpha, PixelQueue& queues, std::vector<int>& batch)
{
    const size_t AHEAD = 8;
    const int step = neighbors[3];
    while (queues.take(batch))
    {
        touchRows(pixels, step, batch, 0, AHEAD);
        for (size_t i = 0; i < batch.size(); i++)
        {
            if (i % AHEAD == 0)
                touchRows(pixels, step, batch, i + AHEAD, i + 2 * AHEAD);
            const int p = batch[i];
            FloodPixel& pixel = pixels[p];
            pixel.state = commonLabel(&pixel, neighbors);
            if (pixel.state == LINE)
                continue;
            for (int k = 0; k < 4; k++)
            {
                const int a = p + neighbors[k];
                if (pixels[a].state != UNLABELLED)
                    continue;
                pixels[a].state = IN_QUEUE;
                queues.push(a, distance(pixel.value, pixels[a].value, alpha));
            }
        }
    }
}

void floodFromMarkers(const Mat& gradient, float border_threshold, int alpha, PixelMap& pixels,
                      PixelFloodBuffers& buffers)
{
    CV_TRACE_FUNCTION();
    buffers.queues.clear();
    fillQueues(pixels, gradient, border_threshold, alpha, buffers.queues);
    flood(pixels.data(), pixels.neighbors(), alpha, buffers.queues, buffers.batch);
}

}}} // namespace
