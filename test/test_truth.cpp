// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// Pictures whose things are known, as far as others are not asked of already: how many pixels lie in a superpixel of
// which more is of another thing.

struct Drawing
{
    Mat image, things;
};

//! Ellipses and boxes of many greys, or colours, with soft edges.
Drawing drawThings(int type, RNG& rng)
{
    const Size size(320, 240);
    const auto anyColor = [&]() { return Scalar(rng.uniform(30, 226), rng.uniform(30, 226), rng.uniform(30, 226)); };
    Drawing drawing = { Mat(size, type, anyColor()), Mat::zeros(size, CV_8UC1) };
    for (int i = 1; i <= 14; i++)
    {
        const Point center(rng.uniform(0, size.width), rng.uniform(0, size.height));
        const Size half(rng.uniform(12, 70), rng.uniform(12, 50));
        const RotatedRect box(center, Size2f(float(2 * half.width), float(2 * half.height)), rng.uniform(0.f, 180.f));
        Point2f corners[4];
        box.points(corners);
        std::vector<Point> polygon(corners, corners + 4);
        const Scalar color = anyColor();
        if (i % 2)
        {
            ellipse(drawing.image, box, color, FILLED);
            ellipse(drawing.things, box, Scalar(i), FILLED);
        }
        else
        {
            fillConvexPoly(drawing.image, polygon, color);
            fillConvexPoly(drawing.things, polygon, Scalar(i));
        }
    }
    GaussianBlur(drawing.image, drawing.image, Size(3, 3), 0);
    return drawing;
}

//! Share of the pixels in superpixels of other things.
double wrongShare(const Ptr<SuperpixelGWatershed>& gws, const Mat& things)
{
    return 1 - purity(labelsOf(gws), gws->getNumberOfSuperpixels(), things);
}

//! The mean of a measure over some drawings, in superpixels of 20x20 pixels.
double meanOverDrawings(int type, int seed, int effort,
                        const std::function<double(const Ptr<SuperpixelGWatershed>&, const Mat& things)>& measure)
{
    const int pictures = 12;
    double mean = 0;
    RNG rng(seed);
    for (int i = 0; i < pictures; i++)
    {
        const Drawing drawing = drawThings(type, rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(drawing.image, RGWATERSHED, 20);
        gws->setEffort(effort);
        gws->iterate();
        mean += measure(gws, drawing.things) / pictures;
    }
    return mean;
}

// A region with an edge in it rises, but is not the slope that what lies behind the edge is part of.
TEST(ximgproc_GWatershed_truth, an_edge_between_grays_is_no_slope)
{
    for (const int& effort : { 1, 2 })
        EXPECT_LT(meanOverDrawings(CV_8UC1, 17, effort, wrongShare), 0.02) << effort;
}

// As of a video that is shown line by line.
TEST(ximgproc_GWatershed_truth, rows_that_alternate_are_no_slope)
{
    const int pictures = 6;
    double wrong[2] = { 0, 0 }; // with the highest effort, and merged
    RNG rng(18);
    for (int i = 0; i < pictures; i++)
    {
        Drawing drawing = drawThings(CV_8UC3, rng);
        for (int y = 1; y < drawing.image.rows; y += 2)
            drawing.image.row(y) /= 2;
        for (int k = 0; k < 2; k++)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(drawing.image, RGWATERSHED, k ? 10 : 20);
            gws->setEffort(k ? 1 : 3);
            gws->iterate();
            if (k)
                gws->mergeSimilar(192);
            wrong[k] += wrongShare(gws, drawing.things) / pictures;
        }
    }
    EXPECT_LT(wrong[0], 0.014);
    EXPECT_LT(wrong[1], 0.014);
}

// A pixel that leaves a straight boundary takes more of it than faint edges pay for, if its price does not follow them.
// Holes in depth are no noise of it.
TEST(ximgproc_GWatershed_truth, faint_things_are_found)
{
    const int pictures = 4, step = 12, noise = 1;
    Mat depth(240, 320, CV_16UC1);
    for (int y = 0; y < depth.rows; y++)
        for (int x = 0; x < depth.cols; x++)
            depth.at<ushort>(y, x) = ushort((7 * x + 3 * y) % 10 == 0 ? 0 : 1000 + y);
    for (int region_size : { 20, 30 })
        for (int way : { 0, 1, 2 }) // usual, with depth, with the most effort
        {
            RNG rng(20);
            double wrong = 0;
            for (int i = 0; i < pictures; i++)
            {
                Mat things(240, 320, CV_8UC1, Scalar(1)), image;
                for (int k = 0; k < 16; k++)
                    circle(things, Point(rng.uniform(0, 320), rng.uniform(0, 240)), rng.uniform(12, 45),
                           Scalar(k % 3), FILLED);
                Mat grain(things.size(), CV_16SC1);
                rng.fill(grain, RNG::NORMAL, 0, noise);
                cv::add(100 + step * things, grain, image, noArray(), CV_8U);
                Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, region_size);
                gws->setEffort(way == 2 ? 3 : 1);
                gws->iterate(image, way == 1 ? depth : Mat());
                wrong += wrongShare(gws, things) / pictures;
            }
            EXPECT_LT(wrong, 0.01) << region_size << ", " << way;
        }
}

//! Share of the superpixels that have no square of 3x3 pixels.
double shareOfSlivers(const Ptr<SuperpixelGWatershed>& gws, const Mat&)
{
    const Mat labels = labelsOf(gws);
    std::vector<uchar> is_broad(numberOfLabels(labels), 0);
    for (int y = 0; y + 3 <= labels.rows; y++)
        for (int x = 0; x + 3 <= labels.cols; x++)
        {
            double lowest, highest;
            minMaxLoc(labels(Rect(x, y, 3, 3)), &lowest, &highest);
            if (lowest == highest)
                is_broad[int(lowest)] = 1;
        }
    return double(std::count(is_broad.begin(), is_broad.end(), uchar(0))) / double(is_broad.size());
}

// The colour of blocks astride of an edge is that of no thing, so nothing would unite with them as they are.
TEST(ximgproc_GWatershed_truth, blocks_astride_of_an_edge_do_not_stay_apart)
{
    for (const int& effort : { 1, 2 })
        EXPECT_LT(meanOverDrawings(CV_8UC3, 19, effort, shareOfSlivers), 0.22) << effort;
}

}} // namespace
