// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// setEffort(): how much time is taken for better superpixels.

const int EFFORTS[] = { 0, 1, 2, 3 };

typedef testing::TestWithParam<int> ximgproc_GWatershed_effort;

Ptr<SuperpixelGWatershed> createWithEffort(Size size, int num_superpixels, int effort)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 3, num_superpixels);
    gws->setEffort(effort);
    return gws;
}

Mat segmentWithEffort(const Mat& image, int num_superpixels, int effort)
{
    Ptr<SuperpixelGWatershed> gws = createWithEffort(image.size(), num_superpixels, effort);
    gws->iterate(image);
    return labelsOf(gws);
}

TEST_P(ximgproc_GWatershed_effort, gives_the_number_of_connected_superpixels)
{
    RNG& rng = theRNG();
    const float rulers[] = { 0, 1, 10, 40 };
    for (int i = 0; i < 40; i++)
    {
        const Size size(rng.uniform(1, 160), rng.uniform(1, 120));
        const Mat image = makeImage(ImageKind(i % IMAGE_KINDS), size, i % 2 ? 1 : 3, rng);
        const int wanted = rng.uniform(1, 2 + size.area() / rng.uniform(1, 500));
        Ptr<SuperpixelGWatershed> gws = createWithEffort(size, wanted, GetParam());
        gws->setRuler(rulers[rng.uniform(0, 4)]);
        if (i % 3)
            gws->iterate(image, 1 + i % 4);
        else
            gws->iterate(image, makeDepth(size, 0.2, rng), 1 + i % 4);
        const int expected = std::min(wanted, size.area());
        EXPECT_EQ(expected, gws->getNumberOfSuperpixels()) << size << ", " << i;
        expectPartition(labelsOf(gws), size, gws->getNumberOfSuperpixels());
    }
}

TEST_P(ximgproc_GWatershed_effort, stays_inside_of_a_mask)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 3 * MASK_KINDS; i++)
    {
        const Size size(rng.uniform(30, 200), rng.uniform(30, 150));
        const Mat image = makeScene(size, rng), mask = makeMask(MaskKind(i % MASK_KINDS), size, rng);
        const int wanted = rng.uniform(1, 200);
        Ptr<SuperpixelGWatershed> gws = createWithEffort(size, wanted, GetParam());
        gws->setMask(mask);
        gws->iterate(image);
        expectMaskedPartition(labelsOf(gws), mask, gws->getNumberOfSuperpixels());
        const int pixels = countNonZero(mask);
        EXPECT_EQ(std::min(std::max(wanted, countMaskPieces(mask)), pixels), gws->getNumberOfSuperpixels());
    }
}

TEST_P(ximgproc_GWatershed_effort, labels_do_not_depend_on_threads)
{
    const Mat image = makeScene(Size(500, 380), theRNG());
    for (int num_superpixels = 100; num_superpixels <= 6400; num_superpixels *= 8)
    {
        Mat expected;
        for (int threads = 1; threads <= 8; threads *= 2)
        {
            const ThreadsGuard guard(threads);
            const Mat labels = segmentWithEffort(image, num_superpixels, GetParam());
            if (threads == 1)
                expected = labels;
            EXPECT_TRUE(equalMats(expected, labels)) << threads << " threads";
        }
    }
}

TEST_P(ximgproc_GWatershed_effort, larger_rulers_give_more_compact_superpixels)
{
    const Mat image = makeScene(Size(320, 240), theRNG());
    double before = 0;
    for (const float ruler : { 0.f, 1.f, 5.f, 10.f, 40.f })
    {
        Ptr<SuperpixelGWatershed> gws = createWithEffort(image.size(), 200, GetParam());
        gws->setRuler(ruler);
        gws->iterate(image);
        const double now = compactness(labelsOf(gws));
        EXPECT_GT(now, before) << "ruler " << ruler;
        before = now;
    }
}

TEST_P(ximgproc_GWatershed_effort, changes_nothing_with_markers_or_for_the_algorithm_of_the_paper)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(120, 90), rng);
    Ptr<SuperpixelGWatershed> with = createWithEffort(image.size(), 40, GetParam());
    Ptr<SuperpixelGWatershed> without = createSuperpixelGWatershed(120, 90, 3, 40);
    for (int i = 0; i < 4; i++)
    {
        const Mat markers = i == 3 ? Mat() : makeMarkers(image.size(), 30, rng);
        for (const Ptr<SuperpixelGWatershed>& gws : { with, without })
        {
            gws->setAlgorithm(i == 3 ? GWATERSHED : RGWATERSHED);
            gws->setMarkers(markers);
            gws->iterate(image, 1 + i);
        }
        EXPECT_TRUE(equalMats(labelsOf(without), labelsOf(with)));
    }
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_effort, testing::ValuesIn(EFFORTS));

