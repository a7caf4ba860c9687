// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/region_choice.hpp"
#include "shared/bit_positions.hpp"

namespace cv { namespace ximgproc { namespace gws {

RegionChoice::RegionChoice(const FeatureMap& features, const Padded<int>& labels, const Padded<uchar>& masks,
                           const Regions& regions, const RegionDistance& distance, int length_price)
    : table_(maskTable()), features_(features.data()), labels_(labels.data()), masks_(masks.data()),
      means_(regions.means.data()), surfaces_(regions.surfaces.means.data()), map_(features),
      distance_(distance), step_(labels.step()), length_price_(length_price)
{
    const int offsets[8] = { -step_ - 1, -step_, -step_ + 1, 1, step_ + 1, step_, step_ - 1, -1 };
    for (int mask = 0; mask < 256; mask++)
    {
        savings_[mask] = length_price * table_.agreement(mask);
        // No region saves more boundary than with all neighbours that do not agree.
        const int most = length_price * table_.agreement(~mask & 255);
        // Tips may have three regions beside them, so they are always looked at.
        bounds_[mask] = !table_.canLeave(mask) ? INT_MAX : savings_[mask] - most - (table_.isTip(mask) ? ALWAYS : 0);
        first_others_[mask] = offsets[table_.first(mask)];
        last_others_[mask] = offsets[table_.last(mask)];
    }
}

//! Lists the numbers i below n where test(i), of four at once, is below 0. Returns how many.
template <typename Test> static inline int listWhere(int n, const Test& test, int* list)
{
    const int AT_ONCE = RegionChoice::AT_ONCE;
    const BitPositions& table = bitPositions();
    int* to = list;
    for (int i = 0; i < n; i += AT_ONCE)
    {
        const unsigned below = unsigned(v_signmask(test(i)) | v_signmask(test(i + AT_ONCE / 2)) << (AT_ONCE / 2));
        to = writePositions<0>(table, below & (255u >> std::max(i + AT_ONCE - n, 0)), i, to);
    }
    return int(to - list);
}

//! Of four elements from i on.
template <typename Of> static inline v_int32x4 gatherFour(int i, const Of& of)
{
    return v_int32x4(of(i), of(i + 1), of(i + 2), of(i + 3));
}

//! The squared distances of n pixels, and some behind them, to some regions.
template <RegionChoice::Content CONTENT, typename PixelOf, typename RegionOf>
void RegionChoice::measure(int n, int y, const PixelOf& pixelOf, const RegionOf& regionOf, int* squares) const
{
    const Normal* row_normals = CONTENT == SURFACE ? map_.normalsOfRow(y) : 0;
    const int row_start = CONTENT >= PLANE ? map_.index(Point(0, y)) : 0, normal_shift = map_.normal_shift;
    const RegionDistance distance = distance_; // a copy of its own does not change when something is written
    for (int i = 0; i < int(alignSize(n, AT_ONCE)); i += FOUR)
    {
        const Feature* features[FOUR];
        const RegionMean* means[FOUR];
        const SurfaceMean* surfaces[FOUR] = {};
        const Normal* normals[FOUR] = {};
        int places[FOUR] = {};
        for (int k = 0; k < FOUR; k++)
        {
            const ptrdiff_t pixel = pixelOf(i + k), region = regionOf(i + k);
            features[k] = features_ + pixel;
            means[k] = means_ + region;
            places[k] = int(pixel) - row_start;
            if (CONTENT >= PLANE)
                surfaces[k] = surfaces_ + region;
            if (CONTENT == SURFACE)
                normals[k] = row_normals + (places[k] >> normal_shift);
        }
        v_store(squares + i, CONTENT >= PLANE
            ? distance.squared<CONTENT == SURFACE>(features, normals, means, surfaces, v_load(places), y)
            : distance.squared<CONTENT == DEPTH>(features, means));
    }
}

//! Lists the pixels that are so far from the mean of their own region that another one may win them.
template <RegionChoice::Content CONTENT> int RegionChoice::listDistant(int n, int y, Batch& b) const
{
    measure<CONTENT>(n, y, [&](int i) { return b.pixels[i]; }, [&](int i) { return labels_[b.pixels[i]]; }, b.squares);
    return listWhere(n, [&](int i)
    {
        const v_int32x4 bounds = gatherFour(i, [&](int k) { return bounds_[masks_[b.pixels[k]]]; });
        const v_int32x4 slack = subtract(v_load(b.squares + i), bounds);
        v_store(b.slack + i, slack);
        return subtract(v_setzero_s32(), slack);
    }, b.distant);
}

//! Of these, those that the region of the first or of the last neighbour may win, or tips. Where these regions differ
//! there is no third one, but beside tips, and each of them has one of two 4-neighbours only.
template <RegionChoice::Content CONTENT> int RegionChoice::listContested(int n, int y, Batch& b) const
{
    const v_int32x4 less = v_setall_s32(2 * length_price_);
    std::fill_n(b.distant + n, int(AT_ONCE), 0);
    measure<CONTENT>(n, y, [&](int i) { return b.pixels[b.distant[i]]; }, [&](int i)
    {
        const int pixel = b.pixels[b.distant[i]], others = ~masks_[pixel] & MaskTable::FOUR_NEIGHBORS;
        const int* const label = labels_ + pixel;
        const int first = label[first_others_[others]];
        b.unseen[i] = others;
        b.differ[i] = -int(first != label[last_others_[others]]);
        return std::max(first, 0);
    }, b.squares);
    const int num_contested = listWhere(n, [&](int i)
    {
        const v_int32x4 slack = gatherFour(i, [&](int k) { return b.slack[b.distant[k]]; });
        const v_int32x4 excess = add(subtract(v_load(b.squares + i), slack), bitAnd(v_load(b.differ + i), less));
        v_store(b.excess + i, excess);
        return excess;
    }, b.contested);
    const int num_doubtful = listWhere(n, [&](int i)
    {
        return bitAnd(v_load(b.differ + i), subtract(v_setall_s32(-1), v_load(b.excess + i)));
    }, b.doubtful);
    return addContested<CONTENT>(num_doubtful, y, num_contested, b);
}

//! Adds to those that are contested the doubtful ones that the region of the last neighbour may win, and nothing else.
//! Returns how many there are then.
template <RegionChoice::Content CONTENT>
int RegionChoice::addContested(int n, int y, int num_contested, Batch& b) const
{
    const v_int32x4 less = v_setall_s32(2 * length_price_);
    int squares[Batch::SIZE], found[Batch::SIZE];
    std::fill_n(b.doubtful + n, int(AT_ONCE), 0);
    measure<CONTENT>(n, y, [&](int i) { return b.pixels[b.distant[b.doubtful[i]]]; }, [&](int i)
    {
        const int number = b.doubtful[i];
        return std::max(labels_[b.pixels[b.distant[number]] + last_others_[b.unseen[number]]], 0);
    }, squares);
    const int num_found = listWhere(n, [&](int i)
    {
        const v_int32x4 slack = gatherFour(i, [&](int k) { return b.slack[b.distant[b.doubtful[k]]]; });
        return add(subtract(v_load(squares + i), slack), less);
    }, found);
    for (int i = 0; i < num_found; i++)
    {
        const int number = b.doubtful[found[i]];
        b.squares[number] = squares[found[i]];
        b.unseen[number] &= b.unseen[number] - 1; // without the first
        b.contested[num_contested + i] = number;
    }
    return num_contested + num_found;
}

//! Four of the pixels that are left, in their own regions.
inline RegionChoice::FourChoices RegionChoice::begin(int i, const Batch& b) const
{
    int others[FOUR]; // neighbours that are not in the own region
    for (int k = 0; k < FOUR; k++)
        others[k] = ~masks_[b.pixels[b.distant[b.contested[i + k]]]] & 255;
    // The own square less what is saved: slack is more by what the others could save.
    const v_int32x4 slack = gatherFour(i, [&](int k) { return b.slack[b.distant[b.contested[k]]]; });
    const v_int32x4 saved = gatherFour(0, [&](int k) { return savings_[others[k]]; });
    const v_int32x4 unseen = gatherFour(i, [&](int k) { return b.unseen[b.contested[k]]; });
    const FourChoices four = { gatherFour(i, [&](int k) { return b.pixels[b.distant[b.contested[k]]]; }),
                               v_setzero_s32(), v_shl<UNSEEN_LOG2>(unseen),
                               subtract(bitAnd(slack, v_setall_s32(ALWAYS - 1)), saved) };
    return four;
}

//! The regions of the first 4-neighbours that were not seen yet win the pixels if that is better. Adds the first
//! `count` choices to those that are made or to the open ones, without a branch.
inline void RegionChoice::compare(const v_int32x4& squares, int count, FourChoices four, Choices& choices) const
{
    int pixels[FOUR], unseen[FOUR], masks[FOUR];
    const int* others[FOUR]; // of labels
    v_store(pixels, four.pixels);
    v_store(unseen, v_shr<UNSEEN_LOG2>(four.masks));
    for (int k = 0; k < FOUR; k++)
    {
        const int* const label = labels_ + pixels[k];
        others[k] = label + first_others_[unseen[k]];
        masks[k] = table_.neighborMask(label, step_, *others[k]);
    }
    const v_int32x4 regions = gatherFour(0, [&](int k) { return *others[k]; });
    const v_int32x4 found = gatherFour(0, [&](int k) { return masks[k]; });
    const v_int32x4 energies = subtract(squares, gatherFour(0, [&](int k) { return savings_[masks[k]]; }));
    const v_int32x4 is_region = equal(v_shr<31>(regions), v_setzero_s32());
    const v_int32x4 better = bitAnd(v_shr<31>(subtract(energies, four.energies)), is_region);
    const v_int32x4 were_unseen = bitAnd(four.masks, v_setall_s32(255 << UNSEEN_LOG2));
    const v_int32x4 are_unseen = subtract(were_unseen, bitAnd(were_unseen, v_shl<UNSEEN_LOG2>(found)));
    four.masks = add(v_select(better, found, subtract(four.masks, were_unseen)), are_unseen);
    four.regions = v_select(better, regions, four.regions);
    four.energies = v_select(better, energies, four.energies);
    v_int32x4 of_pixels[FOUR];
    v_transpose4x4(four.pixels, four.regions, four.masks, four.energies, of_pixels[0], of_pixels[1], of_pixels[2],
                   of_pixels[3]);
    v_store(masks, four.masks);
    const int ALL_SEEN = 1 << UNSEEN_LOG2;
    for (int k = 0; k < count; k++)
    {
        v_store(&choices.made[choices.num_made].pixel, of_pixels[k]);
        v_store(&choices.open[choices.num_open].pixel, of_pixels[k]);
        choices.num_made += (masks[k] > 0) & (masks[k] < ALL_SEEN);
        choices.num_open += masks[k] >= ALL_SEEN;
    }
}

//! Most pixels lie near to the mean of their region, and most others far from that of the one beside it. They are
//! passed over, in loops without branches, because no processor can predict which they are.
template <RegionChoice::Content CONTENT>
int RegionChoice::findGains(const int* pixels, int n, int y, Gain* gains) const
{
    Batch b;
    Gain open[BATCH + AT_ONCE];
    std::copy_n(pixels, n, b.pixels);
    std::fill_n(b.pixels + n, int(AT_ONCE), pixels[0]);
    const int num_contested = listContested<CONTENT>(listDistant<CONTENT>(n, y, b), y, b);
    std::fill_n(b.contested + num_contested, int(AT_ONCE), 0);
    Choices choices = { gains, open, 0, 0 };
    for (int i = 0; i < num_contested; i += FOUR)
        compare(gatherFour(i, [&](int k) { return b.squares[b.contested[k]]; }),
                std::min(num_contested - i, int(FOUR)), begin(i, b), choices);
    while (choices.num_open > 0)
    {
        const int num_open = choices.num_open;
        std::fill_n(open + num_open, int(AT_ONCE), open[0]);
        measure<CONTENT>(num_open, y, [&](int i) { return open[i].pixel; }, [&](int i)
        {
            return std::max(labels_[open[i].pixel + first_others_[open[i].mask >> UNSEEN_LOG2]], 0);
        }, b.squares);
        choices.num_open = 0;
        for (int i = 0; i < num_open; i += FOUR)
        {
            FourChoices four;
            v_int32x4 of_pixels[FOUR];
            for (int k = 0; k < FOUR; k++)
                of_pixels[k] = v_load(&open[i + k].pixel);
            v_transpose4x4(of_pixels[0], of_pixels[1], of_pixels[2], of_pixels[3], four.pixels, four.regions,
                           four.masks, four.energies);
            compare(v_load(b.squares + i), std::min(num_open - i, int(FOUR)), four, choices);
        }
    }
    return choices.num_made;
}

int RegionChoice::findGains(const int* pixels, int n, int y, Gain* gains) const
{
    if (distance_.with_surfaces && distance_.normal_share > 0)
        return findGains<SURFACE>(pixels, n, y, gains);
    if (distance_.with_surfaces)
        return findGains<PLANE>(pixels, n, y, gains);
    return distance_.with_depth ? findGains<DEPTH>(pixels, n, y, gains) : findGains<COLOR>(pixels, n, y, gains);
}

}}} // namespace
