// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// What holds for RGWATERSHED alone: iterations, ruler, colour space, weights of depth.

Mat segmentGuided(const Mat& image, int num_superpixels, float ruler, int iterations)
{
    Ptr<SuperpixelGWatershed> gws =
            createSuperpixelGWatershed(image.cols, image.rows, image.channels(), num_superpixels, RGWATERSHED, ruler);
    gws->iterate(image, iterations);
    return labelsOf(gws);
}

TEST(ximgproc_SuperpixelGWatershed, region_guided_is_the_default)
{
    const Mat image = makeScene(Size(60, 40), theRNG()), depth(image.size(), CV_16UC1, Scalar(1));
    EXPECT_EQ(RGWATERSHED, createSuperpixelGWatershed(60, 40, 3, 10)->getAlgorithm());
    EXPECT_EQ(RGWATERSHED, createSuperpixelGWatershed(image)->getAlgorithm());
    EXPECT_EQ(RGWATERSHED, createSuperpixelGWatershed(image, depth)->getAlgorithm());
}

TEST(ximgproc_SuperpixelGWatershed, more_iterations_never_explain_less)
{
    RNG& rng = theRNG();
    const float rulers[] = { 0, 1, 10, 40 };
    for (int i = 0; i < 24; i++)
    {
        const Size size(rng.uniform(40, 220), rng.uniform(40, 180));
        const Mat image = makeImage(i % 6 == 5 ? NOISE : SCENE, size, 3, rng);
        const int num_superpixels = rng.uniform(2, 400);
        double before = 0;
        for (int iterations = 1; iterations <= 6; iterations++)
        {
            const Mat labels = segmentGuided(image, num_superpixels, rulers[i % 4], iterations);
            expectPartition(labels, image.size(), num_superpixels);
            const double variation = explainedVariation(labels, image);
            EXPECT_GE(variation, before - 1e-12) << i << ", iteration " << iterations;
            before = variation;
        }
    }
}

//! A pixel with depth is at no distance from a region without any, which has depth when it has come: so it leaves.
TEST(ximgproc_SuperpixelGWatershed, iterations_come_to_an_end)
{
    uchar depth[6 * 14] = {};
    const Vec2i valid[] = { Vec2i(4, 159), Vec2i(14, 213), Vec2i(18, 205), Vec2i(32, 105), Vec2i(50, 120),
                            Vec2i(53, 125), Vec2i(54, 39), Vec2i(57, 156), Vec2i(65, 176), Vec2i(76, 54) };
    for (int i = 0; i < 10; i++)
        depth[valid[i][0]] = uchar(valid[i][1]);
    const Mat image(6, 14, CV_8UC1, Scalar(100));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(14, 6, 1, 16, RGWATERSHED, 12.1840906f);
    gws->setAlpha(0.645217299f);
    gws->iterate(image, Mat(6, 14, CV_8UC1, depth), 1000);
    const Mat labels = labelsOf(gws);
    gws->iterate(image, Mat(6, 14, CV_8UC1, depth), 1001);
    EXPECT_TRUE(equalMats(labels, labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, iterations_improve_scenes)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 5; i++)
    {
        const Mat image = makeScene(Size(240, 180), rng);
        EXPECT_GT(explainedVariation(segmentGuided(image, 108, 10, 4), image),
                  explainedVariation(segmentGuided(image, 108, 10, 1), image));
    }
}

TEST(ximgproc_SuperpixelGWatershed, explains_more_than_algorithm_1)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 5; i++)
    {
        const Mat image = makeScene(Size(240, 180), rng);
        EXPECT_GT(explainedVariation(segment(image, RGWATERSHED, 20), image),
                  explainedVariation(segment(image, GWATERSHED, 20), image));
    }
}

//! Waves of lightness in both directions, over a slow one of colour.
Mat makeShading(double wavelength, double amplitude, RNG& rng)
{
    const double turn = 2 * CV_PI / wavelength;
    Mat image(240, 320, CV_8UC3);
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols; x++)
        {
            const double shade = 128 + amplitude * std::sin(turn * x) * std::sin(turn * y);
            const double colors[] = { shade + 40 * std::sin(turn * (x + 2 * y) / 3), shade, shade };
            for (int k = 0; k < 3; k++)
                image.at<Vec3b>(y, x)[k] = saturate_cast<uchar>(colors[k] + rng.gaussian(3));
        }
    return image;
}

//! Within large things, shading should not decide what is united; superpixels of few blocks are as small as it.
TEST(ximgproc_SuperpixelGWatershed, small_superpixels_follow_shading)
{
    RNG& rng = theRNG();
    const double wavelengths[] = { 20, 30, 40, 60 }, amplitudes[] = { 20, 60 };
    double variation = 0;
    for (double wavelength : wavelengths)
        for (double amplitude : amplitudes)
        {
            const Mat image = makeShading(wavelength, amplitude, rng);
            variation += explainedVariation(segment(image, RGWATERSHED, 10), image) / 8;
        }
    EXPECT_GT(variation, 0.8635); // 0.861 if lightness counts as it does in large ones, else 0.866
}

TEST(ximgproc_SuperpixelGWatershed, larger_ruler_is_more_compact)
{
    RNG& rng = theRNG();
    const float rulers[] = { 0, 2, 5, 10, 20, 40, 80 };
    double before = 0;
    std::vector<Mat> images;
    for (int i = 0; i < 5; i++)
        images.push_back(makeScene(Size(320, 240), rng));
    for (int i = 0; i < 7; i++)
    {
        double mean = 0;
        for (size_t j = 0; j < images.size(); j++)
            mean += compactness(segmentGuided(images[j], 192, rulers[i], 1)) / double(images.size());
        EXPECT_GE(mean, before) << "ruler " << rulers[i];
        before = mean;
    }
}

