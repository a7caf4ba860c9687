// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

// Scenes of planes, seen by a camera whose focal length is FOCAL, in one colour.

namespace opencv_test { namespace {

static const Size SIZE(320, 240);
static const float FOCAL = 262;

//! Depth of the plane z = distance + slope_x x + slope_y y, in millimetres.
static Mat makePlane(double distance, double slope_x, double slope_y)
{
    Mat depth(SIZE, CV_32FC1);
    for (int y = 0; y < SIZE.height; y++)
        for (int x = 0; x < SIZE.width; x++)
        {
            const double ray_x = (x - 0.5 * (SIZE.width - 1)) / FOCAL, ray_y = (y - 0.5 * (SIZE.height - 1)) / FOCAL;
            depth.at<float>(y, x) = float(distance / (1 - slope_x * ray_x - slope_y * ray_y));
        }
    return depth;
}

//! Noise of a Kinect: that of the inverse of depth is the same everywhere.
static Mat addNoise(const Mat& depth, double sigma)
{
    Mat inverse = 1 / depth, noise(depth.size(), CV_32FC1);
    theRNG().fill(noise, RNG::NORMAL, 0, sigma);
    return Mat(1 / (inverse + noise));
}

static Ptr<SuperpixelGWatershed> segment(const Mat& image, const Mat& depth, int number)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, image.channels(), number);
    gws->setFocalLength(FOCAL);
    gws->iterate(image, depth);
    EXPECT_EQ(number, gws->getNumberOfSuperpixels());
    return gws;
}

static Mat gray() { return Mat(SIZE, CV_8UC3, Scalar::all(120)); }

TEST(ximgproc_GWatershed_surfaces, planes_seen_at_an_angle_are_as_compact_as_frontal_ones)
{
    const double slopes[][2] = { { 0, 0.6 }, { 0.6, 0 }, { 0.4, 0.4 }, { 0, 1.2 }, { 1, 0 } };
    const double frontal = compactness(labelsOf(segment(gray(), makePlane(1500, 0, 0), 100)));
    for (const double(&slope)[2] : slopes)
    {
        const Mat labels = labelsOf(segment(gray(), makePlane(1500, slope[0], slope[1]), 100));
        EXPECT_GT(compactness(labels), frontal - 0.05) << slope[0] << " " << slope[1];
    }
}

TEST(ximgproc_GWatershed_surfaces, planes_that_meet_in_a_crease_are_cut_along_it)
{
    Mat depth = makePlane(1500, -0.5, 0), right = Mat::zeros(SIZE, CV_8UC1);
    const Rect half(SIZE.width / 2, 0, SIZE.width / 2, SIZE.height);
    makePlane(1500, 0.5, 0)(half).copyTo(depth(half));
    right(half).setTo(Scalar(255));
    EXPECT_GT(purity(labelsOf(segment(gray(), depth, 60)), 60, right), 0.995);
}

// As depth that is projected to an image of twice its size.
TEST(ximgproc_GWatershed_surfaces, lattice_of_depth_has_surfaces)
{
    const Rect half(SIZE.width / 2, 0, SIZE.width / 2, SIZE.height);
    Mat depth = makePlane(1500, -0.5, 0), lattice = Mat::zeros(SIZE, CV_32FC1), right = Mat::zeros(SIZE, CV_8UC1);
    makePlane(1500, 0.5, 0)(half).copyTo(depth(half));
    right(half).setTo(Scalar(255));
    for (int y = 0; y < SIZE.height; y += 2)
        for (int x = 0; x < SIZE.width; x += 2)
            lattice.at<float>(y, x) = depth.at<float>(y, x);
    const Mat labels = labelsOf(segment(gray(), lattice, 60));
    EXPECT_GT(purity(labels, 60, right), 0.99);
    EXPECT_GT(compactness(labels), compactness(labelsOf(segment(gray(), depth, 60))) - 0.1);
}

