// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ALPHA_HPP
#define OPENCV_GWATERSHED_ALPHA_HPP

namespace cv { namespace ximgproc { namespace gws {

//! What colours and what depths give, in the sum of equation (3) of the paper: alpha is the weight of colour, in 1/256.
inline int weighByAlpha(int alpha, int color, int depth)
{
    return (alpha * color + (256 - alpha) * depth + 128) >> 8;
}

}}} // namespace

#endif
