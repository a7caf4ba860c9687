// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// What is refused before an algorithm sees it, so with one algorithm only.

TEST(ximgproc_SuperpixelGWatershed, refuses_wrong_images_and_stays_usable)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(60, 40), rng), depth = makeDepth(image.size(), 0.1, rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth);
    gws->iterate();
    const Mat before = labelsOf(gws);

    const int cube[] = { 4, 5, 6 };
    const int wrong_images[] = { CV_8UC(5), CV_32FC(6) };
    const int wrong_depths[] = { CV_8UC2, CV_8UC(5), CV_64FC2, CV_32SC1, CV_8SC1, CV_16SC3 };
    EXPECT_TRUE(isRefused([&] { gws->iterate(Mat()); }, "image must not be empty"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(noArray()); }, "image must not be empty"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(Mat(3, cube, CV_8UC1, Scalar(0))); }, "image must have two dimensions"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(std::vector<Mat>(3, image)); }, "image must be one Mat"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(std::array<Mat, 1>()); }, "image must be one Mat"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(Scalar(1)); }, "image must be one Mat"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(640, int(RGWATERSHED), 500); }, "image must be one Mat"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image, RGWATERSHED, 20, 10.f, 0.3f); }, // no depth
                          "depth must be one Mat"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image, 20); }, "RGWATERSHED (201)"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(std::vector<std::vector<uchar> >(40, std::vector<uchar>(60))); },
                          "image must be one Mat"));
    EXPECT_TRUE(isRefused([&] { gws->setMask(std::vector<std::vector<uchar> >(3, std::vector<uchar>(4))); },
                          "mask must be one Mat"));
    for (int type : wrong_images)
        EXPECT_TRUE(isRefused([&] { gws->iterate(Mat(40, 60, type)); }, "image must"));
    for (int type : wrong_depths)
        EXPECT_TRUE(isRefused([&] { gws->iterate(image, Mat(40, 60, type)); }, "depth must be"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(image, image); }, "depth must be"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(image, depth.rowRange(1, 40)); }, "depth must have the size of image"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(image, Mat(3, cube, CV_16UC1, Scalar(0))); },
                          "depth must have two dimensions"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(0); }, "num_iterations"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(image, 0); }, "num_iterations"));
    EXPECT_TRUE(isRefused([&] { gws->iterate(image, depth, -1); }, "num_iterations"));
    EXPECT_TRUE(isRefused([&] { gws->enforceLabelConnectivity(-1); }, "min_element_size"));
    EXPECT_TRUE(isRefused([&] { gws->enforceLabelConnectivity(101); }, "min_element_size"));

    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
    gws->iterate();
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
}

