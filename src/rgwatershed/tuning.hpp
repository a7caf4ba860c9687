// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_TUNING_HPP
#define OPENCV_GWATERSHED_TUNING_HPP

#include "shared/merge_rules.hpp"
#include "shared/parameters.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Constants found on one half of the photographs of BSDS500's train split and checked on the other, the last ones of
// merging on all; doc/log.md has the figures.

enum { MAX_LEVEL = 2 };                        // of the pyramid; the blocks of the last one that is made are flooded
enum { SUPERPIXELS_FOR_CUT_OFF = 16 };         // for each begun so many, blocks may cut off one piece of a mask at most
static const double REGIONS_WITH_BUFFERS = 0.06; // for each pixel; for more of them, as small superpixels have, buffers
                                               // of merging would be most of the memory: not kept
enum { EDGE_STEP = 64 };                       // levels, as the flood counts them: more from one neighbour of a block
static const float EDGE_ASIDE = 0.05f;         // to the other is an edge, if the block lies no farther than this part
                                               // of it from the straight line between their colours
enum { GRADIENT_STEP_LOG2 = 5 };               // gradients of blocks are told apart in steps of 32 grey levels, so that
                                               // markers leave the centres of their cells for real edges only
enum { MEAN_GROWTH = 4 };                      // a mean is taken again when its region has grown by 1 / MEAN_GROWTH
static const double FLOOD_RULER = 0.4;         // priority in grey levels, by ruler, one grid step from the marker
static const int USUAL_FLOOD_AREA = 4;         // of a region, in mean areas; larger ones come last
static const double MOST_AREA = 3.1;           // of a superpixel, in mean areas, that still gains blocks or pixels
static const double MOST_AREA_IN_TWO = 2.8;    // the same where two sweeps of the pixels follow the blocks
static const int SWEEPS_OF_BLOCKS = 2;         // on each level between the blocks that are flooded and the pixels
static const int SWEEPS_PER_ITERATION = 2;     // of pixels, for each iteration after the first
static const int ITERATIONS_WITH_TIES = 16;    // then, depth alone moves no pixel any more: some would go to and fro

// For video: sweeps of blocks that move the regions along, and the squared error of a region,
// for what it was when it was made and for each of its blocks, from which on it has changed.
static const int SWEEPS_TO_TRACK = 3;
static const int ERROR_GROWTH = 2, ERROR_FLOOR = 32;

// Weights of lightness and of the colour differences, in 1/256. Lightness varies most within
// things, by shading, so it leads less in finding regions than in settling their boundaries.
static const int FLOOD_LIGHTNESS = 112, FLOOD_CHROMA = 256;
static const int SWEEP_LIGHTNESS = 146, SWEEP_CHROMA = 336;

// How much more depth and normals count beside colour than depth alone does, and the levels of depth that one of the
// 127 levels of a normal is worth. Found on one half of the frames of mOSD.
static const float SURFACE_TRUST = 2, NORMAL_SCALE = 1.3f;

// Price of boundary, in squared levels for a quarter of an edge: at ruler 10, for superpixels of a
// side of 17 pixels. It grows with their area, so that small superpixels may follow the image as well.
static const double PRICE = 22, SIDE_OF_PRICE = 17;

//! What the effort that the user sets stands for: how fine the flood starts, and what is merged where.
struct EffortRules
{
    double blocks_for_side, most_blocks; //!< for each superpixel at least so many, by its side in pixels, up to a limit
    double enough_blocks;        //!< so many of 2x2 pixels do, or pixels would take ten times the time for little more
    int markers;                 //!< for each superpixel, at most
    double pixels_for_marker;    //!< no more markers than one for so many pixels, but one for each superpixel
    double price_before_merging; //!< of boundary
    double regions_on_pixels;    //!< for each superpixel: so many are settled to the pixels, and merged there
};

inline const EffortRules& effortRules(int effort)
{
    static const EffortRules RULES[] = { { 0.6, 12, 12, 2, 18, 0.5, 1 },
                                         { 0.88, 12, 12, 4, 18, 0.5, 1 },
                                         { 2.4, 45, 3, 8, 3, 10, 1 },
                                         { 2.4, 45, 3, 10, 3, 10, 3 } };
    return RULES[effort];
}

//! Rows of blocks that are flooded by themselves, at least: several superpixels, so that few lie at a border.
inline int floodBandHeight(double blocks, int num_superpixels)
{
    const int FEWEST = 16, SUPERPIXELS = 6;
    return int(std::max<double>(FEWEST, SUPERPIXELS * std::sqrt(blocks / num_superpixels)));
}

