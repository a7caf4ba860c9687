// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth/depth_noise.hpp"
#include "depth/depth_rows.hpp"
#include "depth/depth_sample.hpp"
#include "depth/depth_scale.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

const int NEAREST = 1, FARTHEST = 255;
const int LEVELS_OF_GAP = 64; //!< what lies apart stays apart, also where one of them is infinity

//! A scale from depths to levels, of at most three straight pieces.
class DepthScale
{
public:
    //! One piece; last is larger than first.
    explicit DepthScale(FloatRange range, int farthest = FARTHEST) : num_pieces_(1)
    {
        pieces_[0] = Piece(range, farthest - NEAREST);
    }

    //! Almost no depth is between those of the gap. It becomes short, so that depths on both sides are told apart.
    //! @note Differences of less than a thousandth of the depth are noise: they get a level at most.
    DepthScale(FloatRange range, FloatRange gap, int farthest) : num_pieces_(3)
    {
        const double near_length = double(gap.first) - range.first, far_length = double(range.last) - gap.last;
        const double even = (farthest - NEAREST - LEVELS_OF_GAP) / std::max(near_length + far_length, DBL_MIN);
        const double near_levels = near_length * std::min(even, 1000. / gap.first);
        const double far_levels = far_length * std::min(even, 1000. / gap.last);
        const FloatRange near_range = { range.first, gap.first }, far_range = { gap.last, range.last };
        pieces_[0] = Piece(near_range, near_levels);
        pieces_[1] = Piece(gap, farthest - NEAREST - near_levels - far_levels);
        pieces_[2] = Piece(far_range, far_levels);
    }

    //! Levels of four depths, 0 where depth is missing.
    //! @note A division comes before the addition, so that no processor can do both in one step, rounded otherwise.
    v_int32x4 levelsOf(const float* depths) const
    {
        const v_float32x4 depth = v_load(depths);
        v_float32x4 level = v_setall_f32(NEAREST + 0.5f);
        for (int i = 0; i < num_pieces_; i++)
        {
            const v_float32x4 first = v_setall_f32(pieces_[i].first), last = v_setall_f32(pieces_[i].last);
            const v_float32x4 within = subtract(v_min(v_max(depth, first), last), first);
            level = add(level, divide(within, v_setall_f32(pieces_[i].step)));
        }
        return v_max(bitAnd(v_trunc(level), hasDepth(depth)), bitAnd(v_setall_s32(FARTHEST), isFar(depth)));
    }

private:
    //! Levels rise by one with each step from the first of some depths to the last one.
    struct Piece
    {
        Piece() {}
        Piece(FloatRange depths, double num_levels)
            : first(depths.first), last(std::min(depths.last, FLT_MAX)),
              step(std::max(float((double(depths.last) - depths.first) / std::max(num_levels, DBL_MIN)), FLT_MIN))
        {
        }

        float first, last, step;
    };

    //! All bits where a depth is infinite.
    static v_int32x4 isFar(const v_float32x4& depth)
    {
        return isPositive(subtract(v_reinterpret_as_s32(depth), v_reinterpret_as_s32(v_setall_f32(FLT_MAX))));
    }

    Piece pieces_[3];
    int num_pieces_;
};

//! Of all pixels of a small image, or where those of a sample have few depths.
DepthSample sampleFrame(const Mat& depth)
{
    const int64 total = int64(depth.rows) * depth.cols;
    const int64 ALL = 65536, MANY = 32768, ENOUGH = MANY / 8; // a hundredth of them, an end, are 40 depths at least
    const DepthSample sample = sampleDepths(depth, total <= ALL ? 1 : sampleStep(total, MANY));
    return total <= ALL || int64(sample.depths.size()) >= ENOUGH ? sample : sampleDepths(depth, 1);
}

//! Extrema of all measured depths; {0, 0} if there is none.
FloatRange findExtrema(const Mat& depth)
{
    FloatRange range = { FLT_MAX, 0 };
    std::vector<float> row(depth.cols);
    for (int y = 0; y < depth.rows; y++)
    {
        readDepthRow(depth.row(y), row.data());
        for (float value : row)
            if (isValidDepth(value))
            {
                range.first = std::min(range.first, value);
                range.last = std::max(range.last, value);
            }
    }
    return range.last > 0 ? range : FloatRange();
}

