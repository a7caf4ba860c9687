// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_CHOICE_HPP
#define OPENCV_GWATERSHED_REGION_CHOICE_HPP

#include "rgwatershed/neighbor_masks.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Which of the regions beside a pixel has the lowest energy: the squared distance of the pixel to its mean, less the
//! boundary that it saves.
class RegionChoice
{
public:
    enum { BATCH = 256 };

    //! A pixel that is better off in another region, and the mask of its neighbours that are in that.
    struct Gain
    {
        int pixel, region, mask;
    };

    //! masks are those of the pixels with their own labels; length_price is the energy of a quarter of an edge.
    RegionChoice(const FeatureMap& features, const Padded<int>& labels, const Padded<uchar>& masks,
                 const Regions& regions, const RegionDistance& distance, int length_price);

    //! Whether findGains() must know in which row its pixels are, because regions have surfaces.
    bool needsPlaces() const { return distance_.with_surfaces; }

    //! Of up to BATCH pixels, all of row y if places are needed, finds those that are better off in the region of a
    //! 4-neighbour, and the best one for each. Returns how many. Pixels that cannot leave are none of them. Behind the
    //! last pixel are three more to read.
    int findGains(const int* pixels, int n, int y, Gain* gains) const;

private:
    //! Pixels that another region may win. Behind the last one is room for some more: four are measured at a time.
    struct OpenPixels
    {
        enum { NUM_BEHIND = 3, ROOM = BATCH + NUM_BEHIND };
        int count;
        int indices[ROOM];
        int slack[ROOM]; // squared distance below which a region wins that has all neighbours but those of its own
        int first[ROOM]; // square of the distance to the region of the first 4-neighbour that is not in its own
        int last[ROOM];  // the same of the last one
    };

    //! The best choice of a pixel so far.
    struct Choice
    {
        int region, mask, energy, seen; // seen: neighbours in regions that were looked at

        bool seesAll() const { return (~seen & MaskTable::FOUR_NEIGHBORS) == 0; }
    };

    //! Those of the open pixels, and which of them have more regions beside them than were looked at.
    struct Choices
    {
        int num_unfinished;
        int unfinished[BATCH];
        Choice of[BATCH];
    };

    //! What distances are made of: colour, and the depth of the region, its plane, or its plane and its normal.
    enum Content { COLOR, DEPTH, PLANE, SURFACE };

    template <Content CONTENT> void findOpen(const int* pixels, int n, int y, OpenPixels& open) const;
    template <Content CONTENT> void keepDistant(const int* pixels, int n, int y, OpenPixels& open) const;
    template <Content CONTENT> void keepNearFirst(int y, OpenPixels& open) const;
    template <Content CONTENT> void keepNearLast(int y, OpenPixels& open) const;
    template <Content CONTENT, typename RegionOf>
    void measure(const int* pixels, int n, int y, const RegionOf& regionOf, int* squares) const;

    int neighborOf(int pixel, const int* offsets) const;

    int squaredDistance(int pixel, int y, int region) const;

    void compareFirst(const OpenPixels& open, Choices& choices) const;
    void compareOthers(const OpenPixels& open, int y, Choices& choices) const;

    //! Takes the region of the first 4-neighbour that was not seen, if it is better.
    void compare(int pixel, int square, Choice& choice) const;

    const MaskTable& table_;
    const Feature* const features_;
    const int* const labels_;
    const uchar* const masks_;
    const RegionMean* const means_;
    const SurfaceMean* const surfaces_; // if there are any
    const FeatureMap& map_; // of the features
    const RegionDistance distance_;
    const int step_;
    // By mask of the neighbours that agree:
    int savings_[256];                           // of energy
    int bounds_[256];                            // square of its own distance above which another region may win
    int first_offsets_[256], last_offsets_[256]; // of the 4-neighbours that do not agree
};

}}} // namespace

#endif
