// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

#include <thread>

namespace opencv_test { namespace {

// What holds for the labels of every algorithm: partition, number, sameness, symmetry.

typedef testing::TestWithParam<int> ximgproc_GWatershed_partition;

TEST_P(ximgproc_GWatershed_partition, labels_all_pixels_with_connected_superpixels)
{
    RNG& rng = theRNG();
    for (int kind = 0; kind < IMAGE_KINDS; kind++)
        for (int channels = 1; channels <= 3; channels += 2)
            for (int region_size = 3; region_size < 40; region_size += 9)
            {
                const Mat image = makeImage(ImageKind(kind), Size(131, 97), channels, rng);
                Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), region_size);
                gws->iterate(2);
                expectPartition(labelsOf(gws), image.size(), gws->getNumberOfSuperpixels());
            }
}

TEST_P(ximgproc_GWatershed_partition, labels_rgbd_and_bordered_images_with_connected_superpixels)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 12; i++)
    {
        const Mat image = makeScene(Size(140, 110), rng), depth = makeDepth(image.size(), 0.04 * i, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam(), 4 + i);
        gws->setBorderThreshold(i % 4 * 40.f);
        gws->iterate(1 + i % 3);
        expectPartition(labelsOf(gws), image.size(), gws->getNumberOfSuperpixels());
    }
}

TEST_P(ximgproc_GWatershed_partition, takes_any_small_size_with_any_region_size)
{
    RNG& rng = theRNG();
    for (int height = 1; height <= 16; height++)
        for (int width = 1; width <= 16; width++)
        {
            const Mat image = makeImage(ImageKind(rng.uniform(0, int(IMAGE_KINDS))), Size(width, height), 3, rng);
            for (int region_size = 1; region_size <= std::max(width, height) + 5; region_size++)
            {
                Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), region_size);
                gws->iterate(1 + region_size % 3);
                expectPartition(labelsOf(gws), image.size(), gws->getNumberOfSuperpixels());
            }
        }
}

TEST_P(ximgproc_GWatershed_partition, takes_long_strips)
{
    RNG& rng = theRNG();
    const Size sizes[] = { Size(70000, 1), Size(1, 70000), Size(70000, 2), Size(3, 40000), Size(300000, 1) };
    for (size_t i = 0; i < 5; i++)
    {
        const Mat strip = makeImage(NOISE, sizes[i], 3, rng);
        for (int region_size = 1; region_size <= 70000; region_size = region_size * 7 + 1)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(strip, GetParam(), region_size);
            gws->iterate();
            expectPartition(labelsOf(gws), strip.size(), gws->getNumberOfSuperpixels());
        }
    }
}

TEST_P(ximgproc_GWatershed_partition, gives_the_number_asked_for)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(160, 120), rng);
    for (int k = 1; k <= 2000; k += 1 + k / 3)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(160, 120, 3, k, GetParam());
        gws->iterate(image);
        EXPECT_EQ(k, gws->getNumberOfSuperpixels());
        expectPartition(labelsOf(gws), image.size(), k);
    }
}

// Asked for by their size, they are as many rows and columns as fit, as those of SuperpixelSLIC, if that is near.
TEST_P(ximgproc_GWatershed_partition, gives_full_rows_for_a_region_size)
{
    for (const Size& size : { Size(160, 120), Size(201, 97), Size(97, 201), Size(40, 3) })
    {
        const Mat image = makeScene(size, theRNG());
        for (int region_size = 1; region_size < 200; region_size = region_size * 5 / 4 + 1)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), region_size);
            gws->iterate();
            const int n = gws->getNumberOfSuperpixels();
            const double wanted = size.area() / double(region_size * region_size);
            const int up = region_size - 1;
            const Size most((size.width + up) / region_size, (size.height + up) / region_size);
            bool is_full = false;
            for (int rows = size.height / region_size; rows <= most.height; rows++)
                for (int columns = size.width / region_size; columns <= most.width; columns++)
                {
                    const double away = std::abs(rows * columns - wanted);
                    const double aspect = double(size.width) / columns * rows / size.height;
                    is_full |= n == rows * columns;
                    const bool is_near = away < 0.05 * wanted && std::max(aspect, 1 / aspect) < 1.08 * 1.08;
                    const double most_away = is_near ? away : std::max(1., wanted);
                    EXPECT_LE(std::abs(n - wanted), most_away) << size << ", " << region_size;
                }
            EXPECT_LE(std::abs(n - wanted), std::max(1., 0.05 * wanted)) << size << ", " << region_size;
            EXPECT_TRUE(is_full || n == std::max(1, cvRound(wanted))) << size << ", " << region_size;
            expectPartition(labelsOf(gws), size, n);
        }
    }
}

