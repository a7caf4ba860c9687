// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"

namespace opencv_test { namespace {

// What a pipeline does beside and after the segmentation of single images.

CV_ENUM(Algorithm_, RGWATERSHED, GWATERSHED)

typedef PicturesTest<tuple<Algorithm_, Size> > Perf_GWatershed_pipeline;

#define PIPELINE_PARAMS testing::Combine(Algorithm_::all(), testing::Values(szVGA, sz1080p))

static Ptr<SuperpixelGWatershed> createForPerf(const tuple<Algorithm_, Size>& param)
{
    const Size size = get<1>(param);
    return createSuperpixelGWatershed(size.width, size.height, 3, perfNumSuperpixels(size), get<0>(param));
}

//! All but the corners: nearly every pixel is inside, and the mask is not full.
PERF_TEST_P(Perf_GWatershed_pipeline, nearly_full_mask, PIPELINE_PARAMS)
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Mat mask(size, CV_8UC1, Scalar(255));
    rectangle(mask, Rect(0, 0, 3, 3), Scalar(0), FILLED);
    rectangle(mask, Rect(size.width - 3, size.height - 3, 3, 3), Scalar(0), FILLED);
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    gws->setMask(mask);
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

//! A disc of an eighth of the image, with an eighth of the superpixels.
PERF_TEST_P(Perf_GWatershed_pipeline, small_mask, PIPELINE_PARAMS)
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Mat mask = Mat::zeros(size, CV_8UC1);
    const int radius = cvRound(std::sqrt(size.area() / (8 * CV_PI)));
    circle(mask, Point(size.width / 2, size.height / 2), radius, Scalar(255), FILLED);
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    gws->setRegionSize(PERF_REGION_SIZE);
    gws->setMask(mask);
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

//! One pixel in the middle of each cell of a grid.
PERF_TEST_P(Perf_GWatershed_pipeline, markers, PIPELINE_PARAMS)
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Mat markers = Mat::zeros(size, CV_32SC1);
    int count = 0;
    for (int y = PERF_REGION_SIZE / 2; y < size.height; y += PERF_REGION_SIZE)
        for (int x = PERF_REGION_SIZE / 2; x < size.width; x += PERF_REGION_SIZE)
            markers.at<int>(y, x) = ++count;
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    gws->setMarkers(markers);
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

PERF_TEST_P(Perf_GWatershed_pipeline, statistics, PIPELINE_PARAMS)
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    Mat stats, centroids, colors, depths;
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); }, [&]()
    {
        gws->getStatistics(pictures.image(), pictures.depth(), stats, centroids, colors, depths);
    });
}

PERF_TEST_P(Perf_GWatershed_pipeline, adjacency, PIPELINE_PARAMS)
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    Mat pairs, lengths, heights;
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); }, [&]()
    {
        gws->getAdjacency(pictures.image(), noArray(), pairs, lengths, heights);
    });
}

//! The first call, which finds the order of merging.
PERF_TEST_P(Perf_GWatershed_pipeline, merging, PIPELINE_PARAMS)
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); }, [&]() { gws->mergeSimilar(200); });
}

PERF_TEST_P(Perf_GWatershed_pipeline, merging_again, PIPELINE_PARAMS)
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    timeOver(pictures, [&]()
    {
        gws->iterate(pictures.image());
        gws->mergeSimilar(200);
    }, [&]() { gws->mergeSimilar(100); });
}

//! A frame that follows another one, from which the camera has moved by two pixels.
PERF_TEST_P(Perf_GWatershed_pipeline, temporal, PIPELINE_PARAMS)
{
    const Size size = get<1>(GetParam());
    Pictures pictures(Size(size.width + 2, size.height + 2));
    Ptr<SuperpixelGWatershed> gws = createForPerf(GetParam());
    gws->setTemporal(true);
    timeOver(pictures, [&]()
    {
        gws->clear();
        gws->iterate(pictures.image()(Rect(Point(), size)));
    }, [&]() { gws->iterate(pictures.image()(Rect(Point(2, 2), size))); });
}

}} // namespace
