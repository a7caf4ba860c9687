// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/boundary_sweep.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! One sweep in two steps: every pixel of the boundary chooses a region by the labels as they are
//! at the beginning, all at once; then those that chose another one move in turn, as far as it
//! still pays. So no region runs along an edge in the order of the sweep.
class BoundarySweep
{
public:
    BoundarySweep(const Padded<Feature>& features, const RegionDistance& distance, int length_price,
                  const VariationGuard* guard, Padded<int>& labels, Regions& regions)
        : table_(maskTable()), features_(features), distance_(distance), guard_(guard), labels_(labels),
          regions_(regions)
    {
        const int step = labels.step();
        const int offsets[8] = { -step - 1, -step, -step + 1, 1, step + 1, step, step - 1, -1 };
        for (int mask = 0; mask < 256; mask++)
        {
            savings_[mask] = length_price * table_.agreement(mask);
            first_offsets_[mask] = offsets[table_.first(mask & MaskTable::FOUR_NEIGHBORS)];
            last_offsets_[mask] = offsets[table_.last(mask & MaskTable::FOUR_NEIGHBORS)];
        }
    }

    //! Lists the moves that lower the energy.
    void choose(const std::vector<BoundaryPixel>& boundary, std::vector<Move>& moves) const
    {
        enum { BATCH = 256 };
        OpenPixel open[BATCH];
        size_t num_moves = 0;
        for (size_t first = 0; first < boundary.size(); first += BATCH)
        {
            const int n = int(std::min(boundary.size() - first, size_t(BATCH)));
            const int count = distance_.with_depth ? findOpen<true>(&boundary[first], n, open)
                                                   : findOpen<false>(&boundary[first], n, open);
            moves.resize(num_moves + count);
            for (int i = 0; i < count; i++)
            {
                const BoundaryPixel& pixel = boundary[first + open[i].position];
                const Move move = { pixel.index, labels_.data()[pixel.index], chooseRegion(pixel, open[i].energy) };
                moves[num_moves] = move;
                num_moves += move.to != move.from;
            }
        }
        moves.resize(num_moves);
    }

    //! Makes the moves that are still allowed and still pay, in turn. The others leave the list.
    void move(std::vector<Move>& moves)
    {
        size_t made = 0;
        for (size_t i = 0; i < moves.size(); i++)
        {
            if (!pays(moves[i]))
                continue;
            labels_.data()[moves[i].index] = moves[i].to;
            moves[made++] = moves[i];
        }
        moves.resize(made);
    }

private:
    //! A pixel that another region may win.
    struct OpenPixel
    {
        int position, energy;
    };

    //! Most pixels lie near to the mean of their region and far from that of the one beside it. They are passed over
    //! here, in a loop without branches: no one could foresee which they are.
    template <bool WITH_DEPTH> int findOpen(const BoundaryPixel* boundary, int n, OpenPixel* open) const
    {
        int count = 0;
        for (int i = 0; i < n; i++)
        {
            const BoundaryPixel& pixel = boundary[i];
            const int* label = labels_.data() + pixel.index;
            const int others = ~pixel.mask & 255, other = label[first_offsets_[others]];
            const Vec2i squares = distance_.squared<WITH_DEPTH>(features_.data()[pixel.index], regions_.means[*label],
                                                                regions_.means[std::max(other, 0)]);
            const OpenPixel candidate = { i, squares[0] - savings_[pixel.mask] };
            open[count] = candidate;
            // Others can save no more boundary than with all neighbours but these.
            const bool wins = squares[1] - savings_[others] < candidate.energy;
            const bool another_wins = -savings_[others] < candidate.energy;
            const bool several = (label[last_offsets_[others]] != other) | table_.isTip(pixel.mask);
            count += wins | (another_wins & several);
        }
        return count;
    }

    //! The region of a 4-neighbour of the lowest energy, if that is lower than the energy of its own.
    int chooseRegion(const BoundaryPixel& pixel, int energy) const
    {
        const int* label = labels_.data() + pixel.index;
        int best = *label, others = ~pixel.mask & 255;
        do
        {
            const int region = label[first_offsets_[others]];
            const int mask = neighborMask(label, labels_.step(), region);
            const int e = distance_.squared(features_.data()[pixel.index], regions_.means[std::max(region, 0)]) -
                          savings_[mask];
            const bool better = (e < energy) & (region != OUTSIDE);
            best = better ? region : best;
            energy = better ? e : energy;
            others &= ~mask;
        }
        while (others & MaskTable::FOUR_NEIGHBORS);
        return best;
    }

    //! Whether a pixel still may leave its region and gains by it.
    bool pays(const Move& move) const
    {
        const int* label = labels_.data() + move.index;
        const int mask_from = neighborMask(label, labels_.step(), move.from);
        const int mask_to = neighborMask(label, labels_.step(), move.to);
        if (!table_.canLeave(mask_from) || !(mask_to & MaskTable::FOUR_NEIGHBORS))
            return false;
        const Vec2i squares = distance_.squared<true>(features_.data()[move.index], regions_.means[move.from],
                                                      regions_.means[move.to]);
        return squares[1] - savings_[mask_to] < squares[0] - savings_[mask_from] &&
               (!guard_ || guard_->permits(labels_.point(move.index), move.from, move.to));
    }