TEST_P(ximgproc_GWatershed_partition, gives_the_number_asked_for_in_a_row_and_in_a_column)
{
    for (int length : { 1, 2, 3, 9, 40, 244 })
        for (int effort = 0; effort <= 3; effort++)
            for (int number = 1; number <= length; number += 1 + length / 20)
            {
                Mat image(1, length, CV_8UC1);
                theRNG().fill(image, RNG::UNIFORM, 0, 256);
                Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(length, 1, 1, number, GetParam());
                gws->setEffort(effort);
                gws->iterate(image);
                EXPECT_EQ(number, gws->getNumberOfSuperpixels()) << length << ", " << effort;
                gws->iterate(image.t());
                EXPECT_EQ(number, gws->getNumberOfSuperpixels()) << length << ", " << effort;
            }
}

TEST_P(ximgproc_GWatershed_partition, gives_each_pixel_its_own_label_if_more_are_asked_for)
{
    const Mat image = makeScene(Size(23, 17), theRNG());
    const int asked[] = { 23 * 17, 23 * 17 + 1, INT_MAX };
    for (int i = 0; i < 3; i++)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(23, 17, 3, asked[i], GetParam());
        gws->iterate(image);
        EXPECT_EQ(23 * 17, gws->getNumberOfSuperpixels());
        expectPartition(labelsOf(gws), image.size(), 23 * 17);
    }
}

static std::vector<int> areasOf(const Mat& labels)
{
    std::vector<int> areas(numberOfLabels(labels), 0);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            areas[labels.at<int>(y, x)]++;
    return areas;
}

TEST(ximgproc_SuperpixelGWatershed, gives_the_grid_on_a_flat_image)
{
    const Size sizes[] = { Size(120, 120), Size(121, 87), Size(64, 200) };
    for (int i = 0; i < 3; i++)
    {
        const Mat image(sizes[i], CV_8UC3, Scalar(80, 90, 100));
        const Mat labels = segment(image, GWATERSHED, 12);
        const std::vector<int> areas = areasOf(labels);
        const int n = int(areas.size());
        // Within one row and one column, and what rows of unequal numbers of markers differ by.
        const double cell = double(image.total()) / n, side = std::sqrt(cell);
        const double slack = 2 * side + cell * cvRound(sizes[i].height / side) / n;
        EXPECT_GE(*std::min_element(areas.begin(), areas.end()), cell - slack);
        EXPECT_LE(*std::max_element(areas.begin(), areas.end()), cell + slack);
    }
}

// RGWATERSHED merges several cells of a finer grid to a superpixel, so it can be less regular.
TEST(ximgproc_SuperpixelGWatershed, region_guided_superpixels_of_a_flat_image_are_about_equal)
{
    const Size sizes[] = { Size(120, 120), Size(121, 87), Size(64, 200), Size(640, 480) };
    for (int i = 0; i < 4; i++)
    {
        const Mat image(sizes[i], CV_8UC3, Scalar(80, 90, 100));
        const std::vector<int> areas = areasOf(segment(image, RGWATERSHED, 12));
        const double cell = double(image.total()) / double(areas.size());
        EXPECT_GE(*std::min_element(areas.begin(), areas.end()), 0.4 * cell);
        EXPECT_LE(*std::max_element(areas.begin(), areas.end()), 2.0 * cell);
    }
}

