// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

#include <atomic>
#include <thread>

namespace opencv_test { namespace {

// Inputs and calls that users of superpixels reported, for every algorithm. An edge is cut where no label lies on both
// sides of it.

typedef testing::TestWithParam<int> ximgproc_GWatershed_real_inputs;

const float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN(), INFINITE = std::numeric_limits<float>::infinity();

//! Number of labels that lie on both sides: inside of a CV_8UC1 mask and outside.
int labelsOnBothSides(const Mat& labels, const Mat& side)
{
    std::set<int> inside, outside;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            (side.at<uchar>(y, x) ? inside : outside).insert(labels.at<int>(y, x));
    int both = 0;
    for (std::set<int>::const_iterator it = inside.begin(); it != inside.end(); ++it)
        both += int(outside.count(*it));
    return both;
}

Mat leftPart(Size size, int columns)
{
    Mat side(size, CV_8UC1, Scalar(0));
    side.colRange(0, columns).setTo(Scalar(1));
    return side;
}

Mat disc(Size size)
{
    Mat side(size, CV_8UC1, Scalar(0));
    circle(side, Point(size.width / 2, size.height / 2), size.height / 3, Scalar(1), FILLED);
    return side;
}

//! Two values, with noise, in a matrix of a type.
Mat twoValues(const Mat& side, double inside, double outside, double noise, int type)
{
    Mat values(side.size(), CV_64FC1, Scalar(outside)), grain(side.size(), CV_64FC1);
    values.setTo(Scalar(inside), side);
    theRNG().fill(grain, RNG::NORMAL, 0, noise);
    values += grain;
    values.convertTo(values, CV_MAT_DEPTH(type));
    std::vector<Mat> channels(CV_MAT_CN(type), values);
    Mat image;
    merge(channels, image);
    return image;
}

//! Share of the pixels on a boundary of a mask that are on a contour of the labels, or beside one.
double recall(const Ptr<SuperpixelGWatershed>& gws, const Mat& side)
{
    Mat contours, boundary;
    gws->getLabelContourMask(contours);
    dilate(contours, contours, Mat());
    morphologyEx(side, boundary, MORPH_GRADIENT, Mat());
    return countNonZero(boundary & contours) / double(countNonZero(boundary));
}

double recallOf(const Mat& image, const Mat& side, int algorithm)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, algorithm, 16);
    gws->iterate();
    return recall(gws, side);
}

// Values.

TEST_P(ximgproc_GWatershed_real_inputs, images_in_the_range_of_8_bits_of_every_depth)
{
    const Mat image = makeScene(Size(160, 120), theRNG());
    const Mat expected = segment(image, GetParam(), 10);
    const int depths[] = { CV_16U, CV_16S, CV_32S, CV_32F, CV_64F, CV_16F };
    for (int depth : depths)
    {
        Mat floats, same;
        image.convertTo(floats, CV_32F);
        floats.convertTo(same, depth);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(same, GetParam());
        gws->setValueRange(0, 255);
        gws->iterate();
        EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << depth;
    }
    Mat chars;
    image.convertTo(chars, CV_8S, 1, -128);
    EXPECT_TRUE(equalMats(expected, segment(chars, GetParam(), 10)));
    Mat doubles;
    image.convertTo(doubles, CV_64F, 1. / 255);
    EXPECT_TRUE(equalMats(expected, segment(doubles, GetParam(), 10)));
}

TEST_P(ximgproc_GWatershed_real_inputs, images_in_another_range_than_that_of_their_type)
{
    const Size size(160, 120);
    const Mat side = disc(size);
    const double plain = recallOf(twoValues(side, 170, 90, 6, CV_8UC1), side, GetParam());
    struct { double low, high; int depth; } cases[] = {
        { 0, 255, CV_32F }, { -1, 1, CV_32F }, { -1000, 3000, CV_16S }, { -1000, 3000, CV_32F }, { 0, 4095, CV_16U },
        { 0, 1e-4, CV_64F }, { 1e6, 1e6 + 2048, CV_64F }, { -70000, 90000, CV_32S }, { -1, 1, CV_16F } };
    for (const auto& c : cases)
        for (int channels = 1; channels <= 4; channels++)
        {
            const double step = (c.high - c.low) / 255;
            Mat image = twoValues(side, c.low + 170 * step, c.low + 90 * step, 6 * step,
                                  CV_MAKETYPE(c.depth == CV_16F ? CV_32F : c.depth, channels));
            image.convertTo(image, c.depth);
            EXPECT_GE(recallOf(image, side, GetParam()), plain - 0.02) << c.low << " to " << c.high << ", " << channels;
        }
}

