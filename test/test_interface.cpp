// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// The interface: errors, contour masks, small superpixels, Algorithm, code written for SLIC and SEEDS.

typedef testing::TestWithParam<int> ximgproc_GWatershed_interface;

TEST_P(ximgproc_GWatershed_interface, refuses_wrong_images_and_stays_usable)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(60, 40), rng), depth = makeDepth(image.size(), 0.1, rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam());
    gws->iterate();
    const Mat before = labelsOf(gws);

    const int cube[] = { 4, 5, 6 };
    const int wrong_images[] = { CV_8UC(5), CV_32FC(6) };
    const int wrong_depths[] = { CV_8UC2, CV_8UC(5), CV_64FC2, CV_32SC1, CV_8SC1, CV_16SC3 };
    EXPECT_REFUSED(gws->iterate(Mat()), "image must not be empty");
    EXPECT_REFUSED(gws->iterate(noArray()), "image must not be empty");
    EXPECT_REFUSED(gws->iterate(Mat(3, cube, CV_8UC1, Scalar(0))), "image must have two dimensions");
    EXPECT_REFUSED(gws->iterate(std::vector<Mat>(3, image)), "image must be one Mat");
    EXPECT_REFUSED(gws->iterate(std::array<Mat, 1>()), "image must be one Mat");
    EXPECT_REFUSED(gws->iterate(std::vector<std::vector<uchar> >(40, std::vector<uchar>(60))), "image must be one Mat");
    EXPECT_REFUSED(gws->setMask(std::vector<std::vector<uchar> >(3, std::vector<uchar>(4))), "mask must be one Mat");
    for (int type : wrong_images)
        EXPECT_REFUSED(gws->iterate(Mat(40, 60, type)), "image must");
    for (int type : wrong_depths)
        EXPECT_REFUSED(gws->iterate(image, Mat(40, 60, type)), "depth must be");
    EXPECT_REFUSED(gws->iterate(image, image), "depth must be");
    EXPECT_REFUSED(gws->iterate(image, depth.rowRange(1, 40)), "depth must have the size of image");
    EXPECT_REFUSED(gws->iterate(image, Mat(3, cube, CV_16UC1, Scalar(0))), "depth must have two dimensions");
    EXPECT_REFUSED(gws->iterate(0), "num_iterations");
    EXPECT_REFUSED(gws->iterate(image, 0), "num_iterations");
    EXPECT_REFUSED(gws->iterate(image, depth, -1), "num_iterations");
    EXPECT_REFUSED(gws->enforceLabelConnectivity(-1), "min_element_size");
    EXPECT_REFUSED(gws->enforceLabelConnectivity(101), "min_element_size");

    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
    gws->iterate();
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_interface, refuses_wrong_parameters_and_keeps_the_old_ones)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const Mat image = makeScene(Size(60, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 7, 3.f);
    EXPECT_REFUSED(gws->setAlgorithm(7), "algorithm");
    EXPECT_REFUSED(gws->setRegionSize(0), "region_size");
    EXPECT_REFUSED(gws->setRegionSize(-5), "region_size");
    EXPECT_REFUSED(gws->setDesiredSuperpixels(0), "num_superpixels");
    const float wrong_rulers[] = { -1.f, nan, inf };
    for (int i = 0; i < 3; i++)
    {
        EXPECT_REFUSED(gws->setRuler(wrong_rulers[i]), "ruler");
        EXPECT_REFUSED(gws->setBorderThreshold(wrong_rulers[i]), "border_threshold");
        EXPECT_REFUSED(gws->setAlpha(wrong_rulers[i]), "alpha");
        EXPECT_REFUSED(gws->setDepthRange(wrong_rulers[i], 5), "near_depth");
        EXPECT_REFUSED(gws->setDepthRange(0, wrong_rulers[i]), "far_depth");
    }
    EXPECT_REFUSED(gws->setAlpha(1.001f), "alpha");
    EXPECT_REFUSED(gws->setDepthRange(5, 5), "far_depth");
    EXPECT_EQ(GetParam(), gws->getAlgorithm());
    EXPECT_EQ(7, gws->getRegionSize());
    EXPECT_EQ(0, gws->getDesiredSuperpixels());
    EXPECT_EQ(3.f, gws->getRuler());
    EXPECT_EQ(0.5f, gws->getAlpha());
    EXPECT_EQ(0.f, gws->getNearDepth());
    EXPECT_EQ(0.f, gws->getFarDepth());
    EXPECT_EQ(150.f, gws->getBorderThreshold());
    gws->iterate();
    Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(image, GetParam(), 7, 3.f);
    fresh->iterate();
    EXPECT_TRUE(equalMats(labelsOf(fresh), labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_interface, factories_refuse_wrong_arguments)
{
    const Mat image = makeScene(Size(60, 40), theRNG()), depth(image.size(), CV_16UC1, Scalar(1));
    const int a = GetParam();
    EXPECT_REFUSED(createSuperpixelGWatershed(0, 10, 3, 5, a), "image_width");
    EXPECT_REFUSED(createSuperpixelGWatershed(10, -1, 3, 5, a), "image_height");
    EXPECT_REFUSED(createSuperpixelGWatershed(10, 10, 5, 5, a), "image_channels");
    EXPECT_REFUSED(createSuperpixelGWatershed(10, 10, 0, 5, a), "image_channels");
    EXPECT_REFUSED(createSuperpixelGWatershed(10, 10, 3, 0, a), "num_superpixels");
    EXPECT_REFUSED(createSuperpixelGWatershed(65536, 65536, 3, 5, a), "pixels");
    EXPECT_REFUSED(createSuperpixelGWatershed(10, 10, 3, 5, 7), "algorithm");
    EXPECT_REFUSED(createSuperpixelGWatershed(10, 10, 3, 5, a, -1.f), "ruler");
    EXPECT_REFUSED(createSuperpixelGWatershed(Mat(), a), "image");
    EXPECT_REFUSED(createSuperpixelGWatershed(image, 7), "algorithm");
    EXPECT_REFUSED(createSuperpixelGWatershed(image, a, 0), "region_size");
    EXPECT_REFUSED(createSuperpixelGWatershed(image, depth.colRange(0, 9), a), "depth");
    EXPECT_REFUSED(createSuperpixelGWatershed(image, depth, a, 10, 10.f, 2.f), "alpha");
}

TEST_P(ximgproc_GWatershed_interface, says_that_there_is_nothing_yet)
{
    const Mat image = makeScene(Size(60, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(60, 40, 3, 20, GetParam());
    Mat out;
    for (int repeat = 0; repeat < 2; repeat++)
    {
        EXPECT_TRUE(gws->empty());
        EXPECT_EQ(0, gws->getNumberOfSuperpixels());
        EXPECT_REFUSED(gws->iterate(), "no image");
        EXPECT_REFUSED(gws->getLabels(out), "iterate");
        EXPECT_REFUSED(gws->getLabelContourMask(out), "iterate");
        EXPECT_REFUSED(gws->getWatershedLineMask(out), "iterate");
        EXPECT_REFUSED(gws->enforceLabelConnectivity(), "iterate");
        gws->iterate(image);
        EXPECT_FALSE(gws->empty());
        EXPECT_EQ(20, gws->getNumberOfSuperpixels());
        gws->clear(); // and from here on as at the beginning
    }
    EXPECT_EQ(20, gws->getDesiredSuperpixels());
}

TEST_P(ximgproc_GWatershed_interface, contour_masks_show_every_boundary)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 20; i++)
    {
        const Mat image = makeImage(ImageKind(i % IMAGE_KINDS), Size(rng.uniform(1, 90), rng.uniform(1, 90)), 3, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 1 + i);
        gws->iterate();
        const Mat labels = labelsOf(gws);
        Mat thick, thin;
        gws->getLabelContourMask(thick);
        gws->getLabelContourMask(thin, false);
        EXPECT_EQ(image.total(), size_t(countNonZero(thick == 0) + countNonZero(thick == 255)));
        EXPECT_EQ(image.total(), size_t(countNonZero(thin == 0) + countNonZero(thin == 255)));
        for (int y = 0; y < labels.rows; y++)
            for (int x = 0; x < labels.cols; x++)
            {
                bool beside = false, before = false;
                for (int dy = -1; dy <= 1; dy++)
                    for (int dx = -1; dx <= 1; dx++)
                    {
                        const Point q(x + dx, y + dy);
                        if (std::abs(dx) + std::abs(dy) != 1 || !Rect(Point(), labels.size()).contains(q) ||
                            labels.at<int>(q) == labels.at<int>(y, x))
                            continue;
                        beside = true;
                        before = before || dx + dy > 0;
                    }
                ASSERT_EQ(beside, thick.at<uchar>(y, x) == 255);
                ASSERT_EQ(before, thin.at<uchar>(y, x) == 255);
            }
    }
}

TEST_P(ximgproc_GWatershed_interface, one_superpixel_has_no_contour)
{
    const Mat image = makeScene(Size(30, 20), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(30, 20, 3, 1, GetParam());
    gws->iterate(image);
    Mat contours;
    gws->getLabelContourMask(contours);
    EXPECT_EQ(0, countNonZero(contours));
}

TEST_P(ximgproc_GWatershed_interface, merges_small_superpixels)
{
    RNG& rng = theRNG();
    for (int percent = 0; percent <= 100; percent += 20)
    {
        const Mat image = makeImage(percent % 40 ? NOISE : SCENE, Size(150, 110), 3, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 9);
        gws->iterate();
        const Mat before = labelsOf(gws);
        const int n = gws->getNumberOfSuperpixels();
        gws->enforceLabelConnectivity(percent);
        const Mat labels = labelsOf(gws);
        expectPartition(labels, image.size(), gws->getNumberOfSuperpixels());
        EXPECT_LE(gws->getNumberOfSuperpixels(), n);
        EXPECT_TRUE(percent > 0 || equalMats(before, labels));
        std::map<int, int> merged; // every old superpixel lies in one new one
        for (int y = 0; y < labels.rows; y++)
            for (int x = 0; x < labels.cols; x++)
                ASSERT_EQ(labels.at<int>(y, x),
                          merged.insert(std::make_pair(before.at<int>(y, x), labels.at<int>(y, x))).first->second);
        for (int label = 0; label < gws->getNumberOfSuperpixels(); label++)
            EXPECT_GE(100. * countNonZero(labels == label), percent * 150. * 110. / n);
    }
}

TEST_P(ximgproc_GWatershed_interface, keeps_superpixels_of_the_smallest_area_allowed)
{
    Mat markers(5, 5, CV_32SC1, Scalar(2)); // areas 5, 10 and 10: 5 is 60 percent of the mean
    markers.row(0).setTo(Scalar(1));
    markers.rowRange(3, 5).setTo(Scalar(3));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(5, 5, 1, 3, GetParam());
    gws->setMarkers(markers);
    gws->iterate(Mat(5, 5, CV_8UC1, Scalar(9)));
    gws->enforceLabelConnectivity(60);
    EXPECT_EQ(3, gws->getNumberOfSuperpixels());
    gws->enforceLabelConnectivity(61);
    EXPECT_EQ(2, gws->getNumberOfSuperpixels());
}

TEST_P(ximgproc_GWatershed_interface, writes_and_reads_its_parameters)
{
    const Mat image = makeScene(Size(90, 60), theRNG()), depth = makeDepth(image.size(), 0.1, theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam(), 13, 4.5f, 0.75f);
    gws->setDepthRange(400.5f, 4000.f);
    gws->setBorderThreshold(120.f);
    EXPECT_EQ("SuperpixelGWatershed", gws->getDefaultName());

    FileStorage out(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    gws->write(out);
    const String text = out.releaseAndGetString();

    Ptr<SuperpixelGWatershed> other = createSuperpixelGWatershed(image, depth);
    const FileStorage in(text, FileStorage::READ | FileStorage::MEMORY);
    other->read(in.root());
    EXPECT_EQ(GetParam(), other->getAlgorithm());
    EXPECT_EQ(13, other->getRegionSize());
    EXPECT_EQ(0, other->getDesiredSuperpixels());
    EXPECT_EQ(4.5f, other->getRuler());
    EXPECT_EQ(0.75f, other->getAlpha());
    EXPECT_EQ(400.5f, other->getNearDepth());
    EXPECT_EQ(4000.f, other->getFarDepth());
    EXPECT_EQ(120.f, other->getBorderThreshold());
    gws->iterate();
    other->iterate();
    EXPECT_TRUE(equalMats(labelsOf(gws), labelsOf(other)));

    String wrong = text;
    wrong.replace(wrong.find("alpha:"), 6, "alphb:");
    const FileStorage missing(wrong, FileStorage::READ | FileStorage::MEMORY);
    EXPECT_REFUSED(other->read(missing.root()), "alpha");
    const String sizes[] = { "region_size: 0", "region_size: -2", "region_sise: 13" };
    for (int i = 0; i < 3; i++)
    {
        wrong = text;
        wrong.replace(wrong.find("region_size: 13"), 15, sizes[i]);
        const FileStorage in_wrong(wrong, FileStorage::READ | FileStorage::MEMORY);
        EXPECT_REFUSED(other->read(in_wrong.root()), "region_size");
    }
    const String no_integers[] = { "algorithm", "region_size", "num_superpixels", "lab_input", "temporal" };
    for (int i = 0; i < 5; i++)
    {
        wrong = text;
        const size_t end = wrong.find('\n', wrong.find(no_integers[i] + ":"));
        wrong.insert(end, ".25");
        const FileStorage in_wrong(wrong, FileStorage::READ | FileStorage::MEMORY);
        EXPECT_REFUSED(other->read(in_wrong.root()), no_integers[i]);
    }
    EXPECT_EQ(13, other->getRegionSize());
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_interface, GWATERSHED_ALGORITHMS);

// Code as users of SuperpixelSLIC and SuperpixelSEEDS have it, with other names.

TEST(ximgproc_SuperpixelGWatershed, runs_code_written_for_slic)
{
    const Mat frame = makeScene(Size(160, 120), theRNG());
    const int algorithm = 0, region_size = 50, ruler = 30, min_element_size = 50, num_iterations = 3;
    Mat converted, mask, labels;
    cvtColor(frame, converted, COLOR_BGR2HSV);

    Ptr<SuperpixelGWatershed> slic =
            createSuperpixelGWatershed(converted, algorithm + GWATERSHED, region_size, ruler);
    slic->iterate(num_iterations);
    if (min_element_size > 0)
        slic->enforceLabelConnectivity(min_element_size);
    slic->getLabelContourMask(mask, true);
    Mat result = frame;
    result.setTo(Scalar(0, 0, 255), mask);
    slic->getLabels(labels);
    expectPartition(labels, frame.size(), slic->getNumberOfSuperpixels());
    labels &= 3;
    labels *= 1 << 14;
    EXPECT_EQ(10.f, createSuperpixelGWatershed(frame, RGWATERSHED, 20, 10)->getRuler());
    EXPECT_EQ(2.5f, createSuperpixelGWatershed(frame, GWATERSHED, 20, 2.5)->getRuler());
}

TEST(ximgproc_SuperpixelGWatershed, runs_code_written_for_seeds)
{
    const Mat frame = makeScene(Size(160, 120), theRNG());
    const int num_superpixels = 400, num_iterations = 4;
    Mat converted, mask, labels;
    cvtColor(frame, converted, COLOR_BGR2HSV);

    const int width = frame.size().width, height = frame.size().height;
    Ptr<SuperpixelGWatershed> seeds = createSuperpixelGWatershed(width, height, frame.channels(), num_superpixels);
    seeds->iterate(converted, num_iterations);
    seeds->getLabels(labels);
    seeds->getLabelContourMask(mask, false);
    expectPartition(labels, frame.size(), 400);
    EXPECT_GT(countNonZero(mask), 0);
}

}} // namespace
