// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/statistics.hpp"
#include "results/surface_fits.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! Sums over the pixels of one superpixel.
struct Extent
{
    int area, left, top, right, bottom;
    double x, y;

    Extent() : area(0), left(INT_MAX), top(INT_MAX), right(-1), bottom(-1), x(0), y(0) {}

    //! Adds the pixels first..last of a row.
    void addRun(int first, int last, int row)
    {
        const int length = last - first + 1;
        area += length;
        x += 0.5 * length * (double(first) + last);
        y += double(length) * row;
        left = std::min(left, first);
        right = std::max(right, last);
        top = std::min(top, row);
        bottom = std::max(bottom, row);
    }

    void add(const Extent& e)
    {
        area += e.area;
        x += e.x;
        y += e.y;
        left = std::min(left, e.left);
        right = std::max(right, e.right);
        top = std::min(top, e.top);
        bottom = std::max(bottom, e.bottom);
    }
};

//! NaN where there is no value.
float meanOf(double sum, int count)
{
    return count ? float(sum / count) : std::numeric_limits<float>::quiet_NaN();
}

//! Sum over the valid depths of one superpixel.
struct MeanDepth
{
    double sum = 0;
    int area = 0;

    void add(const DepthRun& run)
    {
        for (int i = 0; i < run.length; i++)
            if (isValidDepth(run.depths[i]))
            {
                sum += run.depths[i];
                area++;
            }
    }

    void add(const MeanDepth& other)
    {
        sum += other.sum;
        area += other.area;
    }
};

//! Adds the sums of each superpixel.
template <typename Sums> void addAll(const std::vector<Sums>& sums, std::vector<Sums>& to)
{
    for (size_t i = 0; i < sums.size(); i++)
        to[i].add(sums[i]);
}

//! The sums of all superpixels over some rows. Rows of the image and of depth become CV_64F first, so that sums of
//! integers are exact.
class StripeSums
{
public:
    StripeSums(int num_labels, const StatisticsInput& input)
        : image_(input.image), depth_(input.depth), channels_(image_.empty() ? 0 : image_.channels()),
          extents_(num_labels), colors_(size_t(num_labels) * channels_, 0.),
          color_areas_(isFloat(image_) ? colors_.size() : 0, 0)
    {
        if (depth_.empty())
            return;
        depths_.resize(input.with_mean_depths ? num_labels : 0);
        points_.resize(input.with_positions ? num_labels : 0);
        planes_.resize(input.with_normals ? num_labels : 0);
    }

    void addRows(const Mat& labels, const Range& rows)
    {
        const Point2d axis(0.5 * (labels.cols - 1), 0.5 * (labels.rows - 1));
        Mat colors;
        std::vector<double> depths(depth_.cols);
        for (int y = rows.start; y < rows.end; y++)
        {
            if (!image_.empty())
                image_.row(y).convertTo(colors, CV_64F);
            if (!depth_.empty())
                readDepths(depth_.row(y), depths.data());
            const int* row = labels.ptr<int>(y);
            for (int x = 0; x < labels.cols;)
            {
                const int label = row[x], first = x;
                while (x < labels.cols && row[x] == label)
                    x++;
                if (label < 0)
                    continue;
                extents_[label].addRun(first, x - 1, y);
                if (!colors.empty())
                    addColors(colors.ptr<double>(), first, x, label);
                if (!depths.empty())
                    addDepths(depths.data() + first, x - first, Point2d(first, y) - axis, label);
            }
        }
    }

    void add(const StripeSums& s)
    {
        addAll(s.extents_, extents_);
        for (size_t i = 0; i < colors_.size(); i++)
            colors_[i] += s.colors_[i];
        for (size_t i = 0; i < color_areas_.size(); i++)
            color_areas_[i] += s.color_areas_[i];
        addAll(s.depths_, depths_);
        addAll(s.points_, points_);
        addAll(s.planes_, planes_);
    }

    void write(Point2f focal, Statistics& tables) const
    {
        writeExtents(tables.stats, tables.centroids);
        writeColors(tables.mean_colors);
        writeDepths(focal, tables);
    }

private:
    void writeExtents(Mat& stats, Mat& centroids) const
    {
        const int n = int(extents_.size());
        stats.create(n, CC_STAT_MAX, CV_32SC1);
        centroids.create(n, 2, CV_64FC1);
        for (int i = 0; i < n; i++)
        {
            const Extent& e = extents_[i];
            stats.at<int>(i, CC_STAT_LEFT) = e.left;
            stats.at<int>(i, CC_STAT_TOP) = e.top;
            stats.at<int>(i, CC_STAT_WIDTH) = e.right - e.left + 1;
            stats.at<int>(i, CC_STAT_HEIGHT) = e.bottom - e.top + 1;
            stats.at<int>(i, CC_STAT_AREA) = e.area;
            centroids.at<double>(i, 0) = e.x / e.area;
            centroids.at<double>(i, 1) = e.y / e.area;
        }
    }