//! For a price at ruler 10.
inline int boundaryPrice(double price, float ruler)
{
    const double PART_WITHOUT_RULER = 0.08;
    return cvRound(std::min(price * (PART_WITHOUT_RULER + (1 - PART_WITHOUT_RULER) * ruler / 10), 1e6));
}

inline int boundaryPrice(double price, double side, float ruler)
{
    return boundaryPrice(price * std::min(std::max(side * side / (SIDE_OF_PRICE * SIDE_OF_PRICE), 0.25), 4.), ruler);
}

//! Whether the buffers of merging so many regions are too large to be kept.
inline bool hasLargeMergeBuffers(int num_regions, int num_pixels)
{
    return num_regions > REGIONS_WITH_BUFFERS * num_pixels;
}

//! Exponent of the length of common boundaries. Long ones make compact superpixels, so they count as much as the ruler
//! asks for.
inline int mergeLength(float ruler) { return cvRound(13 + 34 * std::min(ruler / 10, 1.f)); }

//! Below it, superpixels have few blocks.
static const int FEW_BLOCKS = 12;

//! Whether blocks astride of an edge take a side, but in a video, where the next frame would move them back. Where
//! superpixels have few blocks, each is needed as it is; depth of blocks is that of a side already.
inline bool takesSides(double blocks_per_superpixel, const RegionDistance& distance)
{
    return blocks_per_superpixel >= FEW_BLOCKS && !distance.with_depth;
}

//! Merging of regions of blocks.
inline MergeRules mergeRules(float ruler, double blocks_per_superpixel, int side_of_blocks)
{
    MergeRules rules;
    rules.distance = rules.with_depth = 56;
    rules.areas = 92;
    rules.contrast = 50;
    rules.length = mergeLength(ruler);
    rules.lightness = blocks_per_superpixel < FEW_BLOCKS ? 10 : 28; // shading varies less within small ones
    rules.brightness = 42;
    rules.slope = rules.slope_in_cell = -24;
    rules.grain = side_of_blocks > 2 ? 1.5f : 2.5f; // means of fewer pixels have more of it
    rules.rounding = 0.15f; // of blocks, so of few values
    rules.uneven = 0.3f;
    rules.chroma_slope = 1.75f;
    rules.roughness = 128;
    rules.usual = 3;
    rules.grow = true;
    const float part_of_textures = 10 / std::max(ruler, 10.f); // compactness instead where that is asked for
    rules.texture = cvRound(20 * part_of_textures);
    rules.direction = cvRound(45 * part_of_textures);
    rules.mixed = 192;
    // Larger ones make superpixels of even areas squares.
    rules.noise = cvRound(80 + 6 * std::min(std::max(ruler, 10.f), 40.f));
    return rules;
}

//! Merging of what has changed in a video, where the first regions are kept. Parts of even areas must unite before any
//! of these do: textures, which the noise of a camera is, too, would make unions of kept regions the cheapest.
inline MergeRules trackedMergeRules(const MergeRules& of_images, int num_kept)
{
    MergeRules rules = of_images;
    rules.num_kept = num_kept;
    rules.texture = rules.direction = rules.mixed = 0;
    rules.noise *= 2;
    return rules;
}

//! The last merging where there is one of pixels: by textures, and with the compactness that the ruler asks for. What
//! lies around counts less than for mergeSimilar(): it costs explained variation.
inline MergeRules pixelMergeRules(float ruler, bool with_depth)
{
    MergeRules rules = mergeByTextures();
    rules.texture = 66; // noise and few levels are textures, too
    rules.usual = 3.2f; // 4 of 7900 random boards and stripes have a superpixel above 4 mean areas (4.4)
    if (with_depth)
    {
        rules.length = 56; // depth is even over large parts, and says nothing of shapes there
    }
    else
    {
        rules.spread = 8;
        rules.spread_texture = 12;
        rules.distance = 32;
    }
    rules.length = cvRound(double(rules.length + 2) * mergeLength(ruler) / mergeLength(10));
    return rules;
}

