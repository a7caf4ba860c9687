// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

#include <cfenv>

namespace opencv_test { namespace {

// Blocks through which a step of depth goes have the depth of one side. That of both would be a third surface, whose
// superpixels end up as slivers that lie astride of the step: 4.8 wrong pixels in each image.
TEST(ximgproc_GWatershed_depth, few_pixels_are_on_the_wrong_side)
{
    RNG& rng = theRNG();
    const Size size(195, 140);
    const int images = 100;
    double wrong = 0; // pixels in superpixels of which more is on the other side
    for (int i = 0; i < images; i++)
    {
        const Rect box(rng.uniform(4, 100), rng.uniform(4, 70), rng.uniform(30, 90), rng.uniform(30, 66));
        Mat depth(size, CV_32FC1, Scalar(1600)), inside = Mat::zeros(size, CV_8UC1);
        depth.colRange(0, rng.uniform(50, 100)).setTo(Scalar(1500));
        depth(box).setTo(Scalar(i % 2 ? 5000 : 700));
        inside(box).setTo(Scalar(1));
        Ptr<SuperpixelGWatershed> gws =
                createSuperpixelGWatershed(Mat(size, CV_8UC3, Scalar(90, 120, 70)), depth, RGWATERSHED, 20);
        gws->iterate();
        wrong += (1 - purity(labelsOf(gws), gws->getNumberOfSuperpixels(), inside)) * size.area();
    }
    EXPECT_LT(wrong, images);
}

// What is farther than a range that was set is at its far end, and so is infinity; what is nearer is at its near end.
TEST(ximgproc_GWatershed_depth, what_lies_beyond_a_range_is_at_its_end)
{
    RNG& rng = theRNG();
    const Size size(160, 120);
    for (int i = 0; i < 60; i++)
    {
        const float near_depth = i % 3 ? 0.5f : 0, far_depth = 3;
        const Mat image = makeScene(size, rng);
        Mat depth(size, CV_32FC1);
        for (int y = 0; y < size.height; y++)
            for (int x = 0; x < size.width; x++)
                depth.at<float>(y, x) = float(1 + 0.004 * x + 0.002 * y);
        Mat beyond = depth.clone(), clipped;
        const Range columns(rng.uniform(40, 80), rng.uniform(100, 160)), rows(rng.uniform(0, 40), rng.uniform(60, 120));
        for (int y = rows.start; y < rows.end; y++) // two walls that meet
            for (int x = columns.start; x < columns.end; x++)
                beyond.at<float>(y, x) = i % 4 ? float(4 + 0.1 * std::abs(x - 90)) : INFINITE;
        beyond.colRange(0, 8).setTo(Scalar(0.2));
        cv::min(beyond, Scalar(far_depth), clipped);
        cv::max(clipped, Scalar(near_depth), clipped);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 12);
        gws->setDepthRange(near_depth, far_depth);
        gws->iterate(image, beyond);
        const Mat labels = labelsOf(gws);
        gws->iterate(image, clipped);
        EXPECT_TRUE(equalMats(labelsOf(gws), labels)) << i;
    }
}

// Depth that is the same along each row has normals without an x, whatever the focal length along x is.
TEST(ximgproc_GWatershed_depth, focal_lengths_count_along_their_axes)
{
    const Size size(320, 240);
    const float focal = 262;
    const Mat image = makeScene(size, theRNG()) / 8;
    Mat depth(size, CV_32FC1);
    for (int y = 0; y < size.height; y++)
        depth.row(y).setTo(Scalar(y < 130 ? 1500 + 2 * y : 2020 - 2 * y));
    Mat labels[3];
    const Point2f focals[3] = { Point2f(focal, focal), Point2f(900, focal), Point2f(focal, 900) };
    for (int i = 0; i < 3; i++)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 20);
        gws->setFocalLength(focals[i].x, focals[i].y);
        gws->iterate(image, depth);
        labels[i] = labelsOf(gws);
    }
    EXPECT_TRUE(equalMats(labels[0], labels[1]));
    EXPECT_FALSE(equalMats(labels[0], labels[2]));
}


