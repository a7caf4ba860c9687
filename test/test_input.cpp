// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// What goes in and comes out: types, submatrices, depth, errors, reuse, for every algorithm.

typedef testing::TestWithParam<int> ximgproc_GWatershed_input;

TEST_P(ximgproc_GWatershed_input, takes_every_type_of_image_alike)
{
    RNG& rng = theRNG();
    const Mat depth = makeDepth(Size(97, 61), 0.2, rng);
    for (int channels = 1; channels <= 3; channels += 2)
    {
        const Mat image = makeImage(SCENE, depth.size(), channels, rng);
        Mat words, floats;
        image.convertTo(words, CV_16U, 257);
        image.convertTo(floats, CV_32F, 1. / 255);
        const Mat expected = segment(image, depth, GetParam(), 9);
        EXPECT_TRUE(equalMats(expected, segment(words, depth, GetParam(), 9)));
        EXPECT_TRUE(equalMats(expected, segment(floats, depth, GetParam(), 9)));
        if (channels == 1)
            continue;
        Mat with_alpha;
        cvtColor(image, with_alpha, COLOR_BGR2BGRA);
        Mat noise(image.size(), CV_8UC1);
        rng.fill(noise, RNG::UNIFORM, Scalar::all(0), Scalar::all(256));
        insertChannel(noise, with_alpha, 3);
        EXPECT_TRUE(equalMats(expected, segment(with_alpha, depth, GetParam(), 9)));
    }
}

TEST_P(ximgproc_GWatershed_input, takes_dark_images_of_8_bits_in_16_alike)
{
    for (const double& brightness : { 0.6, 0.4, 0.2, 0.1 })
    {
        const Mat image = makeImage(SCENE, Size(97, 61), 3, theRNG()) * brightness;
        Mat words;
        image.convertTo(words, CV_16U, 257);
        EXPECT_TRUE(equalMats(segment(image, GetParam(), 9), segment(words, GetParam(), 9))) << brightness;
    }
}

TEST_P(ximgproc_GWatershed_input, takes_gray_as_three_equal_channels)
{
    const Mat gray = makeImage(SCENE, Size(97, 61), 1, theRNG());
    Mat color;
    cvtColor(gray, color, COLOR_GRAY2BGR);
    EXPECT_TRUE(equalMats(segment(gray, GetParam(), 9), segment(color, GetParam(), 9)));
}

TEST_P(ximgproc_GWatershed_input, takes_float_images_with_any_value)
{
    Mat image = makeImage(SCENE, Size(60, 50), 3, theRNG());
    image.convertTo(image, CV_32F, 1. / 255);
    image.at<Vec3f>(10, 10) = Vec3f::all(std::numeric_limits<float>::quiet_NaN());
    image.at<Vec3f>(20, 10) = Vec3f::all(std::numeric_limits<float>::infinity());
    image.at<Vec3f>(30, 10) = Vec3f::all(-1e30f);
    image.at<Vec3f>(40, 10) = Vec3f::all(1e30f);
    const Mat labels = segment(image, GetParam(), 8);
    Mat clipped = image.clone();
    clipped.at<Vec3f>(10, 10) = clipped.at<Vec3f>(30, 10) = Vec3f::all(0);
    clipped.at<Vec3f>(20, 10) = clipped.at<Vec3f>(40, 10) = Vec3f::all(1);
    EXPECT_TRUE(equalMats(segment(clipped, GetParam(), 8), labels));
    double largest;
    minMaxLoc(labels, 0, &largest);
    expectPartition(labels, image.size(), int(largest) + 1);
}

// Floats would hold none of the differences between heights in micrometres, or times.
TEST_P(ximgproc_GWatershed_input, takes_values_far_from_zero)
{
    const Mat image = makeScene(Size(60, 50), theRNG());
    for (int type : { CV_32S, CV_64F })
    {
        const double unit = type == CV_32S ? 1 : 1. / 256;
        Mat near_zero, far_away; // convertTo() from bytes to integers works in floats, too
        image.convertTo(near_zero, CV_64F, unit, 1000);
        image.convertTo(far_away, CV_64F, unit, 1e9);
        near_zero.convertTo(near_zero, type);
        far_away.convertTo(far_away, type);
        EXPECT_TRUE(equalMats(segment(near_zero, GetParam(), 8), segment(far_away, GetParam(), 8))) << type;
    }
}

