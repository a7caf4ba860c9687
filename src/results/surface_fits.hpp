// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SURFACE_FITS_HPP
#define OPENCV_GWATERSHED_SURFACE_FITS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! @file Where a superpixel is in space, and which way it faces. Axes: x to the right, y down, z forward.

//! Neighbouring depths in a row of the image, as readDepths() gives them. The place of the first one is in pixels from
//! the optical axis.
struct DepthRun
{
    const double* depths;
    int length;
    double x, y;
};

//! The mean of points in space. The focal length is in pixels.
class MeanPoint
{
public:
    void add(const DepthRun& run);
    void add(const MeanPoint& other);
    //! NaN where no depth is valid.
    Vec3f position(Point2f focal) const;

private:
    double area_ = 0, xz_ = 0, yz_ = 0, z_ = 0;
};

//! The plane that fits the inverses w of depths best, which are an affine function of the place in the image.
class PlaneFit
{
public:
    void add(const DepthRun& run);
    void add(const PlaneFit& other);
    //! Of length 1, towards the camera. NaN where the places with a valid depth are on one line.
    Vec3f normal(Point2f focal) const;

private:
    double area_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0, w_ = 0, xw_ = 0, yw_ = 0;
};

}}} // namespace

#endif
