// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// What comes after the segmentation: statistics, adjacency, merging; against brute force.

typedef testing::TestWithParam<int> ximgproc_GWatershed_pipeline;

//! Segments a scene, inside of a mask where i is odd.
Ptr<SuperpixelGWatershed> segmentScene(int algorithm, Size size, int i, const Mat& image, RNG& rng)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, algorithm, rng.uniform(3, 25));
    if (i % 2)
        gws->setMask(makeMask(MaskKind(i / 2 % MASK_KINDS), size, rng));
    gws->iterate();
    return gws;
}

TEST_P(ximgproc_GWatershed_pipeline, statistics_equal_brute_force)
{
    RNG& rng = theRNG();
    const int types[] = { CV_8UC3, CV_8UC1, CV_16UC3, CV_16SC2, CV_8SC4, CV_32SC1, CV_32FC3, CV_64FC(7) };
    for (int i = 0; i < 48; i++)
    {
        const Size size(rng.uniform(1, 200), rng.uniform(1, 150));
        Ptr<SuperpixelGWatershed> gws = segmentScene(GetParam(), size, i, makeScene(size, rng), rng);
        Mat values(size, types[i % 8]), depth = makeDepth(size, 0.4, rng), single = values.reshape(1);
        rng.fill(single, RNG::UNIFORM, Scalar::all(0), Scalar::all(100));
        if (i % 3 == 0)
        {
            depth.convertTo(depth, CV_32F, 0.001);
            depth.setTo(Scalar(std::numeric_limits<float>::quiet_NaN()), depth == 0);
            depth.at<float>(0, 0) = std::numeric_limits<float>::infinity();
        }
        Mat stats, centroids, colors, depths;
        gws->getStatistics(values, depth, stats, centroids, colors, depths);

        const int n = gws->getNumberOfSuperpixels(), channels = values.channels();
        const Mat labels = labelsOf(gws);
        ASSERT_EQ(Size(5, n), stats.size());
        if (n == 0)
            continue;
        ASSERT_EQ(Size(2, n), centroids.size());
        ASSERT_EQ(Size(channels, n), colors.size());
        ASSERT_EQ(Size(1, n), depths.size());
        ASSERT_EQ(CV_32SC1, stats.type());
        ASSERT_EQ(CV_64FC1, centroids.type());
        ASSERT_EQ(CV_32FC1, colors.type());
        ASSERT_EQ(CV_32FC1, depths.type());
        Mat plain_values, plain_depth;
        values.reshape(1).convertTo(plain_values, CV_64F);
        depth.convertTo(plain_depth, CV_64F);
        int area = 0;
        for (int k = 0; k < n; k++)
        {
            std::vector<Point> points;
            findNonZero(labels == k, points);
            const Rect box = boundsOf(points);
            EXPECT_EQ(box, Rect(stats.at<int>(k, CC_STAT_LEFT), stats.at<int>(k, CC_STAT_TOP),
                                stats.at<int>(k, CC_STAT_WIDTH), stats.at<int>(k, CC_STAT_HEIGHT)));
            EXPECT_EQ(int(points.size()), stats.at<int>(k, CC_STAT_AREA));
            area += stats.at<int>(k, CC_STAT_AREA);
            Point2d sum(0, 0);
            std::vector<double> sums(channels, 0.);
            double depth_sum = 0, valid = 0;
            for (size_t p = 0; p < points.size(); p++)
            {
                sum += Point2d(points[p]);
                for (int c = 0; c < channels; c++)
                    sums[c] += plain_values.at<double>(points[p].y, points[p].x * channels + c);
                const double d = plain_depth.at<double>(points[p]);
                if (d > 0 && d < 1e30)
                {
                    depth_sum += d;
                    valid++;
                }
            }
            EXPECT_NEAR(sum.x / points.size(), centroids.at<double>(k, 0), 1e-9);
            EXPECT_NEAR(sum.y / points.size(), centroids.at<double>(k, 1), 1e-9);
            for (int c = 0; c < channels; c++)
                EXPECT_NEAR(sums[c] / points.size(), colors.at<float>(k, c), 1e-5);
            if (valid > 0)
                EXPECT_NEAR(depth_sum / valid, depths.at<float>(k), 1e-6 * depth_sum / valid);
            else
                EXPECT_TRUE(cvIsNaN(depths.at<float>(k)));
        }
        EXPECT_EQ(countNonZero(labels >= 0), area);
    }
}

