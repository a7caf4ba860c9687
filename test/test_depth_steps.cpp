// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

//! How many pixels lie in superpixels of which more is on the other side of an outline.
int countWrong(const Mat& labels, int num_superpixels, const Rect& inside)
{
    std::vector<int> areas(num_superpixels, 0), areas_inside(num_superpixels, 0);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            const int label = labels.at<int>(y, x);
            areas[label]++;
            areas_inside[label] += inside.contains(Point(x, y));
        }
    int wrong = 0;
    for (int i = 0; i < num_superpixels; i++)
        wrong += std::min(areas_inside[i], areas[i] - areas_inside[i]);
    return wrong;
}

// Blocks through which a step of depth goes have the depth of one side. That of both would be a third surface, whose
// superpixels end up as slivers that lie astride of the step: 4.8 wrong pixels in each image.
TEST(ximgproc_GWatershed_depth_steps, few_pixels_are_on_the_wrong_side)
{
    RNG& rng = theRNG();
    const Size size(195, 140);
    const int images = 100;
    int wrong = 0;
    for (int i = 0; i < images; i++)
    {
        const Rect box(rng.uniform(4, 100), rng.uniform(4, 70), rng.uniform(30, 90), rng.uniform(30, 66));
        Mat depth(size, CV_32FC1, Scalar(1600));
        depth.colRange(0, rng.uniform(50, 100)).setTo(Scalar(1500));
        depth(box).setTo(Scalar(i % 2 ? 5000 : 700));
        Ptr<SuperpixelGWatershed> gws =
                createSuperpixelGWatershed(Mat(size, CV_8UC3, Scalar(90, 120, 70)), depth, RGWATERSHED, 20);
        gws->iterate();
        wrong += countWrong(labelsOf(gws), gws->getNumberOfSuperpixels(), box);
    }
    EXPECT_LT(wrong, images);
}

}} // namespace
