// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test
{

static Scalar randomColor(RNG& rng)
{
    return Scalar(rng.uniform(0, 256), rng.uniform(0, 256), rng.uniform(0, 256));
}

Mat makeScene(Size size, RNG& rng)
{
    Mat image = makeImage(RAMP, size, 3, rng);
    for (int i = 0; i < 40; i++)
    {
        const Point center(rng.uniform(0, size.width), rng.uniform(0, size.height));
        const int radius = rng.uniform(2, std::max(3, size.width / 6));
        if (i % 2)
            circle(image, center, radius, randomColor(rng), FILLED);
        else
            rectangle(image, Rect(center, Size(radius, 2 * radius)), randomColor(rng), FILLED);
    }
    GaussianBlur(image, image, Size(3, 3), 0);
    Mat noise(size, CV_8UC3);
    rng.fill(noise, RNG::UNIFORM, 0, 12);
    return image + noise;
}

Mat makeImage(ImageKind kind, Size size, int channels, RNG& rng)
{
    if (kind == SCENE)
    {
        Mat scene = makeScene(size, rng);
        if (channels == 1)
            cvtColor(scene, scene, COLOR_BGR2GRAY);
        return scene;
    }
    Mat image(size, CV_8UC(channels));
    if (kind == NOISE)
    {
        rng.fill(image, RNG::UNIFORM, 0, 256);
        return image;
    }
    const Scalar light = randomColor(rng), dark = randomColor(rng);
    const int period = rng.uniform(1, 12);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
            for (int c = 0; c < channels; c++)
            {
                double value = light[c];
                if (kind == RAMP)
                    value = light[c] + (dark[c] - light[c]) * (x + 2 * y) / (size.width + 2. * size.height);
                else if (kind == STRIPES && x / period % 2)
                    value = dark[c];
                else if (kind == CHECKERBOARD && (x / period + y / period) % 2)
                    value = dark[c];
                image.ptr(y)[x * channels + c] = saturate_cast<uchar>(value);
            }
    return image;
}

Mat makeDepth(Size size, double holes, RNG& rng)
{
    Mat depth(size, CV_16UC1);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
            depth.at<ushort>(y, x) = saturate_cast<ushort>(3000 - 10 * y + 2 * x);
    for (int i = 0; i < 6; i++)
    {
        const Point corner(rng.uniform(0, size.width), rng.uniform(0, size.height));
        const Size box(rng.uniform(1, size.width + 1), rng.uniform(1, size.height + 1));
        rectangle(depth, Rect(corner, box), Scalar(rng.uniform(500, 4000)), FILLED);
    }
    const int blobs = cvRound(holes * size.area() / 13);
    for (int i = 0; i < blobs; i++)
        circle(depth, Point(rng.uniform(0, size.width), rng.uniform(0, size.height)), 2, Scalar(0), FILLED);
    return depth;
}

Mat labelsOf(const Ptr<SuperpixelGWatershed>& gws)
{
    Mat labels;
    gws->getLabels(labels);
    return labels;
}

Mat segment(InputArray image, int algorithm, int region_size)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, algorithm, region_size);
    gws->iterate();
    return labelsOf(gws);
}

Mat segment(InputArray image, InputArray depth, int algorithm, int region_size)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, depth, algorithm, region_size);
    gws->iterate();
    return labelsOf(gws);
}

int countPieces(const Mat& labels)
{
    Mat seen = Mat::zeros(labels.size(), CV_8UC1);
    std::vector<Point> open;
    int pieces = 0;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            if (seen.at<uchar>(y, x))
                continue;
            pieces++;
            seen.at<uchar>(y, x) = 1;
            open.assign(1, Point(x, y));
            while (!open.empty())
            {
                const Point p = open.back();
                open.pop_back();
                const Point around[4] = { p - Point(1, 0), p - Point(0, 1), p + Point(1, 0), p + Point(0, 1) };
                for (int k = 0; k < 4; k++)
                {
                    const Point q = around[k];
                    if (!Rect(Point(), labels.size()).contains(q) || seen.at<uchar>(q) ||
                        labels.at<int>(q) != labels.at<int>(p))
                        continue;
                    seen.at<uchar>(q) = 1;
                    open.push_back(q);
                }
            }
        }
    return pieces;
}

void expectPartition(const Mat& labels, Size size, int num_labels)
{
    ASSERT_EQ(CV_32SC1, labels.type());
    ASSERT_EQ(size, labels.size());
    std::vector<int> area(num_labels, 0);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            const int label = labels.at<int>(y, x);
            ASSERT_GE(label, 0);
            ASSERT_LT(label, num_labels);
            area[label]++;
        }
    EXPECT_EQ(0, std::count(area.begin(), area.end(), 0)) << "labels without a pixel";
    EXPECT_EQ(num_labels, countPieces(labels));
}

static int numberOfLabels(const Mat& labels)
{
    double largest = 0;
    minMaxLoc(labels, 0, &largest);
    return int(largest) + 1;
}

double explainedVariation(const Mat& labels, const Mat& image)
{
    const int n = numberOfLabels(labels);
    std::vector<Vec3d> sums(n, Vec3d::all(0));
    std::vector<int> areas(n, 0);
    double squares = 0;
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols; x++)
        {
            const Vec3d color = image.at<Vec3b>(y, x);
            sums[labels.at<int>(y, x)] += color;
            areas[labels.at<int>(y, x)]++;
            squares += color.dot(color);
        }
    Vec3d all = Vec3d::all(0);
    double kept = 0;
    for (int i = 0; i < n; i++)
    {
        all += sums[i];
        kept += sums[i].dot(sums[i]) / areas[i];
    }
    const double common = all.dot(all) / double(image.total());
    return (kept - common) / (squares - common);
}

double compactness(const Mat& labels)
{
    const int n = numberOfLabels(labels);
    std::vector<double> area(n, 0), perimeter(n, 0);
    Mat framed;
    cv::copyMakeBorder(labels, framed, 1, 1, 1, 1, BORDER_CONSTANT, Scalar(-1));
    for (int y = 1; y <= labels.rows; y++)
        for (int x = 1; x <= labels.cols; x++)
        {
            const int label = framed.at<int>(y, x);
            area[label]++;
            perimeter[label] += (framed.at<int>(y, x - 1) != label) + (framed.at<int>(y, x + 1) != label) +
                                (framed.at<int>(y - 1, x) != label) + (framed.at<int>(y + 1, x) != label);
        }
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += area[i] * 4 * CV_PI * area[i] / (perimeter[i] * perimeter[i]);
    return sum / double(labels.total());
}

bool equalMats(const Mat& a, const Mat& b)
{
    return a.size() == b.size() && a.type() == b.type() && cvtest::norm(a, b, NORM_INF) == 0;
}

} // namespace
