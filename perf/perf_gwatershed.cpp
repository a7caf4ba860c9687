// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"
#include "gwatershed/gradient_map.hpp"
#include "gwatershed/pixel_flood.hpp"
#include "gwatershed/watershed_lines.hpp"
#include "shared/grid_markers.hpp"

namespace opencv_test { namespace {

CV_ENUM(Algorithm_, RGWATERSHED, GWATERSHED)

typedef PicturesTest<tuple<Algorithm_, Size> > Perf_GWatershed;
typedef PicturesTest<tuple<int, Size> > Perf_GWatershed_iterations;
typedef PicturesTest<Size> Perf_GWatershed_step;

PERF_TEST_P(Perf_GWatershed, color, testing::Combine(Algorithm_::all(), GWATERSHED_PERF_SIZES))
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Ptr<SuperpixelGWatershed> gws =
            createSuperpixelGWatershed(size.width, size.height, 3, perfNumSuperpixels(size), get<0>(GetParam()));
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

PERF_TEST_P(Perf_GWatershed, rgbd, testing::Combine(Algorithm_::all(), GWATERSHED_PERF_SIZES))
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Ptr<SuperpixelGWatershed> gws =
            createSuperpixelGWatershed(size.width, size.height, 3, perfNumSuperpixels(size), get<0>(GetParam()));
    timeOver(pictures, [&]() { gws->iterate(pictures.image(), pictures.depth()); });
}

PERF_TEST_P(Perf_GWatershed_iterations, color, testing::Combine(testing::Values(2, 4), GWATERSHED_PERF_SIZES))
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Ptr<SuperpixelGWatershed> gws =
            createSuperpixelGWatershed(size.width, size.height, 3, perfNumSuperpixels(size), RGWATERSHED);
    timeOver(pictures, [&]() { gws->iterate(pictures.image(), get<0>(GetParam())); });
}

// The steps of GWATERSHED on colour.

const int COLOR_ALONE = 256; // alpha

struct Steps
{
    explicit Steps(Size size) : pictures(size) {}

    void gradientStep() { gws::computeGradientMap(pictures.image(), Mat(), COLOR_ALONE, gradient); }
    void markersStep() { gws::placeGridMarkers(gradient, perfNumSuperpixels(gradient.size()), markers); }
    void nodesStep()
    {
        gws::makePixelMap(pictures.image(), Mat(), COLOR_ALONE, gradient, 0, pixels);
        gws::labelMarkers(markers, pixels);
    }
    void floodStep() { gws::floodFromMarkers(pixels, flood); }
    void linesStep() { gws::absorbLines(pixels, lines); }
    void labelsStep() { gws::extractLabels(pixels, labels); }

    Pictures pictures;
    Mat gradient, labels;
    std::vector<Point> markers;
    gws::PixelFloodBuffers flood;
    gws::LineBuffers lines;
    gws::PixelMap pixels;
};

PERF_TEST_P(Perf_GWatershed_step, gradient, GWATERSHED_PERF_SIZES)
{
    Steps steps(GetParam());
    timeOver(steps.pictures, [&]() { steps.gradientStep(); });
}

PERF_TEST_P(Perf_GWatershed_step, markers, GWATERSHED_PERF_SIZES)
{
    Steps steps(GetParam());
    timeOver(steps.pictures, [&]() { steps.gradientStep(); }, [&]() { steps.markersStep(); });
}

PERF_TEST_P(Perf_GWatershed_step, flood, GWATERSHED_PERF_SIZES)
{
    Steps steps(GetParam());
    timeOver(steps.pictures, [&]()
    {
        steps.gradientStep();
        steps.markersStep();
    }, [&]()
    {
        steps.nodesStep();
        steps.floodStep();
    });
}

PERF_TEST_P(Perf_GWatershed_step, lines_and_labels, GWATERSHED_PERF_SIZES)
{
    Steps steps(GetParam());
    timeOver(steps.pictures, [&]()
    {
        steps.gradientStep();
        steps.markersStep();
        steps.nodesStep();
        steps.floodStep();
    }, [&]()
    {
        steps.linesStep();
        steps.labelsStep();
    });
}

}} // namespace
