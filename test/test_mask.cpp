// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// setMask(): what is outside has no label and no influence, what is inside is a partition.

typedef testing::TestWithParam<int> ximgproc_GWatershed_mask;

TEST_P(ximgproc_GWatershed_mask, labels_the_inside_with_connected_superpixels)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 40 * MASK_KINDS; i++)
    {
        const MaskKind kind = MaskKind(i % MASK_KINDS);
        const Size size(rng.uniform(1, 150), rng.uniform(1, 120));
        const Mat image = makeImage(ImageKind(rng.uniform(0, int(IMAGE_KINDS))), size, 3, rng);
        const Mat mask = makeMask(kind, size, rng), depth = makeDepth(size, 0.2, rng);
        const int inside = countNonZero(mask), k = rng.uniform(1, 1 + size.area() / rng.uniform(1, 200));

        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam());
        gws->setDesiredSuperpixels(k);
        gws->setMask(mask);
        if (i % 2)
            gws->iterate(1 + i % 4);
        else
            gws->iterate(image);
        const int n = gws->getNumberOfSuperpixels();
        ASSERT_EQ(std::max(std::min(k, inside), countMaskPieces(mask)), n)
                << "kind " << int(kind) << ", " << size << ", " << k << " of " << inside;
        ASSERT_NO_FATAL_FAILURE(expectMaskedPartition(labelsOf(gws), mask, n)) << "kind " << int(kind) << ", " << size;

        Mat contours, thin, lines;
        gws->getLabelContourMask(contours);
        gws->getLabelContourMask(thin, false);
        gws->getWatershedLineMask(lines);
        EXPECT_EQ(0, countNonZero((contours | thin | lines) & (mask == 0)));
    }
}

TEST_P(ximgproc_GWatershed_mask, counts_region_size_inside)
{
    const Mat image = makeScene(Size(200, 160), theRNG());
    Mat mask = Mat::zeros(image.size(), CV_8UC1);
    circle(mask, Point(90, 80), 60, Scalar(255), FILLED);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 10);
    gws->setMask(mask);
    gws->iterate();
    EXPECT_EQ(cvRound(countNonZero(mask) / 100.), gws->getNumberOfSuperpixels());
}

TEST_P(ximgproc_GWatershed_mask, does_not_see_the_outside)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 3 * MASK_KINDS; i++)
    {
        const Size size(rng.uniform(20, 150), rng.uniform(20, 120));
        const Mat image = makeScene(size, rng), depth = makeDepth(size, 0.1, rng);
        const Mat mask = makeMask(MaskKind(i % MASK_KINDS), size, rng);
        Mat other(size, CV_8UC3), other_depth(size, CV_16UC1);
        rng.fill(other, RNG::UNIFORM, Scalar::all(0), Scalar::all(256));
        rng.fill(other_depth, RNG::UNIFORM, Scalar::all(0), Scalar::all(9000));
        image.copyTo(other, mask);
        depth.copyTo(other_depth, mask);

        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 8);
        gws->setMask(mask);
        gws->iterate(image, depth, 2);
        const Mat expected = labelsOf(gws);
        const Mat other_before = other.clone(), other_depth_before = other_depth.clone();
        gws->iterate(other, other_depth, 2);
        EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << "kind " << i % MASK_KINDS << ", " << size;
        Mat pairs, lengths, contrasts;
        gws->getAdjacency(other, other_depth, pairs, lengths, contrasts);
        EXPECT_TRUE(equalMats(other_before, other));
        EXPECT_TRUE(equalMats(other_depth_before, other_depth));
    }
}