// What is far has more markers by its area than it has pixels.
TEST(ximgproc_GWatershed_depth, adaptive_superpixels_are_as_many_as_asked_for)
{
    for (const Size& size : { Size(16, 16), Size(33, 18), Size(21, 60) })
        for (int sixths = 1; sixths <= 6; sixths++)
        {
            Mat depth(size, CV_32FC1);
            for (int y = 0; y < size.height; y++)
                for (int x = 0; x < size.width; x++)
                    depth.at<float>(y, x) = 1 + 0.01f * float(x) + (x < size.width / 2 ? 0.f : float(y + 1));
            const int number = size.area() * sixths / 6;
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 3, number);
            gws->setDepthAdaptive(true);
            gws->iterate(Mat(size, CV_8UC3, Scalar::all(120)), depth);
            EXPECT_EQ(number, gws->getNumberOfSuperpixels());
            expectPartition(labelsOf(gws), size, number);
        }
}

// As those of a robot's gripper, or wrong ones.
TEST(ximgproc_GWatershed_depth, a_few_near_depths_take_no_levels_from_others)
{
    const Size size(320, 240);
    Mat ball = Mat::zeros(size, CV_8UC1), noise(size, CV_8UC1);
    circle(ball, Point(200, 100), 40, Scalar(1), FILLED);
    theRNG().fill(noise, RNG::UNIFORM, 0, 100);
    for (const float& near_depth : { 0.03f, 0.06f, 0.12f })
        for (int scattered = 0; scattered < 2; scattered++)
        {
            Mat depth(size, CV_32FC1, Scalar(1.05));
            depth.setTo(Scalar(1), ball);
            if (scattered)
                depth.setTo(Scalar(near_depth), noise < 2);
            else
                depth(Rect(0, 140, 60, 100)).setTo(Scalar(near_depth));
            const Mat labels = segment(Mat(size, CV_8UC3, Scalar(90, 120, 70)), depth, RGWATERSHED, 20);
            EXPECT_GT(purity(labels, numberOfLabels(labels), ball), scattered ? 0.985 : 0.998) << near_depth;
        }
}

Mat makeDisc()
{
    Mat disc = Mat::zeros(240, 320, CV_8UC1);
    circle(disc, Point(160, 120), 70, Scalar(1), FILLED);
    return disc;
}

//! Purity of the superpixels of an even image whose depth shows two classes.
double purityInGray(const Mat& depth, const Mat& classes, int region_size)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(Mat(depth.size(), CV_8UC3, Scalar::all(120)), depth,
                                                               RGWATERSHED, region_size);
    gws->iterate();
    return purity(labelsOf(gws), gws->getNumberOfSuperpixels(), classes);
}

//! One pixel without an end is no reason to keep levels for what lies between.
TEST(ximgproc_GWatershed_depth, an_infinite_pixel_takes_no_levels_from_others)
{
    const Mat disc = makeDisc();
    for (const double& step : { 0.005, 0.01, 0.02 })
        for (const int& side : { 10, 20 })
        {
            Mat depth(disc.size(), CV_32FC1, Scalar(2));
            depth.setTo(Scalar(2 * (1 + step)), disc);
            depth.at<float>(0, 0) = std::numeric_limits<float>::infinity();
            EXPECT_GT(purityInGray(depth, disc, side), 0.998) << step << " " << side;
        }
}

