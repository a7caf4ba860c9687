// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PIXEL_MAP_HPP
#define OPENCV_GWATERSHED_PIXEL_MAP_HPP

#include "shared/padded.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! State of a pixel that has no label yet; labels are 1..N. The names and values are the paper's.
enum PixelState
{
    UNLABELLED = 0,
    LINE = -1,      //!< S_border: a watershed line
    IN_QUEUE = -2,  //!< S_inq
    FRAME = INT_MIN //!< around the image, and outside of the mask
};

//! What the flood knows of a pixel lies together, so that a visit touches one cache line for each row of three.
struct FloodPixel
{
    int state;
    unsigned distances; //!< 8 bits each, from the lowest on: to left, top, right and bottom

    int distance(int neighbor) const { return int(distances >> 8 * neighbor & 255); }
};

typedef Padded<FloodPixel> PixelMap;

//! The distances of all pixels, by equations (1) to (3). color is 8-bit with 1, 3 or 4 channels, depth CV_8UC1 or
//! empty; alpha is in 1/256. Pixels whose gradient is known and not below border_threshold are LINE, unless that is 0,
//! all others UNLABELLED.
void makePixelMap(const Mat& color, const Mat& depth, int alpha, const Mat& gradient, float border_threshold,
                  PixelMap& pixels);

//! Makes the pixels outside of a mask part of the frame.
void closeOutside(const Mat& mask, PixelMap& pixels);

//! Marker i, a point or the pixels that have the value i, gets the label i + 1; the UNLABELLED pixels beside it become
//! IN_QUEUE.
void labelMarkers(const std::vector<Point>& markers, PixelMap& pixels);
void labelMarkers(const Mat& markers, PixelMap& pixels);

//! CV_32SC1 labels 0..N-1, -1 where a pixel has none.
void extractLabels(const PixelMap& pixels, Mat& labels);

}}} // namespace

#endif
