// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_CHECKS_IMAGES_HPP
#define OPENCV_GWATERSHED_CHECKS_IMAGES_HPP

#include <opencv2/core.hpp>

//! @file Images made by integer arithmetic alone, so that they are the same with every compiler and every OpenCV.

//! Numbers that look random and depend on the seed only.
class Numbers
{
public:
    explicit Numbers(uint64 seed) : state_(seed) {}
    //! One of 0..n-1.
    int below(int n);
    //! One of a list.
    template <typename T, int N> T from(const T (&list)[N]) { return list[below(N)]; }

private:
    uint64 state_;
};

//! With FEW_COLORS, pixels often lie exactly half way between the means of two superpixels.
enum ImageKind { SCENE, NOISE, FLAT, STRIPES, RAMP, FEW_COLORS, IMAGE_KINDS };

//! What an image shows; the same for all frames of a sequence.
struct Scene
{
    ImageKind kind;
    cv::Size size;
    uint64 seed;
    int motion; //!< pixels from frame to frame
};

//! CV_8U, CV_16U or CV_32F with any number of channels; some float values are NaN, below 0 or above 1.
cv::Mat makeImage(const Scene& scene, int frame, int type);
//! CV_8UC1, CV_16UC1 in millimetres or CV_32FC1 in metres, with missing values.
cv::Mat makeDepth(const Scene& scene, int frame, int type);
//! CV_8UC1: discs, or the pixels that are in none.
cv::Mat makeMask(cv::Size size, Numbers& numbers);
//! CV_32SC1: boxes and single pixels with values from -5.
cv::Mat makeMarkers(cv::Size size, Numbers& numbers);

#endif
