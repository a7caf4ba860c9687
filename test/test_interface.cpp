// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// The interface: contour masks, small superpixels, Algorithm, code written for SLIC and SEEDS.

typedef testing::TestWithParam<int> ximgproc_GWatershed_interface;

TEST_P(ximgproc_GWatershed_interface, says_that_there_is_nothing_yet)
{
    const Mat image = makeScene(Size(60, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(60, 40, 3, 20, GetParam());
    Mat out;
    for (int repeat = 0; repeat < 2; repeat++)
    {
        EXPECT_TRUE(gws->empty());
        EXPECT_EQ(0, gws->getNumberOfSuperpixels());
        EXPECT_TRUE(isRefused([&] { gws->iterate(); }, "no image"));
        EXPECT_TRUE(isRefused([&] { gws->getLabels(out); }, "iterate"));
        EXPECT_TRUE(isRefused([&] { gws->getLabelContourMask(out); }, "iterate"));
        EXPECT_TRUE(isRefused([&] { gws->getWatershedLineMask(out); }, "iterate"));
        EXPECT_TRUE(isRefused([&] { gws->enforceLabelConnectivity(); }, "iterate"));
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
    gws->setFocalLength(525.f, 520.f);
    gws->setNormalWeight(0.5f);
    gws->setDepthAdaptive(true);
    gws->setBorderThreshold(120.f);
    gws->setEffort(2);
    gws->setLabInput(true);
    gws->setTemporal(true);
    gws->setValueRange(3.f, 250.f);
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
    EXPECT_EQ(2, other->getEffort());
    EXPECT_EQ(0.75f, other->getAlpha());
    EXPECT_EQ(400.5f, other->getNearDepth());
    EXPECT_EQ(4000.f, other->getFarDepth());
    EXPECT_EQ(525.f, other->getFocalLengthX());
    EXPECT_EQ(520.f, other->getFocalLengthY());
    EXPECT_EQ(0.5f, other->getNormalWeight());
    EXPECT_TRUE(other->getDepthAdaptive());
    EXPECT_EQ(120.f, other->getBorderThreshold());
    EXPECT_TRUE(other->getLabInput());
    EXPECT_TRUE(other->getTemporal());
    EXPECT_EQ(3.f, other->getLowValue());
    EXPECT_EQ(250.f, other->getHighValue());
    FileStorage again(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    other->write(again);
    EXPECT_EQ(text, again.releaseAndGetString());
    gws->iterate();
    other->iterate();
    EXPECT_TRUE(equalMats(labelsOf(gws), labelsOf(other)));
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_interface, testing::ValuesIn(ALGORITHMS));

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
