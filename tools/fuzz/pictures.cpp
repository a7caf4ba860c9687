// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "pictures.hpp"

#include <opencv2/imgproc.hpp>

#include <cfloat>
#include <cmath>
#include <limits>

namespace fuzz
{

static const float INFINITE = std::numeric_limits<float>::infinity();
static const float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();

bool oneIn(int count, Bytes& bytes)
{
    return bytes.ConsumeIntegralInRange(1, count) == count; // not so when the bytes are used up
}

static int takeUpTo(int most, Bytes& bytes)
{
    return bytes.ConsumeIntegralInRange(0, std::max(most, 0));
}

Size takeSize(int max_pixels, Bytes& bytes)
{
    const int side = cvFloor(std::sqrt(double(max_pixels)));
    switch (takeUpTo(9, bytes))
    {
    case 0: return Size(1 + takeUpTo(7, bytes), 1 + takeUpTo(7, bytes));
    case 1: return Size(1, 1 + takeUpTo(3 * side, bytes));
    case 2: return Size(1 + takeUpTo(3 * side, bytes), 1);
    case 3: return Size(side / 2 + takeUpTo(side / 2, bytes), side / 2 + takeUpTo(side / 2, bytes));
    default: return Size(1 + takeUpTo(side / 2, bytes), 1 + takeUpTo(side / 2, bytes));
    }
}

float takeFloat(float usual_max, Bytes& bytes)
{
    const float edges[] = { 0.f, -0.f, 1.f, 1.0001f, -1e-30f, -1.f, 1e-42f, 1e6f, FLT_MAX, -FLT_MAX, INFINITE,
                            -INFINITE, NOT_A_NUMBER };
    switch (takeUpTo(15, bytes))
    {
    case 0: return bytes.PickValueInArray(edges);
    case 1: return bytes.ConsumeFloatingPoint<float>();
    default: return bytes.ConsumeFloatingPointInRange(0.f, usual_max);
    }
}

int takeInt(int usual_max, Bytes& bytes)
{
    switch (takeUpTo(15, bytes))
    {
    case 0: return bytes.PickValueInArray({ 0, -1, 1, INT_MIN, INT_MAX, INT_MAX - 1, 65535, 65536 });
    case 1: return bytes.ConsumeIntegral<int>();
    default: return bytes.ConsumeIntegralInRange(1, usual_max);
    }
}

static RNG takeRandom(Bytes& bytes)
{
    return RNG(bytes.ConsumeIntegral<uint16_t>());
}

static Point takePoint(Size size, Bytes& bytes)
{
    return Point(takeUpTo(size.width - 1, bytes), takeUpTo(size.height - 1, bytes));
}

static Rect takeBox(Size size, Bytes& bytes)
{
    const Point corner = takePoint(size, bytes);
    return Rect(corner, takePoint(size - Size(corner), bytes) + corner + Point(1, 1));
}

static Scalar takeColor(Bytes& bytes)
{
    const double b = takeUpTo(255, bytes), g = takeUpTo(255, bytes), r = takeUpTo(255, bytes);
    return Scalar(b, g, r) / 255.;
}

//! Some pixels get some bytes, so that these decide on everything.
static void writePixels(Mat& scene, Bytes& bytes)
{
    const std::vector<uchar> values = bytes.ConsumeBytes<uchar>(1 + takeUpTo(63, bytes));
    for (size_t i = 0; !values.empty() && i < scene.total() * 3; i++)
        scene.ptr<float>(int(i / 3 / scene.cols))[i % (scene.cols * size_t(3))] = values[i % values.size()] / 255.f;
}

Mat makeScene(Size size, Bytes& bytes)
{
    Mat scene(size, CV_32FC3, takeColor(bytes));
    const int kind = takeUpTo(6, bytes);
    if (kind == 0)
        takeRandom(bytes).fill(scene.reshape(1), RNG::UNIFORM, cv::Scalar::all(0), cv::Scalar::all(1));
    if (kind == 1)
        writePixels(scene, bytes);
    if (kind == 2) // stripes or a checkerboard
    {
        const Scalar other = takeColor(bytes);
        const int period = 1 + takeUpTo(8, bytes), slope = takeUpTo(1, bytes);
        for (int y = 0; y < size.height; y++)
            for (int x = 0; x < size.width; x++)
                if ((x / period + slope * (y / period)) % 2)
                    scene.at<cv::Vec3f>(y, x) = cv::Vec3f(float(other[0]), float(other[1]), float(other[2]));
    }
    if (kind == 3) // ramp
        for (int y = 0; y < size.height; y++)
            for (int x = 0; x < size.width; x++)
                scene.at<cv::Vec3f>(y, x) *= float(x + y + 1) / float(size.width + size.height);
    if (kind > 4) // boxes and discs, with noise
    {
        for (int i = takeUpTo(12, bytes); i > 0; i--)
        {
            const Rect box = takeBox(size, bytes);
            if (i % 2)
                cv::rectangle(scene, box, takeColor(bytes), cv::FILLED);
            else
                cv::circle(scene, box.tl(), box.width, takeColor(bytes), cv::FILLED);
        }
        Mat noise(size, CV_32FC3);
        takeRandom(bytes).fill(noise.reshape(1), RNG::UNIFORM,
                               cv::Scalar::all(0), cv::Scalar::all(takeUpTo(3, bytes) * 0.02));
        scene += noise;
    }
    return scene;
}

Mat changeScene(const Mat& scene, Bytes& bytes)
{
    Mat next = scene.clone();
    switch (takeUpTo(5, bytes))
    {
    case 0: // a camera that moves
    {
        const int dx = takeUpTo(8, bytes) - 4, dy = takeUpTo(8, bytes) - 4;
        for (int y = 0; y < scene.rows; y++)
            for (int x = 0; x < scene.cols; x++)
                next.at<cv::Vec3f>(y, x) = scene.at<cv::Vec3f>(std::min(std::max(y + dy, 0), scene.rows - 1),
                                                               std::min(std::max(x + dx, 0), scene.cols - 1));
        break;
    }
    case 1:
    {
        Mat noise(scene.size(), CV_32FC3);
        RNG random = takeRandom(bytes);
        const double deviation = 0.02 + 0.02 * takeUpTo(5, bytes);
        random.fill(noise.reshape(1), RNG::NORMAL, cv::Scalar::all(0), cv::Scalar::all(deviation));
        next += noise;
        break;
    }
    case 2:
    case 3:
        next(takeBox(scene.size(), bytes)).setTo(takeColor(bytes));
        break;
    case 4:
        return makeScene(scene.size(), bytes);
    default:;
    }
    return next;
}

//! Puts NaN, infinity and extreme values into a float matrix.
static void writeSpecials(Mat& floats, Bytes& bytes)
{
    const float specials[] = { NOT_A_NUMBER, INFINITE, -INFINITE, 0.f, -3.f, 7.f, FLT_MAX, -FLT_MAX, 1e-42f };
    RNG random = takeRandom(bytes);
    const int width = floats.cols * floats.channels();
    const int most = std::max(1, floats.rows * width / 3), count = random.uniform(1, most + 1);
    for (int i = 0; i < count; i++)
        floats.ptr<float>(random.uniform(0, floats.rows))[random.uniform(0, width)] = specials[random.uniform(0, 9)];
}

static Mat makeWrong(Size size, Bytes& bytes)
{
    const int types[] = { CV_8SC1, CV_16SC3, CV_32SC1, CV_64FC1, CV_8UC2, CV_8UC(5), CV_16UC(7), CV_32FC2, CV_64FC3 };
    if (oneIn(4, bytes))
        return Mat();
    const int sides[] = { 2, 3, 4 };
    if (oneIn(4, bytes))
        return Mat(3, sides, CV_8UC1, Scalar(1));
    Mat wrong(size, bytes.PickValueInArray(types));
    wrong.reshape(1).setTo(Scalar(3));
    return wrong;
}

Mat makeImage(const Mat& scene, Bytes& bytes)
{
    if (oneIn(32, bytes))
        return makeWrong(scene.size(), bytes);
    const int depth = bytes.PickValueInArray({ CV_8U, CV_8U, CV_16U, CV_32F, CV_8S, CV_16S, CV_32S, CV_64F, CV_16F });
    const int channels = bytes.PickValueInArray({ 3, 3, 3, 1, 4, 2 });
    Mat image = scene;
    if (channels == 1)
        cv::extractChannel(scene, image, 1);
    if (channels == 2 || channels == 4)
    {
        std::vector<Mat> planes;
        cv::split(scene, planes);
        planes.push_back(planes[takeUpTo(2, bytes)]);
        planes.resize(channels, planes[3]);
        cv::merge(planes, image);
    }
    const bool is_float = depth == CV_32F || depth == CV_64F || depth == CV_16F;
    const double usual = depth == CV_8U ? 255 : depth == CV_16U ? 65535 : is_float ? 1 : 127;
    const double span = oneIn(2, bytes) ? usual : bytes.PickValueInArray({ 4095., 300., 1e9, 1e30, 1e-30 });
    Mat converted;
    image.convertTo(converted, is_float ? CV_32F : depth, span,
                    bytes.PickValueInArray({ 0., 0., 7000., -1000., -0.5 }));
    if (is_float && oneIn(3, bytes))
        writeSpecials(converted, bytes);
    converted.convertTo(converted, depth);
    return converted;
}

bool isImage(const Mat& image)
{
    const int depth = image.depth(), channels = image.channels();
    return !image.empty() && image.dims == 2 && depth <= CV_16F && channels <= 4;
}

//! Keeps one depth in each square of a few pixels, or all but one.
static void keepLattice(Mat& depth, Bytes& bytes)
{
    const bool keeps_one = oneIn(2, bytes);
    const int step = 2 + takeUpTo(3, bytes), left = takeUpTo(step - 1, bytes), top = takeUpTo(step - 1, bytes);
    for (int y = 0; y < depth.rows; y++)
        for (int x = 0; x < depth.cols; x++)
            if ((x % step == left && y % step == top) != keeps_one)
                depth.at<float>(y, x) = 0;
}

Mat makeDepth(const Mat& scene, Bytes& bytes)
{
    if (oneIn(32, bytes))
        return makeWrong(scene.size(), bytes);
    const Size size = oneIn(64, bytes) ? scene.size() + Size(1, 0) : scene.size();
    Mat depth(size, CV_32FC1, Scalar(0.5));
    if (size == scene.size() && !oneIn(4, bytes))
        cv::extractChannel(scene, depth, takeUpTo(2, bytes));
    if (oneIn(2, bytes))
        depth(takeBox(size, bytes)).setTo(Scalar(0));
    if (oneIn(2, bytes))
    {
        Mat share(size, CV_8UC1);
        takeRandom(bytes).fill(share.reshape(1), RNG::UNIFORM, cv::Scalar::all(0), cv::Scalar::all(8));
        depth.setTo(Scalar(0), share < takeUpTo(8, bytes));
    }
    if (oneIn(4, bytes))
        keepLattice(depth, bytes);
    if (oneIn(4, bytes)) // a value that stands for none
        depth(takeBox(size, bytes)).setTo(Scalar(bytes.PickValueInArray({ 1., 20., 1000., 1e-3, double(INFINITE) })));
    Mat converted;
    switch (takeUpTo(5, bytes))
    {
    case 0:
        depth.convertTo(converted, CV_8U, 255);
        break;
    case 1:
        depth.convertTo(converted, CV_16U, bytes.PickValueInArray({ 65535, 5000, 3 }));
        if (oneIn(2, bytes)) // how other cameras say that it is missing
            converted.setTo(Scalar(65535), depth == 0);
        break;
    case 2:
        depth.convertTo(converted, CV_16S, bytes.PickValueInArray({ 32767, 1000 }), -16);
        break;
    case 3:
        depth.convertTo(converted, CV_64F, bytes.PickValueInArray({ 8., 1e200, 1e-200 }));
        break;
    default:
        depth.convertTo(converted, CV_32F, bytes.PickValueInArray({ 8., 8., 1e30, 1e-40 }));
        if (oneIn(2, bytes))
            writeSpecials(converted, bytes);
    }
    return converted;
}

bool isDepth(const Mat& depth, Size size)
{
    const int type = depth.type();
    return depth.empty() || (depth.dims == 2 && depth.size() == size &&
                             (type == CV_8UC1 || type == CV_16UC1 || type == CV_16SC1 || type == CV_32FC1 ||
                              type == CV_64FC1));
}

Mat makeValues(Size size, Bytes& bytes)
{
    Mat floats(size, CV_32FC(1 + takeUpTo(5, bytes))), values;
    takeRandom(bytes).fill(floats.reshape(1), RNG::UNIFORM, cv::Scalar::all(-1000), cv::Scalar::all(1000));
    floats.convertTo(values, takeUpTo(CV_16F, bytes));
    if (values.depth() == CV_32F && oneIn(2, bytes))
        writeSpecials(values, bytes);
    return values;
}

Mat makeMask(Size size, Bytes& bytes)
{
    if (oneIn(32, bytes))
        return makeWrong(size, bytes);
    const Scalar inside(1 + takeUpTo(254, bytes));
    const Point center(size.width / 2, size.height / 2);
    Mat mask(size, CV_8UC1, Scalar(0));
    switch (takeUpTo(9, bytes))
    {
    case 0: // dust
        takeRandom(bytes).fill(mask.reshape(1), RNG::UNIFORM,
                               cv::Scalar::all(0), cv::Scalar::all(2 + takeUpTo(6, bytes)));
        break;
    case 1: // the opposite of dust
        takeRandom(bytes).fill(mask.reshape(1), RNG::UNIFORM, cv::Scalar::all(0), cv::Scalar::all(9));
        mask = mask != 0;
        break;
    case 2: // rings
        for (int radius = takeUpTo(3, bytes); radius < size.width; radius += 3 + takeUpTo(8, bytes))
            cv::circle(mask, center, radius, inside, 1);
        break;
    case 3: // mesh
        mask.setTo(inside);
        for (int y = takeUpTo(6, bytes); y < size.height; y += 7)
            mask.row(y).setTo(Scalar(0));
        for (int x = takeUpTo(6, bytes); x < size.width; x += 11)
            mask.col(x).setTo(Scalar(0));
        break;
    case 4: // full or empty
        mask.setTo(oneIn(2, bytes) ? inside : Scalar(0));
        break;
    case 5:
        for (int i = takeUpTo(6, bytes); i >= 0; i--)
            mask.at<uchar>(takePoint(size, bytes)) = 1;
        break;
    case 6:
        for (int i = takeUpTo(6, bytes); i >= 0; i--)
            cv::line(mask, takePoint(size, bytes), takePoint(size, bytes), inside, 1 + i / 2, 4);
        break;
    case 7: // all but a box
        mask.setTo(inside);
        mask(takeBox(size, bytes)).setTo(Scalar(0));
        break;
    default: // boxes, often beside each other
        for (int i = takeUpTo(3, bytes); i >= 0; i--)
            mask(takeBox(size, bytes)).setTo(inside);
    }
    return mask;
}

Mat makeMarkers(Size size, Bytes& bytes)
{
    if (oneIn(32, bytes))
        return makeWrong(size, bytes);
    Mat markers(size, CV_32SC1, Scalar(0));
    switch (takeUpTo(6, bytes))
    {
    case 0: // each pixel one of its own
        for (int y = 0; y < size.height; y++)
            for (int x = 0; x < size.width; x++)
                markers.at<int>(y, x) = 1 + y * size.width + x;
        break;
    case 1:
        takeRandom(bytes).fill(markers.reshape(1), RNG::UNIFORM,
                               cv::Scalar::all(-1), cv::Scalar::all(1 + takeUpTo(50, bytes)));
        break;
    case 2: // the same everywhere
        markers.setTo(Scalar(takeUpTo(3, bytes) - 1));
        break;
    case 3:
        for (int i = takeUpTo(8, bytes); i >= 0; i--)
            cv::line(markers, takePoint(size, bytes), takePoint(size, bytes), Scalar(takeUpTo(5, bytes)), 1, 4);
        break;
    case 4:
        for (int i = takeUpTo(4, bytes); i >= 0; i--)
            markers(takeBox(size, bytes)).setTo(Scalar(takeInt(6, bytes)));
        break;
    default:
        for (int i = takeUpTo(12, bytes); i >= 0; i--)
            markers.at<int>(takePoint(size, bytes)) = takeInt(20, bytes);
    }
    return markers;
}

void Guarded::overwrite(int value)
{
    whole_.reshape(1).setTo(Scalar(value));
}

Guarded::Guarded(const Mat& values, Bytes& bytes)
{
    const bool alone = values.empty() || values.dims != 2 || oneIn(2, bytes);
    if (alone)
        whole_ = part_ = values.clone();
    else
    {
        const Point corner(takeUpTo(3, bytes), takeUpTo(3, bytes));
        whole_.create(values.rows + corner.y + takeUpTo(3, bytes), values.cols + corner.x + takeUpTo(3, bytes),
                      values.type());
        overwrite(takeUpTo(255, bytes));
        part_ = whole_(Rect(corner, values.size()));
        values.copyTo(part_);
    }
    before_ = whole_.clone();
}

} // namespace
