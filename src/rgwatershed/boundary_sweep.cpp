// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/boundary_sweep.hpp"
#include "rgwatershed/region_labels.hpp"
#include <atomic>

namespace cv { namespace ximgproc { namespace gws {

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

//! Masks may be found band by band: the rows beside another band have not moved when it begins. The last sweep makes no
//! marks.
void BoundarySweeper::sweepFrom(const MaskFinder& find, int count, const FeatureMap& features,
                                const SweepRules& rules, Padded<int>& labels, Regions& regions)
{
    const SweepRules first = rulesOfOne(rules, count - 1);
    const Size size = features.size();
    masks_.create(size, uchar(INTERIOR));
    if (!first.last)
        marks_.create(size, uchar(0));
    sweep([&](const Range& rows, BoundaryList& list)
    {
        const Range pixel_rows = pixelRows(rows, size.height);
        find(pixel_rows);
        for (int y = pixel_rows.start; y < pixel_rows.end && !first.last; y++)
            std::fill_n(marks_.row(y), size.width, uchar(0));
        listBoundary(masks_, rows, list);
    }, features, first, labels, regions);
    sweepAgain(count - 1, features, rules, labels, regions);
}

void BoundarySweeper::sweepAll(int count, const FeatureMap& features, const SweepRules& rules, Padded<int>& labels,
                               Regions& regions)
{
    sweepFrom([&](const Range& rows) { findMasks(labels, rows, masks_); }, count, features, rules, labels, regions);
}

void BoundarySweeper::sweepBlocks(int count, const BoundarySweeper& of_blocks, const Padded<int>& blocks,
                                  const BlockGrid& grid, const FeatureMap& features, const SweepRules& rules,
                                  Padded<int>& labels, Regions& regions)
{
    labels.create(features.size(), OUTSIDE);
    sweepFrom([&](const Range& rows)
    {
        spreadLabels(blocks, grid, rows, labels);
        findMasksInBlocks(of_blocks.masks_, grid, rows, masks_);
    }, count, features, rules, labels, regions);
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
    const SweepBands bands((masks_.size().height + 1) / 2);
    const WaveTables tables = { choice, features, rules, regions, labels, masks_, marks_, lists_, bands };
    lists_.divide(bands.count(), std::max(1, getNumThreads()));
    moves_.resize(2 * bands.count() - 1);
    for (Moves& moves : moves_)
        moves.clear();
    sweepGroups(list, tables);
    moved_ = std::any_of(moves_.begin(), moves_.end(), [](const Moves& moves) { return !moves.list.empty(); });
    if (!rules.last)
        updateRegions(features, rules.guard, regions);
}

//! Groups at the same time. What is left between two of them is swept by the thread that finishes the second one.
void BoundarySweeper::sweepGroups(const List& list, const WaveTables& tables)
{
    const int num_groups = lists_.numGroups();
    std::vector<std::atomic<int> > finished(num_groups + 1); // of the two groups beside each limit
    for (std::atomic<int>& count : finished)
        count = 0;
    parallel_for_(Range(0, num_groups), [&](const Range& groups)
    {
        for (int group = groups.start; group < groups.end; group++)
        {
            for (int band = lists_.firstBand(group); band < lists_.firstBand(group + 1); band++)
            {
                sweepWithin(band, list, tables);
                if (band != lists_.firstBand(group))
                    sweepAbove(band, tables);
            }
            for (int limit = group; limit <= group + 1; limit++)
                if (++finished[limit] == 2)
                    sweepAbove(lists_.firstBand(limit), tables);
        }
    });
}

void BoundarySweeper::sweepWithin(int band, const List& list, const WaveTables& tables)
{
    const Range rows = tables.bands[band];
    const int width = (masks_.size().width + 1) / 2;
    BoundaryList& of_band = lists_.of(band);
    of_band.begin(rows.start, size_t(rows.size()) * width);
    list(rows, of_band);
    readAhead(tables.features, rows);
    runWave(tables, ClassRows::within(rows, tables.bands.numRows()), moves_[band]);
}

//! What is left between a band and the one above it, when both are done.
void BoundarySweeper::sweepAbove(int band, const WaveTables& tables)
{
    const SweepBands& bands = tables.bands;
    runWave(tables, ClassRows::between(bands.first(band), bands.numRows()), moves_[bands.count() + band - 1]);
}

//! In stripes, of which each reads all moves.
void BoundarySweeper::updateRegions(const FeatureMap& features, VariationGuard* guard, Regions& regions) const
{
    const int stripes = std::max(1, getNumThreads()), n = regions.size();
    parallel_for_(Range(0, stripes), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            updateRegions(Range(int(int64(n) * i / stripes), int(int64(n) * (i + 1) / stripes)), features, guard,
                          regions);
    });
    if (guard)
        guard->joinOwned();
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
    for (const Moves& moves : moves_)
    {
        if (!moves.meets(range))
            continue;
        for (const Move& move : moves.list)
        {
            const Point place = needs_places ? features.point(move.index) : Point();
            add(move.feature, place, move.from, -1);
            add(move.feature, place, move.to, 1);
        }
    }
    regions.update(range);
    if (guard)
        guard->update(range);
}

}}} // namespace
