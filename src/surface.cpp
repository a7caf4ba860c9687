// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "surface.hpp"
#include "shared/features.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

const int REACH = 4;        //!< blocks over which differences are taken; less is noise, more misses small things
const int NEAR_INVERSE = 1 << 13; //!< inverse depth of the near end of the range; four times as much is the most
const int MOST_INVERSE = SHRT_MAX;
const int FARTHEST = 1, NEAREST = 255;
const double LEVELS = 4000; //!< of nearness, at most, down to infinity: finer differences are noise

//! Nearness is offset + slope / depth.
struct NearnessScale
{
    float offset, slope;
};

//! The depths of a row as floats, 0 where they are missing.
template <typename T> void readRow(const Mat& depth, int y, float* to)
{
    const T* from = depth.ptr<T>(y);
    for (int x = 0; x < depth.cols; x++)
        to[x] = isValidDepth(from[x]) || isFarDepth(from[x]) ? float(from[x]) : 0.f;
}

void readRow(const Mat& depth, int y, float* to)
{
    switch (depth.depth())
    {
    case CV_8U: return readRow<uchar>(depth, y, to);
    case CV_16U: return readRow<ushort>(depth, y, to);
    case CV_16S: return readRow<short>(depth, y, to);
    case CV_32F: return readRow<float>(depth, y, to);
    default: readRow<double>(depth, y, to);
    }
}

//! The range of finite depths without a hundredth at each end; {0, 0} if there are not two different ones.
FloatRange findRange(const Mat& depth)
{
    const int64 MANY = 32768, total = int64(depth.rows) * depth.cols;
    std::vector<float> row(depth.cols), values;
    std::vector<int> columns;
    int at = -1;
    visitSample(depth.size(), (total + MANY - 1) / MANY, [&](int y, int x)
    {
        if (y != at)
            readRow(depth, at = y, row.data());
        if (isValidDepth(row[x]))
            values.push_back(row[x]);
    });
    FloatRange range = { 0, 0 };
    if (!values.empty())
        range = rangeWithout(values.size() / 100, values);
    if (range.first < range.last)
        return range;
    range.first = FLT_MAX;
    range.last = 0;
    for (int y = 0; y < depth.rows; y++)
    {
        readRow(depth, y, row.data());
        for (int x = 0; x < depth.cols; x++)
            if (row[x] > 0)
            {
                range.first = std::min(range.first, row[x]);
                range.last = std::max(range.last, row[x]);
            }
    }
    return range.first < range.last ? range : FloatRange();
}

//! @note A division comes before the addition, so that no processor can do both in one step, rounded otherwise.
void scaleRow(const float* depth, int cols, const NearnessScale& scale, uchar* nearness)
{
    for (int x = 0; x < cols; x++)
    {
        const float value = scale.offset + scale.slope / std::max(depth[x], FLT_MIN);
        const int level = int(std::min(std::max(value, float(FARTHEST)), float(NEAREST)));
        nearness[x] = uchar(depth[x] > 0 ? level : 0);
    }
}

//! Inverse depths of blocks of 2x2 pixels, of those that have depth; 0 if none has.
void invertRows(const float* upper, const float* lower, int cols, float near, short* inverses)
{
    const float scale = NEAR_INVERSE * near;
    for (int x = 0; x < cols / 2; x++)
    {
        const float a = upper[2 * x], b = upper[2 * x + 1], c = lower[2 * x], d = lower[2 * x + 1];
        const float sum = (a + b) + (c + d);
        const int count = (a > 0) + (b > 0) + (c > 0) + (d > 0);
        const float inverse = std::min(scale * float(count) / std::max(sum, FLT_MIN), float(MOST_INVERSE));
        inverses[x] = short(int(inverse));
    }
}

//! Difference over REACH elements, to the side on which inverse depth is nearer to a straight line; NO_SLOPE if there is
//! none.
const int NO_SLOPE = INT_MIN;
inline int slopeAt(const short* w, int step)
{
    const int FAR_OFF = 1 << 20;
    const int a = w[-REACH * step], a2 = w[-REACH / 2 * step], q = w[0];
    const int b = w[REACH * step], b2 = w[REACH / 2 * step];
    const int bend_a = (a != 0) & (a2 != 0) ? std::abs(q + a - 2 * a2) : FAR_OFF;
    const int bend_b = (b != 0) & (b2 != 0) ? std::abs(q + b - 2 * b2) : FAR_OFF;
    const int slope = bend_a < bend_b ? q - a : b - q;
    return (q != 0) & (std::min(bend_a, bend_b) < FAR_OFF) ? slope : NO_SLOPE;
}

//! Directions of the rays in 1/4096, along one axis.
std::vector<int> raysOf(int blocks, float focal, float center)
{
    const double WIDEST = 8192;
    std::vector<int> rays(blocks);
    for (int i = 0; i < blocks; i++)
    {
        const double away = 2. * i + 0.5 - center;
        rays[i] = cvRound(std::min(std::max(4096 * away / focal, -WIDEST), WIDEST));
    }
    return rays;
}

//! The normal of a plane whose inverse depth w has the slopes u, v is (focal u, focal v, w - x u - y v).
struct NormalFinder
{
    NormalFinder(const Camera& camera, Size blocks)
        : focal_x(cvRound(std::min(2 * camera.focal.x, 32767.f))), focal_y(cvRound(std::min(2 * camera.focal.y, 32767.f))),
          rays_x(raysOf(blocks.width, camera.focal.x, camera.center.x)),
          rays_y(raysOf(blocks.height, camera.focal.y, camera.center.y))
    {
    }