//! A block of noise has no sides. As long as it took the depth of one, whatever pixels were nearest to each other, the
//! noise went on to all levels, and superpixels were ragged: 0.25 and 0.11.
TEST(ximgproc_GWatershed_depth, noise_is_averaged_in_blocks)
{
    const Mat disc = makeDisc();
    for (const Vec2d& step_and_least : { Vec2d(0.1, 0.33), Vec2d(0.05, 0.18) })
    {
        Mat depth(disc.size(), CV_32FC1, Scalar(1500)), noise(disc.size(), CV_32FC1);
        depth.setTo(Scalar(1500 * (1 - step_and_least[0])), disc);
        theRNG().fill(noise, RNG::NORMAL, 1, 0.01);
        depth = depth.mul(noise);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(disc.cols, disc.rows, 3, 200);
        gws->iterate(Mat(disc.size(), CV_8UC3, Scalar::all(120)), depth);
        const Mat labels = labelsOf(gws);
        EXPECT_GT(compactness(labels), step_and_least[1]) << step_and_least[0];
        EXPECT_GT(purity(labels, 200, disc), 0.998) << step_and_least[0];
    }
}

//! As the tutorial says.
TEST(ximgproc_GWatershed_depth, steps_of_2_percent_become_boundaries)
{
    const Mat disc = makeDisc();
    for (const double& step : { 0.02, 0.05, 0.5 })
        for (const int& side : { 10, 20, 30 })
        {
            Mat depth(disc.size(), CV_16UC1, Scalar(1500));
            depth.setTo(Scalar(1500 * (1 + step)), disc);
            EXPECT_GT(purityInGray(depth, disc, side), 0.998) << step << " " << side;
        }
}

// Levels are those of inverse depth, of which a near end of 0 would take all.
TEST(ximgproc_GWatershed_depth, a_range_that_begins_at_the_camera_leaves_levels_for_the_rest)
{
    const Size size(320, 240);
    const Mat image(size, CV_8UC3, Scalar::all(120));
    const Vec2f ranges[] = { Vec2f(0, 4000), Vec2f(0, 8000), Vec2f(1, 4000), Vec2f(100, 4000), Vec2f(500, 4000) };
    const Vec2f sides[] = { Vec2f(1500, 2500), Vec2f(800, 900), Vec2f(3000, 3300) };
    Mat left(size, CV_8UC1, Scalar(0));
    for (int y = 0; y < size.height; y++)
        left.row(y).colRange(0, size.width / 2 + (y / 2) % 17).setTo(Scalar(255));
    for (const Vec2f& range : ranges)
        for (const Vec2f& side : sides)
            for (double unit : { 1., 0.001 })
            {
                Mat depth(size, CV_32FC1, Scalar(side[1] * unit));
                depth.setTo(Scalar(side[0] * unit), left);
                Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 3, 200);
                gws->setDepthRange(float(range[0] * unit), float(range[1] * unit));
                gws->iterate(image, depth);
                EXPECT_GT(purity(labelsOf(gws), 200, left), 0.995) << range << side << unit;
            }
}

// Clang divides two numbers as a vector of four, 0 / 0 in the others, which is such an error, too.
#if defined FE_DIVBYZERO && !defined __clang__
// Programs that trap floating-point errors would end where depth is missing.
TEST(ximgproc_GWatershed_depth, holes_are_no_floating_point_error)
{
    RNG& rng = theRNG();
    const ThreadsGuard threads(1); // each thread has flags of its own
    const Mat image = makeScene(Size(160, 120), rng), depth = makeDepth(image.size(), 0.2, rng);
    Mat stats, centroids, colors, depths, positions, normals;
    depth(Rect(20, 20, 60, 60)).setTo(Scalar(0));
    for (int algorithm : { int(GWATERSHED), int(RGWATERSHED) })
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, algorithm, 12);
        std::feclearexcept(FE_ALL_EXCEPT);
        gws->iterate(image, depth);
        gws->getStatistics(image, depth, stats, centroids, colors, depths, positions, normals);
        EXPECT_EQ(0, std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)) << algorithm;
    }
    EXPECT_FALSE(cv::checkRange(normals)) << "a superpixel lies in the hole, and has none";
}
#endif

}} // namespace
