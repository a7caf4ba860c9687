// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/region_choice.hpp"

namespace cv { namespace ximgproc { namespace gws {

RegionChoice::RegionChoice(const FeatureMap& features, const Padded<int>& labels, const Padded<uchar>& masks,
                           const Regions& regions, const RegionDistance& distance, int length_price)
    : table_(maskTable()), features_(features.data()), labels_(labels.data()), masks_(masks.data()),
      means_(regions.means.data()), surfaces_(regions.surfaces.means.data()), map_(features),
      distance_(distance), step_(labels.step())
{
    const int offsets[8] = { -step_ - 1, -step_, -step_ + 1, 1, step_ + 1, step_, step_ - 1, -1 };
    for (int mask = 0; mask < 256; mask++)
    {
        const int others = ~mask & 255;
        savings_[mask] = length_price * table_.agreement(mask);
        // No region saves more boundary than with all neighbours that do not agree.
        const int most = length_price * table_.agreement(others);
        bounds_[mask] = table_.canLeave(mask) ? savings_[mask] - most : INT_MAX;
        first_offsets_[mask] = offsets[table_.first(others & MaskTable::FOUR_NEIGHBORS)];
        last_offsets_[mask] = offsets[table_.last(others & MaskTable::FOUR_NEIGHBORS)];
    }
}

//! The region of the neighbour that a mask gives the offset of; any one if there is none.
int RegionChoice::neighborOf(int pixel, const int* offsets) const
{
    return std::max(labels_[pixel + offsets[masks_[pixel]]], 0);
}

//! Squared distances of pixels to some regions.
template <RegionChoice::Content CONTENT, typename RegionOf>
void RegionChoice::measure(const int* pixels, int n, int y, const RegionOf& regionOf, int* squares) const
{
    const Normal* row_normals = CONTENT == SURFACE ? map_.normalsOfRow(y) : 0;
    const ptrdiff_t first = map_.index(Point(0, y));
    const int normal_shift = map_.normal_shift;
    const RegionDistance distance = distance_; // a copy of its own does not change when squares are written
    for (int i = 0; i < n; i += 4)
    {
        const Feature* features[4];
        const RegionMean* means[4];
        const SurfaceMean* surfaces[4] = {};
        const Normal* normals[4] = {};
        for (int k = 0; k < 4; k++)
        {
            const ptrdiff_t pixel = pixels[i + k], region = regionOf(int(pixel));
            features[k] = features_ + pixel;
            means[k] = means_ + region;
            if (CONTENT >= PLANE)
                surfaces[k] = surfaces_ + region;
            if (CONTENT == SURFACE)
                normals[k] = row_normals + ((pixel - first) >> normal_shift);
        }
        const v_int32x4 x = subtract(v_load(pixels + i), v_setall_s32(int(first)));
        v_store(squares + i, CONTENT >= PLANE
            ? distance.squared<CONTENT == SURFACE>(features, normals, means, surfaces, x, y)
            : distance.squared<CONTENT == DEPTH>(features, means));
    }
}

int RegionChoice::squaredDistance(int pixel, int y, int region) const
{
    const Feature& feature = features_[pixel];
    const RegionMean& mean = means_[region];
    if (!distance_.with_surfaces)
        return distance_.squared(feature, mean);
    const Point p(pixel - map_.index(Point(0, y)), y);
    return distance_.squared(feature, map_.normalAt(p), mean, surfaces_[region], p);
}

//! The pixels that are so far from the mean of their own region that another one may win them.
template <RegionChoice::Content CONTENT>
void RegionChoice::keepDistant(const int* pixels, int n, int y, OpenPixels& open) const
{
    if (CONTENT == SURFACE) // pixels behind the last one may be of another row, and have no normal in this one
    {
        std::copy_n(pixels, n, open.indices);
        std::fill_n(open.indices + n, int(OpenPixels::NUM_BEHIND), pixels[0]);
        pixels = open.indices;
    }
    measure<CONTENT>(pixels, n, y, [&](int pixel) { return labels_[pixel]; }, open.first);
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        const int pixel = pixels[i], slack = open.first[i] - bounds_[masks_[pixel]];
        open.indices[count] = pixel;
        open.slack[count] = slack;
        count += slack > 0;
    }
    open.count = count;
}

//! Of these, those that the region of the first neighbour may win, or those beside several regions, or tips.
template <RegionChoice::Content CONTENT> void RegionChoice::keepNearFirst(int y, OpenPixels& open) const
{
    measure<CONTENT>(open.indices, open.count, y, [&](int pixel) { return neighborOf(pixel, first_offsets_); },
                     open.first);
    const int n = open.count;
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        const int index = open.indices[i], slack = open.slack[i], square = open.first[i], mask = masks_[index];
        const bool several = labels_[index + first_offsets_[mask]] != labels_[index + last_offsets_[mask]];
        open.indices[count] = index;
        open.slack[count] = slack;
        open.first[count] = square;
        count += (square < slack) | several | table_.isTip(mask);
    }
    open.count = count;
}

//! Of these, those that the first or the last region may win, or tips, which may have a third one.
template <RegionChoice::Content CONTENT> void RegionChoice::keepNearLast(int y, OpenPixels& open) const
{
    measure<CONTENT>(open.indices, open.count, y, [&](int pixel) { return neighborOf(pixel, last_offsets_); },
                     open.last);
    const int n = open.count;
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        const int index = open.indices[i], slack = open.slack[i], first = open.first[i], last = open.last[i];
        open.indices[count] = index;
        open.slack[count] = slack;
        open.first[count] = first;
        open.last[count] = last;
        count += (first < slack) | (last < slack) | table_.isTip(masks_[index]);
    }
    open.count = count;
}