// With the number of depths of blocks, not of pixels, the centres of planes were at half of their places.
TEST(ximgproc_GWatershed_surfaces, gaps_of_depth_harm_no_plane_inside_of_a_mask)
{
    const Rect half(SIZE.width / 2, 0, SIZE.width / 2, SIZE.height);
    Mat depth = makePlane(1500, -0.5, 0), right = Mat::zeros(SIZE, CV_8UC1), gaps(SIZE, CV_8UC1);
    makePlane(1500, 0.5, 0)(half).copyTo(depth(half));
    right(half).setTo(Scalar(255));
    theRNG().fill(gaps, RNG::UNIFORM, 0, 2);
    depth.setTo(Scalar(0), gaps);
    Ptr<SuperpixelGWatershed> gws = segment(gray(), depth, 60);
    const double free = compactness(labelsOf(gws));
    Mat mask(SIZE, CV_8UC1, Scalar(255)), labels;
    mask.at<uchar>(0, 0) = 0;
    gws->setMask(mask);
    gws->iterate(gray(), depth);
    gws->getLabels(labels);
    labels.at<int>(0, 0) = labels.at<int>(0, 1);
    EXPECT_GT(purity(labels, 60, right), 0.99);
    EXPECT_GT(compactness(labels), free - 0.1);
}

TEST(ximgproc_GWatershed_surfaces, box_on_a_table_of_its_colour_is_cut_out)
{
    const Mat table = makePlane(900, 0, -1.2); // it comes nearer to the bottom of the image
    const Rect box(120, 70, 80, 90);
    Mat depth = table.clone(), inside = Mat::zeros(SIZE, CV_8UC1);
    depth(box).setTo(Scalar(table.at<float>(box.br().y - 1, box.x))); // it stands on the table, its front is upright
    inside(box).setTo(Scalar(255));
    EXPECT_GT(purity(labelsOf(segment(gray(), depth, 80)), 80, inside), 0.99);
}

// A region without depth is not the nearest one of all that are not quite planes.
TEST(ximgproc_GWatershed_surfaces, where_depth_ends_no_pixel_goes_over)
{
    double wrong = 0;
    RNG rng(11);
    for (int i = 0; i < 6; i++)
    {
        Mat depth(SIZE, CV_32FC1), known = Mat::zeros(SIZE, CV_8UC1);
        for (int y = 0; y < SIZE.height; y++)
            for (int x = 0; x < SIZE.width; x++)
                depth.at<float>(y, x) = float(1500 + 150 * std::sin(x * 0.07 + i) * std::sin(y * 0.06));
        for (int k = 0; k < 6; k++)
            circle(known, Point(rng.uniform(0, SIZE.width), rng.uniform(0, SIZE.height)), rng.uniform(20, 60),
                   Scalar(255), FILLED);
        depth.setTo(Scalar(0), known == 0);
        Mat image(SIZE, CV_8UC3, Scalar(120, 120, 120));
        image.setTo(Scalar(108, 132, 124), known);
        wrong += (1 - purity(labelsOf(segment(image, depth, 100)), 100, known)) / 6;
    }
    EXPECT_LT(wrong, 0.01);
}

//! Nearer than 99 of 100 pixels is only the small one.
TEST(ximgproc_GWatershed_surfaces, small_things_near_to_the_camera_are_cut_out)
{
    for (int side : { 12, 16, 20, 24 })
    {
        Mat depth(SIZE, CV_32FC1, Scalar(5000)), small = Mat::zeros(SIZE, CV_8UC1);
        depth(Rect(100, 80, 100, 60)).setTo(Scalar(3330)); // a large thing, and the small one on it
        const Rect place(140, 100, side, side);
        depth(place).setTo(Scalar(3245));
        small(place).setTo(Scalar(255));
        const double wrong = (1 - purity(labelsOf(segment(gray(), depth, 100)), 100, small)) * SIZE.area();
        EXPECT_LT(wrong, 0.1 * place.area()) << side;
    }
}

//! As the far plane of a renderer, or what it has beside that, over less and over more than half of the image: it takes
//! no level from others.
TEST(ximgproc_GWatershed_surfaces, a_background_takes_no_levels_from_others)
{
    Mat ball = Mat::zeros(SIZE, CV_8UC1);
    circle(ball, Point(160, 180), 40, Scalar(1), FILLED);
    const double infinity = std::numeric_limits<double>::infinity();
    for (const int& rows : { 1, 60, 130 })
        for (const double& background : { 1e-4, 20., 1e3, 65504., 1e10, infinity })
        {
            Mat depth(SIZE, CV_32FC1, Scalar(2.6));
            depth.rowRange(0, rows).setTo(Scalar(background));
            depth.setTo(Scalar(2), ball);
            EXPECT_GT(purity(labelsOf(segment(gray(), depth, 100)), 100, ball), 0.99) << background << ", " << rows;
            if (background < 3)
                continue;
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(SIZE.width, SIZE.height, 3, 100);
            gws->setDepthRange(0, background < infinity ? float(background) : 3.f);
            gws->iterate(gray(), depth);
            EXPECT_GT(purity(labelsOf(gws), 100, ball), 0.99) << background << ", " << rows;
        }
}

