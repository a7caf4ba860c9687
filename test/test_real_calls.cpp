// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

#include <atomic>
#include <thread>

namespace opencv_test { namespace {

// Calls that users of superpixels reported, for every algorithm: they mean what they say.

typedef testing::TestWithParam<int> ximgproc_GWatershed_real_calls;

TEST_P(ximgproc_GWatershed_real_calls, no_depth_is_colour_alone)
{
    const Mat image = makeScene(Size(80, 60), theRNG());
    const Mat expected = segment(image, GetParam(), 10);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, noArray(), GetParam(), 10);
    gws->iterate();
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
    gws->iterate(image, noArray());
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
    gws->iterate(image, Mat(), 1);
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
    // What Python makes of (image, None, algorithm, region_size).
    gws = createSuperpixelGWatershed(image, 0, GetParam(), 8.f);
    EXPECT_EQ(GetParam(), gws->getAlgorithm());
    EXPECT_EQ(8, gws->getRegionSize());
}

TEST_P(ximgproc_GWatershed_real_calls, numbers_of_every_type_and_two_arguments)
{
    const Mat image = makeScene(Size(64, 48), theRNG());
    EXPECT_EQ(50, createSuperpixelGWatershed(64, 48, 3, size_t(50))->getDesiredSuperpixels());
    EXPECT_EQ(50, createSuperpixelGWatershed(64, 48, 3, int64(50))->getDesiredSuperpixels());
    EXPECT_EQ(50, createSuperpixelGWatershed(64, 48, 3, short(50))->getDesiredSuperpixels());
    EXPECT_EQ(50, createSuperpixelGWatershed(64, 48, 3, 50.9)->getDesiredSuperpixels());
    EXPECT_EQ(50, createSuperpixelGWatershed(size_t(64), size_t(48), 3u, 50LL, GetParam(), 5)->getDesiredSuperpixels());
    EXPECT_EQ(INT_MAX, createSuperpixelGWatershed(64, 48, 3, 1e300)->getDesiredSuperpixels());
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(64, 48, 3, -1.); }, "num_superpixels"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(64, 48, 3, NOT_A_NUMBER); }, "num_superpixels"));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    EXPECT_EQ(GetParam(), gws->getAlgorithm());
    EXPECT_EQ(20, createSuperpixelGWatershed(image, GetParam(), size_t(20))->getRegionSize());
    EXPECT_EQ(20, createSuperpixelGWatershed(image, GetParam(), 20, 10)->getRegionSize());
    gws->iterate(image, size_t(2));
    gws->iterate(short(2));
    gws->setRuler();
    EXPECT_EQ(10, gws->getRuler());
    gws->setAlpha();
    EXPECT_EQ(0.5f, gws->getAlpha());
}

