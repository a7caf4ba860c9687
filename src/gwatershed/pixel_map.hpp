// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PIXEL_MAP_HPP
#define OPENCV_GWATERSHED_PIXEL_MAP_HPP

#include "shared/padded.hpp"
#include "shared/pixel.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! States of a pixel that has no label; labels are 1..N. Values as in the paper.
enum PixelState
{
    UNLABELLED = 0,
    LINE = -1,      //!< S_border: a watershed line
    IN_QUEUE = -2,  //!< S_inq
    FRAME = INT_MIN //!< around the image, or outside of the mask
};

//! State and value are side by side, so that a visit of a pixel and its neighbours reads one cache line in each of
//! three rows.
struct FloodPixel
{
    int state;
    Pixel value;
};

typedef Padded<FloodPixel> PixelMap;

//! All pixels UNLABELLED. color is 8-bit with 1, 3 or 4 channels, depth CV_8UC1 or empty.
void makePixelMap(const Mat& color, const Mat& depth, PixelMap& pixels);

//! Makes the pixels outside of a mask part of the frame.
void closeOutside(const Mat& mask, PixelMap& pixels);

//! Marker i gets the label i + 1. It is a point, or all pixels with the value i.
void labelMarkers(const std::vector<Point>& markers, PixelMap& pixels);
void labelMarkers(const Mat& markers, PixelMap& pixels);

//! CV_32SC1 labels 0..N-1, and -1 where a pixel has no label.
void extractLabels(PixelMap& pixels, Mat& labels);

}}} // namespace

#endif
