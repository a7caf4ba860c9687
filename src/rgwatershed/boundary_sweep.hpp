// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP
#define OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP

#include "rgwatershed/block_grid.hpp"
#include "rgwatershed/boundary_wave.hpp"
#include <functional>

namespace cv { namespace ximgproc { namespace gws {

//! Sweeps over the boundary: each of its pixels goes to the neighbouring region of the lowest energy, while each
//! region stays one piece. Holds the state between sweeps, so there is one for each level.
//!
//! A sweep takes the four classes of pixels in turn. No two pixels of a class are neighbours, so all of them can choose
//! and move at once: what they chose holds, and the order does not matter. Means are those of the beginning of the
//! sweep. Which pixels are looked at is known then, too.
class BoundarySweeper
{
public:
    //! Sweeps over the whole boundary, and then again, count times in all.
    void sweepAll(int count, const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
                  Regions& regions);

    //! The same for labels that become those of blocks of 2x2 or 3x3 pixels first, which were swept just before.
    void sweepBlocks(int count, const BoundarySweeper& of_blocks, const Padded<int>& blocks, const BlockGrid& grid,
                     const FeatureMap& features, const SweepRules& rules, Padded<int>& labels, Regions& regions);

    //! Sweeps around the pixels that moved in the sweep before, of the same labels: count times, or until none does.
    void sweepAgain(int count, const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
                    Regions& regions);

    //! Whether any pixel moved in the last sweep.
    bool moved() const { return moved_; }

private:
    //! Lists the pixels that a sweep looks at in some rows of quads.
    typedef std::function<void(const Range& rows, BoundaryList& list)> List;

    //! Finds the masks of some rows of pixels.
    typedef std::function<void(const Range& rows)> MaskFinder;

    void sweepFrom(const MaskFinder& find, int count, const FeatureMap& features, const SweepRules& rules,
                   Padded<int>& labels, Regions& regions);
    void sweep(const List& list, const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
               Regions& regions);
    void sweepGroups(const List& list, const WaveTables& tables);
    void sweepWithin(int band, const List& list, const WaveTables& tables);
    void sweepAbove(int band, const WaveTables& tables);
    void updateRegions(const FeatureMap& features, VariationGuard* guard, Regions& regions) const;
    void updateRegions(const Range& range, const FeatureMap& features, VariationGuard* guard,
                       Regions& regions) const;

    Padded<uchar> masks_;      // of the neighbours with the same label, by pixel
    Padded<uchar> marks_;      // 1 for pixels that moved, and for their 4-neighbours
    BandLists lists_;
    std::vector<Moves> moves_; // within bands, then between them
    bool moved_ = false;
};

}}} // namespace

#endif
