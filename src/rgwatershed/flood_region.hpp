// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FLOOD_REGION_HPP
#define OPENCV_GWATERSHED_FLOOD_REGION_HPP

#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What a flood reads and writes of a region, in one place.
struct FloodRegion
{
    FloodRegion() {}
    FloodRegion(const RegionSum& sum_, Point center_, Point middle_)
        : sum(sum_), center(center_), middle(middle_), rise(0), next_update(0)
    {
        if (sum.area > 0)
            update();
    }

    //! Depth of its plane at a place, in steps.
    int depthAt(Point p) const
    {
        return SurfaceMean::limit(means[3] + slope.dot(p - center) / SurfaceMean::PLANE_UNIT);
    }

    void add(const Feature& f)
    {
        sum.add(f);
        if (sum.area >= next_update)
            update();
    }

    //! The same where there is depth. p is the place.
    void add(const Feature& f, Point p)
    {
        rise += f.depth ? slope.dot(p - center) : 0;
        add(f);
    }

    //! Takes the means anew.
    void update();

    RegionSum sum;
    Point center;    //!< that the plane counts from
    Point middle;    //!< that the ruler counts from, twice
    Point slope;     //!< of depth, in 1/PLANE_UNIT of a step for an element
    int64 rise;      //!< sum of how much higher the plane is at its pixels with depth than at the centre
    short means[4];  //!< of the channels 0, 2, 1, and the depth of the plane at the centre
    int next_update; //!< area at which the means are taken anew
};

}}} // namespace

#endif
