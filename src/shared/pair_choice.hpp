// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PAIR_CHOICE_HPP
#define OPENCV_GWATERSHED_PAIR_CHOICE_HPP

#include "shared/merge_region.hpp"

namespace cv { namespace ximgproc { namespace gws {

// The price of a union is its cost and, below it, what names the other region to each of the two. So equal costs have
// an order, too: that of the nearest numbers comes first, and it differs for all neighbours of a region.

static const uint64 NO_PRICE = ~uint64(0);

inline uint64 priceOf(int cost, int a, int b)
{
    return (uint64(unsigned(cost) ^ 0x80000000u) << 32) | unsigned(a ^ b);
}

//! Larger for a larger cost, without a sign.
inline unsigned costOf(uint64 price) { return unsigned(price >> 32); }

inline int neighborOf(int region, uint64 price) { return int(unsigned(price)) ^ region; }

//! A union that may be done in a round.
struct MergePair
{
    MergePair() {}
    MergePair(uint64 price_, int from_, int to_) : price(price_), from(from_), to(to_) {}

    uint64 price;
    int from, to;

    bool operator<(const MergePair& p) const { return price < p.price || (price == p.price && from < p.from); }
};

//! What a round knows of the regions of a band.
struct MergeBand
{
    std::vector<int> active;      //!< that are left and have neighbours, in order
    std::vector<MergePair> pairs; //!< of those that are the best to each other
};

//! Chooses the cheapest pairs, within 1/1024 of the range of costs: at most `count`, of those at the limit the first
//! ones. If they are not all that are to be done, none is much dearer than the cheapest unions that regions want. best
//! has, for each region, the price of its cheapest union.
void choosePairs(const std::vector<MergeBand>& bands, const std::vector<uint64>& best, size_t count, size_t num_to_do,
                 std::vector<MergePair>& chosen);

//! Chooses unions of regions with their best neighbours, also where these have better ones: of a share, the cheapest
//! first, up to a number. No region is taken in that took in others, or the other way round.
void chooseOneSided(const std::vector<MergeBand>& bands, const std::vector<uint64>& best,
                    const std::vector<MergeRegion>& records, int log_usual_area, double share, size_t most,
                    std::vector<MergePair>& chosen);

}}} // namespace

#endif
