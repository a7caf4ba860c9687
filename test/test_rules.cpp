// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// Single rules of the documentation, each by an input that is made for it. They were found by breaking lines of the
// source that no other test missed.

//! Superpixels that are what markers say, on every pixel.
Ptr<SuperpixelGWatershed> segmentAs(const Mat& labels, int algorithm = RGWATERSHED)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(labels.cols, labels.rows, 1, 1, algorithm);
    gws->setMarkers(labels + 1);
    gws->iterate(Mat(labels.size(), CV_8UC1, Scalar(9)));
    return gws;
}

//! Contrasts where each pixel is a superpixel.
Mat pixelContrasts(const Mat& image, float low = 0, float high = 0)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 1, int(image.total()));
    gws->setValueRange(low, high);
    gws->iterate(Mat(image.size(), CV_8UC1, Scalar(9)));
    Mat pairs, lengths, contrasts;
    gws->getAdjacency(image, noArray(), pairs, lengths, contrasts);
    return contrasts;
}

TEST(ximgproc_SuperpixelGWatershed, statistics_skip_what_is_no_number_in_halves)
{
    Mat values(8, 8, CV_32FC1, Scalar(4)), means;
    values.row(2).setTo(Scalar(NOT_A_NUMBER));
    values.row(3).setTo(Scalar(INFINITE));
    values.convertTo(values, CV_16F);
    segmentAs(Mat::zeros(8, 8, CV_32SC1))->getStatistics(values, noArray(), noArray(), noArray(), means);
    EXPECT_EQ(4, means.at<float>(0));
}

TEST(ximgproc_SuperpixelGWatershed, no_normal_where_depth_is_nearly_on_one_line)
{
    Mat depth = Mat::zeros(300, 301, CV_32FC1), normals;
    for (int i = 0; i < 300; i++)
        depth.at<float>(i, i + (i == 150)) = 2;
    segmentAs(Mat::zeros(depth.size(), CV_32SC1))->getStatistics(noArray(), depth, noArray(), noArray(), noArray(),
                                                                 noArray(), noArray(), normals);
    EXPECT_TRUE(cvIsNaN(normals.at<float>(0, 0)));
}

TEST(ximgproc_SuperpixelGWatershed, normals_of_two_focal_lengths)
{
    const Point2d focal(200, 350);
    Mat depth(60, 80, CV_64FC1), depths, positions, normals;
    for (int y = 0; y < 60; y++)
        for (int x = 0; x < 80; x++)
            depth.at<double>(y, x) = 1 / (0.2 * (x - 39.5) / focal.x - 0.4 * (y - 29.5) / focal.y + 0.5);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(80, 60, 1, 1);
    gws->setFocalLength(float(focal.x), float(focal.y));
    gws->iterate(Mat(60, 80, CV_8UC1, Scalar(9)));
    gws->getStatistics(noArray(), depth, noArray(), noArray(), noArray(), depths, positions, normals);
    const Vec3d away(0.2, -0.4, 0.5);
    EXPECT_LT(cv::norm(Vec3d(*normals.ptr<Vec3f>()) + away / cv::norm(away)), 1e-5);
}

TEST(ximgproc_SuperpixelGWatershed, no_contrasts_without_an_image)
{
    Mat pairs, lengths, contrasts(3, 1, CV_32FC1);
    segmentAs((Mat_<int>(1, 3) << 0, 1, 2))->getAdjacency(noArray(), noArray(), pairs, lengths, contrasts);
    EXPECT_EQ(2, pairs.rows);
    EXPECT_EQ(0, contrasts.rows);
}

TEST(ximgproc_SuperpixelGWatershed, no_contour_beside_the_outside_of_a_mask)
{
    RNG& rng = theRNG();
    const Mat mask = makeMask(DISCS, Size(60, 40), rng), image = makeScene(mask.size(), rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 200); // one for each component
    gws->setMask(mask);
    gws->iterate();
    gws->mergeSimilar(1);
    Mat contours;
    for (int thick = 0; thick < 2; thick++)
    {
        gws->getLabelContourMask(contours, thick != 0);
        EXPECT_EQ(0, countNonZero(contours));
    }
}

