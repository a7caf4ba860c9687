// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// setMarkers(): superpixels grow from markers of the user. test_reference.cpp compares Algorithm 1 pixel by pixel.

typedef testing::TestWithParam<int> ximgproc_GWatershed_markers;

//! Values inside of the mask, in their order.
std::vector<int> valuesOf(const Mat& markers, const Mat& mask)
{
    std::set<int> values;
    for (int y = 0; y < markers.rows; y++)
        for (int x = 0; x < markers.cols; x++)
            if (markers.at<int>(y, x) > 0 && (mask.empty() || mask.at<uchar>(y, x)))
                values.insert(markers.at<int>(y, x));
    return std::vector<int>(values.begin(), values.end());
}

//! Number of connected pieces of pixels of equal value in a map, those below `first` aside.
int countPiecesFrom(const Mat& map, int first)
{
    Mat own = map.clone();
    int next = 1 << 30, aside = 0;
    for (int y = 0; y < map.rows; y++)
        for (int x = 0; x < map.cols; x++)
            if (map.at<int>(y, x) < first)
            {
                own.at<int>(y, x) = next++;
                aside++;
            }
    return countPieces(own) - aside;
}

void expectGrownFromMarkers(const Mat& labels, const Mat& markers, const Mat& mask, int num_labels)
{
    const std::vector<int> values = valuesOf(markers, mask);
    ASSERT_EQ(int(values.size()), num_labels);
    Mat inside = markers.clone();
    if (!mask.empty())
        inside.setTo(Scalar(0), mask == 0);
    Mat pieces; // of the mask, or of the image
    cv::connectedComponents(mask.empty() ? Mat(labels.size(), CV_8UC1, Scalar(1)) : mask, pieces, 4);
    std::set<int> reached;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            if (inside.at<int>(y, x) > 0)
            {
                reached.insert(pieces.at<int>(y, x));
                ASSERT_EQ(values[labels.at<int>(y, x)], inside.at<int>(y, x)) << Point(x, y);
            }
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            if (reached.count(pieces.at<int>(y, x)) && pieces.at<int>(y, x) > 0)
                ASSERT_GE(labels.at<int>(y, x), 0) << Point(x, y);
            else
                ASSERT_EQ(-1, labels.at<int>(y, x)) << Point(x, y);
        }
    EXPECT_LE(countPiecesFrom(labels, 0), countPiecesFrom(inside, 1));
}

TEST_P(ximgproc_GWatershed_markers, every_marker_keeps_its_pixels)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 150; i++)
    {
        const Size size(rng.uniform(1, 140), rng.uniform(1, 110));
        const Mat image = makeImage(ImageKind(i % IMAGE_KINDS), size, i % 4 ? 3 : 1, rng);
        const Mat markers = makeMarkers(size, rng.uniform(1, 60), rng), depth = makeDepth(size, 0.2, rng);
        const Mat mask = i % 3 == 0 ? makeMask(MaskKind(i / 3 % MASK_KINDS), size, rng) : Mat();
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
        gws->setMarkers(markers);
        gws->setMask(mask);
        if (i % 2)
            gws->iterate(image, depth, 1 + i % 4);
        else
            gws->iterate(1 + i % 4);
        ASSERT_NO_FATAL_FAILURE(expectGrownFromMarkers(labelsOf(gws), markers, mask, gws->getNumberOfSuperpixels()))
                << "case " << i << ", " << size;
    }
}

TEST_P(ximgproc_GWatershed_markers, takes_more_markers_than_16_bits_count)
{
    const Size size(300, 300);
    const Mat image = makeScene(size, theRNG());
    Mat markers(size, CV_32SC1);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
            markers.at<int>(y, x) = (x + y) % 5 == 0 ? 0 : 7 + 3 * (y * size.width + x);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMarkers(markers);
    gws->iterate();
    EXPECT_EQ(72000, gws->getNumberOfSuperpixels());
    expectGrownFromMarkers(labelsOf(gws), markers, Mat(), gws->getNumberOfSuperpixels());
}

TEST_P(ximgproc_GWatershed_markers, floods_up_to_edges)
{
    Mat image(60, 80, CV_8UC3, Scalar(40, 60, 200));
    circle(image, Point(37, 28), 18, Scalar(200, 120, 30), FILLED);
    Mat markers = Mat::zeros(image.size(), CV_32SC1);
    markers.at<int>(28, 37) = 9;
    markers.row(0).setTo(Scalar(4));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMarkers(markers);
    gws->iterate();
    Mat disc = Mat::zeros(image.size(), CV_8UC1);
    circle(disc, Point(37, 28), 18, Scalar(255), FILLED);
    EXPECT_EQ(0, countNonZero((labelsOf(gws) == 1) != disc));
}

