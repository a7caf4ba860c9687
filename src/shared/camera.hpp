// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_CAMERA_HPP
#define OPENCV_GWATERSHED_CAMERA_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! How places in an image, or on a level of blocks, become directions in space.
struct Camera
{
    Point2f focal;     //!< focal length, in elements
    Point2f center;    //!< where the optical axis meets the image
    float horizon = 0; //!< nearness of what is infinitely far away, in levels; it may be below 0

    //! The same for elements of `side` x `side` of these.
    Camera united(int side) const
    {
        Camera camera = *this;
        camera.focal = focal / float(side);
        camera.center = (center - middle(side)) / float(side);
        return camera;
    }

    //! The same for elements that these are made of, `side` x `side` for each.
    Camera divided(int side) const
    {
        Camera camera = *this;
        camera.focal = focal * side;
        camera.center = center * side + middle(side);
        return camera;
    }

private:
    //! Of an element in what it is made of.
    static Point2f middle(int side) { return Point2f(1, 1) * (0.5f * float(side - 1)); }
};

}}} // namespace

#endif
