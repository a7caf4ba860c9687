// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_MERGE_HPP
#define OPENCV_GWATERSHED_REGION_MERGE_HPP

#include "shared/merge_context.hpp"
#include "shared/merge_graph.hpp"
#include "shared/pair_choice.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Buffers of merging. The textures are also its input.
struct MergeBuffers
{
    MergeGraph graph;
    std::vector<RegionTexture> textures; // of each region; empty: not measured
    std::vector<MergeBand> bands;
    std::vector<MergeRegion> records;
    MergeContexts contexts;         // empty: they do not count
    std::vector<uint64> best;       // of each region: the price of its cheapest union
    std::vector<int> parents;       // the region that took each one in, or itself
    std::vector<uchar> changed;     // took in others in this round
    std::vector<MergePair> chosen;
};

//! Merges pairs of neighbouring regions in rounds of mutual best neighbours.
class SimilarMerger
{
public:
    //! The regions of a CV_32SC1 label map, which stays as it is. Where colours are even, a plan, if there is one, says
    //! which unions go first.
    SimilarMerger(const Mat& labels, const Padded<Feature>& features, const RegionDistance& distance,
                  const MergeRules& rules, MergeBuffers& buffers, Regions& regions,
                  const UnionPlan& plan = UnionPlan());
    SimilarMerger(const SimilarMerger&) = delete; // what describes regions refers to other members

    //! Merges until num_regions are left, or none has a neighbour.
    void run(int num_regions);

    //! Merges until none has a neighbour, so that any number on the way is as good. Returns what was merged, in order:
    //! a region and the one that took it in.
    std::vector<Vec2i> runToTheEnd();

    //! The region that took each one in, or itself.
    const std::vector<int>& parents() const { return b_.parents; }

private:
    void start();
    std::vector<MergePair> prepareContexts(int num_wanted);
    std::vector<MergePair> uniteMixtures(int num_wanted);
    void joinEdges();
    void expect(int num_regions);
    bool runRound(int num_wanted, bool in_order);
    void evaluate();
    void findCosts(int k, std::vector<int>& table);
    void findBest(const EdgeList& list);
    void findPairs();
    void findPairs(int band);
    size_t countWelcome(size_t num_pairs) const;
    void unite(bool one_sided);
    void unite(const Range& pairs);
    void unite(const MergePair* first, const MergePair* end, std::vector<int>& grown);

    const RegionDistance distance_;
    const MergeRules rules_;
    UnionPlan plan_; // empty: the cells of the rules count
    MergeBuffers& b_;
    Regions& regions_;
    const RegionDescriber describer_;
    int num_left_;
    double area_;        // of all regions
    int log_usual_area_; // above it, unions are expensive
    int log_most_area_;  // above it, they come last
    bool expects_anew_;  // another area than the known costs have
};

}}} // namespace

#endif
