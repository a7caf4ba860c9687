// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// Matrices and vectors that results are given to.

typedef testing::TestWithParam<int> ximgproc_GWatershed_output;

static Ptr<SuperpixelGWatershed> segmentNoise(Size size, int algorithm)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(makeImage(NOISE, size, 3, theRNG()), algorithm, 4);
    gws->iterate();
    return gws;
}

TEST_P(ximgproc_GWatershed_output, vectors_take_what_has_one_row_or_column)
{
    const Size sizes[] = { Size(1, 300), Size(300, 1), Size(1, 1) };
    for (int i = 0; i < 3; i++)
    {
        const Ptr<SuperpixelGWatershed> gws = segmentNoise(sizes[i], GetParam());
        Mat contours, lines, stats, centroids, depths;
        const Mat depth(sizes[i], CV_16UC1, Scalar(700));
        gws->getLabelContourMask(contours, false);
        gws->getWatershedLineMask(lines);
        gws->getStatistics(noArray(), depth, stats, centroids, noArray(), depths);
        std::vector<int> labels;
        std::vector<uchar> mask;
        std::vector<float> mean_depths;
        gws->getLabels(labels);
        EXPECT_TRUE(equalMats(labelsOf(gws).reshape(1, 1), Mat(labels).reshape(1, 1)));
        gws->getLabelContourMask(mask, false);
        EXPECT_TRUE(equalMats(contours.reshape(1, 1), Mat(mask).reshape(1, 1)));
        gws->getWatershedLineMask(mask);
        EXPECT_TRUE(equalMats(lines.reshape(1, 1), Mat(mask).reshape(1, 1)));
        gws->getStatistics(noArray(), depth, stats, centroids, noArray(), mean_depths);
        EXPECT_TRUE(equalMats(depths.reshape(1, 1), Mat(mean_depths).reshape(1, 1)));
    }
}

TEST_P(ximgproc_GWatershed_output, all_tables_are_written_or_none)
{
    const Ptr<SuperpixelGWatershed> gws = segmentNoise(Size(40, 30), GetParam());
    Mat stats(1, 1, CV_32SC1, Scalar(7)), pairs(1, 1, CV_32SC1, Scalar(7));
    Matx<double, 3, 2> few_centroids;
    Matx<int, 3, 1> few_lengths;
    EXPECT_TRUE(isRefused([&]() { gws->getStatistics(noArray(), noArray(), stats, few_centroids); }, "centroids"));
    EXPECT_TRUE(isRefused([&]() { gws->getAdjacency(noArray(), noArray(), pairs, few_lengths); }, "lengths"));
    EXPECT_EQ(Size(1, 1), stats.size());
    EXPECT_EQ(Size(1, 1), pairs.size());
}

TEST_P(ximgproc_GWatershed_output, a_umat_may_be_input_and_output)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(80, 60), rng), depth = makeDepth(image.size(), 0.1, rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->iterate();
    Mat stats, centroids, colors, depths, pairs, lengths;
    gws->getStatistics(image, depth, stats, centroids, colors, depths);
    gws->getAdjacency(image, noArray(), pairs, lengths);
    UMat ucolors, udepths, upairs;
    image.copyTo(ucolors);
    image.copyTo(upairs);
    depth.copyTo(udepths);
    gws->getStatistics(ucolors, udepths, stats, centroids, ucolors, udepths);
    gws->getAdjacency(upairs, noArray(), upairs, lengths);
    EXPECT_TRUE(equalMats(colors, ucolors.getMat(ACCESS_READ)));
    EXPECT_EQ(0, cvtest::norm(pairs, upairs.getMat(ACCESS_READ), NORM_INF));
    EXPECT_EQ(depths.size(), udepths.size());
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_output, testing::ValuesIn(ALGORITHMS));

}} // namespace
