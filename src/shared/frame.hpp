// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FRAME_HPP
#define OPENCV_GWATERSHED_FRAME_HPP

#include "shared/camera.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! One image with all that is needed to segment it. All matrices but normals have its size, or are empty.
struct Frame
{
    Mat color;   //!< 8-bit with 1, 3 or 4 channels
    Mat depth;   //!< CV_8UC1, 0 where it is missing; empty if there is no depth
    Mat normals; //!< CV_8UC2, as Normal, of blocks of 2x2 pixels; empty if there are none
    Camera camera; //!< of the normals
    Mat mask;    //!< CV_8UC1, 255 inside and 0 outside; empty if all pixels are inside
    Mat markers; //!< CV_32SC1, the label of a marker, or below 0; empty if markers are not given by the user
    std::vector<int> owners; //!< the marker of the user of which each label is a part; empty if they are whole
    int num_pixels = 0;      //!< inside of the mask
    int num_superpixels = 0; //!< asked for, or the number of labels of the markers
    bool continues = false;  //!< continues the last frame, which had the same size, mask and number
};

}}} // namespace

#endif
