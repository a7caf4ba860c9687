// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SEGMENTER_HPP
#define OPENCV_GWATERSHED_SEGMENTER_HPP

#include "depth/surface.hpp"
#include "gwatershed/gwatershed.hpp"
#include "rgwatershed/rgwatershed.hpp"
#include "segmentation.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! From an image, its depth and the parameters to a segmentation. Holds the algorithms, and what stays from one image
//! to the next: buffers, and in temporal mode what the next frame goes on from.
class Segmenter
{
public:
    //! Makes room for images of a size.
    void reserve(int algorithm, Size size);

    //! All matrices were checked; depth and markers may be empty. If something fails on the way, there is no
    //! segmentation, and the next call goes on from nothing.
    void segment(const Mat& image, const Mat& depth, const Mat& markers, const Mask& mask, const Parameters& parameters,
                 int num_iterations, Segmentation& result);

    //! The next frame starts from the beginning.
    void forget() { last_ = Last(); }

    //! Draws the watershed lines of the last segmentation, 255 on a mask of zeros.
    void drawLines(const Segmentation& result, Mat& mask) const;

    //! Finds the order in which the superpixels of the last segmentation merge.
    void buildHierarchy(Segmentation& result);

private:
    //! What the next frame must have in common with the last one to go on from it in temporal mode.
    struct Last
    {
        int algorithm = 0; // 0: there is nothing to go on from
        Size size;
        int num_superpixels = 0;

        bool operator==(const Last& other) const
        {
            return algorithm == other.algorithm && size == other.size && num_superpixels == other.num_superpixels;
        }
    };

    Frame makeFrame(const Mat& image, const Mat& depth, const Mat& markers, const Segmentation& result);
    void addSurface(const Mat& depth, const Segmentation& result, Frame& frame);
    void run(Frame frame, const Last& last, int num_iterations, Segmentation& result);

    GWatershed gwatershed_;
    RGWatershed rgwatershed_;
    SurfaceBuffers surface_;
    MergeBuffers merge_buffers_; // of RGWATERSHED and of hierarchies
    Mat converted_, scaled_, numbered_;
    Last last_;
};

//! Scaled depth, or empty. What is outside of the mask has no influence on the scale.
Mat scaleInside(const Mat& depth, const Mat& mask, const Parameters& parameters, Mat& buffer);

}}} // namespace

#endif
