// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// Images and depth that users of superpixels reported, for every algorithm. An edge is cut where no label lies on both
// sides of it.

typedef testing::TestWithParam<int> ximgproc_GWatershed_real_inputs;

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
    const int depths[] = { CV_8U, CV_16U, CV_16S, CV_32S, CV_32F, CV_64F, CV_16F };
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

//! CIELAB as cvtColor() makes it, from a BGR image in 8 bits, in 8 bits or floats.
Mat toLab(const Mat& image, int depth)
{
    Mat converted, lab;
    image.convertTo(converted, depth, depth == CV_8U ? 1 : 1. / 255);
    cvtColor(converted, lab, COLOR_BGR2Lab);
    return lab;
}

//! Labels of 150 superpixels of an image of uniform colours. After one iteration, single pixels at an edge are left on
//! its wrong side, by chance more or fewer.
Mat segmentLab(const Mat& lab, int algorithm)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(lab.cols, lab.rows, 3, 150, algorithm);
    gws->setLabInput(true);
    gws->iterate(lab, 2);
    return labelsOf(gws);
}

// One map for all channels keeps the proportions of CIELAB, while cvtColor() stretches lightness, 2.55 times as much as
// a and b, where it makes 8 bits. So floats follow colour more. On 50 photographs, 400 superpixels of RGWATERSHED
// explain 0.883 of the variation by floats and 0.894 by 8 bits; those of GWATERSHED 0.696 and 0.693.
TEST_P(ximgproc_GWatershed_real_inputs, lab_of_floats_is_cut_as_lab_of_8_bits)
{
    const Mat side = disc(Size(160, 120));
    Mat image(side.size(), CV_8UC3, Scalar(90, 120, 70));
    image.setTo(Scalar(60, 90, 140), side);
    EXPECT_LE(labelsOnBothSides(segmentLab(toLab(image, CV_32F), GetParam()), side),
              labelsOnBothSides(segmentLab(toLab(image, CV_8U), GetParam()), side));
    double gain = 0;
    for (int i = 0; i < 8; i++)
    {
        const Mat scene = makeScene(Size(240, 180), theRNG());
        gain += explainedVariation(segmentLab(toLab(scene, CV_32F), GetParam()), scene) -
                explainedVariation(segmentLab(toLab(scene, CV_8U), GetParam()), scene);
    }
    EXPECT_GE(gain / 8, -0.005);
}