static Mat thickContours(const Mat& labels)
{
    Mat contours = Mat::zeros(labels.size(), CV_8UC1);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            for (int k = 0; k < 2; k++)
            {
                const Point p(x, y), q = k ? Point(x + 1, y) : Point(x, y + 1);
                if (q.x < labels.cols && q.y < labels.rows && labels.at<int>(p) != labels.at<int>(q))
                    contours.at<uchar>(p) = contours.at<uchar>(q) = 255;
            }
    return contours;
}

//! Share of the contour pixels of a that b has within one pixel.
static double agreement(const Mat& a, const Mat& b)
{
    Mat wide;
    dilate(b, wide, Mat());
    return double(countNonZero(a & wide)) / countNonZero(a);
}

//! Segments a mirrored or a transposed image and turns the labels back.
static Mat segmentTurned(const Mat& image, bool mirrored, int algorithm)
{
    Mat turned, back;
    if (mirrored)
        flip(image, turned, 1);
    else
        cv::transpose(image, turned);
    const Mat labels = segment(turned, algorithm, 20);
    if (mirrored)
        flip(labels, back, 1);
    else
        cv::transpose(labels, back);
    return back;
}

//! Mean agreement with transposed and with mirrored images. Of few scenes it differs by 0.02.
static Vec2d meanAgreement(int algorithm, Size size)
{
    const int count = 18;
    Vec2d mean(0, 0);
    for (int i = 0; i < count; i++)
    {
        const Mat image = makeScene(size, theRNG()), contours = thickContours(segment(image, algorithm, 20));
        for (int mirrored = 0; mirrored < 2; mirrored++)
        {
            const Mat turned = segmentTurned(image, mirrored != 0, algorithm);
            mean[mirrored] += agreement(contours, thickContours(turned)) / count;
        }
    }
    return mean;
}

TEST(ximgproc_SuperpixelGWatershed, has_no_direction)
{
    const Size size(240, 240);
    const Vec2d plain = meanAgreement(GWATERSHED, size), guided = meanAgreement(RGWATERSHED, size);
    EXPECT_GE(plain[0], 0.95) << "transposed";
    EXPECT_GE(plain[1], 0.95) << "mirrored";
    EXPECT_GE(guided[0], 0.88) << "transposed"; // scenes have noise; on photographs it is 0.93
    EXPECT_GE(guided[1], 0.845) << "mirrored";  // and 0.91; of 300 scenes 0.854; strips along edges agreed more
}

// The markers of a superpixel lie side by side along the longer side of the image.
TEST(ximgproc_SuperpixelGWatershed, a_transposed_image_has_the_transposed_markers_at_any_effort)
{
    const int count = 12;
    const Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(1, 1, 3, 1);
    gws->setRegionSize(20);
    for (int effort = 0; effort <= 3; effort++)
    {
        gws->setEffort(effort);
        double mean = 0;
        for (int i = 0; i < count; i++)
        {
            const Mat image = makeScene(Size(300, 200), theRNG());
            gws->iterate(image);
            const Mat contours = thickContours(labelsOf(gws));
            gws->iterate(image.t());
            mean += agreement(contours, thickContours(labelsOf(gws).t())) / count;
        }
        EXPECT_GE(mean, 0.86) << "effort " << effort;
    }
}

// Where blocks do not divide the image, short ones lie in the middle.
TEST(ximgproc_SuperpixelGWatershed, has_no_direction_where_blocks_do_not_divide_the_image)
{
    for (int rest = 1; rest < 4; rest++)
    {
        const Vec2d agreement = meanAgreement(RGWATERSHED, Size(240 + rest, 160 + rest));
        EXPECT_GE(agreement[0], 0.865) << "transposed, " << rest;
        EXPECT_GE(agreement[1], 0.91) << "mirrored, " << rest;
    }
}

