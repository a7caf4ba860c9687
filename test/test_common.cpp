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

testing::AssertionResult isRefused(const std::function<void()>& call, const String& word)
{
    try
    {
        call();
    }
    catch (const cv::Exception& e)
    {
        const String message = e.what();
        if (message.find(word) != String::npos)
            return testing::AssertionSuccess();
        return testing::AssertionFailure() << "the message has no \"" << word << "\": " << message;
    }
    return testing::AssertionFailure() << "nothing was thrown";
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
    rng.fill(noise, RNG::UNIFORM, Scalar::all(0), Scalar::all(12));
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
        rng.fill(image, RNG::UNIFORM, Scalar::all(0), Scalar::all(256));
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

Mat makeMask(MaskKind kind, Size size, RNG& rng)
{
    Mat mask = Mat::zeros(size, CV_8UC1);
    const Scalar inside(rng.uniform(1, 256));
    const Rect all(Point(), size);
    switch (kind)
    {
    case DISCS:
        for (int i = 0; i < 5; i++)
            circle(mask, Point(rng.uniform(0, size.width), rng.uniform(0, size.height)),
                   rng.uniform(1, std::max(2, size.width / 4)), inside, FILLED);
        break;
    case DUST:
        rng.fill(mask, RNG::UNIFORM, Scalar::all(0), Scalar::all(3));
        break;
    case MESH:
        mask.setTo(inside);
        for (int y = 0; y < size.height; y += 7)
            mask.row(y).setTo(Scalar(0));
        for (int x = 3; x < size.width; x += 11)
            mask.col(x).setTo(Scalar(0));
        break;
    case THIN_LINES:
        for (int i = 0; i < 6; i++)
            line(mask, Point(rng.uniform(0, size.width), rng.uniform(0, size.height)),
                 Point(rng.uniform(0, size.width), rng.uniform(0, size.height)), inside, 1 + i / 2);
        break;
    case FRAME_MASK:
        mask.setTo(inside);
        mask(Rect(size.width / 5, size.height / 5, size.width * 3 / 5, size.height * 3 / 5)).setTo(Scalar(0));
        break;
    case BRIDGE: // two boxes and a line of one pixel between them
        mask(Rect(0, 0, (size.width + 2) / 3, size.height)).setTo(inside);
        mask(Rect(size.width - size.width / 3, 0, size.width / 3, size.height)).setTo(inside);
        mask.row(size.height / 2).setTo(inside);
        break;
    case FEW_PIXELS:
        for (int i = 0; i < 3; i++)
            mask.at<uchar>(rng.uniform(0, size.height), rng.uniform(0, size.width)) = uchar(inside[0]);
        break;
    case FULL_MASK:
        mask(all).setTo(inside);
        break;
    default:;
    }
    return mask;
}

Mat makeMarkers(Size size, int count, RNG& rng)
{
    Mat markers = Mat::zeros(size, CV_32SC1);
    for (int i = 0; i < count; i++)
    {
        const Scalar value(rng.uniform(0, 8) ? rng.uniform(1, 2 + 3 * count) : rng.uniform(-5, 1000000));
        const Point p(rng.uniform(0, size.width), rng.uniform(0, size.height));
        const Point q(rng.uniform(0, size.width), rng.uniform(0, size.height));
        if (i % 3 == 0)
            markers.at<int>(p) = int(value[0]);
        else if (i % 3 == 1)
            line(markers, p, p + (q - p) / 4, value, 1, 4);
        else
            rectangle(markers, p, p + (q - p) / 6, value, FILLED);
    }
    return markers;
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

Mat makeCells(Size size, int count, RNG& rng)
{
    std::vector<Point> centers;
    for (int i = 0; i < count; i++)
        centers.push_back(Point(rng.uniform(0, size.width), rng.uniform(0, size.height)));
    Mat cells(size, CV_32SC1);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
        {
            int nearest = 0, least = INT_MAX;
            for (int i = 0; i < count; i++)
            {
                const Point d = centers[i] - Point(x, y);
                if (d.dot(d) < least)
                {
                    least = d.dot(d);
                    nearest = i;
                }
            }
            cells.at<int>(y, x) = nearest;
        }
    return cells;
}

Mat paintCells(const Mat& cells, int count, RNG& rng)
{
    std::vector<Vec3b> colors;
    for (int i = 0; i < count; i++)
        colors.push_back(Vec3b(uchar(rng.uniform(60, 200)), uchar(rng.uniform(60, 200)), uchar(rng.uniform(60, 200))));
    Mat image(cells.size(), CV_8UC3), noise(cells.size(), CV_16SC3);
    for (int y = 0; y < cells.rows; y++)
        for (int x = 0; x < cells.cols; x++)
        {
            const int shade = (x * (cells.at<int>(y, x) % 3) + y * (cells.at<int>(y, x) % 5)) / 3 % 64;
            image.at<Vec3b>(y, x) = colors[cells.at<int>(y, x)] + Vec3b::all(uchar(std::abs(shade - 32)));
        }
    GaussianBlur(image, image, Size(5, 5), 0);
    rng.fill(noise, RNG::NORMAL, Scalar::all(0), Scalar::all(4));
    cv::add(image, noise, image, noArray(), CV_8U);
    return image;
}

int countLeaks(const Mat& labels, int num_labels, const Mat& cells, int num_cells)
{
    Mat common(num_labels, num_cells, CV_32SC1, Scalar(0));
    int leaks = 0;
    for (int y = 0; y < cells.rows; y++)
        for (int x = 0; x < cells.cols; x++)
        {
            const int label = labels.at<int>(y, x);
            if (label < 0)
                continue;
            common.at<int>(label, cells.at<int>(y, x))++;
            leaks++;
        }
    for (int i = 0; i < num_labels; i++)
        leaks -= *std::max_element(common.ptr<int>(i), common.ptr<int>(i) + num_cells);
    return leaks;
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

Rect boundsOf(const std::vector<Point>& points)
{
    if (points.empty())
        return Rect();
    Point low = points[0], high = points[0];
    for (size_t i = 1; i < points.size(); i++)
    {
        low = Point(std::min(low.x, points[i].x), std::min(low.y, points[i].y));
        high = Point(std::max(high.x, points[i].x), std::max(high.y, points[i].y));
    }
    return Rect(low, high + Point(1, 1));
}

std::vector<std::vector<Point> > pixelsOf(const Mat& labels)
{
    std::vector<std::vector<Point> > pixels(numberOfLabels(labels));
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            pixels[labels.at<int>(y, x)].push_back(Point(x, y));
    return pixels;
}

Vec2d extremeAreas(const Mat& labels)
{
    const std::vector<std::vector<Point> > pixels = pixelsOf(labels);
    const double mean = double(labels.total()) / double(pixels.size());
    Vec2d extremes(1, 1);
    for (size_t i = 0; i < pixels.size(); i++)
    {
        extremes[0] = std::min(extremes[0], double(pixels[i].size()) / mean);
        extremes[1] = std::max(extremes[1], double(pixels[i].size()) / mean);
    }
    return extremes;
}

double medianAspect(const Mat& labels)
{
    const std::vector<std::vector<Point> > pixels = pixelsOf(labels);
    std::vector<double> aspects;
    for (size_t i = 0; i < pixels.size(); i++)
    {
        if (pixels[i].empty())
            continue;
        const Size box = boundsOf(pixels[i]).size();
        aspects.push_back(double(std::max(box.width, box.height)) / std::min(box.width, box.height));
    }
    std::nth_element(aspects.begin(), aspects.begin() + aspects.size() / 2, aspects.end());
    return aspects[aspects.size() / 2];
}

int countMaskPieces(const Mat& mask)
{
    Mat own(mask.size(), CV_32SC1, Scalar(0)); // each pixel outside has a number of its own
    int outside = 0;
    for (int y = 0; y < mask.rows; y++)
        for (int x = 0; x < mask.cols; x++)
            if (!mask.at<uchar>(y, x))
                own.at<int>(y, x) = ++outside;
    return countPieces(own) - outside;
}

void expectMaskedPartition(const Mat& labels, const Mat& mask, int num_labels)
{
    ASSERT_EQ(CV_32SC1, labels.type());
    ASSERT_EQ(mask.size(), labels.size());
    Mat own = labels.clone(); // each pixel outside has a number of its own
    std::vector<int> area(num_labels, 0);
    int next = num_labels;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            const int label = labels.at<int>(y, x);
            if (!mask.at<uchar>(y, x))
            {
                ASSERT_EQ(-1, label) << "outside, " << Point(x, y);
                own.at<int>(y, x) = next++;
                continue;
            }
            ASSERT_GE(label, 0) << Point(x, y);
            ASSERT_LT(label, num_labels);
            area[label]++;
        }
    EXPECT_EQ(0, std::count(area.begin(), area.end(), 0)) << "labels without a pixel";
    EXPECT_EQ(next, countPieces(own));
}

int numberOfLabels(const Mat& labels)
{
    double largest = 0;
    minMaxLoc(labels, 0, &largest);
    return int(largest) + 1;
}

double purity(const Mat& labels, int number, const Mat& classes)
{
    std::vector<std::vector<int> > areas(number, std::vector<int>(256, 0));
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            areas[labels.at<int>(y, x)][classes.at<uchar>(y, x)]++;
    double pure = 0;
    for (const std::vector<int>& of_one : areas)
        pure += *std::max_element(of_one.begin(), of_one.end());
    return pure / double(labels.total());
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
