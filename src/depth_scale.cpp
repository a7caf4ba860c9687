// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "depth_scale.hpp"
#include "shared/valid_depth.hpp"

#include <type_traits>

namespace cv { namespace ximgproc { namespace gws {

namespace {

const int NEAREST = 1, FARTHEST = 255;
const int LEVELS_OF_GAP = 64; //!< what lies apart stays apart, also where one of them is infinity

//! A scale from depths to levels, of at most three straight pieces.
class DepthScale
{
public:
    //! One piece; last is larger than first.
    explicit DepthScale(FloatRange range, int farthest = FARTHEST) : num_pieces_(1), last_(range.last)
    {
        const Piece piece = { range.first, NEAREST, (farthest - NEAREST) / (double(range.last) - range.first) };
        pieces_[0] = piece;
    }

    //! Almost no depth is between those of the gap. It becomes short, so that depths on both sides are told apart.
    //! @note Differences of less than a thousandth of the depth are noise: they get a level at most.
    DepthScale(FloatRange range, FloatRange gap, int farthest) : num_pieces_(3), last_(range.last)
    {
        const double near_length = double(gap.first) - range.first, far_length = double(range.last) - gap.last;
        const double even = (farthest - NEAREST - LEVELS_OF_GAP) / std::max(near_length + far_length, DBL_MIN);
        const double near_slope = std::min(even, 1000. / gap.first), far_slope = std::min(even, 1000. / gap.last);
        const double gap_begin = NEAREST + near_slope * near_length, gap_end = farthest - far_slope * far_length;
        const Piece pieces[3] = { { range.first, NEAREST, near_slope },
                                  { gap.first, gap_begin, (gap_end - gap_begin) / (double(gap.last) - gap.first) },
                                  { gap.last, gap_end, far_slope } };
        std::copy(pieces, pieces + 3, pieces_);
    }

    bool isStraight() const { return num_pieces_ == 1; }

    uchar operator()(float depth) const
    {
        const float value = clip(depth);
        int i = 0;
        while (i + 1 < num_pieces_ && value >= pieces_[i + 1].first)
            i++;
        return levelOf(value, pieces_[i]);
    }

    //! The same for a straight scale.
    uchar onlyPiece(float depth) const { return levelOf(clip(depth), pieces_[0]); }

private:
    struct Piece
    {
        float first;
        double level, slope;
    };

    float clip(float depth) const { return std::min(std::max(depth, pieces_[0].first), last_); }

    static uchar levelOf(float value, const Piece& piece)
    {
        return uchar(piece.level + 0.5 + piece.slope * (value - piece.first));
    }

    Piece pieces_[3];
    int num_pieces_;
    float last_;
};

//! The measured depths of a frame, or of a sample of it.
class DepthSample
{
public:
    template <typename T> void take(const Mat& depth)
    {
        const int64 ALL = 65536, MANY = 32768, ENOUGH = MANY / 8, total = int64(depth.rows) * depth.cols;
        take<T>(depth, total <= ALL ? 1 : (total + MANY - 1) / MANY);
        if (total > ALL && values_.size() < size_t(ENOUGH))
            take<T>(depth, 1);
    }

    bool empty() const { return values_.empty(); }
    bool hasFar() const { return has_far_; }

    //! The 1st and 99th percentile, so that a few outliers do not matter.
    //! @note The paper says only that D is scaled.
    FloatRange findRange()
    {
        return rangeWithout(values_.size() / 100, values_);
    }

    //! Finds a gap that leaves an eighth of the range at most to all depths: one side of it is a value that stands for
    //! none, or so far away that nothing else could be told apart. Up to one in a hundred depths may lie in a gap.
    bool findGap(FloatRange range, FloatRange& gap) const
    {
        const int BINS = 256, SHORTEST = BINS * 7 / 8;
        int counts[BINS] = {};
        for (float value : values_)
            if (value >= range.first && value <= range.last)
                counts[binOf(value, range, BINS)]++;
        const int most = int(values_.size() / 100);
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
        gap.first = range.first;
        gap.last = range.last;
        for (float value : values_)
            if (value >= range.first && value <= range.last)
            {
                const int bin = binOf(value, range, BINS);
                if (bin < begin)
                    gap.first = std::max(gap.first, value);
                else if (bin >= begin + length)
                    gap.last = std::min(gap.last, value);
            }
        return true;
    }

private:
    static int binOf(float value, FloatRange range, int bins)
    {
        const double share = (double(value) - range.first) / (double(range.last) - range.first);
        return std::min(int(share * bins), bins - 1);
    }