// A sample of the values would meet none of them.
TEST_P(ximgproc_GWatershed_input, takes_images_of_which_hardly_any_value_is_known)
{
    for (int x : { 100, 350, 600 })
        for (int y : { 75, 575 })
        {
            Mat image(1000, 1000, CV_32F, Scalar(NOT_A_NUMBER));
            image(Rect(x, y, 5, 5)).setTo(Scalar(0.2));
            image(Rect(x + 2, y, 3, 5)).setTo(Scalar(1));
            const Mat labels = segment(image, GetParam(), 25);
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 25);
            gws->setValueRange(0, 1);
            gws->iterate();
            EXPECT_TRUE(equalMats(labelsOf(gws), labels)) << x << ", " << y;
        }
}

TEST_P(ximgproc_GWatershed_input, takes_umat)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(80, 60), rng), depth = makeDepth(image.size(), 0.1, rng);
    UMat uimage, udepth, ulabels;
    image.copyTo(uimage);
    depth.copyTo(udepth);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(uimage, udepth, GetParam());
    gws->iterate();
    gws->getLabels(ulabels);
    EXPECT_TRUE(equalMats(segment(image, depth, GetParam(), 10), ulabels.getMat(ACCESS_READ)));
}

TEST_P(ximgproc_GWatershed_input, takes_submatrices_as_their_clones)
{
    RNG& rng = theRNG();
    const Rect roi(31, 17, 111, 83);
    for (int channels = 1; channels <= 3; channels += 2)
    {
        const Mat image = makeImage(SCENE, Size(170, 120), channels, rng);
        const Mat depth = makeDepth(image.size(), 0.2, rng);
        Mat bytes, floats;
        depth.convertTo(bytes, CV_8U, 1. / 20);
        depth.convertTo(floats, CV_32F, 1. / 1000);
        const Mat depths[] = { depth, bytes, floats };
        EXPECT_TRUE(equalMats(segment(image(roi).clone(), GetParam(), 9), segment(image(roi), GetParam(), 9)));
        for (int i = 0; i < 3; i++)
            EXPECT_TRUE(equalMats(segment(image(roi).clone(), depths[i](roi).clone(), GetParam(), 9),
                                  segment(image(roi), depths[i](roi), GetParam(), 9)));
    }
}

TEST_P(ximgproc_GWatershed_input, never_writes_to_its_input)
{
    RNG& rng = theRNG();
    const Size size(90, 70);
    const int depths[] = { CV_8U, CV_16U, CV_32F };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
        {
            Mat image, depth;
            makeScene(size, rng).convertTo(image, depths[i]);
            makeDepth(size, 0.2, rng).convertTo(depth, depths[j]);
            const Mat image_before = image.clone(), depth_before = depth.clone();
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 3, 50, GetParam());
            for (int repeat = 0; repeat < 3; repeat++)
            {
                gws->iterate(image, depth, 2);
                gws->iterate(image, 2);
                gws->enforceLabelConnectivity();
            }
            EXPECT_TRUE(equalMats(image_before, image));
            EXPECT_TRUE(equalMats(depth_before, depth));
        }
}