TEST_P(ximgproc_GWatershed_real_inputs, the_automatic_range_is_without_one_value_in_1000_at_each_end)
{
    const Mat lab = toLab(makeScene(Size(72, 72), theRNG()), CV_32F); // small enough to be looked at as a whole
    std::vector<float> values(lab.ptr<float>(), lab.ptr<float>() + lab.total() * 3);
    std::sort(values.begin(), values.end());
    const size_t outliers = values.size() / 1000;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(lab, GetParam());
    gws->setValueRange(values[outliers], values[values.size() - 1 - outliers]);
    gws->iterate();
    EXPECT_TRUE(equalMats(labelsOf(gws), segment(lab, GetParam(), 10)));
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

TEST_P(ximgproc_GWatershed_real_inputs, a_sixteenth_of_the_usual_range_is_enough)
{
    const Mat side = disc(Size(160, 120));
    for (int depth : { CV_16U, CV_32F, CV_64F })
        for (int span : { 14, 18 }) // of 255
        {
            const Mat image = twoValues(side, 200 + span, 200, 0, CV_8UC3);
            const double white = depth == CV_16U ? 65535 : 1;
            Mat converted;
            image.convertTo(converted, depth, white / 255);
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(converted, GetParam(), 10);
            gws->iterate();
            Mat contrasts, pairs, lengths;
            gws->getAdjacency(converted, noArray(), pairs, lengths, contrasts);
            double highest;
            minMaxLoc(contrasts, 0, &highest);
            if (span < 255 / 16)
                EXPECT_GT(highest, 200) << depth;
            else
                EXPECT_TRUE(equalMats(segment(image, GetParam(), 10), labelsOf(gws))) << depth;
            EXPECT_EQ(span < 255 / 16, highest > span + 1) << depth;
        }
}

// The most of 12 bits is 4095, and an image of 8 bits in words is as it was in bytes.
TEST_P(ximgproc_GWatershed_real_inputs, words_of_any_number_of_bits)
{
    Mat image = makeScene(Size(160, 120), theRNG());
    image(Rect(0, 0, 20, 20)).setTo(Scalar::all(255));
    const Mat expected = segment(image, GetParam(), 10);
    for (int bits = 8; bits <= 16; bits++)
    {
        Mat words;
        image.convertTo(words, CV_16U, ((1 << bits) - 1) / 255.);
        EXPECT_TRUE(equalMats(expected, segment(words, GetParam(), 10))) << bits;
    }
}

// A thermal camera may count from far below all that it sees.
TEST_P(ximgproc_GWatershed_real_inputs, words_far_above_zero_are_taken_from_the_lowest_on)
{
    Mat gray, expected;
    cvtColor(makeScene(Size(160, 120), theRNG()), gray, COLOR_BGR2GRAY);
    for (const int& offset : { 6000, 7300, 16400, 29000 })
    {
        Mat words;
        gray.convertTo(words, CV_16U, 7, offset);
        const Mat labels = segment(words, GetParam(), 10);
        EXPECT_TRUE(expected.empty() || equalMats(expected, labels)) << offset;
        expected = labels;
    }
}

TEST_P(ximgproc_GWatershed_real_inputs, the_fourth_channel_has_no_part_in_the_range)
{
    const Mat image = makeScene(Size(160, 120), theRNG());
    const struct { int depth; double scale, alpha; } cases[] = {
        { CV_16U, 4, 65535 }, { CV_16S, 4, 32767 }, { CV_32S, 100, 1e6 }, { CV_32F, 1. / 255, 255 }, { CV_64F, 3, -1e9 }
    };
    for (const auto& c : cases)
    {
        Mat colors, with_alpha;
        image.convertTo(colors, c.depth, c.scale);
        const Mat parts[] = { colors, Mat(image.size(), CV_MAKETYPE(c.depth, 1), Scalar(c.alpha)) };
        merge(parts, 2, with_alpha);
        EXPECT_TRUE(equalMats(segment(colors, GetParam(), 10), segment(with_alpha, GetParam(), 10))) << c.depth;
    }
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
    gws->iterate(dark);
    Mat same;
    dark.convertTo(same, CV_16U);
    const Mat expected = labelsOf(gws);
    gws->iterate(same);
    EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << "of the same values in 8 bits";
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

TEST_P(ximgproc_GWatershed_real_inputs, two_channels_are_never_lightness_and_color)
{
    Mat image(60, 95, CV_8UC2);
    theRNG().fill(image, RNG::UNIFORM, 0, 256);
    GaussianBlur(image, image, Size(), 3);
    Mat labels[2], merged[2];
    for (int lab_input = 0; lab_input < 2; lab_input++)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 5);
        gws->setLabInput(lab_input != 0);
        gws->iterate();
        labels[lab_input] = labelsOf(gws);
        gws->mergeSimilar(40);
        merged[lab_input] = labelsOf(gws);
    }
    EXPECT_EQ(0, cv::norm(labels[0], labels[1], NORM_INF));
    EXPECT_EQ(0, cv::norm(merged[0], merged[1], NORM_INF));
}

TEST_P(ximgproc_GWatershed_real_inputs, more_than_4_channels_are_refused_with_advice)
{
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(Mat(20, 20, CV_32FC(7)), GetParam()); }, "PCA"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(Mat(20, 20, CV_8UC(5)), GetParam()); }, "extractChannel"));
}

// Depth.