//! As the documentation says: the smallest one first, of equal ones that of the lowest label.
Mat mergeBySize(Mat labels, int n, int min_area)
{
    std::vector<int> into(n);
    for (int i = 0; i < n; i++)
        into[i] = i;
    for (;;)
    {
        std::vector<int> areas(n, 0);
        std::map<std::pair<int, int>, int> lengths;
        for (int y = 0; y < labels.rows; y++)
            for (int x = 0; x < labels.cols; x++)
                for (int k = 0; k < 2; k++)
                {
                    const int a = labels.at<int>(y, x);
                    areas[a] += k == 0;
                    const Point q(x + k, y + !k);
                    const int b = q.x < labels.cols && q.y < labels.rows ? labels.at<int>(q) : a;
                    if (a == b)
                        continue;
                    lengths[std::make_pair(a, b)]++;
                    lengths[std::make_pair(b, a)]++;
                }
        int from = -1, to = -1;
        for (int i = 0; i < n; i++)
            if (areas[i] > 0 && areas[i] < min_area && (from < 0 || areas[i] < areas[from]))
                from = i;
        double longest = 0;
        for (const auto& e : lengths)
        {
            const double length = double(e.second) * e.second / areas[e.first.second];
            if (e.first.first != from || length <= longest)
                continue;
            longest = length;
            to = e.first.second;
        }
        if (to < 0)
            break;
        labels.setTo(Scalar(to), labels == from);
        into[from] = to;
    }
    std::map<int, int> numbers;
    Mat numbered = labels.clone();
    for (int i = 0; i < n; i++)
    {
        int root = i;
        while (into[root] != root)
            root = into[root];
        numbered.setTo(Scalar(numbers.insert(std::make_pair(root, int(numbers.size()))).first->second), labels == root);
    }
    return numbered;
}

TEST(ximgproc_SuperpixelGWatershed, merges_small_superpixels_as_documented)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 30; i++)
    {
        const Mat image = makeImage(i % 2 ? NOISE : SCENE, Size(40, 30), 3, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 3);
        gws->iterate();
        const Mat expected = mergeBySize(labelsOf(gws).clone(), gws->getNumberOfSuperpixels(), 10 + 4 * i);
        gws->mergeSmall(10 + 4 * i);
        EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << i;
    }
}

TEST(ximgproc_SuperpixelGWatershed, a_video_starts_again_with_another_mask)
{
    RNG& rng = theRNG();
    const Size size(120, 90);
    const Mat image = makeScene(size, rng), first = makeMask(DISCS, size, rng);
    Mat second;
    flip(first, second, 1);
    for (int algorithm : ALGORITHMS)
    {
        Ptr<SuperpixelGWatershed> video = createSuperpixelGWatershed(size.width, size.height, 3, 100, algorithm);
        Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(size.width, size.height, 3, 100, algorithm);
        video->setTemporal(true);
        video->setMask(first);
        video->iterate(image);
        for (const Ptr<SuperpixelGWatershed>& gws : { video, fresh })
        {
            gws->setMask(second);
            gws->iterate(image);
        }
        EXPECT_TRUE(equalMats(labelsOf(fresh), labelsOf(video)));
    }
}

