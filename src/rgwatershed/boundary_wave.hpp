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

//! Rows of quads in bands of nearly equal heights, at least 5, so that the rows left out between bands do not meet. The
//! number of bands is even, so that two threads have the same.
class SweepBands
{
public:
    explicit SweepBands(int num_rows)
        : num_rows_(num_rows), count_(num_rows <= HEIGHT ? 1 : (num_rows + 2 * HEIGHT - 1) / (2 * HEIGHT) * 2)
    {
    }

    int count() const { return count_; }
    int numRows() const { return num_rows_; }
    int first(int band) const { return int(int64(num_rows_) * band / count_); }
    Range operator[](int band) const { return Range(first(band), first(band + 1)); }
    int of(int row) const { return int((int64(count_) * (row + 1) - 1) / num_rows_); }

private:
    enum { HEIGHT = 16 }; // at most

    int num_rows_, count_;
};

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
    //! Two groups for each thread, or one where bands are few.
    void divide(int num_bands, int num_threads)
    {
        const int MANY = 4; // bands for a thread
        const int most = num_threads == 1 ? 1 : num_bands < MANY * num_threads ? num_threads : 2 * num_threads;
        groups_.resize(std::min(num_bands, most));
        of_bands_.resize(num_bands);
        for (int i = 0; i < numGroups(); i++)
            for (int band = firstBand(i); band < firstBand(i + 1); band++)
                of_bands_[band] = band == firstBand(i) ? &groups_[i].first
                                : band % 2 == 0 ? &groups_[i].even : &groups_[i].odd;
    }

    int numGroups() const { return int(groups_.size()); }
    int firstBand(int group) const { return int(int64(of_bands_.size()) * group / numGroups()); }

    BoundaryList& of(int band) { return *of_bands_[band]; }

private:
    struct Group
    {
        BoundaryList first, even, odd;
    };

    std::vector<Group> groups_;
    std::vector<BoundaryList*> of_bands_;
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
    const SweepBands& bands;
};

//! Takes some rows of quads through all four classes: what one thread does. Rows are in lists already.
void runWave(const WaveTables& tables, const ClassRows& classes, Moves& moves);

}}} // namespace

#endif