TEST_P(ximgproc_GWatershed_real_inputs, thermal_images_as_they_are_normalized)
{
    const Mat side = disc(Size(160, 120));
    const Mat image = twoValues(side, 7300, 7000, 20, CV_16UC1);
    Mat normalized;
    normalize(image, normalized, 0, 255, NORM_MINMAX, CV_8U);
    EXPECT_GE(recallOf(image, side, GetParam()), recallOf(normalized, side, GetParam()) - 0.01);
    Mat hot = image.clone();
    hot.at<ushort>(5, 5) = 65535;
    hot.at<ushort>(50, 5) = 0;
    EXPECT_GE(recallOf(hot, side, GetParam()), recallOf(normalized, side, GetParam()) - 0.01);
}

TEST_P(ximgproc_GWatershed_real_inputs, lab_of_floats_as_lab_of_8_bits)
{
    const Mat side = disc(Size(160, 120));
    Mat image(side.size(), CV_8UC3, Scalar(90, 120, 70)), floats, lab;
    image.setTo(Scalar(60, 90, 140), side);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, 150, GetParam());
    gws->setLabInput(true);
    cvtColor(image, lab, COLOR_BGR2Lab);
    gws->iterate(lab);
    const double of_bytes = recall(gws, side);
    image.convertTo(floats, CV_32F, 1. / 255);
    cvtColor(floats, lab, COLOR_BGR2Lab);
    gws->iterate(lab);
    EXPECT_GE(recall(gws, side), of_bytes - 0.01);
    const Mat photo = makeScene(Size(240, 180), theRNG());
    cvtColor(photo, lab, COLOR_BGR2Lab);
    gws->iterate(lab);
    const double explained = explainedVariation(labelsOf(gws), photo);
    photo.convertTo(floats, CV_32F, 1. / 255);
    cvtColor(floats, lab, COLOR_BGR2Lab);
    gws->iterate(lab);
    EXPECT_GE(explainedVariation(labelsOf(gws), photo), explained - 0.02);
}

TEST_P(ximgproc_GWatershed_real_inputs, one_value_in_1000_outside_of_the_usual_range)
{
    Mat image = makeScene(Size(320, 240), theRNG()), clipped;
    image.convertTo(image, CV_32F, 1. / 255);
    for (int i = 0; i < 70; i++)
        image.at<Vec3f>(3 * i, 2 * i) = Vec3f::all(i % 2 ? 30.f : -20.f);
    image.at<Vec3f>(7, 9) = Vec3f(NOT_A_NUMBER, INFINITE, -INFINITE);
    clipped = cv::min(cv::max(image, 0.), 1.);
    clipped.at<Vec3f>(7, 9) = Vec3f(0, 1, 0);
    EXPECT_TRUE(equalMats(segment(clipped, GetParam(), 10), segment(image, GetParam(), 10)));
    for (int i = 0; i < 200; i++)
        image.at<Vec3f>(i, 300) = Vec3f::all(2);
    EXPECT_FALSE(equalMats(segment(clipped, GetParam(), 10), segment(image, GetParam(), 10)));
}

TEST_P(ximgproc_GWatershed_real_inputs, a_range_that_is_set_holds_for_all_frames)
{
    const Mat image = makeScene(Size(160, 120), theRNG());
    Mat words, dark;
    image.convertTo(words, CV_16U, 4095. / 255);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(words, GetParam());
    gws->setValueRange(0, 4095);
    gws->iterate();
    EXPECT_TRUE(equalMats(segment(image, GetParam(), 10), labelsOf(gws)));
    EXPECT_EQ(0, gws->getLowValue());
    EXPECT_EQ(4095, gws->getHighValue());
    image.convertTo(dark, CV_8U, 0.2);
    dark.convertTo(words, CV_16U, 4095. / 255);
    gws->iterate(words);
    EXPECT_TRUE(equalMats(segment(dark, GetParam(), 10), labelsOf(gws)));
    gws->iterate(dark); // 8 bits are taken as they are
    EXPECT_TRUE(equalMats(segment(dark, GetParam(), 10), labelsOf(gws)));
    const float wrong[][2] = { { 1, 1 }, { 2, 1 }, { 0, INFINITE }, { NOT_A_NUMBER, 1 }, { -INFINITE, 0 } };
    for (const auto& range : wrong)
        EXPECT_TRUE(isRefused([&] { gws->setValueRange(range[0], range[1]); }, "_value"));
    EXPECT_EQ(4095, gws->getHighValue());
}

