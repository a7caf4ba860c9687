// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "surface.hpp"
#include "shared/features.hpp"
#include "shared/valid_depth.hpp"
#include <opencv2/core/hal/intrin.hpp>

namespace cv { namespace ximgproc { namespace gws {

namespace {

const int REACH = 4;         //!< blocks over which differences are taken; less is noise, more misses small things
const int NEAR_INVERSE = 1 << 13; //!< inverse depth of the near end of the range, a number that floats hold
const int MOST_INVERSE = SHRT_MAX;
const int FARTHEST = 1, NEAREST = 255;
const double LEVELS = 4000;  //!< of nearness, at most, down to infinity: finer differences are noise

//! Nearness is offset + slope / depth.
struct NearnessScale
{
    float offset, slope;
};

//! The depth of a pixel, 0 where it is missing. Infinity is a depth here.
inline float depthOf(uchar depth) { return depth; }
inline float depthOf(ushort depth) { return float(depth == USHRT_MAX ? 0 : int(depth)); }
inline float depthOf(short depth) { return float(std::max(int(depth), 0)); }
template <typename T> inline float depthOf(T depth) { return float(depth > 0 ? depth : 0); }

template <typename T> void readRow(const T* from, int cols, float* to)
{
    for (int x = 0; x < cols; x++)
        to[x] = depthOf(from[x]);
}

void readRow(const Mat& depth, int y, float* to)
{
    switch (depth.depth())
    {
    case CV_8U: return readRow(depth.ptr<uchar>(y), depth.cols, to);
    case CV_16U: return readRow(depth.ptr<ushort>(y), depth.cols, to);
    case CV_16S: return readRow(depth.ptr<short>(y), depth.cols, to);
    case CV_32F: return readRow(depth.ptr<float>(y), depth.cols, to);
    default: readRow(depth.ptr<double>(y), depth.cols, to);
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

//! 1 for a depth, 0 where it is missing.
inline float isDepth(float depth)
{
    return std::min(depth * FLT_MAX, 1.f);
}

//! Inverse depths of blocks of 2x2 pixels, of those that have depth; 0 if none has. 
void invertRows(const float* upper, const float* lower, int blocks, float near_depth, int* inverses)
{
    const float scale = NEAR_INVERSE * near_depth;
    for (int x = 0; x < blocks; x++)
    {
        const float a = upper[2 * x], b = upper[2 * x + 1], c = lower[2 * x], d = lower[2 * x + 1];
        const float sum = (a + b) + (c + d);
        const float count = (isDepth(a) + isDepth(b)) + (isDepth(c) + isDepth(d));
        const float inverse = scale * count / std::max(sum, FLT_MIN);
        inverses[x] = int(std::min(inverse, float(MOST_INVERSE)));
    }
}

//! The difference over REACH elements to the side on which inverse depth is nearer to a straight line. bend becomes how
//! far it is from one, NO_PLANE if neither side has depth.
const int NO_PLANE = 1 << 20;
inline int slopeAt(const int* w, int step, int& bend)
{
    const int a = w[-REACH * step], half_a = w[-REACH / 2 * step], here = w[0];
    const int b = w[REACH * step], half_b = w[REACH / 2 * step];
    const int bend_a = std::min(a, half_a) > 0 ? std::abs(here + a - 2 * half_a) : NO_PLANE;
    const int bend_b = std::min(b, half_b) > 0 ? std::abs(here + b - 2 * half_b) : NO_PLANE;
    bend = std::max(bend, std::min(bend_a, bend_b));
    return bend_a < bend_b ? here - a : b - here;
}

//! Directions of the rays of blocks along one axis, for a step forward of 1.
std::vector<float> raysOf(int blocks, float focal, float center)
{
    std::vector<float> rays(blocks);
    for (int i = 0; i < blocks; i++)
        rays[i] = (2 * float(i) + 0.5f - center) / focal;
    return rays;
}

//! A normal with its number, in parts of a word that 9 of them can be added up in.
enum { Y_SHIFT = 12, COUNT_SHIFT = 24, PART = (1 << 12) - 1 };

//! Finds the normals of a row of blocks.
//! @note No product is added to anything, because some processors round that once, others twice. Squares are taken
//! as integers.
class NormalFinder
{
public:
    NormalFinder(const Camera& camera, Size blocks)
        : per_slope_x_(camera.focal.x / (2 * REACH)), per_slope_y_(camera.focal.y / (2 * REACH)),
          rays_x_(raysOf(blocks.width, camera.focal.x, camera.center.x)),
          rays_y_(raysOf(blocks.height, camera.focal.y, camera.center.y))
    {
    }

    //! The normal of a plane whose inverse depth w has the slopes u, v, along rays (x, y, 1), is
    //! (focal u, focal v, w - x focal u - y focal v).
    void findRow(const int* w, int step, int y, int* normals) const
    {
        enum { STRIDE = 64 };
        const int cols = int(rays_x_.size());
        float a[STRIDE], b[STRIDE], squares[STRIDE], lengths[STRIDE];
        int known[STRIDE];
        std::fill_n(squares, int(STRIDE), 1.f);
        for (int first = 0; first < cols; first += STRIDE)
        {
            const int n = std::min<int>(cols - first, STRIDE);
            findStride(w + first, step, &rays_x_[first], rays_y_[y], n, a, b, squares, known);
            for (int i = 0; i < STRIDE; i += 4)
                v_store(lengths + i, v_sqrt(v_load(squares + i)));
            for (int i = 0; i < n; i++)
            {
                const int nx = int(Normal::ZERO + 0.5f + a[i] / lengths[i]);
                const int ny = int(Normal::ZERO + 0.5f + b[i] / lengths[i]);
                normals[first + i] = (nx | ny << Y_SHIFT | 1 << COUNT_SHIFT) & known[i];
            }
        }
    }

private:
    //! Two components, the squared length in units that make it Normal::ONE, and whether there is a normal: all bits.
    void findStride(const int* w, int step, const float* rays_x, float ray_y, int n, float* a, float* b,
                    float* squares, int* known) const
    {
        const float STEEPEST = 8 * MOST_INVERSE, SHARE = 1 / 64.f, UNIT = 1.f / Normal::ONE;
        for (int i = 0; i < n; i++)
        {
            int bend = w[i] > 0 ? 0 : NO_PLANE;
            const float u = float(slopeAt(w + i, 1, bend)) * per_slope_x_;
            const float v = float(slopeAt(w + i, step, bend)) * per_slope_y_;
            a[i] = std::min(std::max(u, -STEEPEST), STEEPEST);
            b[i] = std::min(std::max(v, -STEEPEST), STEEPEST);
            const float c = float(w[i] - int(a[i] * rays_x[i]) - int(b[i] * ray_y));
            const int square = int(a[i] * a[i] * SHARE) + int(b[i] * b[i] * SHARE) + int(c * c * SHARE);
            squares[i] = float(square + 2) * (UNIT * UNIT / SHARE);
            known[i] = -int(bend < NO_PLANE);
        }
    }

    const float per_slope_x_, per_slope_y_;
    const std::vector<float> rays_x_, rays_y_;
};

//! Means over 3x3 blocks, where the one in the middle is known.
void smoothRow(const int* above, const int* row, const int* below, int cols, std::vector<int>& sums, Normal* to)
{
    sums.assign(cols + 2, 0); // of columns, between empty ones
    for (int x = 0; x < cols; x++)
        sums[x + 1] = above[x] + row[x] + below[x];
    for (int x = 0; x < cols; x++)
    {
        const int sum = sums[x] + sums[x + 1] + sums[x + 2];
        const float count = float(std::max(sum >> COUNT_SHIFT, 1));
        const int nx = int(0.5f + float(sum & PART) / count), ny = int(0.5f + float(sum >> Y_SHIFT & PART) / count);
        const int known = -int(row[x] != 0); // all bits
        to[x].x = uchar(nx & known);
        to[x].y = uchar(ny & known);
    }
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
    buffers.inverses.create(blocks.height + 2 * REACH, blocks.width + 2 * REACH, CV_32SC1);
    buffers.inverses.setTo(Scalar(0));
    parallel_for_(Range(0, blocks.height), [&](const Range& rows)
    {
        std::vector<float> upper(2 * blocks.width), lower(2 * blocks.width);
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
            invertRows(upper.data(), lower.data(), blocks.width, range.first,
                       buffers.inverses.ptr<int>(y + REACH) + REACH);
        }
    });
    double low = 0, high = 0;
    minMaxLoc(buffers.nearness, &low, &high, 0, 0, buffers.nearness);
    if (low >= high)
        return;
    nearness = buffers.nearness;

    buffers.raw_normals.create(blocks.height + 2, blocks.width, CV_32SC1);
    buffers.raw_normals.row(0).setTo(Scalar(0));
    buffers.raw_normals.row(blocks.height + 1).setTo(Scalar(0));
    buffers.normals.create(blocks, CV_8UC2);
    const NormalFinder finder(camera, blocks);
    const int step = int(buffers.inverses.step1());
    parallel_for_(Range(0, blocks.height), [&](const Range& rows)
    {
        for (int y = rows.start; y < rows.end; y++)
            finder.findRow(buffers.inverses.ptr<int>(y + REACH) + REACH, step, y, buffers.raw_normals.ptr<int>(y + 1));
    });
    parallel_for_(Range(0, blocks.height), [&](const Range& rows)
    {
        std::vector<int> sums;
        for (int y = rows.start; y < rows.end; y++)
            smoothRow(buffers.raw_normals.ptr<int>(y), buffers.raw_normals.ptr<int>(y + 1),
                      buffers.raw_normals.ptr<int>(y + 2), blocks.width, sums, buffers.normals.ptr<Normal>(y));
    });
    normals = buffers.normals;
}

}}} // namespace
