// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/region_merge.hpp"
#include "shared/mixtures.hpp"
#include "shared/union_cost.hpp"

namespace cv { namespace ximgproc { namespace gws {

// A round: each region finds the neighbour with which its union costs least. Where two regions are that to each other,
// they are a pair; the cheaper pairs are united. All is done by passes over the edges and over the regions, in the
// order of the image. No region is in two pairs, so bands of regions can be worked on at the same time.

// Of the pairs, such a share is united in a round: always the same one where the order of all unions counts; else as
// many times SHARE_AT_END as there are regions for each one that is wanted, up to a highest share.
static const double SHARE_IN_ORDER = 0.4, SHARE_AT_END = 0.35, HIGHEST_SHARE = 0.8;

SimilarMerger::SimilarMerger(const Mat& labels, const Padded<Feature>& features, const RegionDistance& distance,
                             const MergeRules& rules, MergeBuffers& buffers, Regions& regions, const UnionPlan& plan)
    : distance_(distance), rules_(rules), plan_(plan), b_(buffers), regions_(regions),
      describer_(distance_, rules_, regions_, b_.textures, plan_), num_left_(regions.size())
{
    b_.graph.build(labels, num_left_, features, distance_);
    start();
}

//! Sets the area that is usual when so many regions are left. All costs change with it.
void SimilarMerger::expect(int num_regions)
{
    log_usual_area_ = logarithm(std::max(1.f, rules_.usual * float(area_ / num_regions)));
    log_most_area_ = logarithm(std::max(1.f, LARGEST_UNION * float(area_ / num_regions)));
    expects_anew_ = true;
}

void SimilarMerger::run(int num_regions)
{
    prepareContexts(num_regions);
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
    for (const MergePair& pair : prepareContexts(1))
        unions.push_back(Vec2i(pair.from, pair.to));
    int expected = leadingBits(num_left_);
    expect(expected);
    while (runRound(1, true))
    {
        for (const MergePair& pair : b_.chosen)
            unions.push_back(Vec2i(pair.from, pair.to));
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
    b_.changed.assign(n, 0);
    b_.best.resize(n);
    b_.bands.resize(b_.graph.numBands());
    b_.graph.forBands([&](int k, std::vector<int>&)
    {
        const Range band = b_.graph.band(k);
        b_.bands[k].active.resize(band.size());
        for (int i = band.start; i < band.end; i++)
            b_.parents[i] = b_.bands[k].active[i - band.start] = i;
        describer_.describe(band, b_.records);
    });
    area_ = 0;
    for (int i = 0; i < n; i++)
        area_ += b_.records[i].area;
    b_.contexts.clear();
}

//! What is nothing but an edge goes first, or it would be a superpixel to the end: its colour is far from those of both
//! sides. Then wider edges, of several such regions, are narrow ones. Returns what was united, in order.
std::vector<MergePair> SimilarMerger::uniteMixtures(int num_wanted)
{
    CV_TRACE_FUNCTION();
    const int TIMES = 2;
    std::vector<MergePair> united;
    for (int i = 0; i < TIMES; i++)
    {
        findMixtures(b_.graph, b_.records, b_.chosen);
        b_.chosen.resize(std::min(b_.chosen.size(), size_t(std::max(num_left_ - num_wanted, 0))));
        if (b_.chosen.empty())
            break;
        unite(true);
        united.insert(united.end(), b_.chosen.begin(), b_.chosen.end());
        b_.graph.relabel(b_.parents, b_.changed);
        joinEdges();
    }
    return united;
}

void SimilarMerger::joinEdges()
{
    b_.graph.forLists([&](int k, std::vector<int>& table) { b_.graph.join(k, table); });
}

//! What lies around regions, if it counts. Before it spreads, mixtures are united.
std::vector<MergePair> SimilarMerger::prepareContexts(int num_wanted)
{
    if (rules_.spread == 0)
        return std::vector<MergePair>();
    joinEdges();
    const std::vector<MergePair> united = uniteMixtures(num_wanted);
    b_.contexts.spread(b_.records, b_.graph);
    return united;
}

//! Returns false if no region has a neighbour.
bool SimilarMerger::runRound(int num_wanted, bool in_order)
{
    evaluate();
    findPairs();
    size_t num_active = 0, num_pairs = 0;
    for (const MergeBand& band : b_.bands)
    {
        num_active += band.active.size();
        num_pairs += band.pairs.size();
    }
    if (num_active == 0)
        return false;
    const size_t FEWEST = 32; // active regions for each pair; else they depend on each other in long chains, or on one
    const double share = in_order ? SHARE_IN_ORDER
            : std::min(HIGHEST_SHARE, SHARE_AT_END * double(num_left_) / num_wanted);
    const size_t most = num_left_ - num_wanted;
    const bool one_sided = num_pairs * FEWEST < num_active;
    if (one_sided)
        chooseOneSided(b_.bands, b_.best, b_.records, log_usual_area_, share, most, b_.chosen);
    else
    {
        const size_t count = size_t(std::ceil(share * double(countWelcome(num_pairs))));
        choosePairs(b_.bands, b_.best, std::min(most, count), most, b_.chosen);
    }
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
        for (int region : b_.bands[k].active)
            b_.best[region] = NO_PRICE;
        findBest(b_.graph.edges(k));
    });
    findBest(b_.graph.edges(num_bands));
    expects_anew_ = false;
}

//! The costs of the edges of a list that are not known.
void SimilarMerger::findCosts(int k, std::vector<int>& table)
{
    const size_t first = b_.graph.join(k, table);
    UnionCost(distance_, rules_, b_.records.data(), b_.contexts.data(), regions_.surfaces.means.data(), log_usual_area_,
              log_most_area_).find(b_.graph.edges(k), expects_anew_ ? 0 : first);
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
    for (int region : active)
    {
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
    if (rules_.num_kept == 0)
        return num_pairs;
    size_t num_kept = 0;
    for (const MergeBand& band : b_.bands)
        num_kept += std::count_if(band.pairs.begin(), band.pairs.end(), [&](const MergePair& pair)
        {
            return std::max(pair.from, pair.to) < rules_.num_kept;
        });
    return num_kept < num_pairs ? num_pairs - num_kept : num_pairs;
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
    for (const MergePair* pair = first; pair != end && !b_.contexts.empty(); pair++)
        b_.contexts.unite(pair->from, pair->to);
    regions_.update(grown, rules_.few_depths_count);
    describer_.describe(grown, b_.records);
    if (!b_.contexts.empty())
        b_.contexts.update(grown, b_.records);
}

}}} // namespace
