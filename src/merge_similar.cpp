// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "region_graph.hpp"
#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! log2 in 1/256 for value >= 1, linear between the powers of two: the bits of a float are just that.
static int logarithm(int64 value)
{
    Cv32suf bits;
    bits.f = float(value);
    return (bits.i - (127 << 23)) >> 15;
}

//! Merges pairs of regions, cheapest first, until few enough are left.
class SimilarMerger
{
public:
    SimilarMerger(const RegionDistance& distance, int boundary_exponent, std::vector<MergePair>& pairs,
                  Regions& regions)
        : distance_(distance), boundary_exponent_(boundary_exponent), regions_(regions), pairs_(pairs),
          graph_(regions.size()), versions_(regions.size(), 0),
          first_(COSTS, int(NONE)), last_(COSTS, int(NONE)), lowest_(COSTS)
    {
    }

    RegionGraph& graph() { return graph_; }

    void run(int num_regions)
    {
        int left = regions_.size();
        pairs_.clear();
        for (int i = 0; i < left; i++)
            for (size_t j = 0; j < graph_.boundaries(i).size(); j++)
                if (graph_.boundaries(i)[j].neighbor > i)
                    push(i, graph_.boundaries(i)[j]);
        while (left > num_regions)
        {
            const MergePair pair = pop();
            if (versions_[pair.a] != pair.version_a || versions_[pair.b] != pair.version_b)
                continue; // one of them has changed, and the pair was queued again
            unite(pair.b, pair.a);
            left--;
        }
    }

private:
    enum { NONE = -1, COSTS = 8192 }; // 64 costs for each doubling

    //! (squared distance of the means + 4 levels^2) * (n1 n2 / (n1 + n2))^1.75 /
    //! (length of the boundary / root of the smaller area)^exponent, as a logarithm: the exponents
    //! are factors then, and there are no roots and no divisions. Ward's criterion, with a minimum
    //! that lets small regions go first where colours are equal, and a bonus for long boundaries.
    int cost(int i, const RegionGraph::Boundary& boundary) const
    {
        const int area_a = regions_.sums[i].area, area_b = regions_.sums[boundary.neighbor].area;
        const int log_a = logarithm(area_a), log_b = logarithm(area_b);
        const int areas = log_a + log_b - logarithm(int64(area_a) + area_b);
        const int length = logarithm(boundary.length) - std::min(log_a, log_b) / 2;
        const int64 distance = squaredDistance(regions_.means[i], regions_.means[boundary.neighbor]);
        const int sum = 16 * logarithm(distance + 4 * 256) + 28 * areas - boundary_exponent_ * length;
        return std::min(std::max(sum >> 6, 0), COSTS - 1);
    }

    //! Of the means, in 1/256 of a squared level, with the weights of the flood.
    int64 squaredDistance(const RegionMean& a, const RegionMean& b) const
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

    void push(int i, const RegionGraph::Boundary& boundary)
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

    //! There is always a pair, because the regions of an image are connected.
    MergePair pop()
    {
        while (first_[lowest_] == NONE)
            lowest_++;
        const MergePair pair = pairs_[first_[lowest_]];
        first_[lowest_] = pair.next;
        return pair;
    }

    void unite(int from, int to)
    {
        regions_.sums[to].add(regions_.sums[from]);
        regions_.update(to);
        graph_.unite(from, to);
        versions_[to]++;
        versions_[from]++;
        for (size_t j = 0; j < graph_.boundaries(to).size(); j++)
            push(to, graph_.boundaries(to)[j]);
    }

    const RegionDistance distance_;
    const int boundary_exponent_;
    Regions& regions_;
    std::vector<MergePair>& pairs_;
    RegionGraph graph_;
    std::vector<int> versions_; // how often a region has changed
    std::vector<int> first_, last_; // pairs by cost
    int lowest_;
};

//! Edges side by side between the same regions are added at once.
static void addEdges(const Padded<int>& labels, RegionGraph& graph)
{
    const Size size = labels.size();
    for (int y = 0; y < size.height; y++)
    {
        const int* row = labels.row(y);
        const int* below = row + labels.step();
        for (int x = 0, run = 0; x < size.width; x++)
        {
            run++;
            const bool ends = row[x + 1] != row[x];
            if (ends || below[x + 1] != below[x])
            {
                if (below[x] != row[x] && below[x] != OUTSIDE)
                    graph.addEdges(row[x], below[x], run);
                run = 0;
            }
            if (ends && row[x + 1] != OUTSIDE)
                graph.addEdges(row[x], row[x + 1], 1);
        }
    }
}

void mergeSimilarRegions(int num_regions, const RegionDistance& distance, int boundary_exponent,
                         std::vector<MergePair>& buffer, Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    if (regions.size() <= num_regions)
        return;
    SimilarMerger merger(distance, boundary_exponent, buffer, regions);
    addEdges(labels, merger.graph());
    merger.run(num_regions);

    std::vector<int> numbers;
    merger.graph().number(numbers);
    for (int i = 0; i < regions.size(); i++)
        if (merger.graph().isLeft(i))
        {
            regions.sums[numbers[i]] = regions.sums[i];
            regions.means[numbers[i]] = regions.means[i];
        }
    regions.resize(num_regions);
    for (int y = 0; y < labels.size().height; y++)
        for (int x = 0; x < labels.size().width; x++)
            labels.row(y)[x] = numbers[labels.row(y)[x]];
}

}}} // namespace