TEST_P(ximgproc_GWatershed_pipeline, statistics_are_the_same_for_any_number_of_threads)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(320, 240), rng);
    Mat values(image.size(), CV_32FC3), depth(image.size(), CV_32FC1), expected[6];
    rng.fill(values, RNG::NORMAL, Scalar::all(0), Scalar::all(1));
    rng.fill(depth, RNG::UNIFORM, Scalar::all(0.5), Scalar::all(8));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 12);
    gws->iterate();
    for (int threads = 1; threads <= 8; threads++)
    {
        ThreadsGuard guard(threads);
        Mat tables[6];
        gws->getStatistics(values, depth, tables[0], tables[1], tables[2], tables[3], tables[4], tables[5]);
        for (int i = 0; i < 6; i++)
        {
            if (threads == 1)
                expected[i] = tables[i].clone();
            EXPECT_TRUE(equalMats(expected[i], tables[i])) << threads << " threads, table " << i;
        }
    }
}

//! Equations (1) to (3) between two pixels of CV_8UC3 and CV_8UC1 depth.
int pixelDistance(const Mat& image, const Mat& depth, Point p, Point q, int alpha)
{
    const Vec3b a = image.at<Vec3b>(p), b = image.at<Vec3b>(q);
    int color = 0;
    for (int c = 0; c < 3; c++)
        color = std::max(color, std::abs(a[c] - b[c]));
    if (depth.empty() || !depth.at<uchar>(p) || !depth.at<uchar>(q))
        return color;
    return (alpha * color + (256 - alpha) * std::abs(depth.at<uchar>(p) - depth.at<uchar>(q)) + 128) / 256;
}

TEST_P(ximgproc_GWatershed_pipeline, adjacency_equals_brute_force)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 40; i++)
    {
        const Size size(rng.uniform(1, 160), rng.uniform(1, 120));
        const Mat image = makeScene(size, rng);
        Mat depth, plain_depth;
        if (i % 3 == 0)
        {
            depth = makeDepth(size, 0.2, rng);
            depth.convertTo(depth, CV_8U, 0.05);
            plain_depth = depth;
        }
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), rng.uniform(3, 25));
        if (i % 2)
            gws->setMask(makeMask(MaskKind(i / 2 % MASK_KINDS), size, rng));
        gws->setAlpha(0.25f);
        gws->iterate();
        gws->setAlpha(0.75f); // not before the next iterate()
        Mat pairs, lengths, contrasts;
        gws->getAdjacency(image, depth, pairs, lengths, contrasts);

        const Mat labels = labelsOf(gws);
        std::map<std::pair<int, int>, std::pair<int, double> > expected; // pair of labels: length, sum of contrasts
        for (int y = 0; y < size.height; y++)
            for (int x = 0; x < size.width; x++)
                for (int k = 0; k < 2; k++)
                {
                    const Point p(x, y), q = k ? Point(x, y + 1) : Point(x + 1, y);
                    if (!Rect(Point(), size).contains(q))
                        continue;
                    const int a = std::min(labels.at<int>(p), labels.at<int>(q));
                    const int b = std::max(labels.at<int>(p), labels.at<int>(q));
                    if (a == b || a < 0)
                        continue;
                    std::pair<int, double>& edge = expected[std::make_pair(a, b)];
                    edge.first++;
                    edge.second += pixelDistance(image, plain_depth, p, q, 64);
                }
        ASSERT_EQ(expected.size(), pairs.empty() ? 0u : size_t(pairs.rows));
        if (expected.empty())
            continue;
        ASSERT_EQ(CV_32SC1, pairs.type());
        ASSERT_EQ(CV_32SC1, lengths.type());
        ASSERT_EQ(CV_32FC1, contrasts.type());
        ASSERT_EQ(Size(2, pairs.rows), pairs.size());
        ASSERT_EQ(Size(1, pairs.rows), lengths.size());
        ASSERT_EQ(Size(1, pairs.rows), contrasts.size());
        int row = 0;
        std::map<std::pair<int, int>, std::pair<int, double> >::iterator e = expected.begin();
        for (; e != expected.end(); ++e, row++)
        {
            EXPECT_EQ(e->first.first, pairs.at<int>(row, 0));
            EXPECT_EQ(e->first.second, pairs.at<int>(row, 1));
            EXPECT_EQ(e->second.first, lengths.at<int>(row));
            EXPECT_NEAR(e->second.second / e->second.first, contrasts.at<float>(row), 1e-4);
        }
    }
}