TEST(ximgproc_SuperpixelGWatershed, effort_is_1_unless_set)
{
    const Mat image = makeScene(Size(200, 150), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(200, 150, 3, 75);
    EXPECT_EQ(1, gws->getEffort());
    gws->iterate(image);
    EXPECT_TRUE(equalMats(segmentWithEffort(image, 75, 1), labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, more_effort_than_usual_leaks_less)
{
    RNG& rng = theRNG();
    const int num_images = 12, num_cells = 90, num_superpixels = 190;
    double leaks[4] = {};
    for (int i = 0; i < num_images; i++)
    {
        const Mat cells = makeCells(Size(320, 240), num_cells, rng), image = paintCells(cells, num_cells, rng);
        for (const int effort : EFFORTS)
            leaks[effort] += countLeaks(segmentWithEffort(image, num_superpixels, effort), num_superpixels, cells,
                                        num_cells);
    }
    EXPECT_LT(leaks[2], 0.95 * leaks[1]);
    EXPECT_LT(leaks[3], 0.97 * leaks[2]);
    EXPECT_LT(leaks[3], 0.95 * leaks[0]);
}

Mat segmentRegions(const Mat& image, int effort, int region_size)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, region_size);
    gws->setEffort(effort);
    gws->iterate(image);
    return labelsOf(gws);
}

// The last regions of a cell are united with each other, not with those beside it.
TEST(ximgproc_SuperpixelGWatershed, areas_of_an_even_image_are_alike_with_more_effort)
{
    for (const int effort : { 2, 3 })
        for (const Size& size : { Size(640, 480), Size(481, 321), Size(333, 249) })
            for (const int region_size : { 10, 13, 14, 17, 20, 21, 30 })
            {
                const Mat labels = segmentRegions(Mat(size, CV_8UC3, Scalar(90, 120, 60)), effort, region_size);
                const Vec2d areas = extremeAreas(labels);
                EXPECT_GE(areas[0], 0.6) << effort << ", " << size << ", " << region_size;
                EXPECT_LE(areas[1], 1.7) << effort << ", " << size << ", " << region_size;
                EXPECT_GE(compactness(labels), 0.6) << effort << ", " << size << ", " << region_size;
            }
}

// Means of 2x2 pixels have more noise than those of larger blocks.
TEST(ximgproc_SuperpixelGWatershed, no_strips_on_a_ramp_with_noise_with_more_effort)
{
    RNG& rng = theRNG();
    for (const int effort : { 2, 3 })
        for (const Size& size : { Size(320, 240), Size(400, 300) })
            for (const int region_size : { 13, 14, 17, 20, 21, 30 })
            {
                Mat image(size, CV_8UC3);
                for (int y = 0; y < size.height; y++)
                    for (int x = 0; x < size.width * 3; x++)
                        image.ptr(y)[x] = saturate_cast<uchar>(cvRound(255. * y / (size.height - 1)) +
                                                               cvRound(rng.gaussian(1)));
                EXPECT_LE(medianAspect(segmentRegions(image, effort, region_size)), 1.6)
                        << effort << ", " << size << ", " << region_size;
            }
}

TEST(ximgproc_SuperpixelGWatershed, no_superpixel_runs_away_with_a_board_with_the_most_effort)
{
    for (const int side : { 3, 5, 9, 14, 20 })
        for (const int region_size : { 13, 17, 21 })
            for (int offset = 0; offset < side; offset += 3)
            {
                Mat image(321, 481, CV_8UC3);
                for (int y = 0; y < image.rows; y++)
                    for (int x = 0; x < image.cols; x++)
                        image.at<Vec3b>(y, x) = ((x + offset) / side + (y + 2 * offset) / side) % 2
                                ? Vec3b(127, 27, 251) : Vec3b(153, 136, 99);
                EXPECT_LE(extremeAreas(segmentRegions(image, 3, region_size))[1], 4)
                        << side << ", " << region_size << ", " << offset;
            }
}

// No difference of textures or directions outweighs the limit of areas.
TEST(ximgproc_SuperpixelGWatershed, no_superpixel_runs_away_with_a_fine_board_with_the_most_effort)
{
    Mat image(481, 321, CV_8UC3);
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols; x++)
            image.at<Vec3b>(y, x) = ((x + 2) / 2 + y / 2) % 2 ? Vec3b(40, 60, 190) : Vec3b(170, 200, 60);
    EXPECT_LE(extremeAreas(segmentRegions(image, 3, 17))[1], 4);
}

