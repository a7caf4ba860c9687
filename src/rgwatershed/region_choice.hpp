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
    enum { BATCH = 512, AT_ONCE = 8 };

    //! A pixel that is better off in another region, the mask of its neighbours that are in that, and its energy there.
    struct Gain
    {
        int pixel, region, mask, energy;
    };
    static_assert(sizeof(Gain) == 4 * sizeof(int), "it is loaded and stored as a vector");

    //! masks are those of the pixels with their own labels; length_price is the energy of a quarter of an edge.
    RegionChoice(const FeatureMap& features, const Padded<int>& labels, const Padded<uchar>& masks,
                 const Regions& regions, const RegionDistance& distance, int length_price);

    //! Whether findGains() must know in which row its pixels are, because regions have surfaces.
    bool needsPlaces() const { return distance_.with_surfaces; }

    //! Of up to BATCH pixels, all of row y if places are needed, finds those that are better off in the region of a
    //! 4-neighbour, and the best one for each, in any order. Returns how many. Pixels that cannot leave are none of
    //! them.
    int findGains(const int* pixels, int n, int y, Gain* gains) const;

private:
    enum { ALWAYS = 1 << 30 }; // above all squares
    enum { FOUR = 4, UNSEEN_LOG2 = 8 };

    //! Some pixels, with room behind them, as they are looked at by eights.
    struct Batch
    {
        enum { SIZE = BATCH + AT_ONCE };

        int pixels[SIZE];
        int squares[SIZE];   // of the distances that were measured last
        int slack[SIZE];     // squared distances below which a region wins that has all neighbours but those of the own
        int distant[SIZE];   // which of the pixels another region may win
        int unseen[SIZE];    // of these, by the same numbers: the 4-neighbours that are to be looked at
        int differ[SIZE];    // -1 if the first and the last of them are in different regions, or 0
        int excess[SIZE];    // of the squared distance to the first region over the slack
        int doubtful[SIZE];  // which of the distant ones the first region cannot win, but the last one may
        int contested[SIZE]; // and which of these have one that is near enough
    };

    //! The best choices of four pixels so far. Above UNSEEN_LOG2, a mask has the 4-neighbours in regions that were not
    //! looked at.
    struct FourChoices
    {
        v_int32x4 pixels, regions, masks, energies;
    };

    //! Choices that are made, and those of pixels that have more regions beside them, with such masks.
    struct Choices
    {
        Gain *made, *open;
        int num_made, num_open;
    };

    //! What distances are made of: colour, and the depth of the region, its plane, or its plane and its normal.
    enum Content { COLOR, DEPTH, PLANE, SURFACE };

    template <Content CONTENT> int findGains(const int* pixels, int n, int y, Gain* gains) const;
    template <Content CONTENT> int listDistant(int n, int y, Batch& b) const;
    template <Content CONTENT> int listContested(int n, int y, Batch& b) const;
    template <Content CONTENT> int addContested(int n, int y, int num_contested, Batch& b) const;
    template <Content CONTENT, typename PixelOf, typename RegionOf>
    void measure(int n, int y, const PixelOf& pixelOf, const RegionOf& regionOf, int* squares) const;

    FourChoices begin(int i, const Batch& b) const;
    void compare(const v_int32x4& squares, int count, FourChoices four, Choices& choices) const;

    const MaskTable& table_;
    const Feature* const features_;
    const int* const labels_;
    const uchar* const masks_;
    const RegionMean* const means_;
    const SurfaceMean* const surfaces_; // if there are any
    const FeatureMap& map_; // of the features
    const RegionDistance distance_;
    const int step_, length_price_;
    // By mask of the neighbours that agree:
    int savings_[256];                           // of energy
    int bounds_[256];                            // square of its own distance above which another region may win
    int first_others_[256], last_others_[256]; // of the 4-neighbours that do not agree
};

}}} // namespace

#endif