TEST(ximgproc_GWatershed_surfaces, few_wrong_depths_near_to_the_camera_take_no_levels_from_others)
{
    Mat depth(SIZE, CV_32FC1, Scalar(1500)), box = Mat::zeros(SIZE, CV_8UC1);
    const Rect place(120, 90, 60, 50);
    depth(place).setTo(Scalar(1470));
    box(place).setTo(Scalar(255));
    for (int i = 0; i < SIZE.area() / 200; i++)
        depth.at<float>(theRNG().uniform(0, SIZE.height), theRNG().uniform(0, SIZE.width)) = 300;
    const double wrong = (1 - purity(labelsOf(segment(gray(), depth, 100)), 100, box)) * SIZE.area();
    EXPECT_LT(wrong, 0.05 * place.area());
}

//! Compactness of what a patch of another colour, which appears in a video of a plane, is divided into.
static double compactnessOfNewPatch(double slope_x, double slope_y)
{
    const Rect patch(90, 60, 140, 120);
    const Mat plane = makePlane(900, slope_x, slope_y);
    Mat image = gray();
    image.rowRange(0, 30).setTo(Scalar(200, 160, 60)); // after an even frame all would start again
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(SIZE.width, SIZE.height, 3, 100);
    gws->setFocalLength(FOCAL);
    gws->setDepthRange(300, 9000);
    gws->setTemporal(true);
    gws->iterate(image, plane);
    image(patch).setTo(Scalar(40, 60, 200));
    gws->iterate(image, plane);
    Mat labels = labelsOf(gws)(patch).clone();
    std::map<int, int> numbers;
    for (int& label : Mat_<int>(labels))
        label = numbers.insert(std::make_pair(label, int(numbers.size()))).first->second;
    return compactness(labels);
}

TEST(ximgproc_GWatershed_surfaces, new_superpixels_of_a_video_are_as_compact_on_a_plane_at_an_angle)
{
    const double frontal = compactnessOfNewPatch(0, 0), slopes[] = { 0, 0.8, 1.2 };
    double mean = 0;
    for (double slope : slopes)
        mean += compactnessOfNewPatch(slope, -1.5) / 3;
    EXPECT_GT(mean, frontal - 0.05);
}

TEST(ximgproc_GWatershed_surfaces, noise_of_depth_does_not_cut_a_wall)
{
    const double colour_alone = compactness(labelsOf(segment(gray(), Mat(), 100)));
    const Mat noisy = addNoise(makePlane(1500, 0, 0), 3e-6); // 7 mm
    Ptr<SuperpixelGWatershed> gws = segment(gray(), noisy, 100);
    EXPECT_GT(compactness(labelsOf(gws)), 0.6 * colour_alone);
    gws->setNormalWeight(0); // depth as it is
    gws->iterate(gray(), noisy);
    EXPECT_LT(compactness(labelsOf(gws)), 0.55 * colour_alone);
}

//! Where depth is hardly wider than its noise, that had up to all levels: 0.05, and 0.12 where blocks average it.
TEST(ximgproc_GWatershed_surfaces, noise_alone_has_few_levels)
{
    const Mat noisy = addNoise(makePlane(1500, 0, 0), 2e-5); // 3 %
    Ptr<SuperpixelGWatershed> gws = segment(gray(), noisy, 100);
    EXPECT_GT(compactness(labelsOf(gws)), 0.16); // 0.78 without depth
    gws->setNormalWeight(0); // depth as it is: it was 0.06
    gws->iterate(gray(), noisy);
    EXPECT_GT(compactness(labelsOf(gws)), 0.28);
}

