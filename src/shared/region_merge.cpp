// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/region_merge.hpp"
#include <numeric>

namespace cv { namespace ximgproc { namespace gws {

// A round: each region finds the neighbour with which its union costs least. Where two regions are that to each other,
// they are a pair; the cheaper pairs are united. All is done by passes over the edges and over the regions, in the
// order of the image. No region is in two pairs, so bands of regions can be worked on at the same time.

// Of the pairs, such a share is united in a round: always the same one where the order of all unions counts; else as
// many times SHARE_AT_END as there are regions for each one that is wanted, up to a highest share.
static const double SHARE_IN_ORDER = 0.4, SHARE_AT_END = 0.35, HIGHEST_SHARE = 0.8;
static const uint64 NO_PRICE = ~uint64(0);

//! Cheaper unions first; of equal costs that of the nearest numbers, which differs for all neighbours of a region.
static inline uint64 priceOf(int cost, int a, int b)
{
    return (uint64(unsigned(cost) ^ 0x80000000u) << 32) | unsigned(a ^ b);
}

//! Larger for a larger cost, without a sign.
static inline unsigned costOf(uint64 price) { return unsigned(price >> 32); }

static inline int neighborOf(int region, uint64 price) { return int(unsigned(price)) ^ region; }

SimilarMerger::SimilarMerger(const RegionDistance& distance, const MergeRules& rules, MergeBuffers& buffers,
                             Regions& regions, const UnionPlan& plan)
    : distance_(distance), rules_(rules), plan_(plan), b_(buffers), regions_(regions), num_left_(regions.size())
{
    start();
}

//! Sets the area that is usual when so many regions are left. All costs change with it.
void SimilarMerger::expect(int num_regions)
{
    log_usual_area_ = logarithm(std::max(1.f, rules_.usual * float(area_ / num_regions)));
    expects_anew_ = true;
}

void SimilarMerger::run(int num_regions)
{
    expect(num_regions);
    while (num_left_ > num_regions && runRound(num_regions, false))
        if (num_left_ > num_regions)
            b_.graph.relabel(b_.parents, b_.changed);
}

//! The three highest bits: how many regions there are, so roughly that costs are taken anew a few times only.
static int leadingBits(int n)
{
    int lowest = 1;
    while (n / lowest >= 8)
        lowest *= 2;
    return n / lowest * lowest;
}

std::vector<Vec2i> SimilarMerger::runToTheEnd()
{
    std::vector<Vec2i> unions;
    int expected = leadingBits(num_left_);
    expect(expected);
    while (runRound(1, true))
    {
        for (size_t i = 0; i < b_.chosen.size(); i++)
            unions.push_back(Vec2i(b_.chosen[i].from, b_.chosen[i].to));
        b_.graph.relabel(b_.parents, b_.changed);
        if (leadingBits(num_left_) == expected)
            continue;
        expected = leadingBits(num_left_);
        expect(expected);
    }
    return unions;
}

void SimilarMerger::start()
{
    const int n = regions_.size();
    b_.records.resize(n);
    b_.parents.resize(n);
    b_.changed.resize(n);
    b_.best.resize(n);
    b_.bands.resize(b_.graph.numBands());
    b_.graph.forBands([&](int k, std::vector<int>&)
    {
        const Range band = b_.graph.band(k);
        b_.bands[k].active.resize(band.size());
        for (int i = band.start; i < band.end; i++)
        {
            b_.parents[i] = b_.bands[k].active[i - band.start] = i;
            b_.records[i] = describe(i);
        }
    });
    area_ = 0;
    for (int i = 0; i < n; i++)
        area_ += b_.records[i].area;
}

//! Of all channels, without a sign.
static int riseOfColors(int lightness, int chroma, int other_chroma, float weight)
{
    const int64 x = lightness, y = cvRound(weight * float(chroma)), z = cvRound(weight * float(other_chroma));
    return std::min(cvRound(std::sqrt(double(x * x + y * y + z * z))), int(STEEPEST_SLOPE));
}

//! Steps are divided by pixels, not by their own number. So a narrow region, with few of them, counts as a smooth one.
void SimilarMerger::describeTexture(int region, MergeRegion& record) const
{
    const float FINE = STEPS_PER_LEVEL, FLAT = FINE / 2; // for each pixel; less is like none
    const RegionTexture& texture = b_.textures[region];
    const float area = float(regions_.sums[region].area), steps = texture.across + texture.down;
    record.texture = short(logarithm(steps + FINE * area) - logarithm(area));
    record.direction = short(logarithm(texture.across + FLAT * area) - logarithm(texture.down + FLAT * area));
    describeSlope(texture, 1 / area, record);
}

//! How unlike the rises of lightness are in the blocks of a region, squared: on a slope all of them rise alike, at an
//! edge a few rise much.
static float unevennessOf(const RegionTexture& texture, float share)
{
    const float FLAT = 0.35f * float(SLOPE_OF_LEVEL);
    float sum = 0;
    for (int i = 0; i < 2; i++)
    {
        const float mean = texture.rises[0][i] * share;
        sum += texture.squares[0][i] * share - mean * mean;
    }
    return std::max(sum - FLAT * FLAT, 0.f);
}

//! Steps that are no slope go up and down, or are of the other channels: noise, as far as they are small. Where nearly
//! all steps are one slope of all channels, this is that of the region, and it has no roughness. Chroma that rises by
//! three levels or more for each pixel is an edge or a pattern.
void SimilarMerger::describeSlope(const RegionTexture& texture, float share, MergeRegion& record) const
{
    const float LEVEL = SLOPE_OF_LEVEL;
    int rises[3][2], light = 0, chroma = 0;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
        {
            rises[k][i] = cvRound(texture.rises[k][i] * share);
            (k == 0 ? light : chroma) += std::abs(rises[k][i]);
        }
    const int others = cvRound((texture.across + texture.down) * share * LEVEL / STEPS_PER_LEVEL) - light;
    const bool is_ramp = (others - chroma - cvRound(rules_.uneven * LEVEL)) * 20 <= chroma;
    const bool is_shade = is_ramp && chroma > SLOPE_OF_LEVEL / 10 && chroma < 3 * SLOPE_OF_LEVEL;
    for (int i = 0; i < 2; i++)
        record.slope[i] = short(is_shade ? riseOfColors(rises[0][i], rises[1][i], rises[2][i], rules_.chroma_slope)
                                         : rises[0][i]);
    const int noise = std::max(others - cvRound(rules_.grain * LEVEL), 0) * rules_.roughness / 64;
    const float rough = std::sqrt(float(noise) * float(noise) + unevennessOf(texture, share));
    record.rough = is_shade ? int(IS_SHADE) : cvRound(std::min(rough, float(STEEPEST_SLOPE)));
}

MergeRegion SimilarMerger::describe(int region) const
{
    const RegionMean& mean = regions_.means[region];
    const RegionSum& sum = regions_.sums[region];
    const float scale = rules_.on_surface && mean.depth != RegionMean::NO_DEPTH
            ? areaScale(mean.depth, regions_.surfaces.camera) : 1.f;
    const float area = float(sum.area) * scale;
    MergeRegion record = { { 0, 0, 0, mean.depth }, area, { 0, 0 },
                           0, 0, float(sum.color[0] + 16 * int64(sum.area)) * scale,
                           plan_.parts.empty() ? region / rules_.in_cell : plan_.parts[region], 0 };
    for (int k = 0; k < 3; k++)
        record.mean[k] = short((distance_.weights[0][k] * mean.color[k]) >> FULL_WEIGHT_LOG2);
    if (!b_.textures.empty())
        describeTexture(region, record);
    return record;
}

//! Returns false if no region has a neighbour.
bool SimilarMerger::runRound(int num_wanted, bool in_order)
{
    evaluate();
    findPairs();
    size_t num_active = 0, num_pairs = 0;
    for (size_t k = 0; k < b_.bands.size(); k++)
    {
        num_active += b_.bands[k].active.size();
        num_pairs += b_.bands[k].pairs.size();
    }
    if (num_active == 0)
        return false;
    const size_t FEWEST = 32; // active regions for each pair; else they depend on each other in long chains, or on one
    const double share = in_order ? SHARE_IN_ORDER
            : std::min(HIGHEST_SHARE, SHARE_AT_END * double(num_left_) / num_wanted);
    const size_t most = num_left_ - num_wanted;
    const bool one_sided = num_pairs * FEWEST < num_active;
    if (one_sided)
        chooseOneSided(share, most);
    else
        choose(std::min(most, size_t(std::ceil(share * double(countWelcome(num_pairs))))), most);
    if (in_order)
        std::sort(b_.chosen.begin(), b_.chosen.end());
    unite(one_sided);
    return true;
}

//! Finds the costs of all unions, and the best one of each region.
void SimilarMerger::evaluate()
{
    const int num_bands = b_.graph.numBands();
    b_.graph.forLists([&](int k, std::vector<int>& table)
    {
        findCosts(k, table);
        if (k == num_bands)
            return; // edges between bands come when these are done
        const std::vector<int>& active = b_.bands[k].active;
        for (size_t i = 0; i < active.size(); i++)
            b_.best[active[i]] = NO_PRICE;
        findBest(b_.graph.edges(k));
    });
    findBest(b_.graph.edges(num_bands));
    expects_anew_ = false;
}

//! The costs of the edges of a list that are not known.
void SimilarMerger::findCosts(int k, std::vector<int>& table)
{
    const size_t first = b_.graph.join(k, table);
    UnionCost(distance_, rules_, b_.records.data(), regions_.surfaces.means.data(), log_usual_area_)
        .find(b_.graph.edges(k), expects_anew_ ? 0 : first);
}

void SimilarMerger::findBest(const EdgeList& list)
{
    uint64* best = b_.best.data();
    for (size_t i = 0; i < list.count; i++)
    {
        const MergeEdge& edge = list.edges[i];
        const uint64 price = priceOf(edge.cost, edge.a, edge.b), best_a = best[edge.a], best_b = best[edge.b];
        best[edge.a] = price < best_a ? price : best_a;
        best[edge.b] = price < best_b ? price : best_b;
    }
}

void SimilarMerger::findPairs()
{
    b_.graph.forBands([&](int k, std::vector<int>&) { findPairs(k); });
}

//! Pairs of regions that are the best to each other.
void SimilarMerger::findPairs(int band)
{
    std::vector<int>& active = b_.bands[band].active;
    std::vector<MergePair>& pairs = b_.bands[band].pairs;
    pairs.resize(active.size());
    const uint64* const best = b_.best.data();
    const int* const parents = b_.parents.data();
    uchar* const changed = b_.changed.data();
    size_t num_active = 0, num_pairs = 0;
    for (size_t i = 0; i < active.size(); i++)
    {
        const int region = active[i];
        const uint64 price = best[region];
        if (parents[region] != region || price == NO_PRICE)
            continue;
        active[num_active++] = region;
        changed[region] = 0;
        const int neighbor = neighborOf(region, price);
        const MergePair pair(price, neighbor, region);
        pairs[num_pairs] = pair;
        num_pairs += (region < neighbor) & (best[neighbor] == price);
    }
    active.resize(num_active);
    pairs.resize(num_pairs);
}

//! How many of the pairs are welcome. Those of two regions that should stay apart are only if there are no others: else
//! many of them would be united in each round, only because they are many.
size_t SimilarMerger::countWelcome(size_t num_pairs) const
{
    size_t num_kept = 0;
    for (size_t k = 0; k < b_.bands.size() && rules_.num_kept > 0; k++)
        num_kept += std::count_if(b_.bands[k].pairs.begin(), b_.bands[k].pairs.end(), [&](const MergePair& pair)
        {
            return std::max(pair.from, pair.to) < rules_.num_kept;
        });
    return num_kept < num_pairs ? num_pairs - num_kept : num_pairs;
}

//! Bins of equal width for costs from a lowest to a highest one.
struct CostBins
{
    CostBins(unsigned lowest_, unsigned highest) : lowest(lowest_), shift(0)
    {
        while ((highest - lowest) >> shift >= unsigned(COUNT))
            shift++;
    }

