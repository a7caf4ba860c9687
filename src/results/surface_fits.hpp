// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SURFACE_FITS_HPP
#define OPENCV_GWATERSHED_SURFACE_FITS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Mean point, and normal of the plane that fits best, of each superpixel. focal is in pixels; the optical axis meets
//! the middle of the image. The tables are those of SuperpixelGWatershed::getSurfaces().
void measureSurfaces(const Mat& labels, int num_labels, const Mat& depth, Point2f focal, Mat& positions, Mat& normals);

}}} // namespace

#endif
