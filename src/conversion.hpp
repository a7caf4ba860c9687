// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_CONVERSION_HPP
#define OPENCV_GWATERSHED_CONVERSION_HPP

#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The image in 8 bits with 1, 3 or 4 channels, converted into the buffer. Values from range.first to range.last become
//! 0 to 255. Where both are 0, 8 bits are taken as they are, and not copied if they have so many channels; the range of
//! others is that of the image, or of what is inside of the mask if there is one.
Mat convertImage(const Mat& image, const Mat& mask, FloatRange range, Mat& buffer);

}}} // namespace

#endif
