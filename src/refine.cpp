// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The 8 neighbours of a pixel, clockwise from the upper left; those with an odd number are its
//! 4-neighbours. A mask has a bit for each.
struct Window
{
    Window(const Padded<int>& map, int p)
    {
        const int step = map.step();
        const int* label = map.data() + p;
        const int around[8] = { label[-step - 1], label[-step], label[-step + 1], label[1],
                                label[step + 1], label[step], label[step - 1], label[-1] };
        std::copy(around, around + 8, labels);
    }
    //! The neighbours that have the label.
    int mask(int label) const
    {
        const int* l = labels;
        return (l[0] == label) | (l[1] == label) << 1 | (l[2] == label) << 2 | (l[3] == label) << 3 |
               (l[4] == label) << 4 | (l[5] == label) << 5 | (l[6] == label) << 6 | (l[7] == label) << 7;
    }

    int labels[8];
};

//! What a pixel must know of the mask of its neighbours with one label.
class MaskTable
{
public:
    enum { FOUR_NEIGHBORS = 0xAA, ALL_AGREE = 12 };

    MaskTable()
    {
        for (int mask = 0; mask < 256; mask++)
        {
            int pieces = 0;
            agreement_[mask] = 0;
            first_neighbor_[mask] = uchar((mask & 0x02) ? 1 : (mask & 0x08) ? 3 : (mask & 0x20) ? 5 : 7);
            for (int k = 0; k < 8; k++)
            {
                const bool here = (mask >> k) & 1, corner = (mask >> ((k + 7) & 7)) & 1;
                const bool before = (mask >> ((k + 6) & 7)) & 1;
                agreement_[mask] += here ? 1 + (k & 1) : 0;
                // A 4-neighbour begins a piece unless the one before it reaches it over the corner.
                pieces += (k & 1) && here && !(corner && before);
            }
            keeps_together_[mask] = pieces == 1;
        }
    }

    //! Whether the 4-neighbours are connected within the window, so that their region stays one
    //! piece if it loses the pixel in the middle. False if there is none, or if all 8 have the label.
    bool keepsTogether(int mask) const { return keeps_together_[mask]; }

    //! Boundary that the pixel would not have if it had the label, too, in quarters of an edge: two
    //! for each 4-neighbour and one for each diagonal one.
    int agreement(int mask) const { return agreement_[mask]; }

    //! The first 4-neighbour of a mask that has one.
    int firstNeighbor(int mask) const { return first_neighbor_[mask]; }

private:
    bool keeps_together_[256];
    uchar agreement_[256], first_neighbor_[256];
};

static const MaskTable& maskTable()
{
    static const MaskTable table;
    return table;
}

//! One sweep in two steps: every pixel of the boundary chooses a region by the labels as they are
//! at the beginning, all at once; then those that chose another one move in turn, as far as it
//! still pays. So no region runs along an edge in the order of the sweep.
class BoundarySweep
{
public:
    BoundarySweep(const Padded<Feature>& features, const RegionDistance& distance, int length_price,
                  VariationGuard* guard, Padded<int>& labels, Regions& regions)
        : table_(maskTable()), features_(features), distance_(distance), length_price_(length_price), guard_(guard),
          labels_(labels), regions_(regions)
    {
    }

    //! The region of the pixel itself, unless one of its 4-neighbours has a lower energy.
    int choose(int p) const
    {
        const Window window(labels_, p);
        const int from = labels_.data()[p], mask = window.mask(from);
        if (!table_.keepsTogether(mask))
            return from;
        int best = from, lowest = energy(p, from, mask);
        if (lowest <= -length_price_ * (MaskTable::ALL_AGREE - table_.agreement(mask)))
            return from; // even if all others had one label, and the mean of it were the colour
        int others = ~mask & MaskTable::FOUR_NEIGHBORS; // 4-neighbours with labels not looked at yet
        while (others)
        {
            const int region = window.labels[table_.firstNeighbor(others)], mask_region = window.mask(region);
            others &= ~mask_region;
            if (region == OUTSIDE)
                continue;
            const int e = energy(p, region, mask_region);
            if (e < lowest)
            {
                lowest = e;
                best = region;
            }
        }
        return best;
    }

    //! Moves a pixel to the region that it chose, if it still may and that still pays.
    bool move(int p, int to)
    {
        const Window window(labels_, p);
        const int from = labels_.data()[p], mask_from = window.mask(from), mask_to = window.mask(to);
        if (regions_.sums[from].area == 1 || !table_.keepsTogether(mask_from) ||
            !(mask_to & MaskTable::FOUR_NEIGHBORS) || energy(p, to, mask_to) >= energy(p, from, mask_from))
            return false;
        if (guard_ && !guard_->permits(labels_.point(p), from, to))
            return false;
        labels_.data()[p] = to;
        regions_.sums[from].add(features_.data()[p], -1);
        regions_.sums[to].add(features_.data()[p]);
        if (guard_)
            guard_->move(labels_.point(p), from, to);
        return true;
    }

private:
    //! Squared distance to the mean, less the boundary that is saved.
    int energy(int p, int region, int mask) const
    {
        const int d = distance_(features_.data()[p], regions_.means[region]);
        return ((d * d) >> 8) - length_price_ * table_.agreement(mask);
    }

    const MaskTable& table_;
    const Padded<Feature>& features_;
    const RegionDistance distance_;
    const int length_price_;
    VariationGuard* const guard_;
    Padded<int>& labels_;
    Regions& regions_;
};

//! What the next sweep looks at: the boundary around the pixels that moved.
static void listAround(const std::vector<int>& moved, const Padded<int>& labels, std::vector<uchar>& marks,
                       std::vector<int>& boundary)
{
    const int step = labels.step();
    const int* label = labels.data();
    marks.resize(size_t(step) * (labels.size().height + 2), 0);
    boundary.clear();
    for (size_t i = 0; i < moved.size(); i++)
        for (int dy = -step; dy <= step; dy += step)
            for (int p = moved[i] + dy - 1; p <= moved[i] + dy + 1; p++)
                if (!marks[p] && label[p] != OUTSIDE)
                {
                    marks[p] = 1;
                    boundary.push_back(p);
                }
    for (size_t i = 0; i < boundary.size(); i++)
        marks[boundary[i]] = 0;
}

//! Means are those of the beginning of the sweep.
void sweepBoundary(const Padded<Feature>& features, const RegionDistance& distance, int length_price,
                   VariationGuard* guard, Padded<int>& labels, Regions& regions,
                   SweepBuffers& buffers, std::vector<int>& boundary)
{
    CV_TRACE_FUNCTION();
    BoundarySweep sweep(features, distance, length_price, guard, labels, regions);
    std::vector<int>& chosen = buffers.chosen;
    std::vector<int>& moved = buffers.moved;
    chosen.resize(boundary.size());
    moved.clear();
    parallel_for_(Range(0, int(boundary.size())), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            chosen[i] = sweep.choose(boundary[i]);
    });
    for (size_t i = 0; i < boundary.size(); i++)
        if (chosen[i] != labels.data()[boundary[i]] && sweep.move(boundary[i], chosen[i]))
            moved.push_back(boundary[i]);

    listAround(moved, labels, buffers.marks, boundary);
    regions.update();
    if (guard)
        guard->update();
}

}}} // namespace
