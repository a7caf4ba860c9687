// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "similar_merger.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! log2 in 1/256 for value >= 1, linear between the powers of two: the bits of a float are just that.
static int logarithm(int64 value)
{
    Cv32suf bits;
    bits.f = float(value);
    return (bits.i - (127 << 23)) >> 15;
}

SimilarMerger::SimilarMerger(const RegionDistance& distance, int length_exponent, int height_exponent,
                             std::vector<MergePair>& pairs, Regions& regions)
    : distance_(distance), length_exponent_(length_exponent), height_exponent_(height_exponent),
      regions_(regions), pairs_(pairs), graph_(regions.size()), versions_(regions.size(), 0),
      first_(COSTS, int(NONE)), last_(COSTS, int(NONE)), lowest_(COSTS)
{
}

int SimilarMerger::run(int num_regions)
{
    int left = regions_.size();
    pairs_.clear();
    for (int i = 0; i < left; i++)
        for (size_t j = 0; j < graph_.boundaries(i).size(); j++)
            if (graph_.boundaries(i)[j].neighbor > i)
                push(i, graph_.boundaries(i)[j]);
    MergePair pair;
    while (left > num_regions && pop(pair))
    {
        if (versions_[pair.a] != pair.version_a || versions_[pair.b] != pair.version_b)
            continue; // one of them has changed, and the pair was queued again
        unite(pair.b, pair.a);
        left--;
    }
    return left;
}

//! (squared distance of the means + 4 levels^2) * (n1 n2 / (n1 + n2))^1.75 *
//! (mean height of the boundary + 1 level)^height exponent /
//! (length of the boundary / root of the smaller area)^length exponent, as a logarithm: the exponents
//! are factors then, and there are no roots and no divisions. Ward's criterion, with a minimum
//! that lets small regions go first where colours are equal, and a bonus for long boundaries.
int SimilarMerger::cost(int i, const RegionGraph::Boundary& boundary) const
{
    const int area_a = regions_.sums[i].area, area_b = regions_.sums[boundary.neighbor].area;
    const int log_a = logarithm(area_a), log_b = logarithm(area_b);
    const int areas = log_a + log_b - logarithm(int64(area_a) + area_b);
    const int log_length = logarithm(boundary.length), length = log_length - std::min(log_a, log_b) / 2;
    const int64 distance = squaredDistance(regions_.means[i], regions_.means[boundary.neighbor]);
    int sum = 16 * logarithm(distance + 4 * 256) + 28 * areas - length_exponent_ * length;
    if (height_exponent_ > 0)
        sum += height_exponent_ * (logarithm(boundary.height + 16 * int64(boundary.length)) - log_length);
    return std::min(std::max(sum >> 6, 0), COSTS - 1);
}

//! Of the means, in 1/256 of a squared level, with the weights of the flood.
int64 SimilarMerger::squaredDistance(const RegionMean& a, const RegionMean& b) const
{
    const int64 d0 = (distance_.lightness * (a.color[0] - b.color[0])) >> 8;
    const int64 d1 = (distance_.chroma * (a.color[1] - b.color[1])) >> 8;
    const int64 d2 = (distance_.chroma * (a.color[2] - b.color[2])) >> 8;
    const int64 color = d0 * d0 + d1 * d1 + d2 * d2;
    if (a.depth == RegionMean::NO_DEPTH || b.depth == RegionMean::NO_DEPTH)
        return color;
    const int64 depth = a.depth - b.depth;
    const int64 color_share = distance_.color_share, depth_share = distance_.depth_share;
    return (color_share * color_share * color + depth_share * depth_share * depth * depth) >> 16;
}

void SimilarMerger::push(int i, const RegionGraph::Boundary& boundary)
{
    const int b = boundary.neighbor, at = cost(i, boundary), index = int(pairs_.size());
    const MergePair pair = { i, b, versions_[i], versions_[b], NONE };
    pairs_.push_back(pair);
    if (first_[at] == NONE)
        first_[at] = index;
    else
        pairs_[last_[at]].next = index;
    last_[at] = index;
    lowest_ = std::min(lowest_, at);
}

bool SimilarMerger::pop(MergePair& pair)
{
    while (lowest_ < COSTS && first_[lowest_] == NONE)
        lowest_++;
    if (lowest_ == COSTS)
        return false;
    pair = pairs_[first_[lowest_]];
    first_[lowest_] = pair.next;
    return true;
}

void SimilarMerger::unite(int from, int to)
{
    regions_.sums[to].add(regions_.sums[from]);
    regions_.update(to);
    graph_.unite(from, to);
    versions_[to]++;
    versions_[from]++;
    unions_.push_back(Vec2i(from, to));
    for (size_t j = 0; j < graph_.boundaries(to).size(); j++)
        push(to, graph_.boundaries(to)[j]);
}

}}} // namespace
