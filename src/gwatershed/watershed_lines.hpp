// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_WATERSHED_LINES_HPP
#define OPENCV_GWATERSHED_WATERSHED_LINES_HPP

#include "gwatershed/pixel_map.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Lists of pixels, by index.
struct LineBuffers
{
    std::vector<int> lines; //!< all that the flood left without a label
    std::vector<int> round, later; // pixels that get a label in this round, and later
    std::vector<int> chosen; // labels for the pixels of the round
};

//! Gives every pixel without a label to a neighbour.
void absorbLines(int alpha, PixelMap& map, LineBuffers& buffers);

}}} // namespace

#endif