    static int limit(int value)
    {
        const int STEEPEST = 1 << 16;
        return std::min(std::max(value, -STEEPEST), STEEPEST);
    }

    void findRow(const short* w, int step, int y, Normal* normals) const
    {
        for (size_t x = 0; x < rays_x.size(); x++)
        {
            const int u = slopeAt(w + x, 1), v = slopeAt(w + x, step);
            const bool known = (u != NO_SLOPE) & (v != NO_SLOPE);
            const int a = limit((known ? u : 0) * focal_x >> 4), b = limit((known ? v : 0) * focal_y >> 4);
            const int c = w[x] - ((rays_x[x] * a + rays_y[y] * b) >> 12);
            // Squares and their sum are integers that a double holds, so nothing is rounded before the root.
            const double square = double(a) * a + double(b) * b + double(c) * c;
            const float length = std::max(std::sqrt(float(square)), 1.f);
            const Normal normal = { uchar(128.5f + float(127 * a) / length), uchar(128.5f + float(127 * b) / length) };
            normals[x].x = uchar(known ? normal.x : 0);
            normals[x].y = uchar(known ? normal.y : 0);
        }
    }

    int focal_x, focal_y; // in half pixels
    std::vector<int> rays_x, rays_y;
};

//! Means of 3x3 blocks, where the one in the middle is known.
void smoothRow(const Normal* above, const Normal* row, const Normal* below, int cols, Normal* to)
{
    for (int x = 0; x < cols; x++)
    {
        const int left = x > 0 ? x - 1 : x, right = x + 1 < cols ? x + 1 : x;
        int sx = 0, sy = 0, count = 0;
        for (int i = left; i <= right; i++)
        {
            sx += above[i].x + row[i].x + below[i].x;
            sy += above[i].y + row[i].y + below[i].y;
            count += above[i].known() + row[i].known() + below[i].known();
        }
        const int divisor = std::max(count, 1);
        to[x].x = uchar(row[x].known() ? (sx + divisor / 2) / divisor : 0);
        to[x].y = uchar(row[x].known() ? (sy + divisor / 2) / divisor : 0);
    }
}

template <typename Body> void forRows(int rows, const Body& body)
{
    parallel_for_(Range(0, rows), [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
            body(y);
    });
}

} // namespace

void findSurface(const Mat& depth, FloatRange range, Camera& camera, SurfaceBuffers& buffers, Mat& nearness,
                 Mat& normals)
{
    CV_TRACE_FUNCTION();
    const Size blocks((depth.cols + 1) / 2, (depth.rows + 1) / 2);
    nearness = normals = Mat();
    if (range.last <= 0)
        range = findRange(depth);
    if (range.last <= 0)
        return;
    range.first = std::max(range.first, range.last / 256);
    const double inverse_near = 1. / range.first, inverse_far = 1. / range.last;
    const double slope = std::min((NEAREST - FARTHEST) / (inverse_near - inverse_far), LEVELS / inverse_near);
    const NearnessScale scale = { float(NEAREST + 0.5 - slope * inverse_near), float(slope) };
    camera.horizon = float(NEAREST - slope * inverse_near);

    buffers.nearness.create(depth.size(), CV_8UC1);
    buffers.inverses.create(blocks.height + 2 * REACH, blocks.width + 2 * REACH, CV_16SC1);
    buffers.inverses.setTo(Scalar(0));
    parallel_for_(Range(0, blocks.height), [&](const Range& rows)
    {
        std::vector<float> upper(depth.cols + 1), lower(depth.cols + 1);
        for (int y = rows.start; y < rows.end; y++)
        {
            readRow(depth, 2 * y, upper.data());
            scaleRow(upper.data(), depth.cols, scale, buffers.nearness.ptr(2 * y));
            lower.assign(lower.size(), 0.f);
            if (2 * y + 1 < depth.rows)
            {
                readRow(depth, 2 * y + 1, lower.data());
                scaleRow(lower.data(), depth.cols, scale, buffers.nearness.ptr(2 * y + 1));
            }
            upper[depth.cols] = lower[depth.cols] = 0;
            invertRows(upper.data(), lower.data(), depth.cols + 1, range.first,
                       buffers.inverses.ptr<short>(y + REACH) + REACH);
        }
    });
    double low = 0, high = 0;
    minMaxLoc(buffers.nearness, &low, &high, 0, 0, buffers.nearness);
    if (low >= high)
        return;
    nearness = buffers.nearness;

    buffers.raw_normals.create(blocks, CV_8UC2);
    buffers.normals.create(blocks, CV_8UC2);
    const NormalFinder finder(camera, blocks);
    const int step = int(buffers.inverses.step1());
    forRows(blocks.height, [&](int y)
    {
        finder.findRow(buffers.inverses.ptr<short>(y + REACH) + REACH, step, y, buffers.raw_normals.ptr<Normal>(y));
    });
    forRows(blocks.height, [&](int y)
    {
        smoothRow(buffers.raw_normals.ptr<Normal>(std::max(y - 1, 0)), buffers.raw_normals.ptr<Normal>(y),
                  buffers.raw_normals.ptr<Normal>(std::min(y + 1, blocks.height - 1)), blocks.width,
                  buffers.normals.ptr<Normal>(y));
    });
    normals = buffers.normals;
}

}}} // namespace