TEST(ximgproc_SuperpixelGWatershed, takes_any_ruler)
{
    const Mat image = makeScene(Size(90, 70), theRNG());
    const float rulers[] = { 0, FLT_MIN, 1e10f, FLT_MAX };
    for (int i = 0; i < 4; i++)
        for (int num_superpixels = 1; num_superpixels <= 6300; num_superpixels *= 7)
            expectPartition(segmentGuided(image, num_superpixels, rulers[i], 2), image.size(), num_superpixels);
}

TEST(ximgproc_SuperpixelGWatershed, cuts_along_edges_of_colour)
{
    // No superpixel has pixels on both sides of an edge, wherever the edge lies in the blocks of the flood.
    for (int line = 30; line < 46; line++)
    {
        Mat image(80, 96, CV_8UC3, Scalar(90, 120, 70));
        image.colRange(line, image.cols).setTo(Scalar(120, 90, 100));
        const Mat labels = segment(image, RGWATERSHED, 16);
        std::set<int> left, right, both;
        for (int y = 0; y < labels.rows; y++)
            for (int x = 0; x < labels.cols; x++)
                (x < line ? left : right).insert(labels.at<int>(y, x));
        std::set_intersection(left.begin(), left.end(), right.begin(), right.end(), std::inserter(both, both.end()));
        EXPECT_TRUE(both.empty()) << "edge at " << line << ", superpixels across " << both.size();
    }
}

TEST(ximgproc_SuperpixelGWatershed, takes_lab_input_as_it_is)
{
    const int SCENES = 10;
    Mat lab;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(120, 90, 3, 42, RGWATERSHED);
    double ev_as_bgr = 0, ev_as_lab = 0;
    EXPECT_FALSE(gws->getLabInput());
    for (int i = 0; i < SCENES; i++)
    {
        const Mat image = makeScene(Size(120, 90), theRNG());
        cvtColor(image, lab, COLOR_BGR2Lab);
        gws->setLabInput(false);
        gws->iterate(lab);
        const Mat as_bgr = labelsOf(gws);
        gws->setLabInput(true);
        EXPECT_TRUE(gws->getLabInput());
        gws->iterate(lab);
        EXPECT_FALSE(equalMats(as_bgr, labelsOf(gws)));
        ev_as_bgr += explainedVariation(as_bgr, image);
        ev_as_lab += explainedVariation(labelsOf(gws), image);
    }
    EXPECT_GT(ev_as_lab, ev_as_bgr);
    gws->setAlgorithm(GWATERSHED); // never converts
    gws->setRegionSize(10);
    gws->iterate(lab);
    EXPECT_TRUE(equalMats(segment(lab, GWATERSHED, 10), labelsOf(gws)));
}

//! What moves from region to region must leave the sums of depth right: without a depth, colour would count.
TEST(ximgproc_SuperpixelGWatershed, depth_alone_is_depth_alone_at_any_size)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 30; i++)
    {
        const Mat image = makeScene(Size(120, 90), rng), other = makeScene(image.size(), rng);
        const Mat depth = makeDepth(image.size(), 0, rng);
        const int region_sizes[] = { 10, 12, 14, 16, 20 };
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, region_sizes[i % 5]);
        gws->setAlpha(0);
        gws->setEffort(i % 2);
        gws->iterate(image, depth);
        const Mat labels = labelsOf(gws);
        gws->iterate(other, depth);
        EXPECT_TRUE(equalMats(labels, labelsOf(gws))) << region_sizes[i % 5] << ", " << i % 2;
    }
}

TEST(ximgproc_SuperpixelGWatershed, alpha_weighs_colour_against_depth)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(120, 90), rng), other = makeScene(image.size(), rng);
    const Mat depth = makeDepth(image.size(), 0, rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 10);
    gws->setAlpha(0); // depth alone
    for (float normal_weight : { 0.f, 0.2f })
        for (int effort = 0; effort < 4; effort++)
        {
            gws->setNormalWeight(normal_weight);
            gws->setEffort(effort);
            gws->iterate(image, depth);
            const Mat of_depth = labelsOf(gws);
            gws->mergeSimilar(30);
            const Mat merged = labelsOf(gws);
            gws->iterate(other, depth);
            EXPECT_TRUE(equalMats(of_depth, labelsOf(gws))) << normal_weight << ", " << effort;
            gws->mergeSimilar(30);
            EXPECT_TRUE(equalMats(merged, labelsOf(gws))) << normal_weight << ", " << effort;
        }
    gws->setEffort(1);
    gws->setAlpha(1); // colour alone
    gws->iterate(image, depth);
    EXPECT_TRUE(equalMats(segment(image, RGWATERSHED, 10), labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, has_no_lines_after_region_guided_flood)
{
    const Mat large = makeScene(Size(120, 90), theRNG()), small = makeScene(Size(20, 10), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(large, GWATERSHED, 10);
    Mat lines;
    gws->iterate();
    gws->getWatershedLineMask(lines);
    EXPECT_GT(countNonZero(lines), 0);
    gws->setAlgorithm(RGWATERSHED);
    gws->iterate(small);
    gws->getWatershedLineMask(lines);
    EXPECT_EQ(small.size(), lines.size());
    EXPECT_EQ(0, countNonZero(lines));
}

}} // namespace
