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
        most_savings_[mask] = length_price * table_.agreement(others);
        bounds_[mask] = table_.canLeave(mask) ? savings_[mask] - most_savings_[mask] : INT_MAX;
        first_offsets_[mask] = offsets[table_.first(others & MaskTable::FOUR_NEIGHBORS)];
        last_offsets_[mask] = offsets[table_.last(others & MaskTable::FOUR_NEIGHBORS)];
    }
}

//! Most pixels lie near to the mean of their region, and most others far from that of the one beside it. They are
//! passed over here, in loops without branches: no one could foresee which they are.
template <bool WITH_DEPTH> int RegionChoice::findOpenWith(const int* pixels, int n, OpenPixel* open) const
{
    Feature features[BATCH];
    RegionMean means[BATCH];
    int squares[BATCH];
    for (int i = 0; i < n; i++)
    {
        features[i] = features_[pixels[i]];
        means[i] = means_[labels_[pixels[i]]];
    }
    distance_.squared<WITH_DEPTH>(features, means, n, squares);
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        const int mask = masks_[pixels[i]];
        const OpenPixel pixel = { pixels[i], squares[i] - savings_[mask], 0 };
        open[count] = pixel;
        features[count] = features[i];
        count += squares[i] > bounds_[mask];
    }

    for (int i = 0; i < count; i++)
    {
        const int* label = labels_ + open[i].index;
        means[i] = means_[std::max(label[first_offsets_[masks_[open[i].index]]], 0)];
    }
    distance_.squared<WITH_DEPTH>(features, means, count, squares);
    int num_open = 0;
    for (int i = 0; i < count; i++)
    {
        const OpenPixel pixel = { open[i].index, open[i].energy, squares[i] };
        const int mask = masks_[pixel.index];
        const int* label = labels_ + pixel.index;
        open[num_open] = pixel;
        const bool several = (label[first_offsets_[mask]] != label[last_offsets_[mask]]) | table_.isTip(mask);
        num_open += (squares[i] - most_savings_[mask] < pixel.energy) | several;
    }
    return num_open;
}

int RegionChoice::findOpen(const int* pixels, int n, OpenPixel* open) const
{
    return distance_.with_depth ? findOpenWith<true>(pixels, n, open) : findOpenWith<false>(pixels, n, open);
}

RegionChoice::Choice RegionChoice::choose(const OpenPixel& pixel) const
{
    const int* label = labels_ + pixel.index;
    Choice best = { *label, masks_[pixel.index] };
    int region = label[first_offsets_[best.mask]], seen = best.mask, lowest = pixel.energy, square = pixel.square;
    while (true)
    {
        const Choice other = { region, neighborMask(label, step_, region) };
        const int energy = square - savings_[other.mask];
        const bool better = (energy < lowest) & (region >= 0);
        best = better ? other : best;
        lowest = better ? energy : lowest;
        seen |= other.mask;
        if (!(~seen & MaskTable::FOUR_NEIGHBORS))
            return best;
        region = label[first_offsets_[seen]];
        square = distance_.squared(features_[pixel.index], means_[std::max(region, 0)]);
    }
}

}}} // namespace