TEST(ximgproc_GWatershed_surfaces, depth_that_is_constant_or_missing_changes_nothing)
{
    const Mat image = makeScene(SIZE, theRNG());
    const Mat expected = labelsOf(segment(image, Mat(), 150));
    EXPECT_TRUE(equalMats(expected, labelsOf(segment(image, Mat(SIZE, CV_16UC1, Scalar(900)), 150))));
    EXPECT_TRUE(equalMats(expected, labelsOf(segment(image, Mat(SIZE, CV_32FC1, Scalar(0)), 150))));
}

TEST(ximgproc_GWatershed_surfaces, unit_of_depth_cancels_out)
{
    const Mat image = makeScene(SIZE, theRNG());
    Mat depth = makeDepth(SIZE, 0.2, theRNG()), floats;
    depth.convertTo(floats, CV_32FC1);
    const Mat expected = labelsOf(segment(image, depth, 150));
    EXPECT_TRUE(equalMats(expected, labelsOf(segment(image, floats, 150))));
    EXPECT_TRUE(equalMats(expected, labelsOf(segment(image, floats * 0.125f, 150))));
}

TEST(ximgproc_GWatershed_surfaces, labels_do_not_depend_on_threads)
{
    const Mat image = makeScene(Size(417, 333), theRNG()), depth = makeDepth(image.size(), 0.2, theRNG());
    Mat expected;
    for (const int threads : { 1, 2, 3, 8 })
    {
        const ThreadsGuard guard(threads);
        const Mat labels = labelsOf(segment(image, depth, 300));
        if (expected.empty())
            expected = labels;
        EXPECT_TRUE(equalMats(expected, labels)) << threads;
    }
}

TEST(ximgproc_GWatershed_surfaces, adaptive_superpixels_have_more_even_areas_on_the_surface)
{
    const Mat depth = makePlane(2000, 0, -1.5); // 1.2 to 6.4 m
    double deviation[2];
    for (int adaptive = 0; adaptive < 2; adaptive++)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(SIZE.width, SIZE.height, 3, 200);
        gws->setFocalLength(FOCAL);
        gws->setDepthAdaptive(adaptive != 0);
        gws->iterate(gray(), depth);
        ASSERT_EQ(200, gws->getNumberOfSuperpixels());
        Mat squares = depth.mul(depth), stats, centroids, means, spread, mean;
        gws->getStatistics(squares, noArray(), stats, centroids, means);
        Mat areas;
        stats.col(CC_STAT_AREA).convertTo(areas, CV_32F);
        meanStdDev(areas.mul(means), mean, spread);
        deviation[adaptive] = spread.at<double>(0) / mean.at<double>(0);
    }
    EXPECT_LT(deviation[1], 0.6 * deviation[0]);
}

//! Positions and normals of getStatistics().
struct Surfaces
{
    Surfaces(const Ptr<SuperpixelGWatershed>& gws, const Mat& depth)
    {
        gws->getStatistics(noArray(), depth, noArray(), noArray(), noArray(), noArray(), positions, normals);
    }

    Mat positions, normals;
};

static int countNumbers(const Mat& table) { return countNonZero(table == table); } // NaN differs from itself

TEST(ximgproc_GWatershed_surfaces, are_measured_on_a_plane)
{
    const Mat depth = makePlane(1500, 0.5, -0.25);
    const Surfaces surfaces(segment(gray(), depth, 50), depth);
    ASSERT_EQ(Size(3, 50), surfaces.positions.size());
    ASSERT_EQ(Size(3, 50), surfaces.normals.size());
    ASSERT_EQ(CV_32FC1, surfaces.positions.type());
    ASSERT_EQ(CV_32FC1, surfaces.normals.type());
    const Vec3f normal = normalize(Vec3f(0.5f, -0.25f, -1.f));
    for (int i = 0; i < 50; i++)
    {
        const Vec3f p = *surfaces.positions.ptr<Vec3f>(i);
        EXPECT_NEAR(1500 + 0.5 * p[0] - 0.25 * p[1], p[2], 1);
        EXPECT_LT(cv::norm(normal - *surfaces.normals.ptr<Vec3f>(i)), 1e-3);
    }
}