TEST_P(ximgproc_GWatershed_pipeline, contrasts_do_not_see_depth_outside_of_the_mask)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(120, 90), rng), depth = makeDepth(image.size(), 0.1, rng);
    Mat mask = Mat::zeros(image.size(), CV_8UC1), other = depth.clone();
    circle(mask, Point(60, 45), rng.uniform(30, 50), Scalar(255), FILLED);
    other.setTo(Scalar(60000), mask == 0);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 9);
    gws->setMask(mask);
    gws->iterate(image, depth);
    Mat pairs, lengths, contrasts, contrasts_of_other;
    gws->getAdjacency(image, depth, pairs, lengths, contrasts);
    gws->getAdjacency(image, other, pairs, lengths, contrasts_of_other);
    EXPECT_GT(pairs.rows, 20);
    EXPECT_TRUE(equalMats(contrasts, contrasts_of_other));
}

//! Number of pieces of a graph of n nodes.
int countGraphPieces(const Mat& pairs, int n)
{
    std::vector<int> parents(n);
    for (int i = 0; i < n; i++)
        parents[i] = i;
    int pieces = n;
    for (int i = 0; i < pairs.rows; i++)
    {
        int a = pairs.at<int>(i, 0), b = pairs.at<int>(i, 1);
        while (parents[a] != a)
            a = parents[a];
        while (parents[b] != b)
            b = parents[b];
        pieces -= a != b;
        parents[a] = b;
    }
    return pieces;
}

TEST_P(ximgproc_GWatershed_pipeline, adjacency_is_connected)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 2 * IMAGE_KINDS; i++)
    {
        const Mat image = makeImage(ImageKind(i / 2), Size(130, 100), 3, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 5);
        Mat mask;
        if (i % 2)
            mask = makeMask(DISCS, image.size(), rng);
        gws->setMask(mask);
        gws->iterate();
        Mat pairs, lengths;
        gws->getAdjacency(noArray(), noArray(), pairs, lengths, noArray());
        EXPECT_EQ(mask.empty() ? 1 : countMaskPieces(mask), countGraphPieces(pairs, gws->getNumberOfSuperpixels()));
    }
}

//! Whether each superpixel of the finer map lies in one of the coarser.
bool isNested(const Mat& fine, const Mat& coarse, int num_fine)
{
    std::vector<int> parents(num_fine, -2);
    for (int y = 0; y < fine.rows; y++)
        for (int x = 0; x < fine.cols; x++)
        {
            const int label = fine.at<int>(y, x);
            if (label < 0 && coarse.at<int>(y, x) >= 0)
                return false;
            if (label < 0)
                continue;
            if (parents[label] != -2 && parents[label] != coarse.at<int>(y, x))
                return false;
            parents[label] = coarse.at<int>(y, x);
        }
    return true;
}

TEST_P(ximgproc_GWatershed_pipeline, merging_gives_nested_partitions)
{
    RNG& rng = theRNG();
    for (int i = 0; i < 2 * IMAGE_KINDS; i++)
    {
        const Size size(160, 120);
        const Mat image = makeImage(ImageKind(i / 2), size, 3, rng), depth = makeDepth(size, 0.2, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, 3, 600);
        gws->setAlgorithm(GetParam());
        if (i % 4 == 3)
        {
            Mat mask(size, CV_8UC1, Scalar(255));
            circle(mask, Point(100, 50), 20, Scalar(0), FILLED);
            gws->setMask(mask);
        }
        if (i % 2)
            gws->iterate(image, depth);
        else
            gws->iterate(image);
        Mat finer = labelsOf(gws);
        const Mat first = finer;
        std::map<int, Mat> levels;
        const int numbers[] = { 500, 200, 50, 7, 1 }; // the mask is one piece
        int before = 600;
        for (int k = 0; k < 5; k++)
        {
            gws->mergeSimilar(numbers[k]);
            const Mat labels = labelsOf(gws);
            ASSERT_EQ(numbers[k], gws->getNumberOfSuperpixels());
            if (i % 4 == 3)
                ASSERT_NO_FATAL_FAILURE(expectMaskedPartition(labels, labels >= 0, numbers[k]));
            else
                ASSERT_NO_FATAL_FAILURE(expectPartition(labels, size, numbers[k]));
            EXPECT_TRUE(isNested(finer, labels, before));
            levels[numbers[k]] = finer = labels;
            before = numbers[k];
        }
        gws->mergeSimilar(200); // back up, and the same as before
        EXPECT_TRUE(equalMats(levels[200], labelsOf(gws)));
        gws->mergeSimilar(1000);
        EXPECT_TRUE(equalMats(first, labelsOf(gws)));
        gws->mergeSimilar(50);
        EXPECT_TRUE(equalMats(levels[50], labelsOf(gws)));
    }
}