// Two bars in opposite corners, of which one is brighter than 1. Of all pixels between them, these would be few.
TEST_P(ximgproc_GWatershed_mask, range_of_values_is_that_of_the_inside)
{
    const Size size(600, 600);
    Mat image(size, CV_32F, Scalar(0.5)), mask(size, CV_8U, Scalar(0));
    const Rect bars[] = { Rect(0, 0, 100, 3), Rect(500, 597, 100, 3) };
    const double values[] = { 1.5, 3, 0, 1 };
    for (int i = 0; i < 4; i++)
        image(Rect(bars[i / 2].x + i % 2 * 50, bars[i / 2].y, 50, 3)).setTo(Scalar(values[i]));
    mask(bars[0]).setTo(Scalar(1));
    mask(bars[1]).setTo(Scalar(1));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 1, 14, GetParam());
    gws->setMask(mask);
    gws->iterate(image);
    const Mat labels = labelsOf(gws);
    for (int y = 0; y < 3; y++)
        EXPECT_NE(labels.at<int>(y, 49), labels.at<int>(y, 50)) << y;
}

TEST_P(ximgproc_GWatershed_mask, does_not_see_the_outside_of_frames_that_follow)
{
    RNG& rng = theRNG();
    const Size size(320, 240);
    Mat mask = Mat::zeros(size, CV_8UC1);
    circle(mask, Point(160, 120), 100, Scalar(255), FILLED);
    for (int i = 0; i < 8; i++)
    {
        const Mat first = makeScene(size, rng);
        Mat next = first.clone();
        circle(next, Point(150 + 5 * i, 50), 40, Scalar(20, 220, 240), FILLED);
        Mat other = makeImage(NOISE, size, 3, rng);
        next.copyTo(other, mask);
        Mat labels[2];
        for (int k = 0; k < 2; k++)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 3, 300, GetParam());
            gws->setTemporal(true);
            gws->setMask(mask);
            gws->iterate(first);
            gws->iterate(k == 0 ? next : other);
            labels[k] = labelsOf(gws);
        }
        EXPECT_TRUE(equalMats(labels[0], labels[1])) << i;
    }
}

