// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_RGWATERSHED_HPP
#define OPENCV_GWATERSHED_RGWATERSHED_HPP

#include "rgwatershed/block_markers.hpp"
#include "rgwatershed/boundary_sweep.hpp"
#include "rgwatershed/edge_blocks.hpp"
#include "rgwatershed/normal_trust.hpp"
#include "rgwatershed/region_flood.hpp"
#include "rgwatershed/region_tracking.hpp"
#include "rgwatershed/tuning.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! RGWATERSHED from the 8-bit image and the scaled depth to the labels. Holds the regions, labels and features of the
//! levels, and buffers.
class RGWatershed
{
public:
    //! Makes room for images of a size.
    void reserve(Size size);

    //! Returns the number of superpixels.
    int run(const Frame& frame, const Parameters& parameters, int num_iterations, MergeBuffers& merge_buffers);

    //! The CV_32SC1 labels of the last run, below 0 where there is none, in the memory that the next run writes to.
    Mat labels() { return labels_[0].view(); }

    //! Features of the pixels of the last run.
    const FeatureMap& features() const { return features_[0]; }

private:
    std::vector<int> findRegions(const Plan& plan, const Mat& mask, MergeBuffers& merge_buffers);
    void floodBlocks(const Plan& plan, const Mat& mask);
    std::vector<int> sweepAndMerge(const Plan& plan, MergeBuffers& merge_buffers);
    std::vector<int> merge(const Plan& plan, int level, int num_regions, const MergeRules& rules,
                           const UnionPlan& of_unions, MergeBuffers& merge_buffers);
    void floodFromUserMarkers(const Frame& frame, const Plan& plan);
    bool track(const Frame& frame, const Mat& mask, MergeBuffers& merge_buffers, Plan& plan);
    void settle(const Frame& frame, const Plan& plan, int num_iterations);
    void descend(const Frame& frame, const Plan& plan, int level);
    void mergePixels(const Frame& frame, const Plan& plan, const std::vector<int>& first_markers, int num_iterations,
                     MergeBuffers& merge_buffers);
    void iterateMore(const Frame& frame, const Plan& plan, int num_iterations);

    MaskPyramid masks_;
    PyramidLevel features_[MAX_LEVEL + 1];
    Padded<int> labels_[MAX_LEVEL + 1];
    Regions regions_;
    BoundarySweeper sweepers_[MAX_LEVEL + 1];
    EdgeBlocks edge_blocks_;
    RegionTracker tracker_;
    NormalTrust normal_trust_;

    // Buffers.
    Mat gradient_, steps_;
    BlockMarkers markers_;
    FloodBuffers flood_buffers_;
};

}}} // namespace

#endif