//! Depth on two sides of an edge where x and y have a phase, 0 elsewhere. One outlier is between four of these pixels,
//! where a sample of odd x and y can meet it.
Mat latticeDepth(const Mat& side, int step, int phase)
{
    Mat depth(side.size(), CV_16UC1, Scalar(0));
    for (int y = phase; y < side.rows; y += step)
        for (int x = phase; x < side.cols; x += step)
            depth.at<ushort>(y, x) = ushort(side.at<uchar>(y, x) ? 1500 : 1600);
    const Point middle(side.cols / 2 / step / 3 * 3 + 1, side.rows / 2 / step / 3 * 3 + 1);
    depth.at<ushort>(middle * step + Point(phase + 1, phase + 1)) = 60000;
    return depth;
}

//! Labels that have pixels of both depths, without the outlier and those beside it: a block of one of each has a depth
//! in the middle, and may be on either side.
int labelsOfBothDepths(const Mat& labels, const Mat& depth)
{
    Mat measured = labels.clone(), ignored;
    dilate(depth > 1600, ignored, noArray());
    measured.setTo(Scalar(-1), ((depth != 1500) & (depth != 1600)) | ignored);
    return labelsOnBothSides(measured, (depth == 1500) & ~ignored);
}

// In GWATERSHED depth counts between neighbours that both have it. On a lattice no pixel has such a neighbour, so
// Algorithm 1 sees colour alone there, as where depth is missing everywhere.
TEST_P(ximgproc_GWatershed_real_inputs, depth_in_lattices_of_any_step_and_phase)
{
    const Size sizes[] = { Size(1920, 1080), Size(640, 480), Size(417, 311) };
    for (const Size& size : sizes)
    {
        const Mat image(size, CV_8UC1, Scalar(90)), side = leftPart(size, size.width / 2 + 5);
        const int region_size = size.width / 32;
        const Mat alone = segment(image, GetParam(), region_size);
        for (int step = 2; step <= 4; step++)
            for (int phase = 0; phase < step; phase++)
            {
                const Mat depth = latticeDepth(side, step, phase);
                const Mat labels = segment(image, depth, GetParam(), region_size);
                if (GetParam() == GWATERSHED)
                    EXPECT_TRUE(equalMats(alone, labels)) << size << ", step " << step << ", phase " << phase;
                else
                    EXPECT_EQ(0, labelsOfBothDepths(labels, depth))
                            << size << ", step " << step << ", phase " << phase;
            }
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
    gws->setFocalLength(76); // or 8 bits are no metric depth
    gws->iterate();
    EXPECT_EQ(0, labelsOnBothSides(labelsOf(gws), side));
    const Mat labels = labelsOf(gws);
    gws->iterate(image, words);
    EXPECT_TRUE(equalMats(labels, labelsOf(gws)));
}

// Large ones of integers are scaled by a table.
TEST_P(ximgproc_GWatershed_real_inputs, depth_of_every_type_small_and_large)
{
    for (const Size& size : { Size(120, 90), Size(320, 240) })
        for (bool with_far : { false, true }) // a value far behind all others
        {
            const Mat image = makeScene(size, theRNG());
            Mat depth = makeDepth(size, 0.2, theRNG());
            if (with_far)
                depth(Rect(10, 10, size.width / 3, size.height / 3)).setTo(Scalar(30000));
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 10);
            gws->setFocalLength(0.8f * size.width); // or 16 bits with a sign are no metric depth
            gws->iterate(image, depth);
            const Mat expected = labelsOf(gws);
            for (int type : { CV_16S, CV_32F, CV_64F })
            {
                Mat other;
                depth.convertTo(other, type);
                other.setTo(Scalar(-16), depth == 0); // as the disparity of StereoSGBM
                gws->iterate(image, other);
                EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << type << ", " << size;
            }
        }
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_real_inputs, testing::ValuesIn(ALGORITHMS));

}} // namespace