    void writeColors(Mat& mean_colors) const
    {
        mean_colors.create(channels_ ? int(extents_.size()) : 0, channels_, CV_32FC1);
        for (int i = 0; i < mean_colors.rows; i++)
            for (int k = 0; k < channels_; k++)
            {
                const size_t j = size_t(i) * channels_ + k;
                const int area = color_areas_.empty() ? extents_[i].area : color_areas_[j];
                mean_colors.at<float>(i, k) = meanOf(colors_[j], area);
            }
    }

    void writeDepths(Point2f focal, Statistics& tables) const
    {
        tables.mean_depths.create(int(depths_.size()), 1, CV_32FC1);
        for (int i = 0; i < tables.mean_depths.rows; i++)
            tables.mean_depths.at<float>(i) = meanOf(depths_[i].sum, depths_[i].area);
        tables.positions.create(int(points_.size()), 3, CV_32FC1);
        for (int i = 0; i < tables.positions.rows; i++)
            *tables.positions.ptr<Vec3f>(i) = points_[i].position(focal);
        tables.normals.create(int(planes_.size()), 3, CV_32FC1);
        for (int i = 0; i < tables.normals.rows; i++)
            *tables.normals.ptr<Vec3f>(i) = planes_[i].normal(focal);
    }

    static bool isFloat(const Mat& image)
    {
#ifdef CV_16BF // since OpenCV 5
        if (image.depth() == CV_16BF)
            return true;
#endif
        return image.depth() == CV_32F || image.depth() == CV_64F || image.depth() == CV_16F;
    }

    void addColors(const double* row, int first, int end, int label)
    {
        const size_t begin = size_t(label) * channels_;
        for (int k = 0; k < channels_; k++)
        {
            const double* values = row + k;
            double sum = 0;
            if (color_areas_.empty())
                for (int x = first; x < end; x++)
                    sum += values[size_t(x) * channels_];
            else
                sum = addFinite(values, first, end, color_areas_[begin + k]);
            colors_[begin + k] += sum;
        }
    }

    //! Which values are finite cannot be foreseen, so there is no branch.
    double addFinite(const double* values, int first, int end, int& count) const
    {
        double sum = 0;
        for (int x = first; x < end; x++)
        {
            const double value = values[size_t(x) * channels_], addends[2] = { 0, value };
            const bool is_finite = std::abs(value) <= DBL_MAX;
            sum += addends[is_finite];
            count += is_finite;
        }
        return sum;
    }

    //! What depths are asked for. The place of the first one is from the optical axis.
    void addDepths(const double* values, int length, Point2d place, int label)
    {
        const DepthRun run = { values, length, place.x, place.y };
        if (!depths_.empty())
            depths_[label].add(run);
        if (!points_.empty())
            points_[label].add(run);
        if (!planes_.empty())
            planes_[label].add(run);
    }

    const Mat image_, depth_;
    const int channels_;
    std::vector<Extent> extents_;
    std::vector<double> colors_; // channels of a superpixel side by side
    std::vector<int> color_areas_; // finite values of floats; empty where all values are finite
    std::vector<MeanDepth> depths_;
    std::vector<MeanPoint> points_;
    std::vector<PlaneFit> planes_;
};

} // namespace

//! One pass over stripes of rows. Their number depends on the label map only, so sums of floats do not depend on the
//! number of threads.
void measureSuperpixels(const Mat& labels, int num_labels, const StatisticsInput& input, Statistics& tables)
{
    CV_TRACE_FUNCTION();
    const int MAX_STRIPES = 16, PIXELS_PER_SUM = 16;
    const double affordable = double(labels.rows) * labels.cols / (double(PIXELS_PER_SUM) * std::max(num_labels, 1));
    const int stripes = std::max(1, int(std::min(affordable, double(std::min(MAX_STRIPES, labels.rows)))));
    std::vector<StripeSums> sums(stripes, StripeSums(num_labels, input));
    parallel_for_(Range(0, stripes), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
        {
            const int first = int(int64(labels.rows) * i / stripes);
            sums[i].addRows(labels, Range(first, int(int64(labels.rows) * (i + 1) / stripes)));
        }
    });
    for (int i = 1; i < stripes; i++)
        sums[0].add(sums[i]);
    sums[0].write(input.focal, tables);
}

}}} // namespace
