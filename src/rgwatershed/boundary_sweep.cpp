// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/boundary_sweep.hpp"
#include "rgwatershed/region_choice.hpp"
#include "rgwatershed/region_labels.hpp"

namespace cv { namespace ximgproc { namespace gws {

// Bands of rows of quads go through all four classes while they are in the cache. What a pixel may see are the classes
// before its own, moved, and those after it, not yet. So a row of a class comes when the rows above and below it have
// had the classes before; and near to another band the rows are left out whose neighbours may lie there. They come when
// both bands are done. So the result is that of one class after another.
// The same holds for what a move writes: the masks of its neighbours and the marks of their quads.

enum { BAND_HEIGHT = 16 }; // rows of quads; at least 5, so that the rows left out between bands do not meet

// Bands of a group are swept by one thread. Labels do not depend on the groups: there are as many as the threads need,
// because each has lists of its own.
enum { FEWEST_BANDS = 2 };

static int countGroups() { return getNumThreads() > 1 ? 2 * getNumThreads() : 1; }

namespace {

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

} // namespace

//! What one sweep works with.
struct BoundarySweeper::Pass
{
    const List& list;
    const RegionChoice& choice;
    const FeatureMap& features;
    const SweepRules& rules;
    const Regions& regions;
    Padded<int>& labels;
};

//! What one thread does.
class BoundarySweeper::Wave
{
public:
    Wave(const Pass& pass, BoundarySweeper& sweeper, Moves& moves)
        : table_(maskTable()), choice_(pass.choice), features_(pass.features.data()), rules_(pass.rules),
          all_permitted_(rules_.markers.empty() && !rules_.guard), sums_(pass.regions.sums.data()),
          labels_(pass.labels), sweeper_(sweeper), moves_(moves), marks_step_(sweeper.marks_.step())
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
    enum { ROWS_AT_ONCE = 8 }; // of quads: a row alone has few pixels, and each loop ends with a branch

    void sweepRows(int c, const Range& rows)
    {
        for (int row = rows.start, end; row < rows.end; row = end)
        {
            const int band = row / BAND_HEIGHT;
            end = std::min(rows.end, (band + 1) * BAND_HEIGHT);
            sweepPart(c, row, sweeper_.listOf(band).part(c, Range(row, end)));
        }
    }

    //! The pixels of a class in rows of quads from one on.
    void sweepPart(int c, int row, const BoundaryList::Part& part)
    {
        Point p(0, 2 * row + (c >> 1));
        int left = labels_.index(p);
        uchar* marks = sweeper_.marks_.row(row);
        for (int first = 0; first < part.count; first += RegionChoice::BATCH)
        {
            RegionChoice::Gain gains[RegionChoice::BATCH];
            const int count = std::min<int>(part.count - first, RegionChoice::BATCH);
            const int n = choice_.findGains(part.pixels + first, count, p.y, gains);
            for (int i = 0; i < n; i++)
            {
                for (; gains[i].pixel - left >= labels_.step(); p.y += 2)
                {
                    left += 2 * labels_.step();
                    marks += marks_step_;
                }
                p.x = gains[i].pixel - left;
                if (sums_[gains[i].region].area <= rules_.most_area &&
                    (all_permitted_ || permits(p, gains[i].region)))
                    move(c, marks + p.x / 2, gains[i]);
            }
        }
    }

    bool permits(Point p, int to) const
    {
        return (rules_.markers.empty() || rules_.markers.at<int>(p) < 0) &&
               (!rules_.guard || rules_.guard->permits(p, labels_.row(p.y)[p.x], to));
    }

