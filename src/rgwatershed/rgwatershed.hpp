// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_RGWATERSHED_HPP
#define OPENCV_GWATERSHED_RGWATERSHED_HPP

#include "rgwatershed/boundary_sweep.hpp"
#include "rgwatershed/region_flood.hpp"
#include "shared/frame.hpp"
#include "shared/mask_pyramid.hpp"
#include "shared/parameters.hpp"
#include "shared/region_merge.hpp"
#include "shared/shape_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! RGWATERSHED from the 8-bit image and the scaled depth to the labels. Holds the buffers.
class RGWatershed
{
public:
    //! Makes room for images of a size.
    void reserve(Size size);

    //! labels become CV_32SC1, below 0 where there is none. Returns the number of superpixels.
    int run(const Frame& frame, const Parameters& parameters, int num_iterations, Mat& labels);

    //! Features of the pixels of the last run.
    Padded<Feature> features() const { return features_[0]; }

private:
    enum { MAX_LEVEL = 2 }; //!< blocks of 2^level pixels are flooded

    void makeGradient(const Frame& frame, int level, const RegionDistance& distance);
    void floodAndMerge(const Frame& frame, int level, double side, const Parameters& parameters);
    bool track(const Frame& frame, int level, int length_price, const Parameters& parameters);
    int floodAnew(const Frame& frame, int level, const std::vector<uchar>& changed, double changed_area, double area,
                  const RegionDistance& distance, float ruler);
    void mergeAnew(int level, int num_kept, std::vector<uchar>& changed, const RegionDistance& distance, float ruler);
    void floodFromUserMarkers(const Frame& frame, const RegionDistance& distance);
    void descend(const Frame& frame, int level, const RegionDistance& distance);
    void sweepAgain(int count, int level, const SweepRules& rules);

    //! All rows and all markers.
    static MarkerBand wholeBand(Size size, const std::vector<Point>& markers)
    {
        const MarkerBand band = { Range(0, size.height), Range(0, int(markers.size())) };
        return band;
    }

    MaskPyramid masks_;
    Mat gradient_;
    Padded<Feature> features_[MAX_LEVEL + 1];
    Padded<int> labels_[MAX_LEVEL + 1];
    std::vector<Point> markers_;
    std::vector<MarkerBand> bands_;
    Regions regions_;
    int top_ = 0;               // level of the last flood

    // For video.
    std::vector<int64> errors_; // of the regions of the last flood, when each of them was made
    Mat last_map_, dissolved_;
    std::vector<int> names_, numbers_;

    MarkerBuffers marker_buffers_;
    FloodBuffers flood_buffers_;
    MergeBuffers merge_buffers_;
    BoundarySweeper sweepers_[MAX_LEVEL + 1];
};

}}} // namespace

#endif