TEST_P(ximgproc_GWatershed_real_inputs, values_outside_of_a_mask_do_not_count)
{
    const Size size(160, 120);
    const Mat side = disc(size), mask = leftPart(size, 120);
    Mat image = twoValues(side, 7300, 7000, 5, CV_16UC1), other = image.clone();
    other.colRange(120, 160).setTo(Scalar(60000));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMask(mask);
    gws->iterate();
    const Mat labels = labelsOf(gws);
    gws->iterate(other);
    EXPECT_TRUE(equalMats(labels, labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_real_inputs, extreme_values_and_few_pixels)
{
    const double values[][2] = { { -FLT_MAX, FLT_MAX }, { 0, 1e-42 }, { -1e-38, 1e-38 }, { 5, 5 }, { 1e300, -1e300 },
                                 { FLT_MAX, INFINITE }, { NOT_A_NUMBER, INFINITE }, { NOT_A_NUMBER, NOT_A_NUMBER } };
    for (const auto& pair : values)
        for (int depth = CV_32F; depth <= CV_64F; depth++)
            for (int cols = 1; cols < 40; cols += 19)
            {
                Mat image(9, cols, CV_MAKETYPE(depth, 2), Scalar::all(pair[0]));
                image.rowRange(4, 9).setTo(Scalar::all(pair[1]));
                expectPartition(segment(image, GetParam(), 5), image.size(), std::max(1, cvRound(9 * cols / 25.)));
            }
}

TEST_P(ximgproc_GWatershed_real_inputs, two_channels_count_alike)
{
    const Size size(95, 60);
    const Mat side = leftPart(size, 47);
    for (int channel = 0; channel < 2; channel++)
    {
        Mat image(size, CV_8UC2, Scalar(100, 100));
        Scalar other(100, 100);
        other[channel] = 140;
        image.setTo(other, side);
        EXPECT_EQ(0, labelsOnBothSides(segment(image, GetParam(), 12), side)) << channel;
    }
}

TEST_P(ximgproc_GWatershed_real_inputs, more_than_4_channels_are_refused_with_advice)
{
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(Mat(20, 20, CV_32FC(7)), GetParam()); }, "PCA"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(Mat(20, 20, CV_8UC(5)), GetParam()); }, "extractChannel"));
}

// Depth.

TEST_P(ximgproc_GWatershed_real_inputs, depth_in_lattices_of_any_step_and_phase)
{
    const Size sizes[] = { Size(1920, 1080), Size(640, 480), Size(417, 311) };
    for (const Size& size : sizes)
        for (int step = 2; step <= 3; step++)
            for (int phase = 0; phase < step; phase++)
            {
                const Mat image(size, CV_8UC1, Scalar(90)), side = leftPart(size, size.width / 2);
                Mat depth(size, CV_16UC1, Scalar(0));
                for (int y = phase; y < size.height; y += step)
                    for (int x = phase; x < size.width; x += step)
                        depth.at<ushort>(y, x) = ushort(side.at<uchar>(y, x) ? 1500 : 1600);
                depth.at<ushort>(size.height / 2 + 1, size.width / 2 + 1) = 60000;
                Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam(), size.width / 32);
                gws->iterate();
                Mat centers, depths;
                gws->getStatistics(noArray(), depth, noArray(), centers, noArray(), depths);
                int mixed = 0;
                for (int i = 0; i < depths.rows; i++)
                    mixed += depths.at<float>(i) > 1502 && depths.at<float>(i) < 1598;
                EXPECT_LE(mixed, GetParam() == RGWATERSHED ? 2 : depths.rows / 16)
                        << size << ", step " << step << ", phase " << phase;
            }
}

TEST_P(ximgproc_GWatershed_real_inputs, depth_of_65535_in_16_bits_is_missing)
{
    const Mat image = makeScene(Size(120, 90), theRNG());
    Mat depth = makeDepth(image.size(), 0.2, theRNG()), saturated = depth.clone();
    depth.colRange(60, 90).setTo(Scalar(0));
    saturated.colRange(60, 90).setTo(Scalar(65535));
    EXPECT_TRUE(equalMats(segment(image, depth, GetParam(), 10), segment(image, saturated, GetParam(), 10)));
}