TEST(ximgproc_GWatershed_surfaces, positions_are_means_of_points)
{
    const Point2f focal(250, 310);
    const Mat depth = makeDepth(SIZE, 0.3, theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(SIZE.width, SIZE.height, 3, 300);
    gws->setFocalLength(focal.x, focal.y);
    gws->iterate(gray(), depth);
    gws->setFocalLength(1000); // for the next iterate() only
    Mat mean_depths, positions, normals;
    gws->getStatistics(noArray(), depth, noArray(), noArray(), noArray(), mean_depths, positions, normals);
    const Mat labels = labelsOf(gws);
    std::vector<Vec3d> sums(300);
    std::vector<int> counts(300, 0);
    for (int y = 0; y < SIZE.height; y++)
        for (int x = 0; x < SIZE.width; x++)
            if (const int z = depth.at<ushort>(y, x))
            {
                const Vec3d ray((x - 0.5 * (SIZE.width - 1)) / focal.x, (y - 0.5 * (SIZE.height - 1)) / focal.y, 1);
                sums[labels.at<int>(y, x)] += z * ray;
                counts[labels.at<int>(y, x)]++;
            }
    for (int i = 0; i < 300; i++)
    {
        const Vec3f position = *positions.ptr<Vec3f>(i), normal = *normals.ptr<Vec3f>(i);
        EXPECT_EQ(counts[i] == 0, cvIsNaN(position[0]) != 0);
        if (counts[i] == 0)
            continue;
        EXPECT_LT(cv::norm(Vec3d(position) - sums[i] / counts[i]), 1e-4 * position[2]);
        EXPECT_EQ(mean_depths.at<float>(i), position[2]);
        if (cvIsNaN(normal[0]))
            continue;
        EXPECT_NEAR(1, cv::norm(normal), 1e-5);
        EXPECT_LT(normal.dot(position), 0); // towards the camera
    }
}

TEST(ximgproc_GWatershed_surfaces, usual_focal_length_is_that_of_the_image_for_a_mask_too)
{
    const Mat depth(SIZE, CV_16UC1, Scalar(800));
    Mat mask = Mat::zeros(SIZE, CV_8UC1);
    mask(Rect(0, 0, 61, 41)).setTo(Scalar(255));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(SIZE.width, SIZE.height, 3, 1);
    gws->setMask(mask);
    gws->iterate(gray(), depth);
    const Vec3f position = *Surfaces(gws, depth).positions.ptr<Vec3f>();
    const double focal = 0.8 * SIZE.width;
    EXPECT_NEAR(800 * (30 - 0.5 * (SIZE.width - 1)) / focal, position[0], 1e-3);
    EXPECT_NEAR(800 * (20 - 0.5 * (SIZE.height - 1)) / focal, position[1], 1e-3);
    EXPECT_EQ(800, position[2]);
}

TEST(ximgproc_GWatershed_surfaces, have_no_normal_where_depth_is_on_one_line)
{
    const Mat plane = makePlane(1500, 0.5, -0.25);
    const Rect lines[] = { Rect(7, 0, 1, SIZE.height), Rect(0, 13, SIZE.width, 1) };
    for (int i = 0; i < 3; i++)
    {
        Mat depth = Mat::zeros(SIZE, CV_32FC1);
        if (i < 2)
            plane(lines[i]).copyTo(depth(lines[i]));
        else
            for (int y = 0; y < SIZE.height; y++)
                depth.at<float>(y, y + 3) = plane.at<float>(y, y + 3);
        const Surfaces surfaces(segment(gray(), depth, 1), depth);
        EXPECT_EQ(3, countNumbers(surfaces.positions)) << i;
        EXPECT_EQ(0, countNumbers(surfaces.normals)) << i;
    }
}

TEST(ximgproc_GWatershed_surfaces, are_not_a_number_where_depth_is_missing_and_none_without_depth)
{
    const Ptr<SuperpixelGWatershed> gws = segment(gray(), makePlane(1500, 0, 0), 50);
    const Surfaces missing(gws, Mat::zeros(SIZE, CV_16UC1)), none(gws, Mat());
    EXPECT_EQ(Size(3, 50), missing.positions.size());
    EXPECT_EQ(Size(3, 50), missing.normals.size());
    EXPECT_EQ(0, countNumbers(missing.positions) + countNumbers(missing.normals));
    EXPECT_EQ(Size(3, 0), none.positions.size());
    EXPECT_EQ(Size(3, 0), none.normals.size());
}

static bool equalBytes(const Mat& a, const Mat& b)
{
    return a.size() == b.size() && a.type() == b.type() && std::equal(a.datastart, a.dataend, b.datastart);
}

TEST(ximgproc_GWatershed_surfaces, each_table_is_the_same_alone)
{
    const Mat image = makeScene(SIZE, theRNG()), depth = makeDepth(SIZE, 0.3, theRNG());
    const Ptr<SuperpixelGWatershed> gws = segment(image, depth, 300);
    Mat together[6];
    gws->getStatistics(image, depth, together[0], together[1], together[2], together[3], together[4], together[5]);
    for (int i = 0; i < 6; i++)
    {
        Mat alone;
        std::vector<_OutputArray> outputs(6);
        outputs[i] = _OutputArray(alone);
        gws->getStatistics(image, depth, outputs[0], outputs[1], outputs[2], outputs[3], outputs[4], outputs[5]);
        EXPECT_TRUE(equalBytes(together[i], alone)) << i;
    }
}

TEST(ximgproc_GWatershed_surfaces, alpha_1_is_colour_alone)
{
    const Rect part(0, 0, 301, 221); // which blocks do not divide
    const Mat image = makeScene(SIZE, theRNG())(part), depth = makePlane(1500, 0.5, 0.2)(part);
    for (int effort = 0; effort <= 2; effort++)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, 200);
        gws->setEffort(effort);
        gws->iterate(image);
        const Mat expected = labelsOf(gws);
        gws->setAlpha(1);
        gws->iterate(image, depth);
        EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << effort;
    }
}