    const MaskTable& table_;
    const Padded<Feature>& features_;
    const RegionDistance distance_;
    const VariationGuard* const guard_;
    Padded<int>& labels_;
    Regions& regions_;
    int savings_[256];                             // in energy, by mask of the neighbours that agree
    int first_offsets_[256], last_offsets_[256]; // of the 4-neighbours in a mask
};

//! Every second group of bands, beginning with one of them: no two of these touch, so they move at the same time.
//! @note Groups are high because what the order of the moves decides, such as the side of an edge that a strip of one
//! pixel in width goes along, changes between them.
static void moveEverySecond(int first, BoundarySweep& sweep, std::vector<std::vector<Move> >& moves)
{
    const int GROUP = 4, count = (int(moves.size()) + GROUP - 1) / GROUP;
    parallel_for_(Range(0, (count - first + 1) / 2), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
        {
            const int begin = (first + 2 * i) * GROUP, end = std::min(begin + GROUP, int(moves.size()));
            for (int k = begin; k < end; k++)
                sweep.move(moves[k]);
        }
    });
}

//! A list for one thread; the next one that needs a list gets it, with its memory.
//! @note cv::TLSData cannot be used: its destructor allocates, and ends the program where there is no memory.
class BorrowedList
{
public:
    BorrowedList(std::list<BoundaryList>& lists, Mutex& mutex) : lists_(lists), mutex_(mutex)
    {
        AutoLock lock(mutex_);
        if (lists_.empty())
            lists_.emplace_back();
        list_.splice(list_.begin(), lists_, lists_.begin());
    }
    ~BorrowedList()
    {
        AutoLock lock(mutex_);
        lists_.splice(lists_.begin(), list_);
    }
    BoundaryList& get() { return list_.front(); }

private:
    std::list<BoundaryList>& lists_;
    Mutex& mutex_;
    std::list<BoundaryList> list_;
};

void BoundarySweeper::start(const Padded<Feature>& features, const BoundaryEnergy& energy, const Mat& markers,
                            Padded<int>& labels, Regions& regions)
{
    features_ = &features;
    energy_ = &energy;
    markers_ = markers;
    labels_ = &labels;
    regions_ = &regions;
}

void BoundarySweeper::sweepAll()
{
    sweep([&](const Range& rows, BoundaryList& boundary) { listBoundary(*labels_, rows, boundary); }, 0);
}

void BoundarySweeper::sweepAllOfBlocks(const Padded<int>& blocks)
{
    sweep([&](const Range& rows, BoundaryList& boundary)
    {
        listBoundaryOfBlocks(blocks, *labels_, rows, boundary);
    }, 0);
}

void BoundarySweeper::sweepAgain(int count, VariationGuard* guard)
{
    if (count > 0)
        marks_.resize(size_t(labels_->step()) * (labels_->size().height + 2));
    for (int i = 0; i < count && moved(); i++)
        sweep([&](const Range& rows, BoundaryList& boundary)
        {
            listBoundaryAroundMoves(*labels_, rows, last_moves_, marks_, boundary);
        }, guard);
}

bool BoundarySweeper::moved() const
{
    for (size_t i = 0; i < moves_.size(); i++)
        if (!moves_[i].empty())
            return true;
    return false;
}

//! One sweep over what is listed, but for the pixels of markers.
void BoundarySweeper::sweep(const ListBoundary& list, VariationGuard* guard)
{
    CV_TRACE_FUNCTION();
    const int height = labels_->size().height;
    moves_.swap(last_moves_);
    moves_.resize((height + SWEEP_BAND_HEIGHT - 1) / SWEEP_BAND_HEIGHT);
    BoundarySweep sweep(*features_, energy_->distance, energy_->length_price, guard, *labels_, *regions_);
    Mutex mutex;
    parallel_for_(Range(0, int(moves_.size())), [&](const Range& range)
    {
        BorrowedList borrowed(lists_, mutex);
        BoundaryList& boundary = borrowed.get();
        for (int i = range.start; i < range.end; i++)
        {
            boundary.pixels.clear();
            list(Range(i * SWEEP_BAND_HEIGHT, std::min((i + 1) * SWEEP_BAND_HEIGHT, height)), boundary);
            if (!markers_.empty())
                keepMarkers(markers_, *labels_, boundary);
            sweep.choose(boundary.pixels, moves_[i]);
        }
    });
    moveEverySecond(0, sweep, moves_);
    moveEverySecond(1, sweep, moves_);

    for (size_t i = 0; i < moves_.size(); i++)
        for (size_t k = 0; k < moves_[i].size(); k++)
        {
            const Move& move = moves_[i][k];
            const Feature& feature = features_->data()[move.index];
            regions_->sums[move.from].add(feature, -1);
            regions_->sums[move.to].add(feature);
            if (guard)
                guard->move(labels_->point(move.index), move.from, move.to);
        }
    regions_->update();
    if (guard)
        guard->update();
}

}}} // namespace
