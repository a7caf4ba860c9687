// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BOUNDARY_WAVE_HPP
#define OPENCV_GWATERSHED_BOUNDARY_WAVE_HPP

#include "rgwatershed/boundary_list.hpp"
#include "rgwatershed/region_choice.hpp"
#include "rgwatershed/sweep_rules.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Bands of rows of quads go through all four classes while they are in the cache. What a pixel may see are the classes
// before its own, moved, and those after it, not yet. So a row of a class comes when the rows above and below it have
// had the classes before; and near to another band the rows are left out whose neighbours may lie there. They come when
// both bands are done. So the result is that of one class after another.
// The same holds for what a move writes: the masks and the marks of its neighbours.

enum { BAND_HEIGHT = 16 }; // rows of quads; at least 5, so that the rows left out between bands do not meet

//! Rows of quads that a class is looked at in.
struct ClassRows
{
    explicit ClassRows(const Range& all) { std::fill_n(rows, int(NUM_CLASSES), all); }

    //! What of a band has no neighbour in another one, or none that counts.
    static ClassRows within(const Range& band, int height)
    {
        const int above = band.start > 0, below = band.end < height;
        ClassRows result(band);
        result.rows[0] = Range(band.start + above, band.end);
        result.rows[2] = Range(band.start + above, band.end - below);
        result.rows[1] = Range(band.start + 2 * above, band.end - below);
        result.rows[3] = Range(band.start + 2 * above, band.end - 2 * below);
        return result;
    }

    //! What is left between the band that ends at a row and the next one.
    static ClassRows between(int row, int height)
    {
        ClassRows result(Range(row, row + 1));
        result.rows[2] = Range(row - 1, row + 1);
        result.rows[1] = Range(row - 1, std::min(row + 2, height));
        result.rows[3] = Range(row - 2, std::min(row + 2, height));
        return result;
    }

    Range rows[NUM_CLASSES];
};

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
    bool meets(const Range& regions) const { return highest_region >= regions.start && lowest_region < regions.end; }
};

//! The lists of the bands, in groups that one thread sweeps from top to bottom. Those of a group that are still needed
//! are that of its first band, where the group above ends, and those of the last two.
class BandLists
{
public:
    //! At most so many groups, if each has a few bands.
    void divide(int num_bands, int most_groups)
    {
        const int FEWEST_BANDS = 2;
        bands_in_group_ = std::max(FEWEST_BANDS, (num_bands + most_groups - 1) / most_groups);
        groups_.resize((num_bands + bands_in_group_ - 1) / bands_in_group_);
    }

    int numGroups() const { return int(groups_.size()); }
    int firstBand(int group) const { return group * bands_in_group_; }

    BoundaryList& of(int band)
    {
        Group& group = groups_[band / bands_in_group_];
        return band % bands_in_group_ == 0 ? group.first : band % 2 == 0 ? group.even : group.odd;
    }

private:
    struct Group
    {
        BoundaryList first, even, odd;
    };

    std::vector<Group> groups_;
    int bands_in_group_ = 1;
};

//! What the waves of a sweep read and write.
struct WaveTables
{
    const RegionChoice& choice;
    const FeatureMap& features;
    const SweepRules& rules;
    const Regions& regions;
    Padded<int>& labels;
    Padded<uchar>& masks;
    Padded<uchar>& marks;
    BandLists& lists;
};

//! Takes some rows of quads through all four classes: what one thread does. Rows are in lists already.
void runWave(const WaveTables& tables, const ClassRows& classes, Moves& moves);

}}} // namespace

#endif
