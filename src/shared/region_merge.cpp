// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/region_merge.hpp"

namespace cv { namespace ximgproc { namespace gws {

// A round: each region finds the neighbour with which its union costs least. Where two regions are that to each other,
// they may be united; the cheaper ones of these pairs are. Then regions are numbered anew, in the same order, so what
// lies near in the image stays near in memory, and their lists are joined. All regions can do that at the same time.

// Of the candidates, so many are united in a round: more as long as there are FAR times as many regions as are wanted.
static const double SHARE = 0.4, SHARE_FAR = 0.8, FAR = 2;
static const int MANY = 64;      // neighbours: a region with more takes in all to which it is the best
static const uint64 NO_PRICE = ~uint64(0);

//! log2 in 1/256 for value >= 1, linear between the powers of two: the bits of a float are just that.
static inline int logarithm(float value)
{
    Cv32suf bits;
    bits.f = value;
    return (bits.i - (127 << 23)) >> 15;
}

//! Cheaper unions first; of equal costs that of the nearest numbers, which differs for all neighbours of a region.
static inline uint64 price(int cost, int a, int b)
{
    return (uint64(unsigned(cost)) << 32) | unsigned(a ^ b);
}

static inline int neighborOf(int region, uint64 price)
{
    return price == NO_PRICE ? region : int(unsigned(price)) ^ region;
}

//! (squared distance of the means + 4 levels^2) * (n1 n2 / (n1 + n2))^1.75 *
//! (mean contrast of the boundary + 1 level)^contrast exponent /
//! (length of the boundary / root of the smaller area)^length exponent, as a logarithm: the exponents
//! are factors then, and there are no roots and no divisions. Ward's criterion, with a minimum
//! that lets small regions go first where colours are equal, and a bonus for long boundaries.
//! It is the same for both orders of the regions. contrast is the sum over the boundary of what is in the formula.
static inline int unionCost(int squared_distance, float area_a, float area_b, float length, float contrast,
                            int length_exponent, int contrast_exponent)
{
    const int log_a = logarithm(area_a), log_b = logarithm(area_b), log_length = logarithm(length);
    const int areas = log_a + log_b - logarithm(area_a + area_b);
    const int cost = 16 * logarithm(float(squared_distance + 4 * 256)) + 28 * areas -
                     length_exponent * (log_length - std::min(log_a, log_b) / 2);
    return contrast_exponent > 0 ? cost + contrast_exponent * (logarithm(contrast) - log_length) : cost;
}

//! Of means with depth, or of which some have none, with the weights of the flood.
static int squaredDistance(const RegionDistance& distance, const short* a, const short* b)
{
    int sum = 0;
    for (int k = 0; k < 3; k++)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    if (a[3] == RegionMean::NO_DEPTH || b[3] == RegionMean::NO_DEPTH)
        return sum;
    const int depth = (distance.depth_share * (a[3] - b[3])) >> 8;
    return int((int64(sum) * distance.color_share * distance.color_share) >> 16) + depth * depth;
}

SimilarMerger::SimilarMerger(const RegionDistance& distance, int length_exponent, int contrast_exponent,
                             MergeBuffers& buffers, Regions& regions)
    : distance_(distance), length_exponent_(length_exponent), contrast_exponent_(contrast_exponent),
      originals_(regions), b_(buffers)
{
}

void SimilarMerger::run(const Mat& labels, int num_regions)
{
    listNeighbors(labels, originals_.size(), b_.bands, b_.lists);
    runRounds(num_regions, SHARE_FAR);
}

void SimilarMerger::runToTheEnd()
{
    runRounds(1, SHARE);
}

void SimilarMerger::runRounds(int num_regions, double share_far)
{
    start();
    while (int(b_.regions.size()) > num_regions)
    {
        joinLists();
        findCandidates();
        if (b_.candidates.empty())
            return;
        const size_t left = b_.regions.size() - num_regions, found = b_.candidates.size();
        const double share = double(b_.regions.size()) > FAR * num_regions ? share_far : SHARE;
        const size_t count = std::min(left, size_t(std::ceil(share * double(found))));
        std::nth_element(b_.candidates.begin(), b_.candidates.begin() + (count - 1), b_.candidates.end());
        if (contrast_exponent_ > 0)
            std::sort(b_.candidates.begin(), b_.candidates.begin() + count);
        unite(count);
    }
}

//! Each region is a chain of itself.
void SimilarMerger::start()
{
    const int n = originals_.size();
    b_.regions.resize(n);
    b_.parents.resize(n);
    b_.numbers.resize(n);
    b_.firsts.resize(n);
    b_.nexts.assign(n, -1);
    b_.best.resize(n);
    for (int i = 0; i < n; i++)
    {
        b_.regions[i] = describe(i);
        b_.parents[i] = b_.numbers[i] = b_.firsts[i] = i;
    }
}

MergeRegion SimilarMerger::describe(int original) const
{
    const RegionMean& mean = originals_.means[original];
    MergeRegion region = { { 0, 0, 0, mean.depth }, float(originals_.sums[original].area), original };
    for (int k = 0; k < 3; k++)
        region.mean[k] = short((distance_.weights[0][k] * mean.color[k]) >> 8);
    return region;
}

//! Each list gets the room of those that it is made of.
void SimilarMerger::placeLists()
{
    const int n = int(b_.regions.size());
    std::swap(b_.lists, b_.last_lists);
    b_.lists.starts.resize(n + 1);
    b_.lists.counts.resize(n);
    int end = 0;
    for (int i = 0; i < n; i++)
    {
        b_.lists.starts[i] = end;
        for (int k = b_.firsts[i]; k >= 0; k = b_.nexts[k])
            end += b_.last_lists.counts[k];
    }
    b_.lists.starts[n] = end;
    b_.lists.neighbors.resize(end);
    b_.lists.contrasts.resize(contrast_exponent_ > 0 ? end : 0);
    if (b_.first_position > INT_MAX - end)
    {
        b_.first_position = 1;
        b_.scratch.clear();
    }
}

//! Makes the lists of the regions of this round from those of the regions that they were in the last one, and finds
//! the best neighbour of each.
void SimilarMerger::joinLists()
{
    placeLists();
    const int n = int(b_.regions.size()), CHUNK = 1024, num_chunks = (n + CHUNK - 1) / CHUNK;
    b_.scratch.resize(std::max(int(b_.scratch.size()), num_chunks));
    parallel_for_(Range(0, num_chunks), [&](const Range& range)
    {
        MergeBuffers::Scratch& scratch = b_.scratch[range.start];
        scratch.positions.resize(std::max(int(scratch.positions.size()), n));
        for (int k = range.start; k < range.end; k++)
        {
            const Range regions(k * CHUNK, std::min((k + 1) * CHUNK, n));
            if (contrast_exponent_ > 0)
                joinLists<true>(regions, scratch);
            else
                joinLists<false>(regions, scratch);
        }
    });
    b_.first_position += b_.lists.starts[n];
}

template <bool CONTRAST> void SimilarMerger::joinLists(const Range& regions, MergeBuffers::Scratch& scratch)
{
    const int first = b_.lists.starts[regions.start], last = b_.lists.starts[regions.end];
    scratch.owners.resize(std::max(int(scratch.owners.size()), last - first));
    for (int i = regions.start; i < regions.end; i++)
    {
        const int start = b_.lists.starts[i], size = b_.lists.starts[i + 1] - start;
        const int count = joinList<CONTRAST>(i, scratch.positions.data(), scratch.owners.data() + (start - first));
        for (int k = count; k < size; k++)
        {
            const Neighbor none = { i, 1 };
            b_.lists.neighbors[start + k] = none;
            scratch.owners[start - first + k] = i;
        }
        b_.lists.counts[i] = count;
        b_.best[i] = NO_PRICE;
    }
    findBest<CONTRAST>(first, last, scratch.owners.data());
}

//! A neighbour is known if its position is in this list: others are those of lists before it, and are lower.
//! Without branches: an entry is written in any case, and the next is written over it if its neighbour is known, or
//! is the region itself.
template <bool CONTRAST> int SimilarMerger::joinList(int region, int* positions, int* owners)
{
    const int start = b_.lists.starts[region], first_position = b_.first_position + start;
    const int* numbers = b_.numbers.data();
    Neighbor* list = b_.lists.neighbors.data() + start;
    int64* contrasts = CONTRAST ? b_.lists.contrasts.data() + start : 0;
    int count = 0;
    for (int k = b_.firsts[region]; k >= 0; k = b_.nexts[k])
    {
        const int first = b_.last_lists.starts[k], size = b_.last_lists.counts[k];
        const Neighbor* last = b_.last_lists.neighbors.data() + first;
        for (int i = 0; i < size; i++)
        {
            const int neighbor = numbers[last[i].region];
            const Neighbor added = { neighbor, 0 };
            list[count] = added;
            owners[count] = region;
            if (CONTRAST)
                contrasts[count] = 0;
            const int known = positions[neighbor] - first_position;
            const int position = known >= 0 ? known : count;
            positions[neighbor] = neighbor == region ? 0 : first_position + position;
            list[position].length += last[i].length;
            if (CONTRAST)
                contrasts[position] += b_.last_lists.contrasts[first + i];
            count += (position == count) & (neighbor != region);
        }
    }
    return count;
}

//! Of the regions that own the entries first..last-1.
template <bool CONTRAST> void SimilarMerger::findBest(int first, int last, const int* owners)
{
    enum { BATCH = 256 };
    int parts[2 * BATCH], costs[BATCH];
    float areas[2][BATCH], lengths[BATCH], contrasts[BATCH];
    const int length_exponent = length_exponent_, contrast_exponent = CONTRAST ? contrast_exponent_ : 0;
    const MergeRegion* regions = b_.regions.data();
    int owner = -1;
    uint64 best = NO_PRICE;
    for (int begin = first; begin < last; begin += BATCH)
    {
        const int count = std::min(int(BATCH), last - begin);
        const Neighbor* neighbors = b_.lists.neighbors.data() + begin;
        const int* owners_here = owners + (begin - first);
        measureDistances(begin, count, owners_here, parts);
        for (int i = 0; i < count; i++)
        {
            areas[0][i] = regions[owners_here[i]].area;
            areas[1][i] = regions[neighbors[i].region].area;
            lengths[i] = float(neighbors[i].length);
            if (CONTRAST)
                contrasts[i] = float(b_.lists.contrasts[begin + i] + 16 * int64(neighbors[i].length));
        }
        for (int i = 0; i < count; i++)
            costs[i] = unionCost(parts[2 * i] + parts[2 * i + 1], areas[0][i], areas[1][i], lengths[i],
                                 CONTRAST ? contrasts[i] : 1, length_exponent, contrast_exponent);
        for (int i = 0; i < count; i++)
        {
            const int region = owners_here[i], neighbor = neighbors[i].region;
            const uint64 now = neighbor == region ? NO_PRICE : price(costs[i], region, neighbor);
            best = std::min(region == owner ? best : NO_PRICE, now);
            owner = region;
            b_.best[region] = best;
        }
    }
}

//! The squared distances of the means, in 1/256 of a squared level, each as a sum of two parts.
void SimilarMerger::measureDistances(int first, int count, const int* owners, int* parts) const
{
    const Neighbor* neighbors = b_.lists.neighbors.data() + first;
    const MergeRegion* regions = b_.regions.data();
    if (distance_.with_depth)
    {
        for (int i = 0; i < count; i++)
        {
            parts[2 * i] = squaredDistance(distance_, regions[owners[i]].mean, regions[neighbors[i].region].mean);
            parts[2 * i + 1] = 0;
        }
        return;
    }
    for (int i = 0; i < count; i += 2)
    {
        const int next = std::min(i + 1, count - 1);
        const v_int16x8 a = v_load_halves(regions[owners[i]].mean, regions[owners[next]].mean);
        const v_int16x8 b = v_load_halves(regions[neighbors[i].region].mean, regions[neighbors[next].region].mean);
        const v_int16x8 difference = v_sub_wrap(a, b);
        v_store(parts + 2 * i, v_dotprod(difference, difference));
    }
}

//! Pairs of regions that are the best to each other; and what has few neighbours with its best, where that has many.
void SimilarMerger::findCandidates()
{
    b_.candidates.clear();
    for (int i = 0; i < int(b_.regions.size()); i++)
    {
        const int to = neighborOf(i, b_.best[i]);
        if (to == i)
            continue;
        const bool mutual = b_.best[to] == b_.best[i];
        if (mutual ? to < i : b_.lists.counts[to] > MANY && b_.lists.counts[i] <= MANY)
        {
            const MergeBuffers::Candidate candidate = { b_.best[i], i, to };
            b_.candidates.push_back(candidate);
        }
    }
}

//! The region that a region goes into, which stays: one that goes itself takes in only what has few neighbours.
static int rootOf(const std::vector<int>& parents, int region)
{
    return parents[parents[region]];
}

//! Unites the first of the candidates.
void SimilarMerger::unite(size_t count)
{
    const int n = int(b_.regions.size());
    for (int i = 0; i < n; i++)
        b_.parents[i] = i;
    std::fill(b_.nexts.begin(), b_.nexts.begin() + n, -1);
    for (size_t i = 0; i < count; i++)
        b_.parents[b_.candidates[i].from] = b_.candidates[i].to;
    for (size_t i = 0; i < count; i++)
    {
        const int from = b_.candidates[i].from, root = rootOf(b_.parents, from);
        const int original = b_.regions[from].original;
        originals_.sums[b_.regions[root].original].add(originals_.sums[original]);
        unions_.push_back(Vec2i(original, b_.regions[b_.candidates[i].to].original));
        b_.nexts[from] = b_.nexts[root];
        b_.nexts[root] = from;
    }
    number();
    for (size_t i = 0; i < count; i++)
        b_.numbers[b_.candidates[i].from] = b_.numbers[rootOf(b_.parents, b_.candidates[i].from)];
}

//! Numbers the regions that stay, in place.
void SimilarMerger::number()
{
    const int n = int(b_.regions.size());
    int count = 0;
    for (int i = 0; i < n; i++)
    {
        if (b_.parents[i] != i)
            continue;
        const int original = b_.regions[i].original;
        if (b_.nexts[i] >= 0)
        {
            originals_.update(original);
            b_.regions[i] = describe(original);
        }
        b_.regions[count] = b_.regions[i];
        b_.firsts[count] = i;
        b_.numbers[i] = count++;
    }
    b_.regions.resize(count);
}

void applyUnions(const std::vector<Vec2i>& unions, size_t count, int num_regions, std::vector<int>& parents)
{
    parents.resize(num_regions);
    for (int i = 0; i < num_regions; i++)
        parents[i] = i;
    for (size_t i = 0; i < count; i++)
        parents[unions[i][0]] = unions[i][1];
}

}}} // namespace
