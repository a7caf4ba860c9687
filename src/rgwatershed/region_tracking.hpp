// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_TRACKING_HPP
#define OPENCV_GWATERSHED_REGION_TRACKING_HPP

#include "rgwatershed/boundary_sweep.hpp"
#include "rgwatershed/plan.hpp"
#include "rgwatershed/region_flood.hpp"
#include "shared/region_merge.hpp"
#include "shared/shape_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Moves the regions of one frame of a video along to the next one. It works on the blocks that are flooded, not on
//! pixels: so sweeps can follow motions of several pixels.
class RegionTracker
{
public:
    //! Measures the regions of a new segmentation, which those of later frames are compared with.
    void start(const Plan& plan, const FeatureMap& features, const Padded<int>& labels, const Regions& regions);

    //! Keeps the labels of the blocks for the next frame.
    void keep(const Plan& plan, const Mat& labels);

    //! The regions of the last frame, moved to where their things are now. Regions that explain the image much worse
    //! than when they were made are replaced by new ones. mask is that of the blocks, or empty. Returns false, with
    //! labels and regions that are of no use, if most of the scene is new, if the last frame was mere noise beside this
    //! one, if it was even, or if other blocks were flooded.
    bool track(const Plan& plan, const PyramidLevel* pyramid, const Mat& mask, BoundarySweeper& sweeper,
               MergeBuffers& merge_buffers, Padded<int>& labels, Regions& regions);

private:
    //! Regions that have changed much.
    struct Change
    {
        std::vector<uchar> changed; // by region
        double changed_area, area;
        std::vector<int> names; // once they are dissolved: labels that regions have, or had where new ones are
    };

    //! Sums of squared distances of the colours of blocks: to the mean of all, and to that of their region.
    struct Variation
    {
        double all = 0, left = 0;
    };

    static Variation variationOf(double squares, const Regions& regions);
    bool hasSameBlocks(const BlockLevels& levels, Size image) const;
    Change findChange(const std::vector<int64>& errors, const Regions& regions) const;
    void replaceChanged(const Plan& plan, const PyramidLevel* pyramid, const Mat& mask, MergeBuffers& merge_buffers,
                        Change& change, Padded<int>& labels, Regions& regions);
    static void dissolveChanged(Change& change, Mat& labels, Regions& regions);
    int floodChanged(const Plan& plan, const FeatureMap& features, const Mat& mask, Change& change, Padded<int>& labels,
                     Regions& regions);
    void mergeAll(const Plan& plan, const PyramidLevel* pyramid, int num_kept, MergeBuffers& buffers, Change& change,
                  Padded<int>& labels, Regions& regions);

    //! What a frame leaves for the next one.
    struct Last
    {
        int side = 0;              // of the blocks, in pixels; 0: there is no frame
        bool centered = false;     // where the short blocks are
        Mat labels;                // of the blocks
        std::vector<int64> errors; // of each region when it was made
        Variation variation;       // of the blocks
    };
    Last last_;

    FloodBuffers flood_buffers_;
    MarkerBuffers marker_buffers_;
    Mat gradient_, steps_;
};

}}} // namespace

#endif