TEST_P(ximgproc_GWatershed_mask, full_mask_is_none_and_a_box_is_a_submatrix)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(140, 110), rng), depth = makeDepth(image.size(), 0.1, rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam(), 9);
    gws->setMask(Mat(image.size(), CV_8UC1, Scalar(1)));
    gws->iterate();
    EXPECT_TRUE(equalMats(segment(image, depth, GetParam(), 9), labelsOf(gws)));

    const Rect box(17, 5, 80, 71);
    Mat mask = Mat::zeros(image.size(), CV_8UC1);
    mask(box).setTo(Scalar(255));
    gws->setMask(mask);
    gws->iterate();
    EXPECT_TRUE(equalMats(segment(image(box), depth(box), GetParam(), 9), labelsOf(gws)(box)));

    gws->setMask(noArray());
    gws->iterate();
    EXPECT_TRUE(equalMats(segment(image, depth, GetParam(), 9), labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_mask, empty_mask_gives_no_superpixels)
{
    const Mat image = makeScene(Size(50, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->iterate(makeScene(Size(90, 80), theRNG())); // leaves lines, which must not come back
    gws->setMask(Mat::zeros(image.size(), CV_8UC1));
    gws->iterate();
    EXPECT_EQ(0, gws->getNumberOfSuperpixels());
    EXPECT_FALSE(gws->empty());
    EXPECT_EQ(0, cvtest::norm(labelsOf(gws), Mat(image.size(), CV_32SC1, Scalar(-1)), NORM_INF));
    Mat contours, lines, stats, centroids, colors, pairs, lengths, contrasts;
    gws->getWatershedLineMask(lines);
    EXPECT_EQ(0, countNonZero(lines));
    gws->getLabelContourMask(contours);
    EXPECT_EQ(0, countNonZero(contours));
    gws->getStatistics(image, noArray(), stats, centroids, colors, noArray());
    EXPECT_TRUE(stats.empty() && centroids.empty() && colors.empty());
    gws->getAdjacency(image, noArray(), pairs, lengths, contrasts);
    EXPECT_TRUE(pairs.empty() && lengths.empty() && contrasts.empty());
    EXPECT_EQ(CV_32SC1, pairs.type());
    EXPECT_EQ(CV_32FC1, contrasts.type());
    EXPECT_EQ(5, stats.cols);
    EXPECT_EQ(CV_64FC1, centroids.type());
    gws->enforceLabelConnectivity();
    gws->mergeSimilar(3);
    EXPECT_EQ(0, gws->getNumberOfSuperpixels());
}

TEST_P(ximgproc_GWatershed_mask, more_specks_than_superpixels)
{
    Mat image(64, 12000, CV_8UC3), mask = Mat::zeros(image.size(), CV_8UC1);
    theRNG().fill(image, RNG::UNIFORM, Scalar::all(0), Scalar::all(256));
    mask.rowRange(0, 60).setTo(Scalar(1));
    for (int i = 0; i < 20; i++)
        mask.at<uchar>(62, 3 + 500 * i) = 1;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setDesiredSuperpixels(10);
    gws->setMask(mask);
    gws->iterate();
    EXPECT_EQ(21, gws->getNumberOfSuperpixels());
    expectMaskedPartition(labelsOf(gws), mask, 21);
}

//! Everything that an object tells.
std::vector<Mat> askEverything(const Ptr<SuperpixelGWatershed>& gws, const Mat& image)
{
    std::vector<Mat> answers(11);
    gws->getLabels(answers[0]);
    gws->getLabelContourMask(answers[1]);
    gws->getWatershedLineMask(answers[2]);
    gws->getStatistics(image, noArray(), answers[3], answers[4], answers[5]);
    gws->getAdjacency(image, noArray(), answers[6], answers[7], answers[8]);
    gws->mergeSimilar(5);
    gws->getLabels(answers[9]);
    gws->enforceLabelConnectivity(50);
    gws->getLabels(answers[10]);
    return answers;
}

TEST_P(ximgproc_GWatershed_mask, reused_object_equals_a_fresh_one)
{
    RNG& rng = theRNG();
    Ptr<SuperpixelGWatershed> reused = createSuperpixelGWatershed(1, 1, 3, 1);
    for (int i = 0; i < 60; i++)
    {
        const Size size(rng.uniform(1, 130), rng.uniform(1, 100));
        const Mat image = makeImage(ImageKind(rng.uniform(0, int(IMAGE_KINDS))), size, 3, rng);
        const Mat mask = i % 2 ? makeMask(MaskKind(rng.uniform(0, int(MASK_KINDS))), size, rng) : Mat();
        const Mat markers = i % 5 == 4 ? makeMarkers(size, rng.uniform(0, 20), rng) : Mat();
        Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(1, 1, 3, 1);
        const int region_size = rng.uniform(2, 20), algorithm = i % 7 == 6 ? int(GWATERSHED) : GetParam();
        Ptr<SuperpixelGWatershed> both[2] = { reused, fresh };
        std::vector<Mat> answers[2];
        for (int k = 0; k < 2; k++)
        {
            both[k]->setAlgorithm(algorithm);
            both[k]->setRegionSize(region_size);
            both[k]->setMask(mask);
            both[k]->setMarkers(markers);
            both[k]->iterate(image, 1 + i % 3);
            answers[k] = askEverything(both[k], image);
        }
        for (size_t k = 0; k < answers[0].size(); k++)
            EXPECT_TRUE(answers[0][k].empty() ? answers[1][k].empty() : equalMats(answers[0][k], answers[1][k]))
                    << "image " << i << ", answer " << k;
    }
}

TEST_P(ximgproc_GWatershed_mask, keeps_a_copy_and_takes_umat_and_submatrices)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(90, 70), rng), mask = makeMask(DISCS, image.size(), rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMask(mask.clone());
    gws->iterate();
    const Mat expected = labelsOf(gws);

    Mat edited = mask.clone();
    gws->setMask(edited);
    edited.setTo(Scalar(0));
    gws->iterate();
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));

    Mat wide;
    cv::copyMakeBorder(mask, wide, 3, 4, 5, 6, BORDER_CONSTANT, Scalar(77));
    gws->setMask(wide(Rect(Point(5, 3), mask.size())));
    gws->iterate();
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
    gws->setMask(mask.getUMat(ACCESS_READ));
    gws->iterate();
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
    gws->clear();
    gws->iterate(image);
    EXPECT_EQ(0, countNonZero(labelsOf(gws) < 0));
}

