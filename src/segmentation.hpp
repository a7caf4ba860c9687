// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SEGMENTATION_HPP
#define OPENCV_GWATERSHED_SEGMENTATION_HPP

#include "results/merge_hierarchy.hpp"
#include "shared/parameters.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The part of an image that is segmented.
struct Mask
{
    Mask() : area(0) {}
    //! pixels is CV_8UC1, non-zero inside; an empty one is no mask.
    explicit Mask(const Mat& pixels);

    bool empty() const { return pixels.empty(); }
    //! Whether the same pixels are inside.
    bool operator==(const Mask& other) const;

    Mat pixels;  //!< CV_8UC1, 255 inside and 0 outside; never written to
    Rect bounds; //!< of the pixels inside
    int area;    //!< number of them
};

//! What iterate() gives, and what it was made with.
struct Segmentation
{
    //! Keeps what it will be made with; it is not complete yet. labels become -1 outside of the bounds.
    void start(Size size, const Parameters& parameters, const Mask& mask);

    //! Takes the labels of what is inside of the bounds. If that is the whole image, they stay where they are.
    void take(const Mat& labels_inside);

    //! Takes labels from the hierarchy, which is not empty.
    void cut(int num_superpixels);

    bool empty() const { return !complete; }
    //! Whether a vector can hold the label map.
    bool isLine() const { return labels.rows == 1 || labels.cols == 1; }

    Mat labels;             //!< CV_32SC1, 0..number-1 and -1
    int number = 0;         //!< of superpixels
    Rect bounds;            //!< of what was segmented
    Parameters parameters;
    Mask mask;
    bool with_depth = false;
    MergeHierarchy hierarchy; //!< empty until it is asked for
    bool complete = false;
};

}}} // namespace

#endif
