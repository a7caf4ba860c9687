// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SURFACE_HPP
#define OPENCV_GWATERSHED_SURFACE_HPP

#include "depth/surface_normals.hpp"
#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Buffers of findSurface().
struct SurfaceBuffers
{
    Mat nearness, normals, raw_normals;
    InverseDepths inverses;
};

//! From a depth map to what surfaces are compared by.
//!
//! Everything is taken from the inverse of depth. On a plane it is an affine function of the place in the image, so
//! that means and differences of it are exact, and the noise of stereo and structured light is the same near and far.
//!
//! nearness becomes CV_8UC1, 1..255, 255 is near, 0 missing; or empty if depth tells nothing apart. normals become
//! CV_8UC2, one for each block of 2x2 pixels, as in Normal, and rows end with some that are not known, up to a multiple
//! of 8; or they become empty if there are none. The nearness of infinity goes to the camera. Both limits of the range
//! 0: it is taken from the frame. The unit of depth cancels out.
void findSurface(const Mat& depth, FloatRange range, Camera& camera, SurfaceBuffers& buffers, Mat& nearness,
                 Mat& normals);

}}} // namespace

#endif
