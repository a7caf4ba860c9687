// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// Images and superpixels of extreme size and shape. tools/checks/scale.cpp has those that take much memory.

typedef testing::TestWithParam<int> ximgproc_GWatershed_scale;

TEST_P(ximgproc_GWatershed_scale, strips_take_all_that_can_be_set)
{
    RNG& rng = theRNG();
    const Size sizes[] = { Size(70000, 1), Size(1, 70000) };
    for (int i = 0; i < 2; i++)
    {
        const Mat image = makeImage(NOISE, sizes[i], 3, rng), depth = makeDepth(sizes[i], 0.1, rng);
        Mat mask(sizes[i], CV_8UC1), markers = Mat::zeros(sizes[i], CV_32SC1);
        for (int p = 0; p < 70000; p++)
        {
            mask.ptr<uchar>()[p] = p % 1000 < 900; // 70 pieces
            markers.ptr<int>()[p] = p % 500 == 250 ? p : 0;
        }
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(sizes[i].width, sizes[i].height, 3, 300, GetParam());
        gws->setTemporal(true);
        for (int frame = 0; frame < 2; frame++)
        {
            gws->iterate(image, depth, 3);
            expectPartition(labelsOf(gws), sizes[i], 300);
        }
        Mat pairs, lengths;
        gws->getAdjacency(noArray(), noArray(), pairs, lengths); // a chain
        EXPECT_EQ(299, pairs.rows);
        EXPECT_EQ(299, countNonZero(lengths == 1));
        gws->mergeSimilar(7);
        expectPartition(labelsOf(gws), sizes[i], 7);

        gws->setMask(mask);
        gws->iterate(image, depth, 2);
        expectMaskedPartition(labelsOf(gws), mask, 300);
        gws->mergeSimilar(1);
        EXPECT_EQ(70, gws->getNumberOfSuperpixels());
        gws->setMarkers(markers);
        gws->iterate(image, depth);
        expectMaskedPartition(labelsOf(gws), mask, 140);
    }
}

TEST_P(ximgproc_GWatershed_scale, gives_any_number_up_to_one_for_each_pixel)
{
    const Mat image = makeScene(Size(160, 120), theRNG());
    const int pixels = int(image.total());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(160, 120, 3, 1, GetParam());
    for (int k = 2000; k <= pixels; k = k < pixels ? std::min(2 * k, pixels) : k + 1)
    {
        gws->setDesiredSuperpixels(k);
        gws->iterate(image, 2);
        expectPartition(labelsOf(gws), image.size(), k);
        gws->mergeSimilar(k / 2);
        expectPartition(labelsOf(gws), image.size(), k / 2);
    }
}

TEST_P(ximgproc_GWatershed_scale, a_superpixel_with_very_many_neighbours_takes_no_longer)
{
    const Size size(640, 640);
    const Mat image = makeImage(NOISE, size, 3, theRNG());
    Mat pairs, lengths;
    TickMeter times[2];
    for (int i = 0; i < 2; i++)
    {
        Mat markers(size, CV_32SC1, Scalar(i)); // without and with a superpixel between all others
        for (int k = 0; k < 320 * 320; k++)
            markers.at<int>(2 * (k / 320) + 1, 2 * (k % 320) + 1) = k + 2;
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
        gws->setMarkers(markers);
        gws->iterate();
        times[i].start();
        gws->getAdjacency(noArray(), noArray(), pairs, lengths);
        gws->mergeSimilar(1);
        EXPECT_EQ(1, gws->getNumberOfSuperpixels());
        gws->iterate();
        gws->enforceLabelConnectivity(100);
        times[i].stop();
    }
    EXPECT_EQ(320 * 320, pairs.rows);
    EXPECT_LT(times[1].getTimeMilli(), 5 * times[0].getTimeMilli());
}

// The headers have no memory behind them: an image is refused before anything of it is read.
TEST_P(ximgproc_GWatershed_scale, refuses_more_pixels_than_an_index_can_name)
{
    uchar byte = 0;
    const Mat small = makeScene(Size(30, 20), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(30, 20, 3, 6, GetParam());
    gws->iterate(small);
    const Mat before = labelsOf(gws);
    const Size sizes[] = { Size(46339, 46339), Size(65536, 65536), Size(INT_MAX, 1), Size(1, INT_MAX),
                           Size(715827881, 1) };
    for (int i = 0; i < 5; i++)
    {
        const Mat image(sizes[i], CV_8UC1, &byte);
        const int width = image.cols, height = image.rows;
        EXPECT_REFUSED(createSuperpixelGWatershed(width, height, 3, 100, GetParam()), "fewer than 2^31");
        EXPECT_REFUSED(createSuperpixelGWatershed(image, GetParam()), "fewer than 2^31");
        EXPECT_REFUSED(createSuperpixelGWatershed(image, image, GetParam()), "fewer than 2^31");
        EXPECT_REFUSED(gws->iterate(image), "fewer than 2^31");
        EXPECT_REFUSED(gws->iterate(image, image), "fewer than 2^31");
    }
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
    gws->iterate(small);
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_scale, GWATERSHED_ALGORITHMS);

}} // namespace