//! Most pixels lie near to the mean of their region, and most others far from that of the one beside it. They are
//! passed over here, in loops without branches, because no processor can predict which they are: each pixel is written,
//! and the next one overwrites it if it is not kept.
template <RegionChoice::Content CONTENT>
void RegionChoice::findOpen(const int* pixels, int n, int y, OpenPixels& open) const
{
    keepDistant<CONTENT>(pixels, n, y, open);
    std::fill_n(open.indices + open.count, int(OpenPixels::NUM_BEHIND), pixels[0]);
    keepNearFirst<CONTENT>(y, open);
    std::fill_n(open.indices + open.count, int(OpenPixels::NUM_BEHIND), pixels[0]);
    keepNearLast<CONTENT>(y, open);
}

void RegionChoice::compare(int pixel, int square, Choice& choice) const
{
    const int* label = labels_ + pixel;
    const int region = label[first_offsets_[choice.seen]], mask = table_.neighborMask(label, step_, region);
    const int energy = square - savings_[mask];
    const int better = -int((energy < choice.energy) & (region >= 0)); // all bits
    choice.region ^= (choice.region ^ region) & better;
    choice.mask ^= (choice.mask ^ mask) & better;
    choice.energy ^= (choice.energy ^ energy) & better;
    choice.seen |= mask;
}

//! The region of the first neighbour of each pixel.
void RegionChoice::compareFirst(const OpenPixels& open, Choices& choices) const
{
    choices.num_unfinished = 0;
    for (int i = 0; i < open.count; i++)
    {
        const int pixel = open.indices[i], mask = masks_[pixel];
        // Its own square less what it saves: slack is more by what the others could save.
        Choice choice = { labels_[pixel], mask, open.slack[i] - savings_[~mask & 255], mask };
        compare(pixel, open.first[i], choice);
        choices.of[i] = choice;
        choices.unfinished[choices.num_unfinished] = i;
        choices.num_unfinished += !choice.seesAll();
    }
}

//! The regions of the others, which few pixels have.
void RegionChoice::compareOthers(const OpenPixels& open, int y, Choices& choices) const
{
    for (int i = 0; i < choices.num_unfinished; i++)
    {
        const int k = choices.unfinished[i], pixel = open.indices[k], *label = labels_ + pixel;
        const int last = label[last_offsets_[masks_[pixel]]];
        Choice& choice = choices.of[k];
        do
        {
            const int region = label[first_offsets_[choice.seen]];
            const int square = region == last ? open.last[k] : squaredDistance(pixel, y, std::max(region, 0));
            compare(pixel, square, choice);
        }
        while (!choice.seesAll());
    }
}

int RegionChoice::findGains(const int* pixels, int n, int y, Gain* gains) const
{
    OpenPixels open;
    if (distance_.with_surfaces && distance_.normal_share > 0)
        findOpen<SURFACE>(pixels, n, y, open);
    else if (distance_.with_surfaces)
        findOpen<PLANE>(pixels, n, y, open);
    else if (distance_.with_depth)
        findOpen<DEPTH>(pixels, n, y, open);
    else
        findOpen<COLOR>(pixels, n, y, open);

    Choices choices;
    compareFirst(open, choices);
    compareOthers(open, y, choices);
    int count = 0;
    for (int i = 0; i < open.count; i++)
    {
        const Gain gain = { open.indices[i], choices.of[i].region, choices.of[i].mask };
        gains[count] = gain;
        count += gain.region != labels_[gain.pixel];
    }
    return count;
}

}}} // namespace
