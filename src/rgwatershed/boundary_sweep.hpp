// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP
#define OPENCV_GWATERSHED_BOUNDARY_SWEEP_HPP

#include "rgwatershed/boundary_list.hpp"
#include "rgwatershed/variation_guard.hpp"
#include "shared/region_distance.hpp"

#include <functional>
#include <list>

namespace cv { namespace ximgproc { namespace gws {

//! What a sweep makes smaller: the squared distance of each pixel to the mean of its region, and the boundary.
struct BoundaryEnergy
{
    explicit BoundaryEnergy(const RegionDistance& distance_, int length_price_ = 0)
        : distance(distance_), length_price(length_price_) {}

    RegionDistance distance;
    int length_price; //!< in squared grey levels, of a quarter of a pixel edge of boundary
};

//! Sweeps over the boundaries of regions: pixels go to the neighbouring region of the lowest energy, while each region
//! stays one piece. Means are those of the beginning of a sweep.
class BoundarySweeper
{
public:
    //! Sets what the sweeps to come work on. Pixels of markers, CV_32SC1 or empty, that
    //! are 0 or more do not move.
    void start(const Padded<Feature>& features, const BoundaryEnergy& energy, const Mat& markers, Padded<int>& labels,
               Regions& regions);

    //! A sweep over the whole boundary.
    void sweepAll();
    //! The same for labels that are those of blocks of 2x2 pixels.
    void sweepAllOfBlocks(const Padded<int>& blocks);
    //! Sweeps over what touches the pixels that moved in the sweep before, until none does. guard may be 0.
    void sweepAgain(int count, VariationGuard* guard = 0);

    //! Whether any pixel moved in the last sweep.
    bool moved() const;

private:
    typedef std::function<void(const Range& rows, BoundaryList& list)> ListBoundary;

    void sweep(const ListBoundary& list, VariationGuard* guard);

    const Padded<Feature>* features_ = 0;
    const BoundaryEnergy* energy_ = 0;
    Mat markers_;
    Padded<int>* labels_ = 0;
    Regions* regions_ = 0;

    std::vector<std::vector<Move> > moves_, last_moves_; // of this sweep and of the one before, by bands
    std::vector<uchar> marks_;                           // by pixel
    std::list<BoundaryList> lists_;                      // that no thread uses
};

}}} // namespace

#endif
