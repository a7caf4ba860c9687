// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/pair_choice.hpp"
#include <numeric>

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! Bins of equal width for the costs of some pairs, from the lowest to the highest one.
class CostBins
{
public:
    enum { COUNT = 1024 };

    explicit CostBins(const std::vector<MergePair>& pairs) : shift_(0)
    {
        unsigned lowest = UINT_MAX, highest = 0;
        for (const MergePair& pair : pairs)
        {
            lowest = std::min(lowest, costOf(pair.price));
            highest = std::max(highest, costOf(pair.price));
        }
        lowest_ = lowest;
        while ((highest - lowest) >> shift_ >= unsigned(COUNT))
            shift_++;
    }

    //! Dearer ones are beyond the last bin.
    unsigned operator()(uint64 price) const { return (costOf(price) - lowest_) >> shift_; }

    //! So many bins are as wide as a difference of costs.
    unsigned width(unsigned costs) const { return costs >> shift_; }

private:
    unsigned lowest_;
    int shift_;
};

} // namespace

static std::vector<int> countPairs(const std::vector<MergePair>& pairs, CostBins bins)
{
    std::vector<int> counts(CostBins::COUNT, 0);
    for (const MergePair& pair : pairs)
        counts[bins(pair.price)]++;
    return counts;
}

//! In each bin, the cheapest unions of all regions; a pair is the wish of two.
static std::vector<int> countWishes(const std::vector<MergeBand>& bands, const std::vector<uint64>& best, CostBins bins)
{
    std::vector<int> wishes(CostBins::COUNT, 0);
    for (const MergeBand& band : bands)
        for (int region : band.active)
        {
            const unsigned bin = bins(best[region]);
            if (bin < CostBins::COUNT)
                wishes[bin]++;
        }
    return wishes;
}

//! How many of the pairs, which were counted, are not much dearer than the unions that are still to be done: the
//! cheapest ones that regions want, of which most wait for a third region. Without this, the last rounds of an even
//! image would unite cells, and leave parts of others.
static size_t countTimely(const std::vector<int>& counts, const std::vector<int>& wishes, CostBins bins,
                          size_t num_to_do)
{
    const unsigned DOUBLED = LOG_ONE * EXPONENT_ONE; // cost, which is a logarithm
    unsigned bin = 0;
    for (size_t num_wanted = 0; bin < CostBins::COUNT && num_wanted < num_to_do; bin++)
        num_wanted += wishes[bin] - counts[bin];
    const unsigned end = std::min<unsigned>(bin + bins.width(DOUBLED), CostBins::COUNT);
    return size_t(std::accumulate(counts.begin(), counts.begin() + end, 0));
}

//! Keeps so many of the pairs, which were counted: all of the cheaper bins, and the first ones of the last bin.
static void keepCheapest(const std::vector<int>& counts, CostBins bins, size_t num_kept, std::vector<MergePair>& pairs)
{
    unsigned limit = 0; // the last bin
    size_t rest = num_kept;
    for (; rest > size_t(counts[limit]); limit++)
        rest -= counts[limit];
    size_t end = 0;
    for (const MergePair pair : pairs)
    {
        const unsigned bin = bins(pair.price);
        const bool at_limit = (bin == limit) & (rest > 0);
        pairs[end] = pair;
        end += (bin < limit) | at_limit;
        rest -= at_limit;
    }
    pairs.resize(end);
}

void choosePairs(const std::vector<MergeBand>& bands, const std::vector<uint64>& best, size_t count, size_t num_to_do,
                 std::vector<MergePair>& chosen)
{
    chosen.clear();
    for (const MergeBand& band : bands)
        chosen.insert(chosen.end(), band.pairs.begin(), band.pairs.end());
    const CostBins bins(chosen);
    const std::vector<int> counts = countPairs(chosen, bins);
    const size_t num_timely = num_to_do < chosen.size()
            ? countTimely(counts, countWishes(bands, best, bins), bins, num_to_do) : chosen.size();
    keepCheapest(counts, bins, std::min(count, num_timely), chosen);
}

//! Each region with its best neighbour, the cheapest first. votes are how many want to go into a region.
static std::vector<MergePair> listWishes(const std::vector<MergeBand>& bands, const std::vector<uint64>& best,
                                         std::vector<int>& votes)
{
    std::vector<MergePair> wishes;
    for (const MergeBand& band : bands)
        for (int region : band.active)
        {
            const MergePair wish(best[region], region, neighborOf(region, best[region]));
            wishes.push_back(wish);
            votes[wish.to]++;
        }
    std::sort(wishes.begin(), wishes.end());
    return wishes;
}

//! What many want to go into stays, so that no round does little. What took in so many that it is larger than usual,
//! and twice as large as it was, takes in no more.
void chooseOneSided(const std::vector<MergeBand>& bands, const std::vector<uint64>& best,
                    const std::vector<MergeRegion>& records, int log_usual_area, double share, size_t most,
                    std::vector<MergePair>& chosen)
{
    const int MANY = 16, DOUBLED = LOG_ONE; // area
    enum { GONE = 1, TOOK = 2 };
    std::vector<int> votes(records.size(), 0);
    std::vector<uchar> states(records.size(), 0);
    std::vector<float> areas(records.size(), 0.f); // of what took in others
    std::vector<MergePair> wishes = listWishes(bands, best, votes);
    wishes.resize(size_t(std::ceil(share * double(wishes.size()))));
    chosen.clear();
    for (size_t i = 0; i < wishes.size() && chosen.size() < most; i++)
    {
        const MergePair& wish = wishes[i];
        if (votes[wish.from] > MANY || states[wish.from] != 0 || states[wish.to] == GONE)
            continue;
        const float area = std::max(areas[wish.to], records[wish.to].area) + records[wish.from].area;
        if (states[wish.to] == TOOK &&
            logarithm(area) > std::max(log_usual_area, logarithm(records[wish.to].area) + DOUBLED))
            continue;
        areas[wish.to] = area;
        states[wish.from] = GONE;
        states[wish.to] = TOOK;
        chosen.push_back(wish);
    }
}

}}} // namespace
