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

    //! The same for elements that are twice as large.
    Camera halved() const
    {
        Camera camera = *this;
        camera.focal = focal * 0.5f;
        camera.center = (center - Point2f(0.5f, 0.5f)) * 0.5f;
        return camera;
    }

    //! The same for elements that are half as large.
    Camera doubled() const
    {
        Camera camera = *this;
        camera.focal = focal * 2;
        camera.center = center * 2 + Point2f(0.5f, 0.5f);
        return camera;
    }
};

}}} // namespace

#endif