//! The 1st and 99th percentile, so that a few outliers do not matter, or the extrema of all depths where these are the
//! same. Depths that are all equal become 1, so that those that are infinite differ from them.
//! @note The paper says only that D is scaled.
FloatRange findRange(const Mat& depth, std::vector<float>& depths)
{
    FloatRange range = { 0, 0 };
    if (!depths.empty())
        range = rangeWithout(depths.size() / 100, depths);
    if (range.first < range.last)
        return range;
    range = findExtrema(depth);
    if (range.first >= range.last)
        range.last = std::numeric_limits<float>::infinity();
    return range;
}

int binOf(float depth, FloatRange range, int bins)
{
    const double share = (double(depth) - range.first) / (double(range.last) - range.first);
    return std::min(int(share * bins), bins - 1);
}

//! Finds a gap that leaves an eighth of the range at most to all depths: one side of it is a value that stands for
//! none, or so far away that nothing else could be told apart. Up to one in a hundred depths may lie in a gap.
bool findGap(const std::vector<float>& depths, FloatRange range, FloatRange& gap)
{
    const int BINS = 256, SHORTEST = BINS * 7 / 8;
    int counts[BINS] = {};
    for (float depth : depths)
        if (depth >= range.first && depth <= range.last)
            counts[binOf(depth, range, BINS)]++;
    const int most = int(depths.size() / 100);
    int begin = 0, length = 0;
    for (int first = 0, end = 0, inside = 0; first < BINS; inside -= counts[first++])
    {
        while (end < BINS && inside + counts[end] <= most)
            inside += counts[end++];
        if (end - first > length)
        {
            begin = first;
            length = end - first;
        }
        if (end == first)
            inside += counts[end++];
    }
    if (length < SHORTEST || begin == 0 || begin + length == BINS)
        return false;
    gap = range;
    for (float depth : depths)
        if (depth >= range.first && depth <= range.last)
        {
            const int bin = binOf(depth, range, BINS);
            if (bin < begin)
                gap.first = std::max(gap.first, depth);
            else if (bin >= begin + length)
                gap.last = std::min(gap.last, depth);
        }
    return true;
}

//! How many levels a range gets: so many that they are no finer than noise.
int levelsFor(const Mat& depth, FloatRange range, int most)
{
    if (range.last > FLT_MAX)
        return most; // all depths are equal
    const double noise = noiseOfDepth(depth, range, false), length = double(range.last) - range.first;
    return noise * most > LEVELS_OF_NOISE * length ? std::max(int(LEVELS_OF_NOISE * length / noise), 1) : most;
}

//! The scale of a frame.
DepthScale findScale(const Mat& depth)
{
    DepthSample sample = sampleFrame(depth);
    FloatRange range = findRange(depth, sample.depths), gap;
    const int farthest = sample.has_far ? FARTHEST - LEVELS_OF_GAP : FARTHEST;
    if (findGap(sample.depths, range, gap))
        return DepthScale(range, gap, farthest);
    return DepthScale(range, NEAREST + levelsFor(depth, range, farthest - NEAREST));
}

void scaleRows(const Mat& depth, const DepthScale& scale, Mat& scaled)
{
    scaled.create(depth.size(), CV_8UC1);
    parallel_for_(Range(0, depth.rows), [&](const Range& rows)
    {
        std::vector<float> depths(alignSize(depth.cols, LEVELS_AT_ONCE));
        for (int y = rows.start; y < rows.end; y++)
        {
            readDepthRow(depth.row(y), depths.data());
            writeLevels(depths.data(), depth.cols, [&](const float* from) { return scale.levelsOf(from); },
                        scaled.ptr(y));
        }
    });
}

//! Whether there are two levels.
bool tellsApart(const Mat& scaled)
{
    uchar first = 0;
    for (int y = 0; y < scaled.rows; y++)
    {
        const uchar* row = scaled.ptr(y);
        for (int x = 0; x < scaled.cols; x++)
        {
            if (first && row[x] && row[x] != first)
                return true;
            first = std::max(first, row[x]);
        }
    }
    return false;
}

} // namespace

//! @note Depth that is the same everywhere is dropped: halving all priorities by equation (3) would
//! make some of them equal, and the flood another one, although depth says nothing.
Mat scaleDepth(const Mat& depth, FloatRange range, Mat& buffer)
{
    CV_TRACE_FUNCTION();
    if (depth.empty())
        return Mat();
    if (depth.depth() == CV_8U && range.last == 0)
        depth.copyTo(buffer);
    else
        scaleRows(depth, range.last > 0 ? DepthScale(range) : findScale(depth), buffer);
    return tellsApart(buffer) ? buffer : Mat();
}

}}} // namespace
