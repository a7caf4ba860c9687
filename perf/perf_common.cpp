// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"

namespace opencv_test
{

static Mat findPicture(const String& name, int flags)
{
    const String path = samples::findFile(name, false, true);
    return path.empty() ? Mat() : imread(path, flags);
}

static Mat generateScene(RNG& rng)
{
    Mat scene(1110, 1282, CV_8UC3);
    rng.fill(scene, RNG::UNIFORM, Scalar::all(0), Scalar::all(256));
    GaussianBlur(scene, scene, Size(), 2);
    for (int i = 0; i < 600; i++)
        circle(scene, Point(rng.uniform(0, scene.cols), rng.uniform(0, scene.rows)), rng.uniform(3, 60),
               Scalar(rng.uniform(0, 256), rng.uniform(0, 256), rng.uniform(0, 256)), FILLED);
    GaussianBlur(scene, scene, Size(3, 3), 0);
    return scene;
}

//! Cuts size out of a photograph that is mirrored at its borders as often as needed.
static Mat cut(const Mat& photograph, Point corner, Size size)
{
    Mat wide;
    cv::copyMakeBorder(photograph, wide, 0, std::max(0, corner.y + size.height - photograph.rows),
                   0, std::max(0, corner.x + size.width - photograph.cols), BORDER_REFLECT);
    return wide(Rect(corner, size)).clone();
}

Pictures::Pictures(Size size) : index_(0)
{
    RNG rng(7);
    std::vector<Mat> photographs;
    photographs.push_back(findPicture("aloeL.jpg", IMREAD_COLOR));
    photographs.push_back(findPicture("fruits.jpg", IMREAD_COLOR));
    photographs.push_back(findPicture("home.jpg", IMREAD_COLOR));
    Mat disparity = findPicture("aloeGT.png", IMREAD_GRAYSCALE);
    for (size_t i = 0; i < photographs.size(); i++)
        if (photographs[i].empty())
            photographs[i] = generateScene(rng);
    if (disparity.empty())
        cvtColor(generateScene(rng), disparity, COLOR_BGR2GRAY);

    const int count = size.area() > 3000000 ? 3 : 9;
    for (int i = 0; i < count; i++)
    {
        const Mat& photograph = photographs[i % photographs.size()];
        const Point corner(i * 37, i * 23);
        Mat depth;
        cut(disparity, corner, size).convertTo(depth, CV_16U, 16);
        images_.push_back(cut(photograph, corner, size));
        depths_.push_back(depth);
    }
}

} // namespace