TEST_P(ximgproc_GWatershed_input, keeps_a_copy_of_the_image_of_the_factory)
{
    Mat image = makeScene(Size(80, 60), theRNG());
    const Mat expected = segment(image, GetParam(), 10);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 10);
    image.setTo(Scalar::all(0));
    gws->iterate();
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
    gws->iterate(makeScene(Size(70, 50), theRNG()));
    gws->iterate();
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_input, is_not_changed_by_edits_of_the_labels)
{
    const Mat image = makeScene(Size(80, 60), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->iterate();
    Mat labels = labelsOf(gws);
    const Mat before = labels.clone();
    labels.setTo(Scalar(-7));
    EXPECT_TRUE(equalMats(before, labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_input, allocates_outputs_of_another_type_or_size)
{
    const Mat image = makeScene(Size(80, 60), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->iterate();
    Mat labels(3, 5, CV_32FC3), mask(60, 80, CV_16SC1), lines(1, 1, CV_8UC3);
    gws->getLabels(labels);
    gws->getLabelContourMask(mask);
    gws->getWatershedLineMask(lines);
    EXPECT_EQ(CV_32SC1, labels.type());
    EXPECT_EQ(CV_8UC1, mask.type());
    EXPECT_EQ(CV_8UC1, lines.type());
    EXPECT_EQ(image.size(), labels.size());
    EXPECT_EQ(image.size(), mask.size());
    EXPECT_EQ(image.size(), lines.size());
}

TEST_P(ximgproc_GWatershed_input, ignores_depth_that_tells_nothing)
{
    const Mat image = makeScene(Size(120, 90), theRNG());
    const Mat expected = segment(image, GetParam(), 10);
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const float missing[] = { 0.f, -1.f, nan, inf, -inf };
    for (int i = 0; i < 5; i++)
    {
        const Mat depth(image.size(), CV_32FC1, Scalar(missing[i]));
        EXPECT_TRUE(equalMats(expected, segment(image, depth, GetParam(), 10)));
    }
    EXPECT_TRUE(equalMats(expected, segment(image, Mat(image.size(), CV_16UC1, Scalar(0)), GetParam(), 10)));
    EXPECT_TRUE(equalMats(expected, segment(image, Mat(image.size(), CV_8UC1, Scalar(0)), GetParam(), 10)));

    Mat holes(image.size(), CV_8UC1);
    theRNG().fill(holes, RNG::UNIFORM, Scalar::all(0), Scalar::all(2));
    const int types[] = { CV_8UC1, CV_16UC1, CV_32FC1 };
    for (int i = 0; i < 3; i++)
    {
        Mat constant(image.size(), types[i], Scalar(123));
        EXPECT_TRUE(equalMats(expected, segment(image, constant, GetParam(), 10)));
        constant.setTo(Scalar(0), holes);
        EXPECT_TRUE(equalMats(expected, segment(image, constant, GetParam(), 10)));
    }
}

TEST_P(ximgproc_GWatershed_input, takes_millimetres_and_metres_alike)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(120, 90), rng);
    Mat millimetres = makeDepth(image.size(), 0, rng), metres;
    millimetres = millimetres & 0xfff0; // steps that the scaling to bytes keeps apart in both units
    millimetres.convertTo(metres, CV_32F, 1. / 1024);
    const Mat expected = segment(image, millimetres, GetParam(), 10);
    EXPECT_TRUE(equalMats(expected, segment(image, metres, GetParam(), 10)));
    Mat holes;
    rng.fill(holes = Mat(image.size(), CV_8UC1), RNG::UNIFORM, Scalar::all(0), Scalar::all(2));
    millimetres.setTo(Scalar(0), holes);
    metres.setTo(Scalar(std::numeric_limits<float>::quiet_NaN()), holes);
    EXPECT_TRUE(equalMats(segment(image, millimetres, GetParam(), 10), segment(image, metres, GetParam(), 10)));
}

//! Number of labels that occur on both sides of a vertical line.
static int labelsAcross(const Mat& labels, int line)
{
    std::set<int> left, right;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            (x < line ? left : right).insert(labels.at<int>(y, x));
    int both = 0;
    for (std::set<int>::const_iterator it = left.begin(); it != left.end(); ++it)
        both += int(right.count(*it));
    return both;
}

TEST_P(ximgproc_GWatershed_input, cuts_equal_colour_along_a_step_of_depth)
{
    const Mat image(60, 95, CV_8UC3, Scalar(90, 120, 70));
    for (int line = 20; line < 75; line += 5)
    {
        Mat depth(image.size(), CV_16UC1, Scalar(1500));
        depth.colRange(line, depth.cols).setTo(Scalar(1600));
        EXPECT_EQ(0, labelsAcross(segment(image, depth, GetParam(), 12), line)) << line;
        Mat metres;
        depth.convertTo(metres, CV_32F, 0.001);
        EXPECT_EQ(0, labelsAcross(segment(image, metres, GetParam(), 12), line)) << line;
    }
}

TEST_P(ximgproc_GWatershed_input, cuts_equal_depth_along_an_edge_of_colour)
{
    for (int line = 20; line < 75; line += 5)
    {
        Mat image(60, 95, CV_8UC3, Scalar(90, 120, 70)), depth(image.size(), CV_16UC1, Scalar(1500));
        image.colRange(line, image.cols).setTo(Scalar(120, 90, 100));
        depth.rowRange(0, 3).setTo(Scalar(900)); // so that depth is not the same everywhere
        EXPECT_EQ(0, labelsAcross(segment(image, depth, GetParam(), 12).rowRange(6, 60), line)) << line;
    }
}

TEST_P(ximgproc_GWatershed_input, finds_the_range_of_depth_in_long_strips)
{
    const Mat image(1, 70000, CV_8UC1, Scalar(90));
    Mat depth(image.size(), CV_32FC1, Scalar(1.5));
    depth.colRange(33333, depth.cols).setTo(Scalar(1.6));
    depth.at<float>(0, 100) = 1e6f;
    EXPECT_EQ(0, labelsAcross(segment(image, depth, GetParam(), 100).colRange(1000, 70000), 32333));
}

TEST_P(ximgproc_GWatershed_input, takes_the_smallest_differences_of_depth)
{
    Mat depth(8, 8, CV_32FC1, Scalar(1e-38));
    depth.at<float>(3, 3) = 2e-38f;
    const Mat image(8, 8, CV_8UC1, Scalar(90));
    expectPartition(segment(image, depth, GetParam(), 4), image.size(), 4);
}

TEST_P(ximgproc_GWatershed_input, is_not_ruined_by_outliers_of_depth)
{
    Mat image(60, 96, CV_8UC3, Scalar(90, 120, 70)), depth(image.size(), CV_16UC1, Scalar(1500));
    depth.colRange(50, depth.cols).setTo(Scalar(1600));
    depth.at<ushort>(3, 4) = 65535; // if this pixel were the maximum, the step would vanish
    depth.at<ushort>(40, 80) = 1;
    Mat labels = segment(image, depth, GetParam(), 12);
    EXPECT_EQ(0, labelsAcross(labels.rowRange(10, 34), 50));
}

TEST_P(ximgproc_GWatershed_input, uses_the_range_of_depth_it_is_given)
{
    Mat image(60, 96, CV_8UC3, Scalar(90, 120, 70)), depth(image.size(), CV_16UC1, Scalar(1500));
    depth.colRange(50, depth.cols).setTo(Scalar(1600));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam(), 12);
    gws->setDepthRange(1000, 2000);
    gws->iterate();
    EXPECT_EQ(0, labelsAcross(labelsOf(gws), 50));
    gws->setDepthRange(2000, 3000); // both sides are nearer than the range: the same depth
    gws->iterate();
    EXPECT_TRUE(equalMats(segment(image, GetParam(), 12), labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_input, reused_object_equals_a_fresh_one)
{
    RNG& rng = theRNG();
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(64, 48, 3, 30, GetParam());
    for (int i = 0; i < 40; i++)
    {
        const Size size(rng.uniform(1, 120), rng.uniform(1, 120));
        const int channels = i % 3 ? 3 : 1;
        Mat image = makeImage(ImageKind(i % IMAGE_KINDS), size, channels, rng);
        const Mat depth = makeDepth(size, 0.2, rng);
        image.convertTo(image, i % 2 ? CV_8U : CV_16U, i % 2 ? 1 : 257);
        Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(size.width, size.height, channels, 30, GetParam());
        if (i % 4)
        {
            gws->iterate(image);
            fresh->iterate(image);
        }
        else
        {
            gws->iterate(image, depth);
            fresh->iterate(image, depth);
        }
        EXPECT_TRUE(equalMats(labelsOf(fresh), labelsOf(gws))) << i;
        if (i % 5 == 0)
            gws->enforceLabelConnectivity(60);
    }
}

//! Uses the standard allocator and remembers the largest allocation.
class RecordingAllocator CV_FINAL : public MatAllocator
{
public:
    RecordingAllocator() : largest(0) {}
    UMatData* allocate(int dims, const int* sizes, int type, void* data, size_t* step, AccessFlag flags,
                       UMatUsageFlags usage) const CV_OVERRIDE
    {
        UMatData* u = Mat::getStdAllocator()->allocate(dims, sizes, type, data, step, flags, usage);
        largest = std::max(largest, u->size);
        return u;
    }
    bool allocate(UMatData* data, AccessFlag access, UMatUsageFlags usage) const CV_OVERRIDE
    {
        return Mat::getStdAllocator()->allocate(data, access, usage);
    }
    void deallocate(UMatData* data) const CV_OVERRIDE { Mat::getStdAllocator()->deallocate(data); }

    mutable size_t largest;
};

TEST_P(ximgproc_GWatershed_input, allocates_nothing_large_for_the_second_image_of_a_size)
{
    ThreadsGuard one(1);
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(640, 480), rng), depth = makeDepth(image.size(), 0.2, rng);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(640, 480, 3, 768, GetParam());
    gws->iterate(image, depth);

    RecordingAllocator mats;
    const AllocatorGuard guard(&mats);
    const NewRecorder news;
    gws->iterate(image, depth);
    EXPECT_LT(mats.largest, image.total() / 2) << "bytes in a Mat; one for each pixel would be " << image.total();
    EXPECT_LT(news.largest(), image.total() / 2) << "bytes by new";
}

//! Differences of the levels from 0 to 255 that values in a row become.
std::vector<float> stepsOf(const Mat& values, float low, float high, int algorithm)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(values.cols, 1, 1, values.cols, algorithm);
    gws->setValueRange(low, high);
    gws->iterate(values);
    std::vector<float> contrasts;
    gws->getAdjacency(values, noArray(), noArray(), noArray(), contrasts);
    return contrasts;
}

TEST_P(ximgproc_GWatershed_input, takes_the_range_that_is_set_for_8_bits_too)
{
    const uchar values[] = { 90, 95, 95, 102, 115, 7, 200 };
    const float expected[] = { 51, 0, 71.4f, 132.6f, 255, 255 };
    const std::vector<float> steps = stepsOf(Mat(1, 7, CV_8UC1, const_cast<uchar*>(values)), 90, 115, GetParam());
    ASSERT_EQ(6u, steps.size());
    for (int i = 0; i < 6; i++)
        EXPECT_NEAR(expected[i], steps[i], 1) << i;
    const Mat scene = makeScene(Size(90, 70), theRNG()), dark = scene / 10;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(dark, GetParam());
    gws->setValueRange(0, 25.5f);
    gws->iterate();
    Mat stretched;
    dark.convertTo(stretched, CV_8U, 10);
    EXPECT_TRUE(equalMats(segment(stretched, GetParam(), 10), labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_input, takes_values_of_any_magnitude)
{
    for (const double top : { 1e-38, 1e-30, 1e30, 2e38, 3.4e38, 1e-300, 1e-100, 1e39, 1e100, 1.7e308 })
        for (const int low : { 0, -1 })
            for (const bool set : { false, true })
            {
                const bool as_float = top > 1e-39 && top < 1e39;
                if (set && !as_float)
                    continue;
                Mat values(1, 20, as_float ? CV_32FC1 : CV_64FC1);
                for (int i = 0; i < 20; i++)
                {
                    const double value = top * (low + (1 - low) * i / 19.);
                    if (as_float)
                        values.at<float>(i) = float(value);
                    else
                        values.at<double>(i) = value;
                }
                const float end = set ? float(top) : 0.f;
                const std::vector<float> steps = stepsOf(values, float(low) * end, end, GetParam());
                ASSERT_EQ(19u, steps.size());
                for (const float step : steps)
                    EXPECT_NEAR(255 / 19., step, 1) << top << ", from " << low << ", " << set;
            }
}

TEST_P(ximgproc_GWatershed_input, copies_no_float_image_with_few_numbers)
{
    ThreadsGuard one(1);
    RNG& rng = theRNG();
    Mat image(1000, 1000, CV_32FC3, Scalar::all(std::numeric_limits<double>::quiet_NaN()));
    for (int i = 0; i < 20000; i++)
        image.at<Vec3f>(rng.uniform(0, image.rows), rng.uniform(0, image.cols)) =
                Vec3f(float(rng), float(rng), float(rng));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(1000, 1000, 3, 100, GetParam());
    const NewRecorder news;
    gws->iterate(image);
    EXPECT_LT(news.largest(), image.total() * image.elemSize() / 4);
}

// As that of a laser scanner.
TEST_P(ximgproc_GWatershed_input, copies_no_depth_with_few_numbers)
{
    ThreadsGuard one(1);
    RNG& rng = theRNG();
    const Mat image = makeImage(FLAT, Size(1000, 1000), 1, rng);
    Mat depth = Mat::zeros(image.size(), CV_32FC1);
    for (int i = 0; i < 2000; i++)
        depth.at<float>(rng.uniform(0, depth.rows), rng.uniform(0, depth.cols)) = rng.uniform(1.f, 3.f);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(1000, 1000, 1, 100, GetParam());
    const NewRecorder news;
    gws->iterate(image, depth);
    EXPECT_LT(news.largest(), depth.total());
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_input, testing::ValuesIn(ALGORITHMS));

}} // namespace
