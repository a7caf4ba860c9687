// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"
#include "rgwatershed/block_gradient.hpp"
#include "rgwatershed/block_merge.hpp"
#include "rgwatershed/boundary_sweep.hpp"
#include "rgwatershed/feature_pyramid.hpp"
#include "rgwatershed/region_flood.hpp"
#include "rgwatershed/region_labels.hpp"
#include "rgwatershed/tuning.hpp"
#include "shared/grid_markers.hpp"

namespace opencv_test { namespace {

//! The steps of RGWATERSHED on colour, with blocks of 4x4 pixels as at all of the sizes.
class RegionSteps
{
public:
    enum { TOP = 2 };

    explicit RegionSteps(Size size)
        : pictures(size), num_superpixels_(perfNumSuperpixels(size)), ruler_(10),
          flood_distance_(gws::floodDistance(1, false)), sweep_distance_(gws::sweepDistance(1, false))
    {
    }

    void makeFeatures() { gws::makePyramid(pictures.image(), Mat(), false, TOP, features_); }

    void placeMarkers()
    {
        const int num_markers = num_superpixels_ * gws::MARKERS_PER_SUPERPIXEL;
        gws::computeBlockGradient(features_[TOP], flood_distance_, gradient_);
        gws::placeGridMarkers(gradient_, num_markers, markers_);
        gws::divideIntoBands(gradient_.size(), num_markers,
                             gws::floodBandHeight(double(gradient_.total()), num_superpixels_), bands_);
    }

    void flood()
    {
        const int ruler = gws::floodRuler(double(gradient_.total()), int(markers_.size()), ruler_);
        gws::clearLabels(gradient_.size(), Mat(), labels_[TOP]);
        regions_.resize(0);
        gws::floodFromPoints(features_[TOP], markers_, bands_, flood_distance_, ruler, flood_buffers_, labels_[TOP],
                             regions_);
    }

    void sweepBlocks()
    {
        sweepers_[TOP].sweepAll(features_[TOP], rules(flood_distance_, gws::PRICE_BEFORE_MERGING), labels_[TOP],
                                regions_);
    }
    void sweepPixels()
    {
        sweepers_[0].sweepBlocks(labels_[1], features_[0], rules(sweep_distance_, gws::PRICE), labels_[0], regions_);
    }

    void merge()
    {
        gws::mergeSimilarRegions(num_superpixels_, flood_distance_, gws::lengthExponent(ruler_), merge_buffers_,
                                 labels_[TOP], regions_);
    }

    void labelBlocks()
    {
        gws::doubleLabels(labels_[TOP], features_[1].size(), labels_[1]);
        for (int level = TOP - 1; level >= 0; level--)
            regions_.divideBlocks();
    }

    Pictures pictures;

private:
    gws::SweepRules rules(const gws::RegionDistance& distance, double price) const
    {
        const int length_price = gws::boundaryPrice(price, PERF_REGION_SIZE, ruler_);
        const gws::SweepRules rules = { distance, length_price, Mat(), 0, false };
        return rules;
    }

    const int num_superpixels_;
    const float ruler_;
    const gws::RegionDistance flood_distance_, sweep_distance_;
    gws::Padded<gws::Feature> features_[TOP + 1];
    gws::Padded<int> labels_[TOP + 1];
    Mat gradient_;
    std::vector<Point> markers_;
    std::vector<gws::MarkerBand> bands_;
    gws::Regions regions_;
    gws::FloodBuffers flood_buffers_;
    gws::BoundarySweeper sweepers_[TOP + 1];
    gws::MergeBuffers merge_buffers_;
};

enum { FEATURES, MARKERS, FLOOD, SWEEP_OF_BLOCKS, MERGING, LABELS_OF_BLOCKS, SWEEP_OF_PIXELS };

CV_ENUM(RegionStep, FEATURES, MARKERS, FLOOD, SWEEP_OF_BLOCKS, MERGING, LABELS_OF_BLOCKS, SWEEP_OF_PIXELS)

typedef PicturesTest<tuple<RegionStep, Size> > Perf_GWatershed_region_step;

//! One of the steps, after those before it.
PERF_TEST_P(Perf_GWatershed_region_step, region_step, testing::Combine(RegionStep::all(), GWATERSHED_PERF_SIZES))
{
    typedef void (RegionSteps::*Call)();
    const Call calls[] = { &RegionSteps::makeFeatures, &RegionSteps::placeMarkers, &RegionSteps::flood,
                           &RegionSteps::sweepBlocks, &RegionSteps::merge, &RegionSteps::labelBlocks,
                           &RegionSteps::sweepPixels };
    const int step = get<0>(GetParam());
    RegionSteps steps(get<1>(GetParam()));
    timeOver(steps.pictures, [&]()
    {
        for (int i = 0; i < step; i++)
            (steps.*calls[i])();
    }, [&]() { (steps.*calls[step])(); });
}

}} // namespace