TEST(ximgproc_SuperpixelGWatershed, finds_the_range_of_few_bits_few_levels_and_few_values)
{
    const Mat word = (Mat_<ushort>(1, 4) << 0, 128, 256, 3);
    EXPECT_TRUE(equalMats(pixelContrasts(word, 0, 511), pixelContrasts(word)));
    Mat bytes(20, 20, CV_8UC1), words, units(20, 20, CV_32FC1, Scalar(0.5));
    theRNG().fill(bytes, RNG::UNIFORM, 200, 250);
    bytes.convertTo(words, CV_16U);
    EXPECT_TRUE(equalMats(pixelContrasts(bytes), pixelContrasts(words)));
    units.resize(60, Scalar(0.5));
    units.at<float>(7, 7) = 0.9f; // no more than one in 1000
    EXPECT_TRUE(equalMats(pixelContrasts(units, 0, 1), pixelContrasts(units)));
    Mat some(20, 20, CV_32FC1);
    theRNG().fill(some, RNG::UNIFORM, 0.2, 0.7);
    some.row(3).setTo(Scalar(INFINITE));
    some.row(5).setTo(Scalar(-INFINITE));
    EXPECT_TRUE(equalMats(pixelContrasts(some, 0, 1), pixelContrasts(some)));
}

TEST(ximgproc_SuperpixelGWatershed, integers_above_a_narrow_range_are_white)
{
    const Mat word = (Mat_<ushort>(1, 3) << 0, 20000, 65535), byte = (Mat_<uchar>(1, 3) << 0, 100, 255);
    for (float high : { 1.f, 0.01f, 0.005f, 1e-3f, 1e-5f, 1e-30f })
    {
        const Mat expected = (Mat_<float>(2, 1) << 255, 0);
        EXPECT_TRUE(equalMats(expected, pixelContrasts(word, 0, high))) << high;
        EXPECT_TRUE(equalMats(expected, pixelContrasts(byte, 0, high))) << high;
    }
}

// What lies above one, as lamps in linear light, would leave four levels to the picture. Black bars, and a little below
// zero, as a sensor has it, change nothing.
TEST(ximgproc_SuperpixelGWatershed, lights_do_not_take_the_range_from_a_picture)
{
    const Rect light(10, 10, 12, 12), bar(0, 50, 90, 20), dark(40, 20, 8, 8);
    for (int i = 0; i < 6; i++)
    {
        const int type = i < 2 ? CV_16F : i < 4 ? CV_32F : CV_64F;
        Mat image;
        makeScene(Size(90, 70), theRNG()).convertTo(image, CV_32F, 1 / 256., 1 / 512.);
        image(light).setTo(Scalar::all(i % 2 ? 60 : 5));
        image(bar).setTo(Scalar::all(0));
        image(dark).setTo(Scalar::all(-0.01));
        image.convertTo(image, type);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image);
        gws->iterate();
        const Mat labels = labelsOf(gws);
        gws->setValueRange(0, 1);
        gws->iterate();
        EXPECT_TRUE(equalMats(labelsOf(gws), labels)) << i;
    }
}

TEST(ximgproc_SuperpixelGWatershed, whole_numbers_are_levels_though_most_are_dark)
{
    Mat image(70, 90, CV_32FC1, Scalar(0));
    image.colRange(40, 90).setTo(Scalar(1));
    image(Rect(10, 10, 10, 20)).setTo(Scalar(100));
    image(Rect(20, 10, 10, 20)).setTo(Scalar(200));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image);
    gws->iterate();
    const Mat labels = labelsOf(gws);
    gws->setValueRange(0, 200);
    gws->iterate();
    EXPECT_TRUE(equalMats(labelsOf(gws), labels));
}

TEST(ximgproc_SuperpixelGWatershed, refuses_infinite_ranges_and_sizes_that_contradict)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(8, 8, 3, 5);
    EXPECT_TRUE(isRefused([&] { gws->setValueRange(-INFINITE, 1.f); }, "low_value"));
    FileStorage out(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    gws->write(out);
    const String text = out.releaseAndGetString();
    for (const char* wrong : { "region_size: 3", "region_size: 3e9" })
    {
        String changed = text;
        changed.replace(changed.find("region_size: 0"), 14, wrong);
        if (wrong[14])
            changed.replace(changed.find("num_superpixels: 5"), 18, "num_superpixels: 0");
        const FileStorage in(changed, FileStorage::READ | FileStorage::MEMORY);
        EXPECT_TRUE(isRefused([&] { gws->read(in.root()); }, "region_size")) << wrong;
    }
}