//! How many blocks a number of superpixels must keep: more if their boundary may be irregular, fewer where superpixels
//! are small, because a smaller block is not much better than what the sweeps of pixels make of it.
inline double fewestBlocks(int num_pixels, int num_superpixels, float ruler, const EffortRules& effort)
{
    const double side = std::sqrt(double(num_pixels) / num_superpixels);
    const double regular = std::min(effort.blocks_for_side * side, effort.most_blocks);
    const double fewest = num_superpixels * std::max(regular * (2 - std::min(ruler / 10, 1.f)), 1.);
    const double of_2x2 = 0.9 * num_pixels / 4; // at least, also where a mask cuts some off
    return of_2x2 < num_superpixels * effort.enough_blocks ? fewest : std::min(fewest, of_2x2);
}

//! The flood makes as many regions for each superpixel, which are merged. Few blocks do not make many regions worth it.
//! The smallest superpixels, below 6x6 pixels with effort 0 and 1, are what the flood makes of one marker: merging
//! would take most of the time, and they follow the image as they are.
inline int markersPerSuperpixel(double blocks_per_superpixel, double pixels_per_superpixel, const EffortRules& effort)
{
    const int BLOCKS_FOR_MARKER = 5;
    const int wanted = blocks_per_superpixel < 8 ? 2 : blocks_per_superpixel < 12 ? 3
                     : std::max(4, int(std::min(blocks_per_superpixel / BLOCKS_FOR_MARKER, 1e6)));
    const int most = int(std::max(std::min(pixels_per_superpixel / effort.pixels_for_marker, 1e6), 1.));
    const int markers = std::min(std::min(wanted, most), effort.markers);
    return markers == 5 || markers == 7 ? markers - 1 : markers; // parts of a cell would be strips
}

//! Sweeps of the blocks that were flooded, and the price of boundary from then on, in parts of PRICE.
struct BlockSweeps
{
    int before_merging, after_merging;
    double price;
};

//! One at least after merging, or regions keep blocks that hang over an edge. Where superpixels have few blocks, one
//! before it takes a tenth of the time; some more after it, which look at little, and less price do nearly the same.
inline BlockSweeps sweepsOfBlocks(double blocks_per_superpixel, int markers_per_superpixel)
{
    const BlockSweeps usual = { markers_per_superpixel < 4 ? 1 : 2, 1, 1 }, of_few = { 0, 3, 0.7 };
    return blocks_per_superpixel < FEW_BLOCKS && markers_per_superpixel > 1 ? of_few : usual;
}

//! Sweeps of the pixels. Between blocks of 3x3 and the pixels there is no level, and one sweep leaves rows of pixels
//! beside a line where they were. So there are two, but below 12x12 pixels, where they would take too long. A smaller
//! ruler may ask for smaller blocks. These have two as well where the larger ones have two, or 4x4 pixels, whose
//! superpixels are swept on a level between: else superpixels would be more compact with the smaller ruler.
inline int sweepsOfPixels(int side_of_blocks, double pixels_per_region, const EffortRules& effort)
{
    const double LARGE = 132, enough = effort.blocks_for_side * std::sqrt(pixels_per_region);
    const bool has_room_for_3 = pixels_per_region >= std::max(LARGE, 9 * std::min(enough, effort.most_blocks));
    const bool has_room_for_4 = pixels_per_region >= 16 * std::min(enough, 12.);
    const bool two = side_of_blocks == 2 ? has_room_for_3 : side_of_blocks == 3 && (has_room_for_3 || has_room_for_4);
    return two ? 2 : 1;
}

//! With normals, depth is measured against planes, so both are trusted more beside colour.
inline RegionDistance makeDistance(int lightness, int chroma, const Parameters& parameters, bool with_depth,
                                   bool with_normals)
{
    if (!with_normals)
        return RegionDistance(lightness, chroma, parameters.alpha, with_depth);
    const float color = parameters.alpha, surface = SURFACE_TRUST * (1 - parameters.alpha);
    RegionDistance distance(lightness, chroma, color / (color + surface), with_depth);
    distance.addSurfaces(parameters.normal_weight, NORMAL_SCALE);
    return distance;
}

//! The distance that leads in finding regions.
inline RegionDistance floodDistance(const Parameters& parameters, bool with_depth, bool with_normals)
{
    return makeDistance(FLOOD_LIGHTNESS, FLOOD_CHROMA, parameters, with_depth, with_normals);
}

//! The distance that leads in settling boundaries.
inline RegionDistance sweepDistance(const Parameters& parameters, bool with_depth, bool with_normals)
{
    return makeDistance(SWEEP_LIGHTNESS, SWEEP_CHROMA, parameters, with_depth, with_normals);
}

}}} // namespace

#endif