TEST_P(ximgproc_GWatershed_mask, merges_small_superpixels_within_their_component)
{
    RNG& rng = theRNG();
    for (int i = 0; i < MASK_KINDS; i++)
    {
        const Size size(120, 90);
        const Mat mask = makeMask(MaskKind(i), size, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(makeImage(NOISE, size, 3, rng), GetParam(), 7);
        gws->setMask(mask);
        gws->iterate();
        if (gws->getNumberOfSuperpixels() == 0)
            continue;
        const double smallest = 0.6 * countNonZero(mask) / gws->getNumberOfSuperpixels();
        gws->enforceLabelConnectivity(60);
        const int n = gws->getNumberOfSuperpixels();
        ASSERT_NO_FATAL_FAILURE(expectMaskedPartition(labelsOf(gws), mask, n));
        Mat stats, centroids, pairs, lengths;
        gws->getStatistics(noArray(), noArray(), stats, centroids, noArray(), noArray());
        gws->getAdjacency(noArray(), noArray(), pairs, lengths, noArray());
        for (int k = 0; k < n; k++)
        {
            const bool alone = pairs.empty() || countNonZero(pairs == k) == 0;
            EXPECT_TRUE(alone || stats.at<int>(k, CC_STAT_AREA) >= smallest) << "kind " << i << ", label " << k;
        }
    }
}

//! What holes cut off, because no block of pixels is whole there, takes no superpixels from the rest.
TEST_P(ximgproc_GWatershed_mask, has_superpixels_of_usual_areas_with_holes_of_single_pixels)
{
    RNG& rng = theRNG();
    const Size size(320, 240);
    const int count = 100;
    for (const double& share : { 0.01, 0.02, 0.03, 0.05 })
    {
        Mat image(size, CV_8UC3), chance(size, CV_32FC1);
        rng.fill(image, RNG::UNIFORM, Scalar::all(100), Scalar::all(105)); // small superpixels have no other reason
        rng.fill(chance, RNG::UNIFORM, 0, 1);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
        gws->setDesiredSuperpixels(count);
        gws->setMask(Mat(chance > share));
        gws->iterate();
        Mat stats;
        gws->getStatistics(noArray(), noArray(), stats, noArray(), noArray(), noArray());
        const int small = countNonZero(stats.col(CC_STAT_AREA) < int(size.area()) / count / 8);
        EXPECT_LE(small, count / 10) << share;
    }
}

// Blocks reach to the edge of a mask and over its small holes. What is left out joins a superpixel that is beside it.
TEST(ximgproc_SuperpixelGWatershed, superpixels_of_a_ragged_mask_follow_the_image)
{
    RNG& rng = theRNG();
    const int num_cells = 120;
    const Size size(320, 240);
    int leaks = 0, inside = 0;
    for (int i = 0; i < 12; i++)
    {
        const Mat cells = makeCells(size, num_cells, rng), image = paintCells(cells, num_cells, rng);
        Mat waves(size, CV_32FC1), mask;
        rng.fill(waves, RNG::NORMAL, 0, 1);
        GaussianBlur(waves, waves, Size(), 6);
        mask = waves > 0;
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 16);
        gws->setMask(mask);
        gws->iterate(image);
        leaks += countLeaks(labelsOf(gws), gws->getNumberOfSuperpixels(), cells, num_cells);
        inside += countNonZero(mask);
    }
    EXPECT_LE(leaks, 0.042 * inside);
}

TEST_P(ximgproc_GWatershed_mask, is_the_same_for_any_number_of_threads)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(160, 120), rng), mask = makeMask(DISCS, image.size(), rng);
    Mat expected;
    for (int threads = 1; threads <= 8; threads *= 2)
    {
        ThreadsGuard guard(threads);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 8);
        gws->setMask(mask);
        gws->iterate(2);
        if (threads == 1)
            expected = labelsOf(gws);
        EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << threads << " threads";
    }
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_mask, testing::ValuesIn(ALGORITHMS));

}} // namespace
