// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"

namespace opencv_test { namespace {

// What a pipeline does beside and after the segmentation of single images.

const int REGION_SIZE = 20;

typedef tuple<SuperpixelAlgorithm, Size> AlgorithmAndSize;
typedef PicturesTest<AlgorithmAndSize> Perf_GWatershed;

testing::internal::ParamGenerator<AlgorithmAndSize> algorithmsAndSizes()
{
    return testing::Combine(SuperpixelAlgorithm::all(), testing::Values(szVGA, sz1080p));
}

Ptr<SuperpixelGWatershed> create(const AlgorithmAndSize& param)
{
    const Size size = get<1>(param);
    return createSuperpixelGWatershed(size.width, size.height, 3, countSuperpixels(size, REGION_SIZE), get<0>(param));
}

//! All but the corners: nearly every pixel is inside, and the mask is not full.
PERF_TEST_P(Perf_GWatershed, nearly_full_mask, algorithmsAndSizes())
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Mat mask(size, CV_8UC1, Scalar(255));
    rectangle(mask, Rect(0, 0, 3, 3), Scalar(0), FILLED);
    rectangle(mask, Rect(size.width - 3, size.height - 3, 3, 3), Scalar(0), FILLED);
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    gws->setMask(mask);
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

//! A disc of an eighth of the image, with an eighth of the superpixels.
PERF_TEST_P(Perf_GWatershed, small_mask, algorithmsAndSizes())
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Mat mask = Mat::zeros(size, CV_8UC1);
    const int radius = cvRound(std::sqrt(size.area() / (8 * CV_PI)));
    circle(mask, Point(size.width / 2, size.height / 2), radius, Scalar(255), FILLED);
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    gws->setRegionSize(REGION_SIZE);
    gws->setMask(mask);
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

PERF_TEST_P(Perf_GWatershed, markers, algorithmsAndSizes())
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    gws->setMarkers(makeGridMarkers(size, REGION_SIZE));
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

PERF_TEST_P(Perf_GWatershed, statistics, algorithmsAndSizes())
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    Mat stats, centroids, colors, depths;
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); }, [&]()
    {
        gws->getStatistics(pictures.image(), pictures.depth(), stats, centroids, colors, depths);
    });
}

PERF_TEST_P(Perf_GWatershed, adjacency, algorithmsAndSizes())
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    Mat pairs, lengths, contrasts;
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); }, [&]()
    {
        gws->getAdjacency(pictures.image(), noArray(), pairs, lengths, contrasts);
    });
}

//! The first call, which finds the order of merging.
PERF_TEST_P(Perf_GWatershed, merging, algorithmsAndSizes())
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); }, [&]() { gws->mergeSimilar(200); });
}

PERF_TEST_P(Perf_GWatershed, merging_again, algorithmsAndSizes())
{
    Pictures pictures(get<1>(GetParam()));
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    timeOver(pictures, [&]()
    {
        gws->iterate(pictures.image());
        gws->mergeSimilar(200);
    }, [&]() { gws->mergeSimilar(100); });
}

//! A frame that follows another one, from which the camera has moved by two pixels.
PERF_TEST_P(Perf_GWatershed, temporal, algorithmsAndSizes())
{
    const Size size = get<1>(GetParam());
    Pictures pictures(Size(size.width + 2, size.height + 2));
    Ptr<SuperpixelGWatershed> gws = create(GetParam());
    gws->setTemporal(true);
    timeOver(pictures, [&]()
    {
        gws->clear();
        gws->iterate(pictures.image()(Rect(Point(), size)));
    }, [&]() { gws->iterate(pictures.image()(Rect(Point(2, 2), size))); });
}

}} // namespace
