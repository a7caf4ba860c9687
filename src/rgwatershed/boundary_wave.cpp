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
    Wave(const WaveTables& tables, Moves& moves)
        : t_(tables), mask_table_(maskTable()), all_permitted_(t_.rules.markers.empty() && !t_.rules.guard),
          moves_(moves)
    {
    }

    //! Class 2 comes one row after class 0, which it needs above and below, class 1 with it, class 3 two rows after.
    void run(const ClassRows& classes)
    {
        const int ORDER[NUM_CLASSES] = { 0, 2, 1, 3 }, LAGS[NUM_CLASSES] = { 0, 1, 1, 2 };
        const int at_once = t_.choice.needsPlaces() ? 1 : ROWS_AT_ONCE;
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
            const int band = t_.bands.of(row);
            end = std::min(rows.end, t_.bands.first(band + 1));
            sweepPart(2 * row + (c >> 1), t_.lists.of(band).part(c, Range(row, end)));
        }
    }

    //! Pixels of a class. If places are needed, all lie in row y.
    void sweepPart(int y, const BoundaryList::Part& part)
    {
        const RegionSum* const sums = t_.regions.sums.data();
        for (int first = 0; first < part.count; first += RegionChoice::BATCH)
        {
            RegionChoice::Gain gains[RegionChoice::BATCH];
            const int count = std::min<int>(part.count - first, RegionChoice::BATCH);
            const int n = t_.choice.findGains(part.pixels + first, count, y, gains);
            for (int i = 0; i < n; i++)
                if (sums[gains[i].region].area <= t_.rules.most_area &&
                    (all_permitted_ || permits(t_.labels.point(gains[i].pixel), gains[i].region)))
                    move(gains[i]);
        }
    }

    bool permits(Point p, int to) const
    {
        const SweepRules& rules = t_.rules;
        return (rules.markers.empty() || rules.markers.at<int>(p) < 0) &&
               (!rules.guard || rules.guard->permits(p, t_.labels.row(p.y)[p.x], to));
    }

    void move(const RegionChoice::Gain& to)
    {
        int& label = t_.labels.data()[to.pixel];
        if (!t_.rules.last)
        {
            moves_.add({ to.pixel, label, to.region, t_.features.data()[to.pixel] });
            markAround(t_.marks.data() + to.pixel);
        }
        label = to.region;
        changeMasks(t_.masks.data() + to.pixel, to.mask);
    }

    //! @note Loads of words come before stores of bytes, because a load of what was just stored in parts is slow.
    void changeMasks(uchar* mask, int own_mask)
    {
        const int changed = *mask | own_mask;
        for (int row = 0; row < 3; row++)
        {
            uchar* bytes = mask + (row - 1) * t_.labels.step() - (row == 2 ? 2 : 1); // never behind the last row
            unsigned masks, changes;
            memcpy(&masks, bytes, sizeof(masks));
            memcpy(&changes, mask_table_.changes(changed, row), sizeof(changes));
            masks ^= changes;
            memcpy(bytes, &masks, sizeof(masks));
        }
        *mask = uchar(own_mask);
    }

    //! Marks the pixel of a move and its 4-neighbours.
    void markAround(uchar* mark)
    {
        mark[0] = mark[-1] = mark[1] = mark[-t_.marks.step()] = mark[t_.marks.step()] = 1;
    }

    const WaveTables t_;
    const MaskTable& mask_table_;
    const bool all_permitted_;
    Moves& moves_;
};

} // namespace

void runWave(const WaveTables& tables, const ClassRows& classes, Moves& moves)
{
    Wave(tables, moves).run(classes);
}

}}} // namespace
