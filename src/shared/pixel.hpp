// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PIXEL_HPP
#define OPENCV_GWATERSHED_PIXEL_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! A pixel for contrasts: 8-bit colour (all three equal in a gray image) and scaled depth, 0 if it is missing.
struct Pixel
{
    uchar b, g, r, depth;
};

//! Equations (1) to (3) of the paper, 0..255. alpha is in 1/256.
//! @note If the depth of p or q is missing, colour alone counts.
inline int distance(const Pixel& p, const Pixel& q, int alpha)
{
    const int color = std::max(std::max(std::abs(p.b - q.b), std::abs(p.g - q.g)), std::abs(p.r - q.r));
    if (p.depth == 0 || q.depth == 0)
        return color;
    return (alpha * color + (256 - alpha) * std::abs(p.depth - q.depth) + 128) >> 8;
}

}}} // namespace

#endif
