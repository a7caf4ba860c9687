// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/region_merge.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! log2 in 1/256 for value >= 1, linear between the powers of two: the bits of a float are just that.
static int logarithm(int64 value)
{
    Cv32suf bits;
    bits.f = float(value);
    return (bits.i - (127 << 23)) >> 15;
}

SimilarMerger::SimilarMerger(const RegionDistance& distance, int length_exponent, int contrast_exponent,
                             MergeBuffers& buffers, Regions& regions)
    : distance_(distance), length_exponent_(length_exponent), contrast_exponent_(contrast_exponent),
      regions_(regions), graph_(buffers.graph), queued_at_(buffers.queued_at), entries_(buffers.entries),
      first_(buffers.first), last_(buffers.last), lowest_(COSTS)
{
    graph_.reset(regions.size());
    entries_.clear();
    first_.assign(COSTS, int(NONE));
    last_.assign(COSTS, int(NONE));
}

//! Invariant: each boundary waits at the cost that it had when it was queued last. Where the cost has risen it is
//! queued again when its turn comes; where it has fallen, at once, but of a region with many neighbours only where the
//! boundary has become longer. So a merger is as much work as the region with fewer neighbours has neighbours.
void SimilarMerger::run(int num_regions)
{
    queued_at_.assign(graph_.boundaries().size(), 0);
    for (int i = 0; i < int(graph_.boundaries().size()); i++)
        push(i, cost(graph_.boundaries()[i]));
    int left = regions_.size();
    while (left > num_regions)
    {
        const int boundary = pop();
        if (boundary == NONE)
            break;
        const int now = cost(graph_.boundaries()[boundary]);
        if (now > lowest_)
        {
            push(boundary, now);
            continue;
        }
        unite(graph_.boundaries()[boundary].regions[0], graph_.boundaries()[boundary].regions[1]);
        left--;
    }
}

//! (squared distance of the means + 4 levels^2) * (n1 n2 / (n1 + n2))^1.75 *
//! (mean contrast of the boundary + 1 level)^contrast exponent /
//! (length of the boundary / root of the smaller area)^length exponent, as a logarithm: the exponents
//! are factors then, and there are no roots and no divisions. Ward's criterion, with a minimum
//! that lets small regions go first where colours are equal, and a bonus for long boundaries.
int SimilarMerger::cost(const RegionGraph::Boundary& boundary) const
{
    const int a = boundary.regions[0], b = boundary.regions[1];
    const int area_a = regions_.sums[a].area, area_b = regions_.sums[b].area;
    const int log_a = logarithm(area_a), log_b = logarithm(area_b);
    const int areas = log_a + log_b - logarithm(int64(area_a) + area_b);
    const int log_length = logarithm(boundary.length), length = log_length - std::min(log_a, log_b) / 2;
    const int distance = squaredDistance(regions_.means[a], regions_.means[b]);
    int sum = 16 * logarithm(distance + 4 * 256) + 28 * areas - length_exponent_ * length;
    if (contrast_exponent_ > 0)
        sum += contrast_exponent_ * (logarithm(boundary.contrast + 16 * int64(boundary.length)) - log_length);
    return std::min(std::max(sum >> 6, 0), COSTS - 1);
}

//! Of the means, in 1/256 of a squared level, with the weights of the flood.
int SimilarMerger::squaredDistance(const RegionMean& a, const RegionMean& b) const
{
    const short* weights = distance_.weights[a.depth != RegionMean::NO_DEPTH && b.depth != RegionMean::NO_DEPTH];
    const int depth = (weights[3] * (a.depth - b.depth)) >> 8;
    int sum = depth * depth;
    for (int k = 0; k < 3; k++)
    {
        const int color = (weights[k] * (a.color[k] - b.color[k])) >> 8;
        sum += color * color;
    }
    return sum;
}

void SimilarMerger::push(int boundary, int cost)
{
    const MergeBuffers::Entry entry = { boundary, NONE };
    const int index = int(entries_.size());
    entries_.push_back(entry);
    if (first_[cost] == NONE)
        first_[cost] = index;
    else
        entries_[last_[cost]].next = index;
    last_[cost] = index;
    lowest_ = std::min(lowest_, cost);
    queued_at_[boundary] = cost;
}

void SimilarMerger::pushIfLower(int boundary)
{
    const int now = cost(graph_.boundaries()[boundary]);
    if (now < queued_at_[boundary])
        push(boundary, now);
}

//! The regions of the next boundaries of a queue lie anywhere.
void SimilarMerger::touchRegions(int entry) const
{
    for (int count = 0; count < 2 && entry != NONE; count++, entry = entries_[entry].next)
    {
        const RegionGraph::Boundary& boundary = graph_.boundaries()[entries_[entry].boundary];
        for (int side = 0; side < 2; side++)
        {
            touch(regions_.sums[boundary.regions[side]].area);
            touch(regions_.means[boundary.regions[side]].depth);
        }
    }
}

//! The boundary at the lowest cost, which is lowest_ then; NONE if there is none.
int SimilarMerger::pop()
{
    for (; lowest_ < COSTS; lowest_++)
        while (first_[lowest_] != NONE)
        {
            const MergeBuffers::Entry entry = entries_[first_[lowest_]];
            first_[lowest_] = entry.next;
            touchRegions(entry.next);
            if (graph_.boundaries()[entry.boundary].exists() && queued_at_[entry.boundary] == lowest_)
                return entry.boundary;
        }
    return NONE;
}

//! The region with fewer neighbours goes into the other one.
void SimilarMerger::unite(int a, int b)
{
    const bool b_goes = graph_.degree(b) < graph_.degree(a) || (graph_.degree(b) == graph_.degree(a) && a < b);
    const int from = b_goes ? b : a, to = b_goes ? a : b;
    regions_.sums[to].add(regions_.sums[from]);
    regions_.update(to);
    graph_.unite(from, to, joined_);
    unions_.push_back(Vec2i(from, to));
    const int FEW = 32;
    if (graph_.degree(to) <= FEW)
        for (int i = graph_.first(to); i != NONE; i = graph_.next(to, i))
            pushIfLower(i);
    else
        for (size_t i = 0; i < joined_.size(); i++)
            pushIfLower(joined_[i]);
}

}}} // namespace