    //! Dearer ones are beyond the last bin.
    unsigned operator()(uint64 price) const { return (costOf(price) - lowest) >> shift; }

    enum { COUNT = 1024 };
    const unsigned lowest;
    int shift;
};

//! How many of the pairs, whose bins were counted, are not much dearer than the unions that are still to be done: the
//! cheapest ones that regions want, of which most wait for a third region. Without this, the last rounds of an even
//! image would unite cells, and leave parts of others.
size_t SimilarMerger::countTimely(const CostBins& bins, size_t num_to_do) const
{
    const unsigned DOUBLED = LOG_ONE * EXPONENT_ONE; // cost, which is a logarithm
    if (num_to_do >= b_.chosen.size())
        return b_.chosen.size();
    std::vector<int> wishes(CostBins::COUNT, 0); // each pair is the wish of two regions
    for (size_t k = 0; k < b_.bands.size(); k++)
        for (size_t i = 0; i < b_.bands[k].active.size(); i++)
        {
            const unsigned bin = bins(b_.best[b_.bands[k].active[i]]);
            if (bin < CostBins::COUNT)
                wishes[bin]++;
        }
    unsigned bin = 0;
    for (size_t num_wanted = 0; bin < CostBins::COUNT && num_wanted < num_to_do; bin++)
        num_wanted += wishes[bin] - b_.counts[bin];
    const unsigned end = std::min<unsigned>(bin + (DOUBLED >> bins.shift), CostBins::COUNT);
    return size_t(std::accumulate(b_.counts.begin(), b_.counts.begin() + end, 0));
}

//! The cheapest pairs, within 1/1024 of the range of costs; of those at the limit, the first ones.
void SimilarMerger::choose(size_t count, size_t num_to_do)
{
    b_.chosen.clear();
    for (size_t k = 0; k < b_.bands.size(); k++)
        b_.chosen.insert(b_.chosen.end(), b_.bands[k].pairs.begin(), b_.bands[k].pairs.end());
    unsigned lowest = UINT_MAX, highest = 0;
    for (size_t i = 0; i < b_.chosen.size(); i++)
    {
        const unsigned cost = costOf(b_.chosen[i].price);
        lowest = std::min(lowest, cost);
        highest = std::max(highest, cost);
    }
    const CostBins bins(lowest, highest);
    b_.counts.assign(CostBins::COUNT, 0);
    for (size_t i = 0; i < b_.chosen.size(); i++)
        b_.counts[bins(b_.chosen[i].price)]++;
    unsigned limit = 0; // bin in which the last ones are
    size_t rest = std::min(count, countTimely(bins, num_to_do));
    for (; rest > size_t(b_.counts[limit]); limit++)
        rest -= b_.counts[limit];
    size_t num_chosen = 0;
    for (size_t i = 0; i < b_.chosen.size(); i++)
    {
        const MergePair pair = b_.chosen[i];
        const unsigned bin = bins(pair.price);
        const bool at_limit = (bin == limit) & (rest > 0);
        b_.chosen[num_chosen] = pair;
        num_chosen += (bin < limit) | at_limit;
        rest -= at_limit;
    }
    b_.chosen.resize(num_chosen);
}

//! Each region may go into its best neighbour, also if it is not the best one of that, the cheapest first, unless one
//! of them went before, or the first one took in others. What many want to go into stays, so that no round does little.
//! What took in so many that it is larger than usual, and twice as large as it was, takes in no more.
void SimilarMerger::chooseOneSided(double share, size_t most)
{
    const int MANY = 16, DOUBLED = LOG_ONE; // area
    std::vector<MergePair> wishes;
    std::vector<int> votes(regions_.size(), 0);
    for (size_t k = 0; k < b_.bands.size(); k++)
        for (size_t i = 0; i < b_.bands[k].active.size(); i++)
        {
            const int region = b_.bands[k].active[i];
            const MergePair wish(b_.best[region], region, neighborOf(region, b_.best[region]));
            wishes.push_back(wish);
            votes[wish.to]++;
        }
    std::sort(wishes.begin(), wishes.end());
    wishes.resize(size_t(std::ceil(share * double(wishes.size()))));

    enum { GONE = 1, TOOK = 2 };
    std::vector<uchar> states(regions_.size(), 0);
    std::vector<float> areas(regions_.size(), 0.f); // of what took in others
    b_.chosen.clear();
    for (size_t i = 0; i < wishes.size() && b_.chosen.size() < most; i++)
    {
        const MergePair& wish = wishes[i];
        if (votes[wish.from] > MANY || states[wish.from] != 0 || states[wish.to] == GONE)
            continue;
        const float area = std::max(areas[wish.to], b_.records[wish.to].area) + b_.records[wish.from].area;
        if (states[wish.to] == TOOK &&
            logarithm(area) > std::max(log_usual_area_, logarithm(b_.records[wish.to].area) + DOUBLED))
            continue;
        areas[wish.to] = area;
        states[wish.from] = GONE;
        states[wish.to] = TOOK;
        b_.chosen.push_back(wish);
    }
}

//! Each region is in one pair, unless they are one-sided: then many can be united at the same time.
void SimilarMerger::unite(bool one_sided)
{
    const int AT_LEAST = 512, count = int(b_.chosen.size());
    const auto work = [&](const Range& range) { unite(range); };
    if (one_sided || count < AT_LEAST)
        work(Range(0, count));
    else
        parallel_for_(Range(0, count), work);
    num_left_ -= count;
}

//! Some of the chosen pairs, few at a time, so that what the first loop waits for is still near in the last one.
void SimilarMerger::unite(const Range& pairs)
{
    const int FEW = 16;
    std::vector<int> grown;
    for (int i = pairs.start; i < pairs.end; i += FEW)
    {
        const MergePair* const first = b_.chosen.data() + i;
        unite(first, first + std::min(FEW, pairs.end - i), grown);
    }
}

//! Short loops over one table each wait for many lines of memory at a time. Means are taken anew together, because that
//! is done for four regions at once.
void SimilarMerger::unite(const MergePair* first, const MergePair* end, std::vector<int>& grown)
{
    grown.clear();
    for (const MergePair* pair = first; pair != end; pair++)
    {
        b_.parents[pair->from] = pair->to;
        b_.changed[pair->to] = 1;
        grown.push_back(pair->to);
    }
    for (const MergePair* pair = first; pair != end && !plan_.parts.empty(); pair++)
        plan_.unite(pair->from, pair->to, b_.records[pair->from].area > b_.records[pair->to].area);
    for (const MergePair* pair = first; pair != end && !b_.textures.empty(); pair++)
        b_.textures[pair->to].add(b_.textures[pair->from]);
    for (const MergePair* pair = first; pair != end; pair++)
        regions_.unite(pair->from, pair->to);
    regions_.update(grown);
    for (size_t i = 0; i < grown.size(); i++)
        b_.records[grown[i]] = describe(grown[i]);
}

}}} // namespace
