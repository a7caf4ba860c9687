// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_MERGE_HPP
#define OPENCV_GWATERSHED_REGION_MERGE_HPP

#include "shared/region_distance.hpp"
#include "shared/region_graph.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Buffers of merging.
struct MergeBuffers
{
    struct Entry
    {
        int boundary, next;
    };
    RegionGraph graph;
    std::vector<int> queued_at;   // cost of each boundary when it was queued last
    std::vector<Entry> entries;   // of the queues, one for each cost
    std::vector<int> first, last; // entries of each queue
};

//! Merges pairs of neighbouring regions, cheapest first.
class SimilarMerger
{
public:
    //! The exponents, in 1/16, are how much a long common boundary and a high one count.
    SimilarMerger(const RegionDistance& distance, int length_exponent, int contrast_exponent,
                  MergeBuffers& buffers, Regions& regions);

    //! To be filled with the boundaries of the regions before run().
    RegionGraph& graph() { return graph_; }

    //! Merges until num_regions are left, or none has a neighbour.
    void run(int num_regions);

    //! What was merged, in order: a region and the one that took it in.
    const std::vector<Vec2i>& unions() const { return unions_; }

private:
    enum { NONE = -1, COSTS = 8192 }; // 64 costs for each doubling

    int cost(const RegionGraph::Boundary& boundary) const;
    int squaredDistance(const RegionMean& a, const RegionMean& b) const;
    void push(int boundary, int cost);
    void pushIfLower(int boundary);
    int pop();
    void touchRegions(int entry) const;
    void unite(int a, int b);

    const RegionDistance distance_;
    const int length_exponent_, contrast_exponent_;
    Regions& regions_;
    RegionGraph& graph_;
    std::vector<int>& queued_at_;
    std::vector<MergeBuffers::Entry>& entries_;
    std::vector<int>& first_;
    std::vector<int>& last_;
    int lowest_;
    std::vector<Vec2i> unions_;
    std::vector<int> joined_; // boundaries that have become longer
};

}}} // namespace

#endif