TEST_P(ximgproc_GWatershed_markers, no_marker_gives_no_superpixel)
{
    const Mat image = makeScene(Size(50, 40), theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMarkers(Mat(image.size(), CV_32SC1, Scalar(-1)));
    gws->iterate();
    EXPECT_EQ(0, gws->getNumberOfSuperpixels());
    EXPECT_EQ(0, countNonZero(labelsOf(gws) != -1));
    gws->setMarkers(noArray());
    gws->iterate();
    expectPartition(labelsOf(gws), image.size(), gws->getNumberOfSuperpixels());
}

TEST_P(ximgproc_GWatershed_markers, are_copied_and_never_written_to)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(90, 70), rng);
    const Mat markers = makeMarkers(image.size(), 20, rng), before = markers.clone();
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMarkers(markers);
    gws->iterate(3);
    EXPECT_TRUE(equalMats(before, markers));
    const Mat expected = labelsOf(gws);
    Mat wide;
    cv::copyMakeBorder(markers, wide, 2, 3, 4, 5, BORDER_CONSTANT, Scalar(5));
    gws->setMarkers(wide(Rect(Point(4, 2), markers.size())));
    wide.setTo(Scalar(1));
    gws->iterate(3);
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_markers, effort_has_no_effect)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 300; i++)
    {
        Mat image(rng.uniform(1, 15), rng.uniform(1, 25), CV_8UC1);
        rng.fill(image, RNG::UNIFORM, 0, 256);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
        gws->setMarkers(makeMarkers(image.size(), 3, rng));
        gws->iterate();
        const Mat expected = labelsOf(gws);
        for (int effort : { 0, 2, 3 })
        {
            gws->setEffort(effort);
            gws->iterate();
            EXPECT_TRUE(equalMats(expected, labelsOf(gws))) << i << ", " << effort;
        }
    }
}

// A marker of one pixel begins with the noise of that, and still gets its share.
TEST_P(ximgproc_GWatershed_markers, many_points_in_noise_share_the_image)
{
    const Size size(512, 480);
    Mat image(size, CV_8UC3), noise(size, CV_8SC3), markers = Mat::zeros(size, CV_32SC1);
    theRNG().fill(noise, RNG::NORMAL, Scalar::all(0), Scalar::all(5));
    cv::add(Mat(size, CV_8UC3, Scalar(90, 80, 70)), noise, image, noArray(), CV_8U);
    int count = 0;
    for (int y = 10; y < size.height; y += 20)
        for (int x = 10; x < size.width; x += 20)
            markers.at<int>(y, x) = ++count;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMarkers(markers);
    gws->iterate();
    Mat stats;
    gws->getStatistics(noArray(), noArray(), stats, noArray());
    const Mat areas = stats.col(CC_STAT_AREA);
    const double mean = double(size.area()) / count;
    double largest;
    minMaxLoc(areas, 0, &largest);
    EXPECT_LT(largest, 4 * mean);
    EXPECT_LT(countNonZero(areas < mean / 20), count / 4);
}

// The background has two colours, of which the object has the mean.
TEST_P(ximgproc_GWatershed_markers, two_separate_an_object_from_its_background)
{
    Mat image(120, 160, CV_8UC1, Scalar(60)), disc = Mat::zeros(image.size(), CV_8UC1);
    image.colRange(80, 160).setTo(Scalar(180));
    circle(disc, Point(80, 60), 30, Scalar(255), FILLED);
    image.setTo(Scalar(120), disc);
    Mat markers = Mat::zeros(image.size(), CV_32SC1);
    rectangle(markers, Rect(Point(), image.size()), Scalar(2), 3);
    circle(markers, Point(80, 60), 8, Scalar(1), FILLED);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
    gws->setMarkers(markers);
    for (int iterations : { 1, 5 })
    {
        gws->iterate(iterations);
        EXPECT_EQ(2, gws->getNumberOfSuperpixels());
        const Mat found = labelsOf(gws) == 0;
        EXPECT_GT(double(countNonZero(found & disc)) / countNonZero(found | disc), 0.95) << iterations;
    }
}

// Parts of markers are joined where the explained variation is what further iterations go by.
TEST_P(ximgproc_GWatershed_markers, more_iterations_of_few_explain_no_less)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 10; i++)
    {
        const Mat image = makeScene(Size(120, 90), rng);
        Mat markers = Mat::zeros(image.size(), CV_32SC1);
        for (int k = 1; k < 10; k++)
            line(markers, Point(rng.uniform(0, 120), rng.uniform(0, 90)),
                 Point(rng.uniform(0, 120), rng.uniform(0, 90)), Scalar(k), 2);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam());
        gws->setMarkers(markers);
        double before = 0;
        for (int iterations = 1; iterations < 8; iterations++)
        {
            gws->iterate(iterations);
            const double now = explainedVariation(labelsOf(gws), image);
            EXPECT_GE(now, before - 1e-9) << i << ", " << iterations;
            before = now;
        }
    }
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_markers, testing::ValuesIn(ALGORITHMS));

}} // namespace