TEST(ximgproc_SuperpixelGWatershed, lab_input_of_four_channels_is_that_of_three)
{
    const Mat image = makeScene(Size(80, 60), theRNG());
    Mat four;
    cvtColor(image, four, COLOR_BGR2BGRA);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 8);
    gws->setLabInput(true);
    gws->iterate();
    const Mat expected = labelsOf(gws);
    gws->iterate(four);
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
}

//! A slanted plane of depth with a step.
Mat makeSteps(Size size)
{
    Mat depth(size, CV_32FC1);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
            depth.at<float>(y, x) =
                    1 / (0.5f + 0.002f * float(x) - 0.003f * float(y)) + (x > size.width / 2 ? 0.3f : 0);
    return depth;
}

TEST(ximgproc_SuperpixelGWatershed, surfaces_of_an_odd_number_of_rows_do_not_depend_on_threads)
{
    for (int height = 61; height < 90; height += 2)
    {
        const Mat image(height, 80, CV_8UC1, Scalar(9)), depth = makeSteps(image.size());
        Mat expected;
        for (int threads : { 1, 2, 5 })
        {
            ThreadsGuard guard(threads);
            const Mat labels = segment(image, depth, RGWATERSHED, 8);
            if (threads == 1)
                expected = labels;
            EXPECT_TRUE(equalMats(expected, labels)) << height << ", " << threads;
        }
    }
}

TEST(ximgproc_SuperpixelGWatershed, depth_beyond_the_range_tells_nothing)
{
    const Mat image = makeScene(Size(80, 60), theRNG()), depth = makeSteps(image.size());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, 8);
    gws->iterate();
    const Mat expected = labelsOf(gws);
    gws->setDepthRange(0.1f, 0.5f);
    gws->iterate(image, depth);
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
    gws->setDepthRange(40.f, 50.f);
    gws->iterate(image, depth);
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
}

TEST(ximgproc_SuperpixelGWatershed, range_of_depth_that_few_pixels_of_a_large_image_have)
{
    Mat depth = Mat::zeros(300, 300, CV_16UC1), contrasts[2];
    for (int x = 0; x < 80; x++)
        depth.at<ushort>(150, 100 + x) = ushort(1000 + x);
    const Mat image(depth.size(), CV_8UC1, Scalar(9));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(300, 300, 1, 300 * 300);
    gws->setAlpha(0);
    for (int i = 0; i < 2; i++)
    {
        Mat pairs, lengths;
        gws->setDepthRange(i * 1000.f, i * 1079.f); // that of the frame, and the same as a number
        gws->iterate(image);
        gws->getAdjacency(image, depth, pairs, lengths, contrasts[i]);
    }
    EXPECT_GT(countNonZero(contrasts[0]), 0);
    EXPECT_TRUE(equalMats(contrasts[1], contrasts[0]));
}

TEST(ximgproc_SuperpixelGWatershed, a_thing_before_a_wall_of_one_depth_is_cut_out)
{
    const Rect box(31, 22, 16, 15);
    Mat depth(60, 80, CV_16UC1, Scalar(2000)), classes = Mat::zeros(60, 80, CV_8UC1);
    depth(box).setTo(Scalar(500));
    classes(box).setTo(Scalar(1));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(80, 60, 1, 48);
    gws->iterate(Mat(60, 80, CV_8UC1, Scalar(9)), depth);
    EXPECT_GT(purity(labelsOf(gws), gws->getNumberOfSuperpixels(), classes), 0.99);
}

TEST(ximgproc_SuperpixelGWatershed, region_size_gives_no_full_rows_of_stretched_cells)
{
    // 3 x 7 cells would be 21, within 5 percent, but a tenth longer than wide.
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(Mat(23, 8, CV_8UC1, Scalar(9)), RGWATERSHED, 3);
    gws->iterate();
    EXPECT_EQ(20, gws->getNumberOfSuperpixels());
}

}} // namespace