// The headers have no memory behind them: an image is refused before anything of it is read.
TEST(ximgproc_SuperpixelGWatershed, refuses_more_pixels_than_an_index_can_name)
{
    uchar byte = 0;
    const Mat small = makeScene(Size(30, 20), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(30, 20, 3, 6);
    gws->iterate(small);
    const Mat before = labelsOf(gws);
    const Size sizes[] = { Size(46339, 46339), Size(65536, 65536), Size(INT_MAX, 1), Size(1, INT_MAX),
                           Size(715827881, 1) };
    for (int i = 0; i < 5; i++)
    {
        const Mat image(sizes[i], CV_8UC1, &byte);
        const int width = image.cols, height = image.rows;
        EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(width, height, 3, 100); }, "fewer than 2^31"));
        EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image); }, "fewer than 2^31"));
        EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image, image); }, "fewer than 2^31"));
        EXPECT_TRUE(isRefused([&] { gws->iterate(image); }, "fewer than 2^31"));
        EXPECT_TRUE(isRefused([&] { gws->iterate(image, image); }, "fewer than 2^31"));
    }
    for (const Size size : { Size((1 << 29) - 16, 1), Size(1, (1 << 29) - 16) })
    {
        const Mat image(size, CV_8SC4, &byte);
        EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image); }, "fewer than 2^29 - 16"));
        EXPECT_TRUE(isRefused([&] { gws->iterate(image); }, "fewer than 2^29 - 16"));
    }
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
    gws->iterate(small);
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, refuses_wrong_masks_and_stays_usable)
{
    const Mat image = makeScene(Size(60, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image);
    gws->iterate();
    const Mat before = labelsOf(gws);
    EXPECT_TRUE(isRefused([&] { gws->setMask(Mat(40, 60, CV_8UC3)); }, "mask must be CV_8UC1"));
    EXPECT_TRUE(isRefused([&] { gws->setMask(Mat(40, 60, CV_32SC1)); }, "mask must be CV_8UC1"));
    EXPECT_TRUE(isRefused([&] { gws->setMask(std::vector<Mat>(2, Mat(40, 60, CV_8UC1))); }, "mask must be one Mat"));
    gws->setMask(Mat(40, 59, CV_8UC1, Scalar(1)));
    EXPECT_TRUE(isRefused([&] { gws->iterate(); }, "mask must have the size of image"));
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
    gws->setMask(Mat());
    gws->iterate();
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, refuses_wrong_markers_and_stays_usable)
{
    const Mat image = makeScene(Size(60, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image);
    gws->iterate();
    const Mat before = labelsOf(gws);
    EXPECT_TRUE(isRefused([&] { gws->setMarkers(Mat(40, 60, CV_8UC1)); }, "markers must be CV_32SC1"));
    EXPECT_TRUE(isRefused([&] { gws->setMarkers(Mat(40, 60, CV_32FC1)); }, "markers must be CV_32SC1"));
    gws->setMarkers(Mat(60, 40, CV_32SC1, Scalar(1)));
    EXPECT_TRUE(isRefused([&] { gws->iterate(); }, "markers must have the size of image"));
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
    gws->setMarkers(Mat());
    gws->iterate();
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, refuses_wrong_parameters_and_keeps_the_old_ones)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const Mat image = makeScene(Size(60, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GWATERSHED, 7, 3.f);
    EXPECT_TRUE(isRefused([&] { gws->setAlgorithm(7); }, "algorithm"));
    EXPECT_TRUE(isRefused([&] { gws->setRegionSize(0); }, "region_size"));
    EXPECT_TRUE(isRefused([&] { gws->setRegionSize(-5); }, "region_size"));
    EXPECT_TRUE(isRefused([&] { gws->setDesiredSuperpixels(0); }, "num_superpixels"));
    const float wrong_rulers[] = { -1.f, nan, inf };
    for (int i = 0; i < 3; i++)
    {
        EXPECT_TRUE(isRefused([&] { gws->setRuler(wrong_rulers[i]); }, "ruler"));
        EXPECT_TRUE(isRefused([&] { gws->setBorderThreshold(wrong_rulers[i]); }, "border_threshold"));
        EXPECT_TRUE(isRefused([&] { gws->setAlpha(wrong_rulers[i]); }, "alpha"));
        EXPECT_TRUE(isRefused([&] { gws->setDepthRange(wrong_rulers[i], 5); }, "near_depth"));
        EXPECT_TRUE(isRefused([&] { gws->setDepthRange(0, wrong_rulers[i]); }, "far_depth"));
    }
    EXPECT_TRUE(isRefused([&] { gws->setEffort(-1); }, "effort"));
    EXPECT_TRUE(isRefused([&] { gws->setEffort(4); }, "effort"));
    for (int i = 0; i < 3; i++)
    {
        EXPECT_TRUE(isRefused([&] { gws->setFocalLength(wrong_rulers[i]); }, "fx"));
        EXPECT_TRUE(isRefused([&] { gws->setFocalLength(500, wrong_rulers[i]); }, "fy"));
        EXPECT_TRUE(isRefused([&] { gws->setNormalWeight(wrong_rulers[i]); }, "normal_weight"));
    }
    EXPECT_TRUE(isRefused([&] { gws->setFocalLength(0, 500); }, "fy"));
    EXPECT_TRUE(isRefused([&] { gws->setNormalWeight(1.001f); }, "normal_weight"));
    EXPECT_TRUE(isRefused([&] { gws->setAlpha(1.001f); }, "alpha"));
    EXPECT_TRUE(isRefused([&] { gws->setDepthRange(5, 5); }, "far_depth"));
    EXPECT_EQ(GWATERSHED, gws->getAlgorithm());
    EXPECT_EQ(7, gws->getRegionSize());
    EXPECT_EQ(0, gws->getDesiredSuperpixels());
    EXPECT_EQ(3.f, gws->getRuler());
    EXPECT_EQ(1, gws->getEffort());
    EXPECT_EQ(0.5f, gws->getAlpha());
    EXPECT_EQ(0.f, gws->getNearDepth());
    EXPECT_EQ(0.f, gws->getFarDepth());
    EXPECT_EQ(150.f, gws->getBorderThreshold());
    gws->iterate();
    Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(image, GWATERSHED, 7, 3.f);
    fresh->iterate();
    EXPECT_TRUE(equalMats(labelsOf(fresh), labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, refuses_wrong_files_and_keeps_the_old_parameters)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(60, 40, 3, 20);
    gws->setRegionSize(13);
    FileStorage out(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    gws->write(out);
    const String text = out.releaseAndGetString();
    const auto read = [&](const String& wrong)
    {
        const FileStorage in(wrong, FileStorage::READ | FileStorage::MEMORY);
        gws->read(in.root());
    };

    String wrong = text;
    wrong.replace(wrong.find("alpha:"), 6, "alphb:");
    EXPECT_TRUE(isRefused([&] { read(wrong); }, "alpha"));
    const String sizes[] = { "region_size: 0", "region_size: -2", "region_sise: 13" };
    for (int i = 0; i < 3; i++)
    {
        wrong = text;
        wrong.replace(wrong.find("region_size: 13"), 15, sizes[i]);
        EXPECT_TRUE(isRefused([&] { read(wrong); }, "region_size"));
    }
    const String no_integers[] = { "algorithm", "region_size", "num_superpixels", "lab_input", "temporal" };
    for (int i = 0; i < 5; i++)
    {
        wrong = text;
        const size_t end = wrong.find('\n', wrong.find(no_integers[i] + ":"));
        wrong.insert(end, ".25");
        EXPECT_TRUE(isRefused([&] { read(wrong); }, no_integers[i]));
    }
    for (const String flag : { "lab_input", "temporal", "depth_adaptive" })
    {
        wrong = text;
        wrong.replace(wrong.find(flag + ": 0"), flag.size() + 3, flag + ": 7");
        EXPECT_TRUE(isRefused([&] { read(wrong); }, flag));
    }
    EXPECT_EQ(13, gws->getRegionSize());
}

TEST(ximgproc_SuperpixelGWatershed, factories_refuse_wrong_arguments)
{
    const Mat image = makeScene(Size(60, 40), theRNG()), depth(image.size(), CV_16UC1, Scalar(1));
    const int a = GWATERSHED;
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(0, 10, 3, 5, a); }, "image_width"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(10, -1, 3, 5, a); }, "image_height"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(10, 10, 5, 5, a); }, "image_channels"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(10, 10, 3, 0, a); }, "num_superpixels"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(65536, 65536, 3, 5, a); }, "pixels"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(10, 10, 3, 5, 7); }, "algorithm"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(10, 10, 3, 5, a, -1.f); }, "ruler"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(Mat(), a); }, "image"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image, 7); }, "algorithm"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image, a, 0); }, "region_size"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image, depth.colRange(0, 9), a); }, "depth"));
    EXPECT_TRUE(isRefused([&] { createSuperpixelGWatershed(image, depth, a, 10, 10.f, 2.f); }, "alpha"));
}