TEST_P(ximgproc_GWatershed_real_inputs, depth_with_a_value_far_behind_all_others)
{
    const Size size(95, 60);
    const Mat image(size, CV_8UC3, Scalar(90, 120, 70)), side = leftPart(size, 47);
    for (double far_depth : { 5000., 10000., 60000., 1. })
        for (int type : { CV_16UC1, CV_32FC1, CV_64FC1 })
        {
            Mat depth = twoValues(side, 1500, 1600, 0, type), block(size, CV_8UC1, Scalar(0));
            block(Rect(60, 14, 35, 32)).setTo(Scalar(1)); // a fifth of the frame
            depth.setTo(Scalar(far_depth), block);
            const Mat labels = segment(image, depth, GetParam(), 12);
            EXPECT_EQ(0, labelsOnBothSides(labels, side)) << far_depth << ", " << type;
            EXPECT_EQ(0, labelsOnBothSides(labels, block)) << far_depth << ", " << type;
        }
}

TEST_P(ximgproc_GWatershed_real_inputs, depth_of_infinity_is_far_and_nan_is_missing)
{
    const Size size(95, 60);
    const Mat image(size, CV_8UC3, Scalar(90, 120, 70)), side = leftPart(size, 47);
    const Mat alone = segment(image, GetParam(), 12);
    for (int type : { CV_32FC1, CV_64FC1 })
    {
        EXPECT_EQ(0, labelsOnBothSides(segment(image, twoValues(side, 1, INFINITE, 0, type), GetParam(), 12), side));
        for (double missing : { double(NOT_A_NUMBER), 0., -1., -double(INFINITE) })
            EXPECT_TRUE(equalMats(alone, segment(image, twoValues(side, 1, missing, 0, type), GetParam(), 12)));
        Mat three = twoValues(side, 1, 1.5, 0, type);
        three.colRange(75, 95).setTo(Scalar(INFINITE));
        const Mat labels = segment(image, three, GetParam(), 12);
        EXPECT_EQ(0, labelsOnBothSides(labels, side));
        EXPECT_EQ(0, labelsOnBothSides(labels, leftPart(size, 75)));
    }
}

TEST_P(ximgproc_GWatershed_real_inputs, depth_of_8_bits_follows_the_range_that_is_set)
{
    const Size size(95, 60);
    const Mat image(size, CV_8UC3, Scalar(90, 120, 70)), side = leftPart(size, 47);
    const Mat depth = twoValues(side, 30, 32, 0, CV_8UC1);
    Mat words;
    depth.convertTo(words, CV_16U);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam(), 12);
    gws->setDepthRange(25, 40);
    gws->iterate();
    EXPECT_EQ(0, labelsOnBothSides(labelsOf(gws), side));
    const Mat labels = labelsOf(gws);
    gws->iterate(image, words);
    EXPECT_TRUE(equalMats(labels, labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_real_inputs, disparity_of_signed_words_and_depth_of_doubles)
{
    const Mat image = makeScene(Size(120, 90), theRNG());
    const Mat depth = makeDepth(image.size(), 0.2, theRNG());
    const Mat expected = segment(image, depth, GetParam(), 10);
    Mat words, doubles;
    depth.convertTo(words, CV_16S);
    words.setTo(Scalar(-16), depth == 0);
    depth.convertTo(doubles, CV_64F);
    EXPECT_TRUE(equalMats(expected, segment(image, words, GetParam(), 10)));
    EXPECT_TRUE(equalMats(expected, segment(image, doubles, GetParam(), 10)));
}

// Calls.

TEST_P(ximgproc_GWatershed_real_inputs, no_depth_is_colour_alone)
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

TEST_P(ximgproc_GWatershed_real_inputs, numbers_of_every_type_and_two_arguments)
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

TEST_P(ximgproc_GWatershed_real_inputs, one_object_in_two_threads)
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
    EXPECT_EQ(40, done + refused + others);
    EXPECT_GT(done, 0);
    gws->iterate(image);
    EXPECT_TRUE(equalMats(segment(image, GetParam(), 10), labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_real_inputs, statistics_skip_what_is_no_number)
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

TEST_P(ximgproc_GWatershed_real_inputs, no_channel_and_too_many)
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

TEST_P(ximgproc_GWatershed_real_inputs, superpixels_below_an_area_in_pixels)
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

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_real_inputs, testing::ValuesIn(ALGORITHMS));

}} // namespace