// RGWATERSHED floods blocks of pixels and merges what it found, so that a block more to one side
// leads to other superpixels; they must not be worse ones.
TEST(ximgproc_SuperpixelGWatershed, region_guided_superpixels_are_as_good_in_every_direction)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 6; i++)
    {
        const Mat image = makeScene(Size(240, 240), rng);
        const double variation = explainedVariation(segment(image, RGWATERSHED, 20), image);
        for (int mirrored = 0; mirrored < 2; mirrored++)
            EXPECT_NEAR(variation, explainedVariation(segmentTurned(image, mirrored != 0, RGWATERSHED), image), 0.01);
    }
}

TEST(ximgproc_SuperpixelGWatershed, parts_a_plateau_in_the_middle)
{
    // Two markers on a flat strip: the border lies half way between them.
    for (int width = 12; width < 60; width++)
    {
        const Mat strip(5, width, CV_8UC1, Scalar(7));
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(width, 5, 1, 2, GWATERSHED);
        gws->iterate(strip);
        Mat labels = labelsOf(gws);
        EXPECT_NEAR(width / 2., countNonZero(labels.row(2) == 0), 1.);
    }
}

TEST_P(ximgproc_GWatershed_partition, is_the_same_for_any_number_of_threads)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(517, 389), rng), depth = makeDepth(image.size(), 0.2, rng);
    Mat expected, expected_depth;
    {
        ThreadsGuard one(1);
        expected = segment(image, GetParam(), 15);
        expected_depth = segment(image, depth, GetParam(), 15);
    }
    const int numbers[] = { 1, 2, 3, 8 };
    for (int i = 0; i < 4; i++)
    {
        ThreadsGuard threads(numbers[i]);
        EXPECT_TRUE(equalMats(expected, segment(image, GetParam(), 15))) << numbers[i];
        EXPECT_TRUE(equalMats(expected_depth, segment(image, depth, GetParam(), 15))) << numbers[i];
    }
}

TEST_P(ximgproc_GWatershed_partition, is_the_same_inside_a_parallel_loop)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(200, 150), rng), depth = makeDepth(image.size(), 0.2, rng);
    const Mat expected = segment(image, depth, GetParam(), 10);
    Mat same(1, 8, CV_8UC1, Scalar(0));
    parallel_for_(Range(0, 8), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            same.at<uchar>(i) = equalMats(expected, segment(image, depth, GetParam(), 10));
    });
    EXPECT_EQ(8, countNonZero(same));
}

TEST_P(ximgproc_GWatershed_partition, is_the_same_for_two_objects_in_two_threads)
{
    RNG& rng = theRNG();
    const Mat images[2] = { makeScene(Size(300, 200), rng), makeScene(Size(211, 333), rng) };
    const Mat expected[2] = { segment(images[0], GetParam(), 12), segment(images[1], GetParam(), 12) };
    bool same[2] = { true, true };
    const int algorithm = GetParam();
    std::vector<std::thread> threads;
    for (int i = 0; i < 2; i++)
        threads.push_back(std::thread([&, i]()
        {
            for (int repeat = 0; repeat < 10; repeat++)
                same[i] = same[i] && equalMats(expected[i], segment(images[i], algorithm, 12));
        }));
    threads[0].join();
    threads[1].join();
    EXPECT_TRUE(same[0]);
    EXPECT_TRUE(same[1]);
}

TEST_P(ximgproc_GWatershed_partition, is_the_same_without_optimized_code)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(333, 222), rng), depth = makeDepth(image.size(), 0.1, rng);
    const Mat expected = segment(image, depth, GetParam(), 10);
    const UseOptimizedGuard off(false);
    EXPECT_TRUE(equalMats(expected, segment(image, depth, GetParam(), 10)));
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_partition, testing::ValuesIn(ALGORITHMS));

}} // namespace
