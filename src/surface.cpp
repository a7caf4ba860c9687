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
const int NEAR_INVERSE = 1 << 13; //!< inverse depth of the near end of the range
const int MOST_INVERSE = SHRT_MAX;
const int FARTHEST = 1, NEAREST = 255;
const int LEVELS_OF_GAP = 64; //!< between the near end of the range and what is much nearer
const double LEVELS = 4000;  //!< of nearness, at most, down to infinity: finer differences are noise

//! Nearness is offset + slope / depth.
struct NearnessScale
{
    float offset, slope;
};

//! The depth of a pixel, 0 where it is missing. Infinity is a depth here.
inline float depthOf(uchar depth) { return depth; }
inline float depthOf(ushort depth) { return float(int(depth) & -int(depth != USHRT_MAX)); }
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

//! What depths become levels of nearness.
struct DepthSpan
{
    FloatRange range;
    bool nearer; //!< some are much nearer than the range
};

//! The range of depths without a hundredth at each end, up to infinity if some are that. Values
//! much nearer than half of all, as a value that means "no depth", do not count. {0, 0} if there are not two depths.
FloatRange rangeOf(std::vector<float>& depths, bool has_far, bool& nearer)
{
    const float MUCH = 64;
    FloatRange range = { 0, 0 };
    nearer = false;
    if (depths.empty())
        return range;
    const size_t half = depths.size() / 2, hundredth = depths.size() / 100;
    std::nth_element(depths.begin(), depths.begin() + half, depths.end());
    const float nearest = depths[half] / MUCH;
    const auto kept = std::partition(depths.begin(), depths.end(), [&](float depth) { return depth < nearest; });
    nearer = size_t(kept - depths.begin()) > hundredth;
    if (nearer)
        depths.erase(depths.begin(), kept);
    range = rangeWithout(depths.size() / 100, depths);
    if (range.first >= range.last)
    {
        range.first = *std::min_element(depths.begin(), depths.end());
        range.last = *std::max_element(depths.begin(), depths.end());
    }
    if (has_far)
        range.last = std::numeric_limits<float>::infinity();
    return range.first < range.last || nearer ? range : FloatRange();
}

template <typename T> DepthSpan findSpan(const Mat& depth)
{
    const int64 MANY = 8192, total = int64(depth.rows) * depth.cols;
    std::vector<float> values;
    DepthSpan span = DepthSpan();
    for (int64 step = (total + MANY - 1) / MANY;; step = 1)
    {
        bool has_far = false;
        values.clear();
        visitSample(depth.size(), step, [&](int y, int x)
        {
            const float value = depthOf(depth.at<T>(y, x));
            if (isValidDepth(value))
                values.push_back(value);
            has_far |= isFarDepth(value);
        });
        span.range = rangeOf(values, has_far, span.nearer);
        if (span.range.last > 0 || step == 1)
            return span;
    }
}

DepthSpan findSpan(const Mat& depth)
{
    switch (depth.depth())
    {
    case CV_8U: return findSpan<uchar>(depth);
    case CV_16U: return findSpan<ushort>(depth);
    case CV_16S: return findSpan<short>(depth);
    case CV_32F: return findSpan<float>(depth);
    default: return findSpan<double>(depth);
    }
}

//! Levels of 16 values, 0 where depth is missing.
inline v_uint8x16 levelsOf(const float* values, const float* depths)
{
    const v_float32x4 farthest = v_setall_f32(FARTHEST), nearest = v_setall_f32(NEAREST);
    const v_uint32x4 one = v_setall_u32(1);
    v_int32x4 levels[4];
    v_uint32x4 has_depth[4];
    for (int k = 0; k < 4; k++)
    {
        levels[k] = v_trunc(v_min(v_max(v_load(values + 4 * k), farthest), nearest));
        has_depth[k] = v_min(v_reinterpret_as_u32(v_load(depths + 4 * k)), one);
    }
    const v_uint8x16 known = v_pack(v_pack(has_depth[0], has_depth[1]), v_pack(has_depth[2], has_depth[3]));
    return v_min(v_pack_u(v_pack(levels[0], levels[1]), v_pack(levels[2], levels[3])),
                 v_sub_wrap(v_setzero_u8(), known));
}

//! Behind the rows is room for a multiple of 16.
//! @note A division comes before the addition, so that no processor can do both in one step, rounded otherwise.
void scaleRow(const float* depth, int cols, NearnessScale scale, uchar* nearness)
{
    enum { STRIDE = 16 };
    float values[STRIDE];
    for (int x = 0; x < cols; x += STRIDE)
    {
        for (int i = 0; i < STRIDE; i++)
            values[i] = scale.offset + scale.slope / depth[x + i];
        uchar levels[STRIDE];
        v_store(levels, levelsOf(values, depth + x));
        std::copy(levels, levels + std::min<int>(cols - x, STRIDE), nearness + x);
    }
}

//! 1 for a depth, 0 where it is missing.
inline float isDepth(float depth)
{
    return std::min(depth * FLT_MAX, 1.f);
}

//! Inverse depths of blocks of 2x2 pixels, of those that have depth; 0 if fewer than two have, as where
//! depth is a lattice of single pixels.
void invertRows(const float* upper, const float* lower, int blocks, float near_depth, int* inverses)
{
    const float scale = NEAR_INVERSE * near_depth;
    for (int x = 0; x < blocks; x++)
    {
        const float a = upper[2 * x], b = upper[2 * x + 1], c = lower[2 * x], d = lower[2 * x + 1];
        const float sum = (a + b) + (c + d);
        const float count = (isDepth(a) + isDepth(b)) + (isDepth(c) + isDepth(d));
        const float inverse = scale * count / std::max(sum, FLT_MIN) * std::min(count - 1, 1.f); // 0 for less than two
        inverses[x] = int(std::min(inverse, float(MOST_INVERSE)));
    }
}

