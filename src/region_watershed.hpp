// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_WATERSHED_HPP
#define OPENCV_GWATERSHED_REGION_WATERSHED_HPP

#include "parameters.hpp"
#include "region_steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! RGWATERSHED from the 8-bit image and the scaled depth to the labels. Holds the buffers.
class RegionWatershed
{
public:
    //! Makes room for images of a size.
    void reserve(Size size);

    //! color is 8-bit with 1, 3 or 4 channels, depth CV_8UC1 or empty; labels become CV_32SC1.
    void run(const Mat& color, const Mat& depth, const Parameters& parameters, int num_iterations, Mat& labels);

private:
    enum { MAX_LEVEL = 2 }; //!< blocks of 2^level pixels are flooded

    void floodAndMerge(int level, int num_superpixels, double side, const Parameters& parameters);
    void sweep(int level, int count, int length_price, const RegionDistance& distance, VariationGuard* guard);

    Mat gradient_;
    Padded<Feature> features_[MAX_LEVEL + 1];
    Padded<int> labels_[MAX_LEVEL + 1];
    std::vector<Point> markers_;
    Regions regions_;
    std::vector<int> boundary_;
    FloodBuffers flood_buffers_;
    std::vector<MergePair> merge_buffer_;
    SweepBuffers sweep_buffers_;
};

}}} // namespace

#endif
