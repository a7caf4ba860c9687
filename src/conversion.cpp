// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "conversion.hpp"

#include <atomic>

namespace cv { namespace ximgproc { namespace gws {

namespace {

const int OUTLIERS = 1000;  //!< one value in so many may lie outside of the usual range, or is left out at each end
const int SHARE_OF_NOMINAL = 16; //!< values that span less than one part in so many are stretched

//! The range of the frame, where white and black are not those of the type. T holds the values and their differences.
template <typename T> class RangeFinder
{
public:
    typedef RangeOf<T> ValueRange;

    RangeFinder(const Mat& image, const Mat& mask)
        : image_(image), mask_(mask), channels_(image.channels()), colors_(std::min(channels_, 3)),
          row_(image.cols * channels_, image.rows)
    {
    }

    ValueRange find()
    {
        takeSample();
        if (values_.empty())
            return ValueRange();
        ValueRange nominal;
        const bool lies_in_nominal = findNominal(nominal) && liesIn(nominal);
        if (lies_in_nominal && spansMuchOf(nominal))
            return nominal;
        const ValueRange range = rangeWithout(values_.size() / OUTLIERS, values_);
        if (hasLights(range))
            return nominal;
        if (range.first < range.last)
            return range;
        return lies_in_nominal ? nominal : findExtrema();
    }

private:
    //! False for types of which no part is the usual one.
    bool findNominal(ValueRange& range)
    {
        const ValueRange chars = { -128, 127 }, unit = { 0, 1 };
        const int depth = image_.depth();
        range = depth == CV_16U ? rangeOfBits() : depth == CV_8S ? chars : unit;
        return depth != CV_16S && depth != CV_32S;
    }

    //! Cameras give 10, 12, or 14 bits in 16: the fewest, but 8 at least, that hold the values without outliers. Where
    //! all are multiples of 257, 8 bits were spread over 16, as 65535 is 255 * 257, also in a dark picture.
    ValueRange rangeOfBits()
    {
        const bool are_spread = areSpread();
        const auto highest = values_.end() - 1 - int(values_.size()) / OUTLIERS;
        std::nth_element(values_.begin(), highest, values_.end());
        int levels = are_spread ? 65536 : 256;
        while (T(levels) <= *highest)
            levels *= 2;
        return { 0, T(levels - 1) };
    }

    bool areSpread() const
    {
        return std::all_of(values_.begin(), values_.end(), [](T value) { return int(value) % 257 == 0; });
    }

    //! The finite values of a sample; of all values, if too few of these count: one of OUTLIERS must be some.
    void takeSample()
    {
        const int64 MIN_VALUES = 16384, MAX_VALUES = 65536, PIXELS_PER_VALUE = 64, ENOUGH = MIN_VALUES / 8;
        const int64 total = int64(image_.cols) * colors_ * image_.rows;
        const int64 wanted = std::min(std::max(total / PIXELS_PER_VALUE, MIN_VALUES), MAX_VALUES);
        takeOneOf(sampleStep(total, wanted));
        if (total > wanted && values_.size() < size_t(ENOUGH))
            takeOneOf(1);
    }

    //! The finite ones of one value of each `step`.
    void takeOneOf(int64 step)
    {
        Mat values;
        values_.clear();
        readSample(Size(image_.cols * colors_, image_.rows), step, image_.depth(), [&](int y, int i)
        {
            const int x = i / colors_ * channels_ + i % colors_;
            return counts(y, x) ? image_.ptr(y) + size_t(x) * image_.elemSize1() : 0;
        }, [&](const Mat& some)
        {
            some.convertTo(values, DataType<T>::depth);
            std::copy_if(values.begin<T>(), values.end<T>(), std::back_inserter(values_), isFinite);
        });
    }

    //! Values outside of the mask and of a fourth channel do not count.
    bool counts(int y, int x) const
    {
        return x % channels_ < colors_ && (mask_.empty() || mask_.at<uchar>(y, x / channels_));
    }

    //! The values of row y that do not count become NaN.
    void eraseOthers(int y, T* values) const
    {
        const uchar* const inside = mask_.empty() ? 0 : mask_.ptr(y);
        for (int x = 0; x < image_.cols; x++, values += channels_)
            std::fill(values + (!inside || inside[x] ? colors_ : 0), values + channels_,
                      std::numeric_limits<T>::quiet_NaN());
    }

    static bool isFinite(T value) { return std::abs(value) <= std::numeric_limits<T>::max(); }

    //! Calls visit(values, count) for the rows; those that do not count are NaN.
    template <typename Visit> void forValues(Visit visit) const
    {
        parallel_for_(Range(0, row_.height), [&](const Range& rows)
        {
            Mat values;
            for (int y = rows.start; y < rows.end; y++)
            {
                const bool all = mask_.empty() && channels_ == colors_;
                const bool as_it_is = all && image_.depth() == DataType<T>::depth;
                if (!as_it_is)
                    image_.row(y).convertTo(values, DataType<T>::depth);
                if (!all)
                    eraseOthers(y, values.ptr<T>());
                visit(as_it_is ? image_.ptr<T>(y) : values.ptr<T>(), row_.width);
            }
        });
    }

    //! Whether hardly any finite value is outside of a range.
    bool liesIn(ValueRange range) const
    {
        if (image_.depth() == CV_16U || image_.depth() == CV_8S)
            return true;
        std::atomic<int64> outside(0), finite(0);
        forValues([&](const T* values, int count)
        {
            int known = 0, lower = 0, higher = 0, infinite = 0;
            for (int x = 0; x < count; x++)
            {
                known += values[x] == values[x];
                lower += values[x] < range.first;
                higher += values[x] > range.last;
                infinite += std::abs(values[x]) > std::numeric_limits<T>::max();
            }
            finite += known - infinite;
            if (lower + higher > infinite)
                outside += lower + higher - infinite;
        });
        return outside <= finite / OUTLIERS;
    }

    //! Whether the values without outliers span more than a small part of a range, and, of more than 8 bits, more than
    //! half of the lowest one: those of a thermal camera may lie far above 0.
    bool spansMuchOf(ValueRange range) const
    {
        const int BINS = 4096;
        std::vector<int> counts(BINS, 0);
        const T scale = (BINS - 1) / (range.last - range.first);
        for (T value : values_)
            counts[int(scale * (std::min(std::max(value, range.first), range.last) - range.first))]++;
        const int outliers = int(values_.size() / OUTLIERS);
        int first = 0, last = BINS - 1;
        for (int left = outliers; left >= counts[first]; first++)
            left -= counts[first];
        for (int left = outliers; left >= counts[last]; last--)
            left -= counts[last];
        const bool is_far = image_.depth() == CV_16U && range.last > 255 && first > 2 * (last - first) && !areSpread();
        return (last - first) * SHARE_OF_NOMINAL >= BINS - 1 && !is_far;
    }

    //! Whether the range of a picture in linear light is that of a few lamps, or of the sun: most values are between 0
    //! and 1, and what is above would leave little to them. Whole numbers may be levels, of which many are dark. Black
    //! bars and backgrounds are 0 in both, so 0 tells nothing.
    bool hasLights(ValueRange range) const
    {
        const int MOST = 8; // one value in so many
        const T LITTLE = 4; // with this range or more, a quarter of the levels is left
        const bool has_fractions = image_.depth() == CV_16F || image_.depth() == CV_32F || image_.depth() == CV_64F;
        if (!has_fractions || range.last < LITTLE)
            return false;
        const int64 zeros = std::count(values_.begin(), values_.end(), T(0));
        const int64 others = std::count_if(values_.begin(), values_.end(), [](T value)
        {
            return value < 0 || value > 1 || value == std::floor(value);
        });
        return (others - zeros) * MOST <= int64(values_.size()) - zeros;
    }

    //! Of all finite values.
    ValueRange findExtrema() const
    {
        const ValueRange none = { std::numeric_limits<T>::max(), std::numeric_limits<T>::lowest() };
        ValueRange extrema = none;
        Mutex mutex;
        forValues([&](const T* values, int count)
        {
            ValueRange row = none;
            for (int x = 0; x < count; x++)
                if (isFinite(values[x]))
                {
                    row.first = std::min(row.first, values[x]);
                    row.last = std::max(row.last, values[x]);
                }
            AutoLock lock(mutex);
            extrema.first = std::min(extrema.first, row.first);
            extrema.last = std::max(extrema.last, row.last);
        });
        return extrema;
    }

    const Mat image_, mask_;
    const int channels_, colors_; //!< the fourth channel is no colour
    const Size row_; //!< values of a row, and rows
    std::vector<T> values_;
};

//! Gives map(value) for the values of a row, as type T, after those outside of a range became its ends, and NaN the low
//! one.
template <typename T, typename Map> void mapRow(const Mat& row, T low, T high, const Map& map, Mat& values)
{
    const bool as_it_is = row.depth() == DataType<T>::depth;
    if (as_it_is)
        values.create(row.size(), row.type());
    else
        row.convertTo(values, DataType<T>::depth);
    const T* from = as_it_is ? row.ptr<T>() : values.ptr<T>();
    T* to = values.ptr<T>();
    const int count = values.cols * values.channels();
    for (int x = 0; x < count; x++)
    {
        const T value = from[x] > low ? from[x] : low;
        to[x] = map(value < high ? value : high);
    }
}

//! Values of a row, from a range to 0..255.
void scaleFloats(const Mat& row, RangeOf<double> range, Mat& values, Mat& scaled)
{
    const float low = float(range.first), high = float(range.last);
    mapRow(row, low, high, [=](float value) { return value - low; }, values);
    values.convertTo(scaled, CV_8U, 255 / (double(high) - low));
}

//! The same for values, and spans, that are too large or too small for floats.
//! @note Of halves, because the span of doubles may be too large for a double.
void scaleDoubles(const Mat& row, RangeOf<double> range, Mat& values, Mat& scaled)
{
    const double low = range.first, half = range.last / 2 - low / 2;
    mapRow(row, low, range.last, [=](double value) { return 255 * ((value / 2 - low / 2) / half); }, values);
    values.convertTo(scaled, CV_8U);
}

//! The same for integers of up to 16 bits. In two steps: not all processors round a product before they add to it.
void scaleIntegers(const Mat& row, RangeOf<double> range, Mat& values, Mat& scaled)
{
    row.convertTo(values, CV_32F, 1, -range.first);
    values.convertTo(scaled, CV_8U, 255 / (range.last - range.first));
}

//! From a range to 0..255. Floats do where neither the values nor the span are too large or too small for them. Below a
//! span of 1, integers times 255 over it would not fit an int.
void scaleImage(const Mat& image, RangeOf<double> range, Mat& scaled)
{
    const double span = range.last - range.first;
    const bool is_moderate = span > 1e-30 && span < 1e30;
    const int depth = image.depth();
    scaled.create(image.size(), CV_8UC(image.channels()));
    if (span <= 0)
    {
        scaled.setTo(Scalar::all(0));
        return;
    }
    parallel_for_(Range(0, image.rows), [&](const Range& rows)
    {
        Mat values;
        for (int y = rows.start; y < rows.end; y++)
        {
            Mat to = scaled.row(y);
            if (is_moderate && span >= 1 && depth <= CV_16S)
                scaleIntegers(image.row(y), range, values, to);
            else if (is_moderate && depth != CV_32S && depth != CV_64F)
                scaleFloats(image.row(y), range, values, to);
            else
                scaleDoubles(image.row(y), range, values, to);
        }
    });
}

template <typename T> RangeOf<double> findRange(const Mat& image, const Mat& mask)
{
    const RangeOf<T> found = RangeFinder<T>(image, mask).find();
    return { found.first, found.last };
}

bool isAutomatic(FloatRange set) { return set.first == 0 && set.last == 0; }

//! That of the frame, if the user sets none. Floats would not tell the values of large types apart.
RangeOf<double> chooseRange(const Mat& image, const Mat& mask, FloatRange set)
{
    const bool is_large = image.depth() == CV_32S || image.depth() == CV_64F;
    if (isAutomatic(set))
        return is_large ? findRange<double>(image, mask) : findRange<float>(image, mask);
    return { set.first, set.last };
}

//! Two channels as three: between them their mean, so that both count alike when colours are converted.
void addMeanChannel(const Mat& two, Mat& three)
{
    three.create(two.size(), CV_8UC3);
    for (int y = 0; y < two.rows; y++)
        for (int x = 0; x < two.cols; x++)
        {
            const Vec2b& value = two.at<Vec2b>(y, x);
            three.at<Vec3b>(y, x) = Vec3b(value[0], uchar((value[0] + value[1] + 1) / 2), value[1]);
        }
}

} // namespace

Mat convertImage(const Mat& image, const Mat& mask, FloatRange range, Mat& buffer)
{
    CV_TRACE_FUNCTION();
    const bool is_pair = image.channels() == 2, is_ready = image.depth() == CV_8U && isAutomatic(range);
    Mat pair;
    Mat& scaled = is_pair ? pair : buffer;
    if (!is_ready)
        scaleImage(image, chooseRange(image, mask, range), scaled);
    const Mat& bytes = is_ready ? image : scaled;
    if (!is_pair)
        return bytes;
    addMeanChannel(bytes, buffer);
    return buffer;
}

}}} // namespace
