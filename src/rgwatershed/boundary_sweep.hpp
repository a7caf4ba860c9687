// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP
#define OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP

#include "rgwatershed/boundary_list.hpp"
#include "rgwatershed/variation_guard.hpp"
#include "shared/region_distance.hpp"
#include <functional>

namespace cv { namespace ximgproc { namespace gws {

//! What a sweep goes by.
struct SweepRules
{
    SweepRules(const RegionDistance& distance_, const Mat& markers_) : distance(distance_), markers(markers_) {}

    RegionDistance distance;
    int length_price = 0;      //!< energy, in squared grey levels, of a quarter of a pixel edge of boundary
    Mat markers;               //!< of the user: pixels with a value of 0 or more stay; may be empty
    VariationGuard* guard = 0; //!< may be 0
    int most_area = INT_MAX;   //!< a larger region gains no pixel, or one with both colours of a pattern would grow on
    bool last = false;         //!< nothing follows, and the sums and means of the regions are not needed any more
};

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

    //! The same for labels that become those of blocks of 2x2 or 3x3 pixels first.
    void sweepBlocks(int count, const Padded<int>& blocks, const BlockGrid& grid, const FeatureMap& features,
                     const SweepRules& rules, Padded<int>& labels, Regions& regions);

    //! Sweeps around the pixels that moved in the sweep before, of the same labels: count times, or until none does.
    void sweepAgain(int count, const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
                    Regions& regions);

    //! Whether any pixel moved in the last sweep.
    bool moved() const { return moved_; }

private:
    struct Pass;
    class Wave;

    struct Move
    {
        int index, from, to;
        Feature feature; // of the pixel
    };

    //! Moves in some rows, and the regions that lost or gained by them.
    struct Moves
    {
        std::vector<Move> list;
        int lowest_region, highest_region;

        void clear();
        void add(const Move& move);
        bool meets(const Range& regions) const
        {
            return highest_region >= regions.start && lowest_region < regions.end;
        }
    };

    //! The lists of a group of bands, which one thread sweeps from top to bottom. Those that are still needed are that
    //! of the first band, where the group above ends, and those of the last two.
    struct Lists
    {
        BoundaryList first, even, odd;
    };

    //! Lists the pixels that a sweep looks at in some rows of quads.
    typedef std::function<void(const Range& rows, BoundaryList& list)> List;

    void begin(Size size, bool last);
    void listAll(const Range& rows, bool last, BoundaryList& list);
    void sweep(const List& list, const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
               Regions& regions);
    int numBands() const;
    BoundaryList& listOf(int band);
    void divideIntoGroups();
    void sweepGroups(const Pass& pass);
    void sweepWithin(int band, const Pass& pass);
    void sweepAbove(int band, const Pass& pass);
    void updateRegions(const FeatureMap& features, VariationGuard* guard, Regions& regions) const;
    void updateRegions(const Range& range, const FeatureMap& features, VariationGuard* guard,
                       Regions& regions) const;

    Padded<uchar> masks_;      // of the neighbours with the same label, by pixel
    Padded<uchar> marks_;      // of the classes that touch a move, by quad
    std::vector<Lists> lists_; // of each group
    int bands_in_group_ = 0;
    std::vector<Moves> moves_; // within bands, then between them
    bool moved_ = false;
};

}}} // namespace

#endif