Ptr<SuperpixelGWatershed> createTemporalWithEffort(Size size, int effort)
{
    Ptr<SuperpixelGWatershed> gws = createWithEffort(size, 75, effort);
    gws->setTemporal(true);
    return gws;
}

TEST(ximgproc_SuperpixelGWatershed, effort_3_of_a_video_is_effort_2)
{
    const Mat scene = makeScene(Size(220, 160), theRNG());
    Ptr<SuperpixelGWatershed> two = createTemporalWithEffort(Size(200, 150), 2);
    Ptr<SuperpixelGWatershed> three = createTemporalWithEffort(Size(200, 150), 3);
    for (int i = 0; i < 4; i++)
    {
        const Mat frame = scene(Rect(2 * i, i, 200, 150));
        two->iterate(frame);
        three->iterate(frame);
        EXPECT_TRUE(equalMats(labelsOf(two), labelsOf(three))) << i;
    }
}

// Things of faint colours on a table that is seen at an angle.
TEST(ximgproc_SuperpixelGWatershed, most_effort_counts_where_there_are_surfaces)
{
    const Size size(320, 240);
    double purities[2] = { 0, 0 };
    Mat labels[2];
    RNG rng(23);
    for (int i = 0; i < 8; i++)
    {
        Mat things = Mat::zeros(size, CV_8UC1), depth(size, CV_32FC1), noise(size, CV_32FC1);
        Mat image(size, CV_8UC3, Scalar::all(120)), grain(size, CV_16SC3);
        for (int k = 1; k < 12; k++)
            ellipse(things, Point(rng.uniform(0, size.width), rng.uniform(0, size.height)),
                    Size(rng.uniform(10, 50), rng.uniform(10, 40)), rng.uniform(0, 180), 0, 360, Scalar(k), FILLED);
        for (int k = 1; k < 12; k++)
            image.setTo(Scalar(rng.uniform(90, 150), rng.uniform(90, 150), rng.uniform(90, 150)), things == k);
        rng.fill(grain, RNG::NORMAL, Scalar::all(0), Scalar::all(4));
        cv::add(image, grain, image, noArray(), CV_8U);
        for (int y = 0; y < size.height; y++)
            for (int x = 0; x < size.width; x++)
            {
                const int thing = things.at<uchar>(y, x);
                const double along = thing % 2 ? x : y;
                depth.at<float>(y, x) = float(1e-3 + (thing % 3) * 3e-5 + (thing == 0 ? y : along) * 5e-7);
            }
        rng.fill(noise, RNG::NORMAL, 0, 3e-6);
        depth = 1 / (depth + noise);
        for (int k = 0; k < 2; k++)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 3, 60);
            gws->setFocalLength(300);
            gws->setEffort(2 + k);
            gws->iterate(image, depth);
            labels[k] = labelsOf(gws);
            purities[k] += purity(labels[k], gws->getNumberOfSuperpixels(), things) / 8;
        }
        EXPECT_FALSE(equalMats(labels[0], labels[1])) << i;
    }
    EXPECT_GT(purities[1], purities[0] - 2e-4);
}

TEST(ximgproc_SuperpixelGWatershed, frames_start_anew_where_the_effort_changes_the_blocks)
{
    const Mat image = makeScene(Size(200, 150), theRNG());
    Ptr<SuperpixelGWatershed> gws = createTemporalWithEffort(image.size(), 1), fresh;
    gws->iterate(image);
    for (const int effort : { 2, 0, 2, 1 })
    {
        gws->setEffort(effort);
        gws->iterate(image);
        fresh = createTemporalWithEffort(image.size(), effort);
        fresh->iterate(image);
        EXPECT_TRUE(equalMats(labelsOf(fresh), labelsOf(gws))) << "effort " << effort;
    }
}

}} // namespace
