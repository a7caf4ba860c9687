// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// Blocks through which a step of depth goes have the depth of one side. That of both would be a third surface, whose
// superpixels end up as slivers that lie astride of the step: 4.8 wrong pixels in each image.
TEST(ximgproc_GWatershed_depth_steps, few_pixels_are_on_the_wrong_side)
{
    RNG& rng = theRNG();
    const Size size(195, 140);
    const int images = 100;
    double wrong = 0; // pixels in superpixels of which more is on the other side
    for (int i = 0; i < images; i++)
    {
        const Rect box(rng.uniform(4, 100), rng.uniform(4, 70), rng.uniform(30, 90), rng.uniform(30, 66));
        Mat depth(size, CV_32FC1, Scalar(1600)), inside = Mat::zeros(size, CV_8UC1);
        depth.colRange(0, rng.uniform(50, 100)).setTo(Scalar(1500));
        depth(box).setTo(Scalar(i % 2 ? 5000 : 700));
        inside(box).setTo(Scalar(1));
        Ptr<SuperpixelGWatershed> gws =
                createSuperpixelGWatershed(Mat(size, CV_8UC3, Scalar(90, 120, 70)), depth, RGWATERSHED, 20);
        gws->iterate();
        wrong += (1 - purity(labelsOf(gws), gws->getNumberOfSuperpixels(), inside)) * size.area();
    }
    EXPECT_LT(wrong, images);
}

}} // namespace