TEST_P(ximgproc_GWatershed_real_calls, one_object_in_two_threads)
{
    const Mat image = makeScene(Size(200, 150), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    std::atomic<int> done(0), refused(0), others(0);
    const auto work = [&]()
    {
        for (int i = 0; i < 20; i++)
            try
            {
                gws->iterate(image);
                gws->mergeSimilar(20);
                Mat labels;
                gws->getLabels(labels);
                done++;
            }
            catch (const cv::Exception& e)
            {
                (String(e.what()).find("in use by another thread") != String::npos ? refused : others)++;
            }
    };
    std::thread first(work), second(work);
    first.join();
    second.join();
    EXPECT_EQ(0, others);
    EXPECT_EQ(40, done + refused);
    EXPECT_GT(done, 0);
    gws->iterate(image);
    EXPECT_TRUE(equalMats(segment(image, GetParam(), 10), labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_real_calls, statistics_skip_what_is_no_number)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(Mat(8, 8, CV_8UC1, Scalar(9)), GetParam());
    gws->setDesiredSuperpixels(1);
    gws->iterate();
    for (int depth : { CV_32F, CV_64F })
    {
        Mat values(8, 8, CV_MAKETYPE(depth, 3), Scalar(4, 5, NOT_A_NUMBER));
        values.row(2).setTo(Scalar(NOT_A_NUMBER, 5, INFINITE));
        values.row(3).setTo(Scalar(-INFINITE, 13, NOT_A_NUMBER));
        Mat means, depths;
        Mat words(8, 8, CV_16UC1, Scalar(1000));
        words.row(1).setTo(Scalar(65535));
        gws->getStatistics(values, words, noArray(), noArray(), means, depths);
        EXPECT_EQ(4, means.at<float>(0, 0));
        EXPECT_EQ(6, means.at<float>(0, 1));
        EXPECT_TRUE(std::isnan(means.at<float>(0, 2)));
        EXPECT_EQ(1000, depths.at<float>(0));
    }
}

#ifdef CV_64S // since OpenCV 5
TEST_P(ximgproc_GWatershed_real_calls, integers_beyond_double_are_refused_and_others_are_exact)
{
    const Mat image(8, 8, CV_8UC1, Scalar(9));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setDesiredSuperpixels(1);
    gws->iterate();
    Mat stats, colors;
    const auto measure = [&](const Mat& values) { gws->getStatistics(values, noArray(), stats, noArray(), colors); };
    for (int depth : { CV_64S, CV_64U })
    {
        EXPECT_TRUE(isRefused([&] { measure(Mat(8, 8, CV_MAKETYPE(depth, 1), Scalar(1))); }, "64-bit integers"));
        EXPECT_TRUE(isRefused([&] { gws->iterate(Mat(8, 8, CV_MAKETYPE(depth, 1), Scalar(1))); }, "image must be"));
    }
    measure(Mat(8, 8, CV_32UC1, Scalar(3e9)));
    EXPECT_EQ(3e9f, colors.at<float>(0));
}
#endif

TEST_P(ximgproc_GWatershed_real_calls, no_channel_and_too_many)
{
    const Mat image(8, 9, CV_8UC1, Scalar(9));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->iterate();
    uchar memory[8 * 9] = {};
    Mat without(8, 9, CV_8UC(CV_CN_MAX), memory);
    without.step.p[0] = 9; // what a NumPy array of the shape (8, 9, 0) becomes
    Mat stats;
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(without, noArray(), stats, noArray()); }, "must have a channel"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(without); }, "image must have a channel"));
    const int sizes[] = { 8, 9, CV_CN_MAX + 1 };
    const Mat volume(3, sizes, CV_8UC1, Scalar(0));
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(volume, noArray(), stats, noArray()); }, "channels"));
}

TEST_P(ximgproc_GWatershed_real_calls, superpixels_below_an_area_in_pixels)
{
    const Mat image = makeScene(Size(160, 120), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 8);
    gws->iterate();
    const int before = gws->getNumberOfSuperpixels();
    gws->mergeSmall(0);
    EXPECT_EQ(before, gws->getNumberOfSuperpixels());
    gws->mergeSmall(500); // far above the mean area
    Mat stats;
    gws->getStatistics(noArray(), noArray(), stats, noArray());
    double smallest;
    minMaxLoc(stats.col(CC_STAT_AREA), &smallest);
    EXPECT_GE(smallest, 500);
    expectPartition(labelsOf(gws), image.size(), gws->getNumberOfSuperpixels());
    gws->mergeSmall(INT_MAX);
    EXPECT_EQ(1, gws->getNumberOfSuperpixels());
    EXPECT_TRUE(isRefused([&] { gws->mergeSmall(-1); }, "min_area"));
}

// What has grown has the longest boundary with all around it, but does not swallow an even area.
TEST_P(ximgproc_GWatershed_real_calls, small_superpixels_of_an_even_area_are_not_merged_into_one)
{
    const Size size(640, 480);
    for (const int& noise : { 0, 1, 2 })
        for (const int& side : { 8, 10, 16, 20, 25 })
        {
            Mat image(size, CV_8UC1), changes(size, CV_8SC1);
            theRNG().fill(changes, RNG::NORMAL, 0, noise);
            cv::add(Mat(size, CV_8UC1, Scalar(120)), changes, image, noArray(), CV_8U);
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), side);
            gws->iterate();
            const int least = side * side * 5 / 4;
            gws->mergeSmall(least);
            Mat stats;
            gws->getStatistics(noArray(), noArray(), stats, noArray());
            double largest;
            minMaxLoc(stats.col(CC_STAT_AREA), 0, &largest);
            EXPECT_LE(largest, 8 * least) << noise << ", " << side;
        }
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_real_calls, testing::ValuesIn(ALGORITHMS));

}} // namespace