TEST_P(ximgproc_GWatershed_pipeline, merging_starts_from_what_was_merged_for_size)
{
    const Mat image = makeImage(NOISE, Size(120, 90), 3, theRNG());
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 6);
    gws->iterate();
    gws->mergeSimilar(200);
    gws->enforceLabelConnectivity(80);
    const Mat labels = labelsOf(gws);
    const int n = gws->getNumberOfSuperpixels();
    gws->mergeSimilar(20);
    gws->enforceLabelConnectivity(0); // merges nothing, so the finer levels are still there
    EXPECT_TRUE(isNested(labels, labelsOf(gws), n));
    gws->mergeSimilar(10000);
    EXPECT_TRUE(equalMats(labels, labelsOf(gws)));
}

TEST_P(ximgproc_GWatershed_pipeline, merging_finds_what_is_alike)
{
    Mat image(120, 160, CV_8UC3, Scalar(60, 130, 90));
    image(Rect(0, 0, 77, 50)).setTo(Scalar(200, 30, 30));
    circle(image, Point(110, 75), 30, Scalar(20, 200, 220), FILLED);
    Mat things = Mat::zeros(image.size(), CV_32SC1);
    things(Rect(0, 0, 77, 50)).setTo(Scalar(1));
    circle(things, Point(110, 75), 30, Scalar(2), FILLED);
    Mat noise(image.size(), CV_8UC3);
    theRNG().fill(noise, RNG::UNIFORM, Scalar::all(0), Scalar::all(8));
    image += noise;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 8);
    gws->iterate();
    const int n = gws->getNumberOfSuperpixels();
    const Mat labels = labelsOf(gws);
    gws->mergeSimilar(3);
    EXPECT_TRUE(isNested(labels, labelsOf(gws), n));
    int wrong = 0; // pixels outside of the thing that holds most of their superpixel
    for (int k = 0; k < 3; k++)
    {
        int most = 0;
        for (int t = 0; t < 3; t++)
            most = std::max(most, countNonZero((labelsOf(gws) == k) & (things == t)));
        wrong += countNonZero(labelsOf(gws) == k) - most;
    }
    EXPECT_LT(wrong, 60);
}

// In noise, a boundary has as much contrast as all others: what tells the sides apart is their mean depth.
TEST_P(ximgproc_GWatershed_pipeline, merging_finds_what_is_as_far)
{
    const Size size(160, 120);
    const Mat image(size, CV_8UC3, Scalar::all(120));
    Mat disc = Mat::zeros(size, CV_8UC1), depth(size, CV_16UC1, Scalar(1000)), noise(size, CV_16SC1);
    ellipse(disc, Point(80, 60), Size(50, 35), 20, 0, 360, Scalar(1), FILLED);
    depth.setTo(Scalar(1400), disc);
    theRNG().fill(noise, RNG::NORMAL, 0, 90);
    cv::add(depth, noise, depth, noArray(), CV_16U);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, GetParam(), 8);
    gws->setNormalWeight(0);
    gws->iterate();
    for (int number : { 20, 5, 2 })
    {
        gws->mergeSimilar(number);
        EXPECT_GT(purity(labelsOf(gws), number, disc), 0.99) << number;
    }
}

TEST_P(ximgproc_GWatershed_pipeline, merging_does_not_cross_the_outside)
{
    RNG& rng = theRNG();
    for (int i = 0; i < MASK_KINDS; i++)
    {
        const Mat image = makeScene(Size(110, 80), rng), mask = makeMask(MaskKind(i), image.size(), rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 5);
        gws->setMask(mask);
        gws->iterate();
        gws->mergeSimilar(1);
        EXPECT_EQ(countMaskPieces(mask), gws->getNumberOfSuperpixels());
        expectMaskedPartition(labelsOf(gws), mask, gws->getNumberOfSuperpixels());
    }
}

// Iterations read the colours anew.
TEST_P(ximgproc_GWatershed_pipeline, iterates_images_of_every_number_of_channels_alike)
{
    const Mat image = makeScene(Size(97, 61), theRNG());
    Mat gray, three, four;
    cvtColor(image, gray, COLOR_BGR2GRAY);
    cvtColor(gray, three, COLOR_GRAY2BGR);
    cvtColor(image, four, COLOR_BGR2BGRA);
    const Mat pairs[2][2] = { { gray, three }, { image, four } };
    for (const Mat (&pair)[2] : pairs)
    {
        Mat labels[2];
        for (int i = 0; i < 2; i++)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(pair[i], GetParam(), 9);
            gws->iterate(4);
            labels[i] = labelsOf(gws);
        }
        EXPECT_TRUE(equalMats(labels[0], labels[1])) << pair[0].channels();
    }
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_pipeline, testing::ValuesIn(ALGORITHMS));

}} // namespace
