// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/region_choice.hpp"

namespace cv { namespace ximgproc { namespace gws {

RegionChoice::RegionChoice(const Padded<Feature>& features, const Padded<int>& labels, const Padded<uchar>& masks,
                           const std::vector<RegionMean>& means, const RegionDistance& distance, int length_price)
    : table_(maskTable()), features_(features.data()), labels_(labels.data()), masks_(masks.data()),
      means_(means.data()), distance_(distance), step_(labels.step())
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

//! Squared distances of pixels to the regions of some neighbours, of which a mask gives the offset.
template <bool WITH_DEPTH, typename Offset>
void RegionChoice::measure(const int* pixels, int n, const Offset& offset, int* squares) const
{
    for (int i = 0; i < n; i += 4)
    {
        const Feature* features[4];
        const RegionMean* means[4];
        for (int k = 0; k < 4; k++)
        {
            const int pixel = pixels[i + k], label = labels_[pixel + offset(masks_[pixel])];
            features[k] = features_ + pixel;
            means[k] = means_ + (label & ~(label >> 31));
        }
        v_store(squares + i, distance_.squared<WITH_DEPTH>(features, means));
    }
}

//! Most pixels lie near to the mean of their region, and most others far from that of the one beside it. They are
//! passed over here, in loops without branches, because no processor can predict which they are.
template <bool WITH_DEPTH> void RegionChoice::findOpen(const int* pixels, int n, OpenPixels& open) const
{
    measure<WITH_DEPTH>(pixels, n, [](int) { return 0; }, open.first);
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        const int pixel = pixels[i], slack = open.first[i] - bounds_[masks_[pixel]];
        open.indices[count] = pixel;
        open.slack[count] = slack;
        count += slack > 0;
    }

    std::fill_n(open.indices + count, 3, pixels[0]);
    measure<WITH_DEPTH>(open.indices, count, [&](int mask) { return first_offsets_[mask]; }, open.first);
    n = count;
    count = 0;
    for (int i = 0; i < n; i++)
    {
        const int index = open.indices[i], slack = open.slack[i], square = open.first[i], mask = masks_[index];
        const bool several = labels_[index + first_offsets_[mask]] != labels_[index + last_offsets_[mask]];
        open.indices[count] = index;
        open.slack[count] = slack;
        open.first[count] = square;
        count += (square < slack) | several | table_.isTip(mask);
    }

    std::fill_n(open.indices + count, 3, pixels[0]);
    measure<WITH_DEPTH>(open.indices, count, [&](int mask) { return last_offsets_[mask]; }, open.last);
    open.count = 0;
    for (int i = 0; i < count; i++)
    {
        const int index = open.indices[i], slack = open.slack[i], first = open.first[i], last = open.last[i];
        open.indices[open.count] = index;
        open.slack[open.count] = slack;
        open.first[open.count] = first;
        open.last[open.count] = last;
        open.count += (first < slack) | (last < slack) | table_.isTip(masks_[index]);
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

int RegionChoice::findGains(const int* pixels, int n, Gain* gains) const
{
    OpenPixels open;
    if (distance_.with_depth)
        findOpen<true>(pixels, n, open);
    else
        findOpen<false>(pixels, n, open);

    Choice choices[BATCH];
    int unfinished[BATCH], num_unfinished = 0;
    for (int i = 0; i < open.count; i++)
    {
        const int pixel = open.indices[i], mask = masks_[pixel];
        Choice choice = { labels_[pixel], mask, open.slack[i] - savings_[~mask & 255], mask };
        compare(pixel, open.first[i], choice);
        choices[i] = choice;
        unfinished[num_unfinished] = i;
        num_unfinished += (~choice.seen & MaskTable::FOUR_NEIGHBORS) != 0;
    }
    for (int i = 0; i < num_unfinished; i++)
    {
        Choice& choice = choices[unfinished[i]];
        const int pixel = open.indices[unfinished[i]], *label = labels_ + pixel;
        const int last = label[last_offsets_[masks_[pixel]]];
        do
        {
            const int region = label[first_offsets_[choice.seen]];
            const int square = region == last ? open.last[unfinished[i]]
                                              : distance_.squared(features_[pixel], means_[std::max(region, 0)]);
            compare(pixel, square, choice);
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