    //! mark is that of the quad of the pixel.
    void move(int c, uchar* mark, const RegionChoice::Gain& to)
    {
        int& label = labels_.data()[to.pixel];
        if (!rules_.last)
        {
            const Move made = { to.pixel, label, to.region, features_[to.pixel] };
            moves_.add(made);
            markAround(c, mark);
        }
        label = to.region;
        changeMasks(sweeper_.masks_.data() + to.pixel, to.mask);
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

    //! Marks the pixel of a move and its 4-neighbours. Two of these lie in its quad, the others beside that.
    void markAround(int c, uchar* mark)
    {
        mark[0] |= uchar(ALL_CLASSES & ~(1 << (3 - c)));
        mark[c & 1 ? 1 : -1] |= uchar(1 << (c ^ 1));
        mark[c & 2 ? marks_step_ : -marks_step_] |= uchar(1 << (c ^ 2));
    }

    const MaskTable& table_;
    const RegionChoice& choice_;
    const Feature* const features_;
    const SweepRules& rules_;
    const bool all_permitted_;
    const RegionSum* const sums_;
    Padded<int>& labels_;
    BoundarySweeper& sweeper_;
    Moves& moves_;
    const int marks_step_;
};

void BoundarySweeper::Moves::clear()
{
    list.clear();
    lowest_region = INT_MAX;
    highest_region = -1;
}

void BoundarySweeper::Moves::add(const Move& move)
{
    list.push_back(move);
    lowest_region = std::min(lowest_region, std::min(move.from, move.to));
    highest_region = std::max(highest_region, std::max(move.from, move.to));
}

BoundaryList& BoundarySweeper::listOf(int band)
{
    Lists& lists = lists_[band / bands_in_group_];
    return band % bands_in_group_ == 0 ? lists.first : band % 2 == 0 ? lists.even : lists.odd;
}

//! The last sweep makes no marks, but counts in quads, too.
void BoundarySweeper::begin(Size size, bool last)
{
    const Size in_quads((size.width + 1) / 2, (size.height + 1) / 2);
    masks_.create(size, uchar(INTERIOR));
    if (last)
        marks_.reserve(in_quads);
    else
        marks_.create(in_quads, uchar(0));
}

//! Lists the whole boundary in some rows of quads, which have no marks yet.
void BoundarySweeper::listAll(const Range& rows, bool last, BoundaryList& list)
{
    if (!last)
        for (int row = rows.start; row < rows.end; row++)
            std::fill_n(marks_.row(row), marks_.size().width, uchar(0));
    listBoundary(masks_, rows, list);
}

//! The rows of pixels in some rows of quads.
static Range pixelRows(const Range& rows, int height) { return Range(2 * rows.start, std::min(2 * rows.end, height)); }

//! Reads the pixels of some rows of quads once, in order, before a sweep reads them here and there: so they come into
//! the cache faster.
static void readAhead(const FeatureMap& features, const Range& rows)
{
    const int LINE = 64 / int(sizeof(Feature)); // of a cache
    const Range pixel_rows = pixelRows(rows, features.size().height);
    for (int y = pixel_rows.start; y < pixel_rows.end; y++)
    {
        const volatile Feature* row = features.row(y);
        for (int x = 0; x < features.size().width; x += LINE)
            static_cast<void>(uchar(row[x].depth));
    }
}

//! Those of one of some sweeps, of which so many follow.
static SweepRules rulesOfOne(const SweepRules& rules, int num_following)
{
    SweepRules of_one = rules;
    of_one.last = rules.last && num_following == 0;
    return of_one;
}

//! Masks may be found band by band: the rows beside another band have not moved when it begins.
void BoundarySweeper::sweepAll(int count, const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
                               Regions& regions)
{
    const SweepRules first = rulesOfOne(rules, count - 1);
    begin(labels.size(), first.last);
    sweep([&](const Range& rows, BoundaryList& list)
    {
        findMasks(labels, pixelRows(rows, labels.size().height), masks_);
        listAll(rows, first.last, list);
    }, features, first, labels, regions);
    sweepAgain(count - 1, features, rules, labels, regions);
}

void BoundarySweeper::sweepBlocks(int count, const Padded<int>& blocks, const BlockGrid& grid,
                                  const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
                                  Regions& regions)
{
    const SweepRules first = rulesOfOne(rules, count - 1);
    begin(features.size(), first.last);
    labels.create(features.size(), OUTSIDE);
    sweep([&](const Range& rows, BoundaryList& list)
    {
        const Range pixel_rows = pixelRows(rows, labels.size().height);
        spreadLabels(blocks, grid, pixel_rows, labels);
        findMasksInBlocks(blocks, grid, pixel_rows, masks_);
        listAll(rows, first.last, list);
    }, features, first, labels, regions);
    sweepAgain(count - 1, features, rules, labels, regions);
}

void BoundarySweeper::sweepAgain(int count, const FeatureMap& features, const SweepRules& rules,
                                 Padded<int>& labels, Regions& regions)
{
    for (int i = 0; i < count && moved_; i++)
        sweep([&](const Range& rows, BoundaryList& list) { listMarked(masks_, rows, marks_, list); }, features,
              rulesOfOne(rules, count - 1 - i), labels, regions);
}

void BoundarySweeper::sweep(const List& list, const FeatureMap& features, const SweepRules& rules,
                            Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    const RegionChoice choice(features, labels, masks_, regions, rules.distance, rules.length_price);
    const Pass pass = { list, choice, features, rules, regions, labels };
    divideIntoGroups();
    sweepGroups(pass);
    moved_ = std::any_of(moves_.begin(), moves_.end(), [](const Moves& moves) { return !moves.list.empty(); });
    if (!rules.last)
        updateRegions(features, rules.guard, regions);
}

int BoundarySweeper::numBands() const { return (marks_.size().height + BAND_HEIGHT - 1) / BAND_HEIGHT; }

//! No band has moves yet, and no group has lists.
void BoundarySweeper::divideIntoGroups()
{
    const int num_bands = numBands(), most_groups = countGroups();
    bands_in_group_ = std::max<int>(FEWEST_BANDS, (num_bands + most_groups - 1) / most_groups);
    lists_.resize((num_bands + bands_in_group_ - 1) / bands_in_group_);
    moves_.resize(2 * num_bands - 1);
    for (size_t i = 0; i < moves_.size(); i++)
        moves_[i].clear();
}

//! First the groups, at the same time, then what is left between them.
void BoundarySweeper::sweepGroups(const Pass& pass)
{
    const int num_groups = int(lists_.size()), num_bands = numBands();
    parallel_for_(Range(0, num_groups), [&](const Range& groups)
    {
        const int end = std::min(groups.end * bands_in_group_, num_bands);
        for (int band = groups.start * bands_in_group_; band < end; band++)
        {
            sweepWithin(band, pass);
            if (band % bands_in_group_ != 0)
                sweepAbove(band, pass);
        }
    });
    parallel_for_(Range(1, num_groups), [&](const Range& groups)
    {
        for (int group = groups.start; group < groups.end; group++)
            sweepAbove(group * bands_in_group_, pass);
    });
}

void BoundarySweeper::sweepWithin(int band, const Pass& pass)
{
    const int height = marks_.size().height;
    const Range rows(band * BAND_HEIGHT, std::min((band + 1) * BAND_HEIGHT, height));
    listOf(band).begin(rows.start, size_t(rows.size()) * marks_.size().width);
    pass.list(rows, listOf(band));
    readAhead(pass.features, rows);
    Wave(pass, *this, moves_[band]).run(ClassRows::within(rows, height));
}

//! What is left between a band and the one above it, when both are done.
void BoundarySweeper::sweepAbove(int band, const Pass& pass)
{
    const ClassRows rows = ClassRows::between(band * BAND_HEIGHT, marks_.size().height);
    Wave(pass, *this, moves_[numBands() + band - 1]).run(rows);
}

//! In stripes, of which each reads all moves.
void BoundarySweeper::updateRegions(const FeatureMap& features, VariationGuard* guard, Regions& regions) const
{
    const int stripes = countGroups(), n = regions.size();
    parallel_for_(Range(0, stripes), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            updateRegions(Range(int(int64(n) * i / stripes), int(int64(n) * (i + 1) / stripes)), features, guard,
                          regions);
    });
}

//! Sums and means of some regions. Most moves are of regions near to each other, which have numbers near to each other,
//! so few are read for nothing.
void BoundarySweeper::updateRegions(const Range& range, const FeatureMap& features, VariationGuard* guard,
                                    Regions& regions) const
{
    const auto add = [&](const Feature& feature, Point place, int region, int times)
    {
        if (region < range.start || region >= range.end)
            return;
        regions.sums[region].add(feature, times);
        if (regions.surfaces.present)
            regions.surfaces.sums[region].add(feature, features.normalAt(place), place, times);
        if (guard)
            guard->add(place, region, times);
    };
    const bool needs_places = regions.surfaces.present || guard;
    for (size_t i = 0; i < moves_.size(); i++)
        for (size_t k = 0; k < moves_[i].list.size() && moves_[i].meets(range); k++)
        {
            const Move& move = moves_[i].list[k];
            const Point place = needs_places ? features.point(move.index) : Point();
            add(move.feature, place, move.from, -1);
            add(move.feature, place, move.to, 1);
        }
    regions.update(range);
    if (guard)
        guard->update(range);
}

}}} // namespace
