// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/boundary_wave.hpp"

namespace cv { namespace ximgproc { namespace gws {

void Moves::clear()
{
    list.clear();
    lowest_region = INT_MAX;
    highest_region = -1;
}

void Moves::add(const Move& move)
{
    list.push_back(move);
    lowest_region = std::min(lowest_region, std::min(move.from, move.to));
    highest_region = std::max(highest_region, std::max(move.from, move.to));
}

namespace {

class Wave
{
public:
    Wave(const WaveTables& t, Moves& moves)
        : table_(maskTable()), choice_(t.choice), features_(t.features.data()), rules_(t.rules),
          all_permitted_(rules_.markers.empty() && !rules_.guard), sums_(t.regions.sums.data()), labels_(t.labels),
          masks_(t.masks), marks_(t.marks), lists_(t.lists), bands_(t.bands), moves_(moves)
    {
    }

    //! Class 2 comes one row after class 0, which it needs above and below, class 1 with it, class 3 two rows after.
    void run(const ClassRows& classes)
    {
        const int ORDER[NUM_CLASSES] = { 0, 2, 1, 3 }, LAGS[NUM_CLASSES] = { 0, 1, 1, 2 };
        const int at_once = choice_.needsPlaces() ? 1 : ROWS_AT_ONCE;
        for (int row = classes.rows[0].start; row < classes.rows[3].end + LAGS[3]; row += at_once)
            for (int i = 0; i < NUM_CLASSES; i++)
            {
                const int c = ORDER[i], first = row - LAGS[c];
                sweepRows(c, classes.rows[c] & Range(first, first + at_once));
            }
    }

private:
    enum { ROWS_AT_ONCE = 16 }; // of quads: a row alone has few pixels, and each loop ends with a branch

    void sweepRows(int c, const Range& rows)
    {
        for (int row = rows.start, end; row < rows.end; row = end)
        {
            const int band = bands_.of(row);
            end = std::min(rows.end, bands_.first(band + 1));
            sweepPart(2 * row + (c >> 1), lists_.of(band).part(c, Range(row, end)));
        }
    }

    //! Pixels of a class. If places are needed, all lie in row y.
    void sweepPart(int y, const BoundaryList::Part& part)
    {
        for (int first = 0; first < part.count; first += RegionChoice::BATCH)
        {
            RegionChoice::Gain gains[RegionChoice::BATCH];
            const int count = std::min<int>(part.count - first, RegionChoice::BATCH);
            const int n = choice_.findGains(part.pixels + first, count, y, gains);
            for (int i = 0; i < n; i++)
                if (sums_[gains[i].region].area <= rules_.most_area &&
                    (all_permitted_ || permits(labels_.point(gains[i].pixel), gains[i].region)))
                    move(gains[i]);
        }
    }

    bool permits(Point p, int to) const
    {
        return (rules_.markers.empty() || rules_.markers.at<int>(p) < 0) &&
               (!rules_.guard || rules_.guard->permits(p, labels_.row(p.y)[p.x], to));
    }

    void move(const RegionChoice::Gain& to)
    {
        int& label = labels_.data()[to.pixel];
        if (!rules_.last)
        {
            moves_.add({ to.pixel, label, to.region, features_[to.pixel] });
            markAround(marks_.data() + to.pixel);
        }
        label = to.region;
        changeMasks(masks_.data() + to.pixel, to.mask);
    }

    //! @note Loads of words come before stores of bytes, because a load of what was just stored in parts is slow.
    void changeMasks(uchar* mask, int own_mask)
    {
        const int changed = *mask | own_mask;
        for (int row = 0; row < 3; row++)
        {
            uchar* bytes = mask + (row - 1) * labels_.step() - (row == 2 ? 2 : 1); // never behind the last row
            unsigned masks, changes;
            memcpy(&masks, bytes, sizeof(masks));
            memcpy(&changes, table_.changes(changed, row), sizeof(changes));
            masks ^= changes;
            memcpy(bytes, &masks, sizeof(masks));
        }
        *mask = uchar(own_mask);
    }

    //! Marks the pixel of a move and its 4-neighbours.
    void markAround(uchar* mark)
    {
        mark[0] = mark[-1] = mark[1] = mark[-marks_.step()] = mark[marks_.step()] = 1;
    }

    const MaskTable& table_;
    const RegionChoice& choice_;
    const Feature* const features_;
    const SweepRules& rules_;
    const bool all_permitted_;
    const RegionSum* const sums_;
    Padded<int>& labels_;
    Padded<uchar>& masks_;
    Padded<uchar>& marks_;
    BandLists& lists_;
    const Bands& bands_;
    Moves& moves_;
};

} // namespace

void runWave(const WaveTables& tables, const ClassRows& classes, Moves& moves)
{
    Wave(tables, moves).run(classes);
}

}}} // namespace