//! Disparities have no surfaces.
TEST(ximgproc_GWatershed_surfaces, alpha_1_is_colour_alone_where_superpixels_would_adapt)
{
    const Mat image = makeScene(Size(120, 90), theRNG());
    Mat depth;
    makePlane(1500, 0.5, 0.2)(Rect(0, 0, 120, 90)).convertTo(depth, CV_16S);
    for (int algorithm : ALGORITHMS)
    {
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, 300, algorithm);
        gws->iterate(image);
        gws->mergeSimilar(40);
        const Mat expected = labelsOf(gws);
        gws->setAlpha(1);
        gws->setDepthAdaptive(true);
        gws->iterate(image, depth);
        gws->mergeSimilar(40);
        EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << algorithm;
    }
}

TEST(ximgproc_GWatershed_surfaces, adaptive_areas_change_nothing_with_markers_of_the_user)
{
    const Mat image = makeScene(Size(120, 90), theRNG());
    Mat depth, markers(image.size(), CV_32SC1, Scalar(0)), labels[2];
    makePlane(1500, 0.5, 0.2)(Rect(0, 0, 120, 90)).convertTo(depth, CV_16U);
    for (int i = 0; i < 108; i++)
        markers.at<int>(i / 12 * 10 + 5, i % 12 * 10 + 5) = i + 1;
    for (float alpha : { 1.f, 0.5f })
    {
        for (int adaptive = 0; adaptive < 2; adaptive++)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 10);
            gws->setAlpha(alpha);
            gws->setMarkers(markers);
            gws->setDepthAdaptive(adaptive != 0);
            gws->iterate(image, depth);
            gws->mergeSimilar(30);
            labels[adaptive] = labelsOf(gws);
        }
        EXPECT_TRUE(equalMats(labels[0], labels[1])) << alpha;
    }
}

// What is 0 in 32 bits is no depth: its inverse would outweigh all others.
TEST(ximgproc_GWatershed_surfaces, doubles_are_measured_as_floats)
{
    Mat depth = makePlane(2, 0.2, 0.1)(Rect(0, 0, 40, 40)), depths[2], normals[2];
    for (int i = 0; i < 2; i++)
    {
        Mat measured, stats, centroids, colors, positions;
        depth.convertTo(measured, CV_64F);
        measured.at<double>(20, 20) = 1e-200;
        if (i == 1)
            measured.convertTo(measured, CV_32F);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(40, 40, 3, 1);
        gws->iterate(gray()(Rect(0, 0, 40, 40)), measured);
        gws->getStatistics(gray()(Rect(0, 0, 40, 40)), measured, stats, centroids, colors, depths[i], positions,
                           normals[i]);
    }
    EXPECT_TRUE(equalMats(normals[0], normals[1]));
    EXPECT_TRUE(equalMats(depths[0], depths[1]));
    EXPECT_NEAR(1, cv::norm(normals[0]), 1e-6);
}

}} // namespace
