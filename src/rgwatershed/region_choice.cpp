// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/region_choice.hpp"

namespace cv { namespace ximgproc { namespace gws {

RegionChoice::RegionChoice(const FeatureMap& features, const Padded<int>& labels, const Padded<uchar>& masks,
                           const Regions& regions, const RegionDistance& distance, int length_price)
    : table_(maskTable()), features_(features.data()), labels_(labels.data()), masks_(masks.data()),
      means_(regions.means.data()), normals_(features.normals.data()),
      surfaces_(regions.surfaces.data()), distance_(distance), step_(labels.step())
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

//! Most pixels lie near to the mean of their region, and most others far from that of the one beside it. They are
//! passed over here, in loops without branches, because no processor can predict which they are.
template <RegionDistance::Content CONTENT> void RegionChoice::findOpen(const int* pixels, int n, Point row, OpenPixels& open) const
{
    Feature* const features = open.features;
    RegionMean* const means = open.means;
    uchar several[BATCH]; // other regions
    for (int i = 0; i < n; i++)
    {
        features[i] = features_[pixels[i]];
        means[i] = means_[labels_[pixels[i]]];
    }
    for (int i = n; i % 4 != 0; i++) // distances are taken four at a time
    {
        features[i] = features[n - 1];
        means[i] = means[n - 1];
    }
    if (CONTENT == RegionDistance::NORMALS)
    {
        for (int i = 0; i < n; i++)
        {
            open.normals[i] = normals_[pixels[i]];
            open.surfaces[i] = surfaces_[labels_[pixels[i]]];
            open.squares[i] = distance_.squared(features[i], meanAt(means[i], open.surfaces[i], Point(pixels[i] - row.x, row.y)), open.normals[i], open.surfaces[i]);
        }
    }
    else
    distance_.squared<CONTENT != RegionDistance::COLOR>(features, means, n, open.squares);
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        const int pixel = pixels[i], slack = open.squares[i] - bounds_[masks_[pixel]];
        features[count] = features[i];
        if (CONTENT == RegionDistance::NORMALS)
            open.normals[count] = open.normals[i];
        open.indices[count] = pixel;
        open.slack[count] = slack;
        count += slack > 0;
    }

    for (int i = 0; i < count; i++)
    {
        const int mask = masks_[open.indices[i]], *label = labels_ + open.indices[i];
        const int first = label[first_offsets_[mask]], last = label[last_offsets_[mask]];
        means[i] = means_[first & ~(first >> 31)];
        if (CONTENT == RegionDistance::NORMALS)
            open.surfaces[i] = surfaces_[first & ~(first >> 31)];
        several[i] = uchar((first != last) | table_.isTip(mask));
    }
    if (CONTENT == RegionDistance::NORMALS)
        for (int i = 0; i < count; i++)
            open.squares[i] = distance_.squared(features[i], meanAt(means[i], open.surfaces[i], Point(open.indices[i] - row.x, row.y)), open.normals[i], open.surfaces[i]);
    else
    distance_.squared<CONTENT != RegionDistance::COLOR>(features, means, count, open.squares);
    open.count = 0;
    for (int i = 0; i < count; i++)
    {
        const int index = open.indices[i], slack = open.slack[i], square = open.squares[i];
        open.indices[open.count] = index;
        open.slack[open.count] = slack;
        open.squares[open.count] = square;
        open.count += (square < slack) | several[i];
    }
}

void RegionChoice::compare(int pixel, int square, Choice& choice) const
{
    const int* label = labels_ + pixel;
    const int region = label[first_offsets_[choice.seen]], mask = neighborMask(label, step_, region);
    const int energy = square - savings_[mask];
    const int better = -int((energy < choice.energy) & (region >= 0)); // all bits
    choice.region ^= (choice.region ^ region) & better;
    choice.mask ^= (choice.mask ^ mask) & better;
    choice.energy ^= (choice.energy ^ energy) & better;
    choice.seen |= mask;
}

int RegionChoice::findGains(const int* pixels, int n, Point row, Gain* gains) const
{
    OpenPixels open;
    if (distance_.content == RegionDistance::NORMALS)
        findOpen<RegionDistance::NORMALS>(pixels, n, row, open);
    else if (distance_.with_depth)
        findOpen<RegionDistance::DEPTH>(pixels, n, row, open);
    else
        findOpen<RegionDistance::COLOR>(pixels, n, row, open);

    Choice choices[BATCH];
    int unfinished[BATCH], num_unfinished = 0;
    for (int i = 0; i < open.count; i++)
    {
        const int pixel = open.indices[i], mask = masks_[pixel];
        Choice choice = { labels_[pixel], mask, open.slack[i] - savings_[~mask & 255], mask };
        compare(pixel, open.squares[i], choice);
        choices[i] = choice;
        unfinished[num_unfinished] = i;
        num_unfinished += (~choice.seen & MaskTable::FOUR_NEIGHBORS) != 0;
    }
    for (int i = 0; i < num_unfinished; i++)
    {
        Choice& choice = choices[unfinished[i]];
        const int pixel = open.indices[unfinished[i]], *label = labels_ + pixel;
        do
        {
            const int region = label[first_offsets_[choice.seen]];
            compare(pixel, distance_.content == RegionDistance::NORMALS ? distance_.squared(features_[pixel], meanAt(means_[std::max(region, 0)], surfaces_[std::max(region, 0)], Point(pixel - row.x, row.y)), normals_[pixel], surfaces_[std::max(region, 0)]) : distance_.squared(features_[pixel], means_[std::max(region, 0)]), choice);
        }
        while (~choice.seen & MaskTable::FOUR_NEIGHBORS);
    }

    int count = 0;
    for (int i = 0; i < open.count; i++)
    {
        const Gain gain = { open.indices[i], choices[i].region, choices[i].mask };
        gains[count] = gain;
        count += gain.region != labels_[gain.pixel];
    }
    return count;
}

}}} // namespace