//! Slopes of inverse depth: differences over REACH elements, to the side on which it is nearer to a straight line.
//! `known` keeps its bits where one side has depth.
void findSlopes(const int* w, int step, int steepest, int n, int* slopes, int* known)
{
    const int NO_LINE = 1 << 20;
    for (int i = 0; i < n; i++)
    {
        const int a = w[i - REACH * step], half_a = w[i - REACH / 2 * step], here = w[i];
        const int b = w[i + REACH * step], half_b = w[i + REACH / 2 * step];
        const int bend_a = std::abs(here + a - 2 * half_a) | (-int((a == 0) | (half_a == 0)) & NO_LINE);
        const int bend_b = std::abs(here + b - 2 * half_b) | (-int((b == 0) | (half_b == 0)) & NO_LINE);
        const int to_b = -int(bend_b <= bend_a); // all bits
        const int slope = ((b - here) & to_b) | ((here - a) & ~to_b);
        slopes[i] = std::min(std::max(slope, -steepest), steepest);
        known[i] &= -int((bend_a < NO_LINE) | (bend_b < NO_LINE));
    }
}

//! Directions of the rays of blocks along one axis, for a step forward of 1. Rays farther out are as those at WIDEST.
std::vector<float> raysOf(int blocks, float focal, float center)
{
    const float WIDEST = 2;
    std::vector<float> rays(blocks);
    for (int i = 0; i < blocks; i++)
        rays[i] = std::min(std::max((2 * float(i) + 0.5f - center) / focal, -WIDEST), WIDEST);
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
        const int cols = int(rays_x_.size());
        for (int first = 0; first < cols; first += STRIDE)
        {
            Stride stride;
            const int n = std::min<int>(cols - first, STRIDE);
            for (int i = 0; i < n; i++)
                stride.known[i] = -int(w[first + i] != 0);
            findSlopes(w + first, 1, int(float(MOST) / per_slope_x_), n, stride.slopes_x, stride.known);
            findSlopes(w + first, step, int(float(MOST) / per_slope_y_), n, stride.slopes_y, stride.known);
            findLengths(w + first, &rays_x_[first], rays_y_[y], n, stride);
            for (int i = 0; i < n; i++)
            {
                const int nx = int(Normal::ZERO + 0.5f + stride.x[i] / stride.lengths[i]);
                const int ny = int(Normal::ZERO + 0.5f + stride.y[i] / stride.lengths[i]);
                normals[first + i] = (nx | ny << Y_SHIFT | 1 << COUNT_SHIFT) & stride.known[i];
            }
        }
    }

private:
    enum { STRIDE = 64, MOST = 2 * MOST_INVERSE }; // of what normals are made of, so that squares fit

    //! Some blocks of a row. All bits of `known` are set where there is a normal, none elsewhere.
    struct Stride
    {
        int known[STRIDE], slopes_x[STRIDE], slopes_y[STRIDE];
        float x[STRIDE], y[STRIDE], lengths[STRIDE];
    };

    //! Two components of a vector, and its length divided by Normal::ONE.
    void findLengths(const int* w, const float* rays_x, float ray_y, int n, Stride& to) const
    {
        const float SHARE = 1 / 256.f, UNIT = 1.f / Normal::ONE;
        const float per_slope_x = per_slope_x_, per_slope_y = per_slope_y_;
        std::fill_n(to.lengths, int(STRIDE), 1.f);
        for (int i = 0; i < n; i++)
        {
            const float x = float(to.slopes_x[i]) * per_slope_x, y = float(to.slopes_y[i]) * per_slope_y;
            const float z = float(w[i] - int(x * rays_x[i]) - int(y * ray_y));
            const int square = int(x * x * SHARE) + int(y * y * SHARE) + int(z * z * SHARE);
            to.x[i] = x;
            to.y[i] = y;
            to.lengths[i] = float(square + 2) * (UNIT * UNIT / SHARE);
        }
        for (int i = 0; i < STRIDE; i += 4)
            v_store(to.lengths + i, v_sqrt(v_load(to.lengths + i)));
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
    DepthSpan span = { range, false };
    if (range.last <= 0)
        span = findSpan(depth);
    if (span.range.last <= 0)
        return;
    const float first = std::max(span.range.first, span.range.last <= FLT_MAX ? span.range.last / 256 : 0);
    const int near_level = span.nearer ? NEAREST - LEVELS_OF_GAP : NEAREST;
    const double inverse_near = 1. / first, inverse_far = 1. / span.range.last;
    const double slope = std::min((near_level - FARTHEST) / std::max(inverse_near - inverse_far, DBL_MIN),
                                  LEVELS / inverse_near);
    const NearnessScale scale = { float(near_level + 0.5 - slope * inverse_near), float(slope) };
    camera.horizon = float(near_level - slope * inverse_near);

    buffers.nearness.create(depth.size(), CV_8UC1);
    buffers.inverses.create(blocks.height + 2 * REACH, blocks.width + 2 * REACH, CV_32SC1);
    buffers.inverses.setTo(Scalar(0));
    parallel_for_(Range(0, blocks.height), [&](const Range& rows)
    {
        std::vector<float> upper(alignSize(2 * blocks.width, 16)), lower(upper.size());
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
            invertRows(upper.data(), lower.data(), blocks.width, first,
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
