// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

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
        const int step = labels.step();
        const int offsets[8] = { -step - 1, -step, -step + 1, 1, step + 1, step, step - 1, -1 };
        std::copy(offsets, offsets + 8, offsets_);
    }

    enum { STAY = -1 };

    //! The region of a 4-neighbour of the lowest energy, if that is lower than the energy of its own.
    int choose(const BoundaryPixel& pixel) const
    {
        const int* label = labels_.data() + pixel.index;
        const Feature& feature = features_.data()[pixel.index];
        const int agreement = table_.agreement(pixel.mask);
        // What others can save in boundary: they have all neighbours but these at most.
        const int largest_saving = length_price_ * (MaskTable::ALL_AGREE - agreement);
        int best = STAY, lowest = deviation(feature, *label) - length_price_ * agreement;
        // Others win at most that, even if their mean were the colour.
        int others = lowest > -largest_saving ? ~pixel.mask & MaskTable::FOUR_NEIGHBORS : 0;
        for (; others; others &= others - 1)
        {
            const int region = label[offsets_[table_.first(others)]];
            if (region == OUTSIDE || region == best)
                continue;
            const int d = deviation(feature, region);
            if (d - largest_saving >= lowest)
                continue;
            const int e = d - length_price_ * table_.agreement(neighborMask(label, labels_.step(), region));
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
        int& label = labels_.data()[p];
        const Feature& feature = features_.data()[p];
        const int from = label, mask_from = neighborMask(&label, labels_.step(), from);
        const int mask_to = neighborMask(&label, labels_.step(), to);
        if (!table_.canLeave(mask_from) || !(mask_to & MaskTable::FOUR_NEIGHBORS))
            return false;
        const int saving = length_price_ * (table_.agreement(mask_to) - table_.agreement(mask_from));
        if (deviation(feature, to) - saving >= deviation(feature, from))
            return false;
        if (guard_ && !guard_->permits(labels_.point(p), from, to))
            return false;
        label = to;
        regions_.sums[from].add(feature, -1);
        regions_.sums[to].add(feature);
        if (guard_)
            guard_->move(labels_.point(p), from, to);
        return true;
    }

private:
    //! Squared distance to the mean of a region, in squared levels. The energy is this less the boundary saved.
    int deviation(const Feature& feature, int region) const
    {
        return distance_.squared(feature, regions_.means[region]);
    }

    const MaskTable& table_;
    const Padded<Feature>& features_;
    const RegionDistance distance_;
    const int length_price_;
    VariationGuard* const guard_;
    Padded<int>& labels_;
    Regions& regions_;
    int offsets_[8]; // of the neighbours, in the order of their bits
};

//! Means are those of the beginning of the sweep.
void sweepBoundary(const Padded<Feature>& features, const RegionDistance& distance, int length_price,
                   VariationGuard* guard, const std::vector<BoundaryPixel>& boundary, Padded<int>& labels,
                   Regions& regions, std::vector<int>& chosen, std::vector<int>& moved)
{
    CV_TRACE_FUNCTION();
    BoundarySweep sweep(features, distance, length_price, guard, labels, regions);
    chosen.resize(boundary.size());
    parallel_for_(Range(0, int(boundary.size())), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            chosen[i] = sweep.choose(boundary[i]);
    });
    moved.clear();
    for (size_t i = 0; i < boundary.size(); i++)
        if (chosen[i] != BoundarySweep::STAY && sweep.move(boundary[i].index, chosen[i]))
            moved.push_back(boundary[i].index);
    regions.update();
    if (guard)
        guard->update();
}

}}} // namespace
