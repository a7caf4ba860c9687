// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_WATERSHED_LINES_HPP
#define OPENCV_GWATERSHED_WATERSHED_LINES_HPP

#include "gwatershed/pixel_map.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Indices of pixels, and labels.
struct LineBuffers
{
    struct Chunk
    {
        std::vector<int> lines; //!< all that the flood left without a label in some rows
        std::vector<int> labels, rest;
    };
    std::vector<Chunk> chunks;
    std::vector<int> round, later; // pixels that are given a label now, and next
    std::vector<int> labels;       // of a round
};

//! Gives every pixel without a label to a neighbour.
void absorbLines(PixelMap& map, LineBuffers& buffers);

}}} // namespace

#endif
