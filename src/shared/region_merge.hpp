// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_MERGE_HPP
#define OPENCV_GWATERSHED_REGION_MERGE_HPP

#include "shared/neighbor_lists.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What the cost of a union reads of a region, in 16 bytes.
struct MergeRegion
{
    short mean[4]; //!< colour, weighted, and depth, as it is, in 1/16 of a level
    float area;
    int original;  //!< its number before merging began
};

//! Buffers of merging.
struct MergeBuffers
{
    //! A union that may be done in a round, and its price.
    struct Candidate
    {
        uint64 price;
        int from, to;

        bool operator<(const Candidate& c) const
        {
            return price < c.price || (price == c.price && from < c.from);
        }
    };

    //! Of the threads that join lists.
    struct Scratch
    {
        std::vector<int> positions; // by region: where it was written to a list last; they grow with the rounds
        std::vector<int> owners;    // regions whose lists the entries of a chunk are in
    };

    std::vector<BoundaryBand> bands;
    NeighborLists lists, last_lists;
    std::vector<MergeRegion> regions;
    std::vector<uint64> best;         // of each region: price of the cheapest union
    std::vector<Candidate> candidates;
    std::vector<int> parents;         // the region that takes a region in, or itself
    std::vector<int> numbers;         // after the round
    std::vector<int> firsts, nexts;   // chains of the regions that become one
    std::vector<Scratch> scratch;
    int first_position = 1;           // of the lists of this round
};

//! Merges pairs of neighbouring regions in rounds of mutual best neighbours.
class SimilarMerger
{
public:
    //! The exponents, in 1/16, are how much a long common boundary and a high one count.
    SimilarMerger(const RegionDistance& distance, int length_exponent, int contrast_exponent,
                  MergeBuffers& buffers, Regions& regions);

    //! Merges the regions of a label map until num_regions are left, or none has a neighbour.
    void run(const Mat& labels, int num_regions);

    //! The same until none has a neighbour, with the lists of the buffers, and so that any number on the way is as good.
    void runToTheEnd();

    //! What was merged, in order: a region and the one that took it in.
    const std::vector<Vec2i>& unions() const { return unions_; }

private:
    MergeRegion describe(int original) const;
    void start();
    void runRounds(int num_regions, double share_far);
    void placeLists();
    void joinLists();
    template <bool CONTRAST> void joinLists(const Range& regions, MergeBuffers::Scratch& scratch);
    template <bool CONTRAST> int joinList(int region, int* positions, int* owners);
    template <bool CONTRAST> void findBest(int first, int last, const int* owners);
    void measureDistances(int first, int count, const int* owners, int* parts) const;
    void findCandidates();
    void unite(size_t count);
    void number();

    const RegionDistance distance_;
    const int length_exponent_, contrast_exponent_;
    Regions& originals_;
    MergeBuffers& b_;
    std::vector<Vec2i> unions_;
};

//! The region that took each one in, or itself, after the first of the unions.
void applyUnions(const std::vector<Vec2i>& unions, size_t count, int num_regions, std::vector<int>& parents);

}}} // namespace

#endif
