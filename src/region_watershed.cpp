// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_watershed.hpp"
#include "region_steps.hpp"
#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Constants found on one half of the photographs of BSDS500's train split and checked on the other;
// doc/log.md has the figures.

static const int MARKERS_PER_SUPERPIXEL = 4;   // the flood makes as many regions, which are merged
static const int BLOCKS_PER_SUPERPIXEL = 12;   // at least, twice as many at ruler 0, or smaller blocks are flooded
static const double FLOOD_RULER = 0.4;         // height in levels, by ruler, one grid step from the marker
static const int SWEEPS_BEFORE_MERGING = 2;
static const int SWEEPS_OF_BLOCKS = 2;         // on each level between the flood and the pixels
static const int SWEEPS_OF_PIXELS = 1;
static const int SWEEPS_PER_ITERATION = 2;     // of pixels, for each iteration after the first

// Weights of lightness and of the colour differences, in 1/256. Lightness varies most within
// things, by shading, so it leads less in finding regions than in settling their boundaries.
static const int FLOOD_LIGHTNESS = 128, FLOOD_CHROMA = 256;
static const int SWEEP_LIGHTNESS = 150, SWEEP_CHROMA = 218;

// Price of boundary, in squared levels for a quarter of an edge: at ruler 10, for superpixels of a
// side of 17 pixels. It grows with their area, so that small superpixels may follow the image as well.
static const double PRICE_BEFORE_MERGING = 10, PRICE = 24;

static int boundaryPrice(double price, double side, float ruler)
{
    const double PART_WITHOUT_RULER = 0.1;
    const double scale = std::min(std::max(side * side / 289, 0.25), 4.);
    return cvRound(std::min(price * scale * (PART_WITHOUT_RULER + (1 - PART_WITHOUT_RULER) * ruler / 10), 1e6));
}

//! Weight of long common boundaries in merging, in 1/16: long ones make compact superpixels.
static int boundaryExponent(float ruler)
{
    return cvRound(4 + 8 * std::min(ruler / 10, 1.f));
}

//! How often the image is halved before it is flooded: a superpixel must keep enough blocks, and
//! more if its boundary may be irregular.
static int chooseLevel(Size size, int num_superpixels, float ruler, int max_level)
{
    const double blocks = BLOCKS_PER_SUPERPIXEL * (2 - std::min(ruler / 10, 1.f));
    int level = 0;
    while (level < max_level)
    {
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
        if (double(size.width) * size.height < num_superpixels * blocks)
            break;
        level++;
    }
    return level;
}

void RegionWatershed::reserve(Size size)
{
    for (int level = 0; level <= MAX_LEVEL; level++)
    {
        features_[level].reserve(size);
        labels_[level].reserve(size);
        size = Size((size.width + 1) / 2, (size.height + 1) / 2);
    }
}

void RegionWatershed::sweep(int level, int count, int length_price, const RegionDistance& distance,
                            VariationGuard* guard)
{
    for (int i = 0; i < count; i++)
        sweepBoundary(features_[level], distance, length_price, guard, labels_[level], regions_,
                      sweep_buffers_, boundary_);
}

//! More regions than asked for, merged to the number asked for: they are small where the image
//! varies and large where it does not.
void RegionWatershed::floodAndMerge(int level, int num_superpixels, double side, const Parameters& parameters)
{
    const Size size = features_[level].size();
    const double blocks = double(size.width) * size.height;
    const int num_markers = int(std::min(double(num_superpixels) * MARKERS_PER_SUPERPIXEL, blocks));
    const double ruler = 4096 * parameters.ruler * FLOOD_RULER / std::sqrt(blocks / num_markers);
    const RegionDistance distance(FLOOD_LIGHTNESS, FLOOD_CHROMA, parameters.alpha);

    computeGradient(features_[level], distance, gradient_);
    placeMarkers(gradient_, num_markers, markers_);
    floodRegions(features_[level], markers_, distance, cvRound(std::min(ruler, double(INT_MAX))),
                 flood_buffers_, labels_[level], regions_);
    listBoundary(labels_[level], boundary_);
    sweep(level, SWEEPS_BEFORE_MERGING, boundaryPrice(PRICE_BEFORE_MERGING, side, parameters.ruler), distance, 0);
    mergeSimilarRegions(num_superpixels, distance, boundaryExponent(parameters.ruler), merge_buffer_,
                        labels_[level], regions_);
}

void RegionWatershed::run(const Mat& color, const Mat& depth, const Parameters& parameters, int num_iterations,
                          Mat& labels)
{
    CV_TRACE_FUNCTION();
    const int num_superpixels = parameters.countSuperpixels(color.size());
    const double side = std::sqrt(double(color.total()) / num_superpixels);
    const int top = chooseLevel(color.size(), num_superpixels, parameters.ruler, MAX_LEVEL);

    makeFeatures(color, depth, parameters.uniform_color, features_[0]);
    for (int level = 1; level <= top; level++)
        halveFeatures(features_[level - 1], features_[level]);
    floodAndMerge(top, num_superpixels, side, parameters);

    const RegionDistance distance(SWEEP_LIGHTNESS, SWEEP_CHROMA, parameters.alpha);
    const int price = boundaryPrice(PRICE, side, parameters.ruler);
    for (int level = std::max(top - 1, 0); level >= 0; level--)
    {
        if (level < top)
            doubleLabels(labels_[level + 1], features_[level].size(), labels_[level]);
        measureRegions(features_[level], labels_[level], regions_);
        listBoundary(labels_[level], boundary_);
        sweep(level, level > 0 ? SWEEPS_OF_BLOCKS : SWEEPS_OF_PIXELS, price, distance, 0);
    }
    if (num_iterations > 1)
    {
        VariationGuard guard(color, labels_[0], num_superpixels);
        for (int i = 1; i < num_iterations && !boundary_.empty(); i++)
            sweep(0, SWEEPS_PER_ITERATION, price, distance, &guard);
    }

    labels.create(color.size(), CV_32SC1);
    for (int y = 0; y < labels.rows; y++)
        std::copy(labels_[0].row(y), labels_[0].row(y) + labels.cols, labels.ptr<int>(y));
}

}}} // namespace
