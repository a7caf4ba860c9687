// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// Images and superpixels of extreme size and shape. tools/checks/scale.cpp has those that take much memory,
// and the time that strips and very many neighbours take.

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

TEST_P(ximgproc_GWatershed_scale, takes_a_superpixel_with_very_many_neighbours)
{
    const Size size(640, 640);
    const Mat image = makeImage(NOISE, size, 3, theRNG());
    Mat markers(size, CV_32SC1, Scalar(1)), pairs, lengths;
    for (int k = 0; k < 320 * 320; k++)
        markers.at<int>(2 * (k / 320) + 1, 2 * (k % 320) + 1) = k + 2;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMarkers(markers);
    gws->iterate();
    gws->getAdjacency(noArray(), noArray(), pairs, lengths);
    EXPECT_EQ(320 * 320, pairs.rows);
    gws->mergeSimilar(1);
    EXPECT_EQ(1, gws->getNumberOfSuperpixels());
    gws->iterate();
    gws->enforceLabelConnectivity(100);
    expectPartition(labelsOf(gws), size, gws->getNumberOfSuperpixels());
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_scale, testing::ValuesIn(ALGORITHMS));

}} // namespace