TEST(ximgproc_SuperpixelGWatershed, tables_are_refused_for_images_of_another_size)
{
    const Mat image = makeScene(Size(60, 40), theRNG()), wrong(50, 60, CV_8UC3), depth(50, 60, CV_16UC1);
    Mat tables[4];
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image);
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, noArray(), tables[0], tables[1], tables[2], tables[3]); },
                          "iterate"));
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(image, noArray(), tables[0], tables[1], tables[2]); }, "iterate"));
    EXPECT_TRUE(isRefused([&] { gws->mergeSimilar(3); }, "iterate"));
    gws->iterate();
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(wrong, noArray(), tables[0], tables[1]); },
                          "image must have the size"));
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, depth, tables[0], tables[1]); }, "depth must have the size"));
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, image, tables[0], tables[1]); }, "depth must be"));
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(wrong, noArray(), tables[0], tables[1]); },
                          "image must have the size"));
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(Mat(image.size(), CV_64FC(5)), noArray(), tables[0], tables[1]); },
                          "image must have"));
    const Mat deep(image.size(), CV_16UC1);
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(noArray(), deep, tables[0], tables[1], tables[2]); }, "depth"));
    EXPECT_TRUE(isRefused([&] { gws->mergeSimilar(0); }, "num_superpixels"));
    gws->getStatistics(image, noArray(), tables[0], noArray(), tables[2], noArray());
    EXPECT_EQ(gws->getNumberOfSuperpixels(), tables[0].rows);
    EXPECT_EQ(gws->getNumberOfSuperpixels(), tables[2].rows);
}

