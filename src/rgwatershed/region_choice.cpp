// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/region_choice.hpp"

namespace cv { namespace ximgproc { namespace gws {

RegionChoice::RegionChoice(const FeatureMap& features, const Padded<int>& labels, const Padded<uchar>& masks,
                           const Regions& regions, const RegionDistance& distance, int length_price)
    : table_(maskTable()), features_(features.data()), labels_(labels.data()), masks_(masks.data()),
      means_(regions.means.data()), map_(features), surfaces_(regions.surfaces.means.data()),
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

int RegionChoice::squaredDistance(int pixel, const Row& row, int region) const
{
    if (!distance_.with_surfaces)
        return distance_.squared(features_[pixel], means_[region]);
    return distance_.squared(features_[pixel], meanAt(region, pixel, row),
                             row.normals ? ofNormals(region, pixel, row) : 0);
}

//! Most pixels lie near to the mean of their region, and most others far from that of the one beside it. They are
//! passed over here, in loops without branches, because no processor can predict which they are.
template <bool WITH_DEPTH, bool ON_PLANES, bool WITH_NORMALS>
void RegionChoice::findOpen(const int* pixels, int n, const Row& row, OpenPixels& open) const
{
    Feature* const features = open.features;
    RegionMean* const means = open.means;
    uchar several[BATCH]; // other regions
    for (int i = 0; i < n; i++)
    {
        features[i] = features_[pixels[i]];
        const int own = labels_[pixels[i]];
        means[i] = ON_PLANES ? meanAt(own, pixels[i], row) : means_[own];
        if (WITH_NORMALS)
            open.squares[i] = ofNormals(own, pixels[i], row);
    }
    for (int i = n; i % 4 != 0; i++) // distances are taken four at a time
    {
        open.squares[i] = 0;
        features[i] = features[n - 1];
        means[i] = means[n - 1];
    }
    distance_.squared<WITH_DEPTH, WITH_NORMALS>(features, means, n, open.squares);
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        const int pixel = pixels[i], slack = open.squares[i] - bounds_[masks_[pixel]];
        features[count] = features[i];
        open.indices[count] = pixel;
        open.slack[count] = slack;
        count += slack > 0;
    }

    for (int i = 0; i < count; i++)
    {
        const int mask = masks_[open.indices[i]], *label = labels_ + open.indices[i];
        const int first = label[first_offsets_[mask]], last = label[last_offsets_[mask]];
        const int other = first & ~(first >> 31);
        means[i] = ON_PLANES ? meanAt(other, open.indices[i], row) : means_[other];
        if (WITH_NORMALS)
            open.squares[i] = ofNormals(other, open.indices[i], row);
        several[i] = uchar((first != last) | table_.isTip(mask));
    }
    distance_.squared<WITH_DEPTH, WITH_NORMALS>(features, means, count, open.squares);
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

int RegionChoice::findGains(const int* pixels, int n, int y, Gain* gains) const
{
    OpenPixels open;
    const bool with_normals = distance_.with_surfaces && distance_.normal_share > 0;
    const Row row = { y, (y + 1) * step_ + 1,
                      with_normals ? map_.normals.ptr<Normal>(y >> map_.normal_shift) : 0 };
    if (with_normals)
        findOpen<true, true, true>(pixels, n, row, open);
    else if (distance_.with_surfaces)
        findOpen<true, true, false>(pixels, n, row, open);
    else if (distance_.with_depth)
        findOpen<true, false, false>(pixels, n, row, open);
    else
        findOpen<false, false, false>(pixels, n, row, open);

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
            compare(pixel, squaredDistance(pixel, row, std::max(region, 0)), choice);
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
