// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "images.hpp"

#include <limits>

using namespace cv;

//! One step of the generator SplitMix64: a bijection whose values look independent.
static uint64 mix(uint64 value)
{
    value += 0x9e3779b97f4a7c15;
    value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
    value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
    return value ^ (value >> 31);
}

int Numbers::below(int n)
{
    state_ = mix(state_);
    return int((state_ >> 33) % uint64(n));
}

//! A number in 0..65535 for a pixel, a channel and a frame.
static int noiseAt(uint64 seed, int x, int y, int channel, int frame)
{
    return int(mix(seed ^ mix(uint64(x) << 40 ^ uint64(y) << 16 ^ uint64(channel) << 8 ^ uint64(frame))) >> 48);
}

namespace {

//! A thing covers the pixels that are nearest to its centre.
struct Thing
{
    Point center;
    int values[5]; //!< of the channels, then of depth, in 0..65535
};

class Picture
{
public:
    Picture(const Scene& scene, int frame) : scene_(scene), frame_(frame)
    {
        Numbers numbers(scene.seed);
        period_ = 1 + numbers.below(12);
        things_.resize(2 + numbers.below(24));
        for (size_t i = 0; i < things_.size(); i++)
        {
            const int direction = numbers.below(4) - 1, step = direction * scene.motion * frame;
            const int x = numbers.below(scene.size.width), y = numbers.below(scene.size.height);
            things_[i].center = Point(x + step, y + step / 2);
            for (int k = 0; k < 5; k++)
                things_[i].values[k] = numbers.below(65536);
        }
    }

    //! The thing that a pixel of a scene or of stripes shows.
    const Thing& at(int x, int y) const
    {
        if (scene_.kind == STRIPES)
            return things_[(x / period_ + y / (3 * period_)) % 2];
        size_t best = 0;
        for (size_t i = 1; i < things_.size(); i++)
            if (distance(i, x, y) < distance(best, x, y))
                best = i;
        return things_[best];
    }

    //! 0..65535.
    int value(const Thing& thing, int x, int y, int channel) const
    {
        const int noise = noiseAt(scene_.seed, x, y, channel, frame_);
        switch (scene_.kind)
        {
        case NOISE: return noise;
        case FLAT: return things_[0].values[channel];
        case FEW_COLORS: return 2560 + 256 * (noiseAt(scene_.seed, x / 2, y / 2, channel, frame_) % 3);
        case RAMP: return int((int64(x) * 40000 / scene_.size.width + int64(y) * 25000 / scene_.size.height) % 65536);
        default: return saturate_cast<ushort>(thing.values[channel] + (noise >> 4) - 2048 + 16 * x - 8 * y);
        }
    }

private:
    int64 distance(size_t i, int x, int y) const
    {
        const int64 dx = x - things_[i].center.x, dy = y - things_[i].center.y;
        return dx * dx + dy * dy;
    }

    Scene scene_;
    int frame_, period_;
    std::vector<Thing> things_;
};

} // namespace

//! One pixel in 4096 is no colour.
static float floatColor(int value, int noise)
{
    const float strange[] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              -1.5f, 7.f };
    return noise % 4096 == 0 ? strange[noise / 4096 % 4] : float(value) / 65535.f;
}

Mat makeImage(const Scene& scene, int frame, int type)
{
    const Picture picture(scene, frame);
    Mat image(scene.size, type);
    const int cn = image.channels();
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols; x++)
        {
            const Thing& thing = picture.at(x, y);
            for (int k = 0; k < cn; k++)
            {
                const int value = picture.value(thing, x, y, k);
                if (image.depth() == CV_8U)
                    image.ptr(y)[x * cn + k] = uchar(value >> 8);
                else if (image.depth() == CV_16U)
                    image.ptr<ushort>(y)[x * cn + k] = ushort(value);
                else if (image.depth() == CV_16S)
                    image.ptr<short>(y)[x * cn + k] = short(value - 32768);
                else
                    image.ptr<float>(y)[x * cn + k] = floatColor(value, noiseAt(scene.seed + 1, x, y, k, frame));
            }
        }
    return image;
}

Mat makeDepth(const Scene& scene, int frame, int type)
{
    const Picture picture(scene, frame);
    Mat depth(scene.size, type);
    for (int y = 0; y < depth.rows; y++)
        for (int x = 0; x < depth.cols; x++)
        {
            const Thing& thing = picture.at(x, y);
            const bool missing = noiseAt(scene.seed + 2, x / 3, y / 3, 0, frame) % 8 == 0;
            const int millimetres = missing ? 0 : 500 + thing.values[4] / 16 + 2 * x % 2000;
            if (depth.depth() == CV_8U)
                depth.at<uchar>(y, x) = uchar(millimetres / 32);
            else if (depth.depth() == CV_16U)
                depth.at<ushort>(y, x) = ushort(millimetres);
            else
                depth.at<float>(y, x) = missing && x % 2 ? std::numeric_limits<float>::quiet_NaN()
                                                         : float(millimetres) / 1000.f;
        }
    return depth;
}

Mat makeMask(Size size, Numbers& numbers)
{
    const bool inverted = numbers.below(3) == 0;
    Mat mask(size, CV_8UC1, Scalar(inverted ? 255 : 0));
    for (int i = 0; i < 6; i++)
    {
        const int center_x = numbers.below(size.width), center_y = numbers.below(size.height);
        const int radius = 1 + numbers.below(1 + size.width / 4);
        for (int y = 0; y < size.height; y++)
            for (int x = 0; x < size.width; x++)
            {
                const int dx = x - center_x, dy = y - center_y;
                if (dx * dx + dy * dy <= radius * radius)
                    mask.at<uchar>(y, x) = uchar(inverted ? 0 : 1 + i);
            }
    }
    return mask;
}

Mat makeMarkers(Size size, Numbers& numbers)
{
    Mat markers(size, CV_32SC1, Scalar(0));
    const int count = 2 + numbers.below(40);
    for (int i = 0; i < count; i++)
    {
        const int x = numbers.below(size.width), y = numbers.below(size.height);
        const int width = 1 + numbers.below(6), height = 1 + numbers.below(6);
        markers(Rect(x, y, width, height) & Rect(Point(), size)).setTo(Scalar(numbers.below(3 * count) - 5));
    }
    return markers;
}