TEST(ximgproc_SuperpixelGWatershed, refuses_what_cannot_hold_a_result_before_anything_is_written)
{
    const Size size(40, 30);
    const Mat image(size, CV_8UC3, Scalar(1, 2, 3)), depth(size, CV_16UC1, Scalar(4));
    const Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image);
    gws->iterate();
    Mat_<uchar> bytes;
    Mat_<float> floats;
    std::vector<int> labels;
    std::vector<Mat> mats;
    EXPECT_TRUE(isRefused([&] { gws->getLabels(bytes); }, "labels_out must be"));
    EXPECT_TRUE(isRefused([&] { gws->getLabels(labels); }, "labels_out must be"));
    EXPECT_TRUE(isRefused([&] { gws->getLabels(mats); }, "labels_out must be"));
    EXPECT_TRUE(isRefused([&] { gws->getLabels(noArray()); }, "labels_out must be"));
    EXPECT_TRUE(isRefused([&] { gws->getLabelContourMask(floats); }, "image must be"));
    Mat canvas(100, 100, CV_8UC1);
    EXPECT_TRUE(isRefused([&] { gws->getLabelContourMask(canvas(Rect(0, 0, 41, 30))); }, "image must have"));
    EXPECT_TRUE(isRefused([&] { gws->getWatershedLineMask(canvas(Rect(0, 0, 40, 31))); }, "image must have"));
    EXPECT_TRUE(isRefused([&] { gws->getLabelContourMask(noArray()); }, "image must be"));
    EXPECT_TRUE(isRefused([&] { gws->getWatershedLineMask(floats); }, "image must be"));
    EXPECT_TRUE(bytes.empty() && floats.empty() && labels.empty() && mats.empty());

    Mat tables[4];
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, depth, floats, tables[1], tables[2], tables[3]); },
                          "stats must be"));
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, depth, tables[0], floats, tables[2], tables[3]); },
                          "centroids must be"));
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, depth, tables[0], tables[1], bytes, tables[3]); },
                          "mean_colors must be"));
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, depth, tables[0], tables[1], tables[2], bytes); },
                          "mean_depths must be"));
    EXPECT_TRUE(isRefused([&] { gws->getStatistics(image, depth, tables[0], tables[1], tables[2], tables[3], bytes); },
                          "positions must be"));
    const auto toLabels = [&] { gws->getStatistics(image, depth, tables[0], tables[1], noArray(), noArray(), tables[2],
                                                   labels); };
    EXPECT_TRUE(isRefused(toLabels, "normals must be"));
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(image, depth, bytes, tables[1], tables[2]); }, "pairs must be"));
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(image, depth, tables[0], bytes, tables[2]); }, "lengths must be"));
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(image, depth, tables[0], tables[1], bytes); }, "contrasts must be"));
    EXPECT_TRUE(isRefused([&] { gws->getAdjacency(image, depth, labels, tables[1], tables[2]); }, "pairs must be"));
    for (int i = 0; i < 4; i++)
        EXPECT_TRUE(tables[i].empty());
}

}} // namespace
