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
        savings_[mask] = length_price * table_.agreement(mask);
        // No region saves more boundary than with all neighbours that do not agree.
        const int most = length_price * table_.agreement(~mask & 255);
        // Tips may have three regions beside them, so they are always looked at.
        bounds_[mask] = !table_.canLeave(mask) ? INT_MAX : savings_[mask] - most - (table_.isTip(mask) ? ALWAYS : 0);
        first_others_[mask] = offsets[table_.first(mask)];
        last_others_[mask] = offsets[table_.last(mask)];
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

//! Calls take(i, square, to) for n elements, with the squared distances of their pixels to some regions. It writes an
//! element to `to`, and tells whether that is kept: else the next one overwrites it. Returns how many are kept. They
//! may take the place of those that pixelOf(i) and regionOf(i) read; regionOf(i) is asked for once.
template <RegionChoice::Content CONTENT, typename To, typename PixelOf, typename RegionOf, typename Take>
int RegionChoice::measure(int n, int y, To* to, const PixelOf& pixelOf, const RegionOf& regionOf,
                          const Take& take) const
{
    To* const first_to = to;
    const Normal* row_normals = CONTENT == SURFACE ? map_.normalsOfRow(y) : 0;
    const int row_start = CONTENT >= PLANE ? map_.index(Point(0, y)) : 0, normal_shift = map_.normal_shift;
    const RegionDistance distance = distance_; // a copy of its own does not change when something is written
    int i = 0;
    for (; i + 4 <= n; i += 4)
    {
        const Feature* features[4];
        const RegionMean* means[4];
        const SurfaceMean* surfaces[4] = {};
        const Normal* normals[4] = {};
        int places[4] = {}, squares[4];
        for (int k = 0; k < 4; k++)
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
        v_store(squares, CONTENT >= PLANE
            ? distance.squared<CONTENT == SURFACE>(features, normals, means, surfaces, v_load(places), y)
            : distance.squared<CONTENT == DEPTH>(features, means));
        for (int k = 0; k < 4; k++)
            to += take(i + k, squares[k], *to);
    }
    for (; i < n; i++)
        to += take(i, squaredDistance(pixelOf(i), y, regionOf(i)), *to);
    return int(to - first_to);
}

//! The pixels that are so far from the mean of their own region that another one may win them. Returns how many.
template <RegionChoice::Content CONTENT>
int RegionChoice::keepDistant(const int* pixels, int n, int y, OpenPixel* open) const
{
    return measure<CONTENT>(n, y, open, [&](int i) { return pixels[i]; }, [&](int i) { return labels_[pixels[i]]; },
                            [&](int i, int square, OpenPixel& to)
    {
        to.index = pixels[i];
        to.slack = square - bounds_[masks_[pixels[i]]];
        return to.slack > 0;
    });
}

//! Of these, those that the region of the first neighbour may win, or those beside several regions, or tips.
template <RegionChoice::Content CONTENT> int RegionChoice::keepNear(int n, int y, OpenPixel* open) const
{
    return measure<CONTENT>(n, y, open, [&](int i) { return open[i].index; }, [&](int i)
    {
        const int others = ~masks_[open[i].index] & MaskTable::FOUR_NEIGHBORS, *label = labels_ + open[i].index;
        const int first = label[first_others_[others]];
        open[i].slack |= (first != label[last_others_[others]]) * ALWAYS;
        return std::max(first, 0);
    }, [&](int i, int square, OpenPixel& to)
    {
        to = { open[i].index, open[i].slack, square };
        return square < to.slack;
    });
}

//! The region of the first 4-neighbour that was not seen yet wins the pixel if that is better.
inline void RegionChoice::compare(int square, Choice& choice) const
{
    const int* label = labels_ + choice.gain.pixel;
    const int region = label[first_others_[choice.unseen]], mask = table_.neighborMask(label, step_, region);
    const int energy = square - savings_[mask];
    const int better = ((energy - choice.energy) & ~region) >> 31; // all bits, unless there is no region
    choice.gain.region ^= (choice.gain.region ^ region) & better;
    choice.gain.mask ^= (choice.gain.mask ^ mask) & better;
    choice.energy ^= (choice.energy ^ energy) & better;
    choice.unseen &= ~mask;
}

//! Most pixels lie near to the mean of their region, and most others far from that of the one beside it. They are
//! passed over, in loops without branches, because no processor can predict which they are: each pixel is written,
//! and the next one overwrites it if it is not kept.
template <RegionChoice::Content CONTENT>
int RegionChoice::findGains(const int* pixels, int n, int y, Gain* gains) const
{
    OpenPixel open[BATCH];
    const int num_open = keepNear<CONTENT>(keepDistant<CONTENT>(pixels, n, y, open), y, open);
    Choice others[BATCH]; // that have more regions beside them
    int num_gains = 0, num_others = 0;
    const auto add = [&](const Choice& choice)
    {
        const bool more = choice.unseen != 0;
        gains[num_gains] = choice.gain;
        num_gains += (choice.gain.mask != 0) & !more;
        others[num_others] = choice;
        num_others += more;
    };
    for (int i = 0; i < num_open; i++)
    {
        const int pixel = open[i].index, others_mask = ~masks_[pixel] & 255;
        // Its own square less what it saves: slack is more by what the others could save.
        Choice choice = { { pixel, 0, 0 }, (open[i].slack & (ALWAYS - 1)) - savings_[others_mask],
                          others_mask & MaskTable::FOUR_NEIGHBORS };
        compare(open[i].square, choice);
        add(choice);
    }
    while (num_others > 0)
    {
        const int n_others = num_others;
        num_others = 0;
        measure<CONTENT>(n_others, y, others, [&](int i) { return others[i].gain.pixel; }, [&](int i)
        {
            return std::max(labels_[others[i].gain.pixel + first_others_[others[i].unseen]], 0);
        }, [&](int i, int square, Choice&)
        {
            Choice choice = others[i];
            compare(square, choice);
            add(choice);
            return false;
        });
    }
    return num_gains;
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