    template <typename T> void take(const Mat& depth, int64 step)
    {
        values_.clear();
        values_.reserve(size_t(std::min<int64>(int64(depth.rows) * depth.cols / step + 1, 65536)));
        has_far_ = false;
        visitSample(depth.size(), step, [&](int y, int x)
        {
            const T value = depth.at<T>(y, x);
            if (isValidDepth(value))
                values_.push_back(float(value));
            else if (isFarDepth(value))
                has_far_ = true;
        });
    }

    std::vector<float> values_;
    bool has_far_ = false;
};

//! Extrema of all measured depths; {0, 0} if there is none.
template <typename T> FloatRange findExtrema(const Mat& depth)
{
    FloatRange range = { FLT_MAX, 0 };
    for (int y = 0; y < depth.rows; y++)
    {
        const T* row = depth.ptr<T>(y);
        for (int x = 0; x < depth.cols; x++)
            if (isValidDepth(row[x]))
            {
                range.first = std::min(range.first, float(row[x]));
                range.last = std::max(range.last, float(row[x]));
            }
    }
    return range.last > 0 ? range : FloatRange();
}

//! Writes levelOf(depth) of all depths that were measured, and what stands for the others.
template <typename T, typename LevelOf> void scaleRows(const Mat& depth, LevelOf levelOf, Mat& scaled)
{
    parallel_for_(Range(0, depth.rows), [&](const Range& rows)
    {
        for (int y = rows.start; y < rows.end; y++)
        {
            const T* from = depth.ptr<T>(y);
            uchar* to = scaled.ptr(y);
            for (int x = 0; x < depth.cols; x++)
                to[x] = isValidDepth(from[x]) ? levelOf(from[x]) : uchar(isFarDepth(from[x]) ? FARTHEST : 0);
        }
    });
}

//! Floats.
template <typename T> void scaleAll(const Mat& depth, const DepthScale& scale, Mat& scaled, std::false_type)
{
    if (scale.isStraight()) // a loop of its own, which compilers vectorise
        scaleRows<T>(depth, [&](T value) { return scale.onlyPiece(float(value)); }, scaled);
    else
        scaleRows<T>(depth, [&](T value) { return scale(float(value)); }, scaled);
}

//! Integers. Where there are fewer values than pixels, the level of each is found once.
template <typename T> void scaleAll(const Mat& depth, const DepthScale& scale, Mat& scaled, std::true_type)
{
    const int last = std::numeric_limits<T>::max();
    if (int64(depth.rows) * depth.cols <= last)
        return scaleAll<T>(depth, scale, scaled, std::false_type());
    std::vector<uchar> levels(last + 1);
    for (int value = 0; value <= last; value++)
        levels[value] = scale(float(value));
    scaleRows<T>(depth, [&](T value) { return levels[value]; }, scaled);
}

//! The scale of a frame. Depths that are equal become 1, so that those that are infinite differ from them.
template <typename T> DepthScale findScale(const Mat& depth)
{
    DepthSample sample;
    sample.take<T>(depth);
    FloatRange range = sample.empty() ? FloatRange() : sample.findRange(), gap;
    if (range.first >= range.last)
        range = findExtrema<T>(depth);
    if (range.first >= range.last)
        range.last = std::numeric_limits<float>::infinity();
    const int farthest = sample.hasFar() ? FARTHEST - LEVELS_OF_GAP : FARTHEST;
    if (!sample.empty() && sample.findGap(range, gap))
        return DepthScale(range, gap, farthest);
    return DepthScale(range, farthest);
}

template <typename T> void scaleToBytes(const Mat& depth, FloatRange range, Mat& scaled)
{
    scaleAll<T>(depth, range.last > 0 ? DepthScale(range) : findScale<T>(depth), scaled,
                std::integral_constant<bool, std::numeric_limits<T>::is_integer>());
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
    buffer.create(depth.size(), CV_8UC1);
    switch (depth.depth())
    {
    case CV_8U:
        if (range.last > 0)
            scaleToBytes<uchar>(depth, range, buffer);
        else
            depth.copyTo(buffer);
        break;
    case CV_16U: scaleToBytes<ushort>(depth, range, buffer); break;
    case CV_16S: scaleToBytes<short>(depth, range, buffer); break;
    case CV_32F: scaleToBytes<float>(depth, range, buffer); break;
    default: scaleToBytes<double>(depth, range, buffer);
    }
    return tellsApart(buffer) ? buffer : Mat();
}

}}} // namespace
