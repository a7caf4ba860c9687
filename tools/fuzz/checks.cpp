// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "checks.hpp"

#include <opencv2/imgproc.hpp>

#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>

namespace fuzz
{

static int ignoreError(int, const char*, const char*, const char*, int, void*)
{
    return 0;
}

void silenceErrors()
{
    cv::redirectError(ignoreError);
}

void require(bool holds, const char* property)
{
    if (holds)
        return;
    std::fprintf(stderr, "does not hold: %s\n", property);
    std::abort();
}

bool same(const Mat& a, const Mat& b)
{
    if (a.size() != b.size() || a.type() != b.type())
        return false;
    const size_t bytes = a.cols * a.elemSize();
    for (int y = 0; y < a.rows; y++)
        if (std::memcmp(a.ptr(y), b.ptr(y), bytes) != 0)
            return false;
    return true;
}

Settings settingsOf(const SuperpixelGWatershed& gws)
{
    const Settings settings = { gws.getAlgorithm(), gws.getRegionSize(), gws.getDesiredSuperpixels(), gws.getEffort(),
                                gws.getRuler(), gws.getAlpha(), gws.getLabInput(), gws.getTemporal(),
                                gws.getDepthAdaptive(), gws.getLowValue(), gws.getHighValue(), gws.getNearDepth(),
                                gws.getFarDepth(), gws.getFocalLengthX(), gws.getFocalLengthY(), gws.getNormalWeight(),
                                gws.getBorderThreshold() };
    return settings;
}

bool operator==(const Settings& a, const Settings& b)
{
    return a.algorithm == b.algorithm && a.region_size == b.region_size && a.num_superpixels == b.num_superpixels &&
           a.effort == b.effort && a.ruler == b.ruler && a.alpha == b.alpha && a.lab_input == b.lab_input &&
           a.temporal == b.temporal && a.low_value == b.low_value && a.high_value == b.high_value &&
           a.near_depth == b.near_depth && a.far_depth == b.far_depth && a.focal_x == b.focal_x &&
           a.focal_y == b.focal_y && a.normal_weight == b.normal_weight && a.depth_adaptive == b.depth_adaptive &&
           a.border_threshold == b.border_threshold;
}

bool inRange(const Settings& s)
{
    return (s.algorithm == cv::ximgproc::GWATERSHED || s.algorithm == cv::ximgproc::RGWATERSHED) &&
           ((s.region_size >= 1 && s.num_superpixels == 0) || (s.region_size == 0 && s.num_superpixels >= 1)) &&
           s.effort >= 0 && s.effort <= 3 && s.ruler >= 0 && s.ruler <= FLT_MAX && s.alpha >= 0 && s.alpha <= 1 &&
           ((s.low_value == 0 && s.high_value == 0) || s.low_value < s.high_value) && s.low_value >= -FLT_MAX &&
           s.high_value <= FLT_MAX &&
           ((s.near_depth == 0 && s.far_depth == 0) || (s.near_depth >= 0 && s.near_depth < s.far_depth)) &&
           s.far_depth <= FLT_MAX && s.focal_x >= 0 && s.focal_x <= FLT_MAX && s.focal_y >= 0 &&
           s.focal_y <= FLT_MAX && (s.focal_x > 0 || s.focal_y == 0) && s.normal_weight >= 0 && s.normal_weight <= 1 &&
           s.border_threshold >= 0 && s.border_threshold <= FLT_MAX;
}

Partition partitionOf(const SuperpixelGWatershed& gws)
{
    Partition partition;
    partition.num_labels = gws.getNumberOfSuperpixels();
    gws.getLabels(partition.labels);
    return partition;
}

static const Point TO_LEFT(1, 0), TO_TOP(0, 1);

//! Calls visit(p, q) for all pairs of 4-neighbours.
template <typename Visit> static void forNeighbors(Size size, const Visit& visit)
{
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
        {
            const Point p(x, y);
            if (x > 0)
                visit(p - TO_LEFT, p);
            if (y > 0)
                visit(p - TO_TOP, p);
        }
}

//! Disjoint sets of numbers.
class Sets
{
public:
    explicit Sets(int count) : parents_(count)
    {
        for (int i = 0; i < count; i++)
            parents_[i] = i;
    }

    int find(int i)
    {
        while (parents_[i] != i)
            i = parents_[i] = parents_[parents_[i]];
        return i;
    }

    void join(int a, int b) { parents_[find(a)] = find(b); }

private:
    std::vector<int> parents_;
};

//! For each pixel the index of one pixel of its piece, which is the same for the whole piece.
static Mat findPieces(const Mat& values)
{
    const int width = values.cols;
    Sets sets(int(values.total()));
    forNeighbors(values.size(), [&](Point p, Point q)
    {
        if (values.at<int>(p) == values.at<int>(q))
            sets.join(p.y * width + p.x, q.y * width + q.x);
    });
    Mat pieces(values.size(), CV_32SC1);
    for (int i = 0; i < int(values.total()); i++)
        pieces.at<int>(i / width, i % width) = sets.find(i);
    return pieces;
}

std::vector<int> countPieces(const Mat& labels, int num_labels)
{
    std::vector<int> counts(num_labels, 0);
    const Mat pieces = findPieces(labels);
    for (int i = 0; i < int(labels.total()); i++)
    {
        const Point p(i % labels.cols, i / labels.cols);
        if (labels.at<int>(p) >= 0 && pieces.at<int>(p) == i)
            counts[labels.at<int>(p)]++;
    }
    return counts;
}

static int sumOf(const std::vector<int>& values)
{
    int sum = 0;
    for (int value : values)
        sum += value;
    return sum;
}

static std::vector<int> areasOf(const Partition& partition)
{
    std::vector<int> areas(partition.num_labels, 0);
    for (int y = 0; y < partition.labels.rows; y++)
        for (int x = 0; x < partition.labels.cols; x++)
        {
            const int label = partition.labels.at<int>(y, x);
            require(label >= -1 && label < partition.num_labels, "labels are in [-1, N)");
            if (label >= 0)
                areas[label]++;
        }
    return areas;
}

//! Returns the areas.
static std::vector<int> checkLabels(const Partition& partition)
{
    require(partition.labels.type() == CV_32SC1, "labels are CV_32SC1");
    const std::vector<int> areas = areasOf(partition);
    for (int area : areas)
        require(area > 0, "all labels occur");
    return areas;
}

//! Superpixels without markers of the user.
static void checkUnmarked(const Partition& partition, const Mat& inside, const Settings& settings)
{
    for (int y = 0; y < inside.rows; y++)
        for (int x = 0; x < inside.cols; x++)
            require((partition.labels.at<int>(y, x) >= 0) == (inside.at<int>(y, x) == 0),
                    "all pixels inside of the mask have a label, and no other ones");
    const std::vector<int> areas = areasOf(partition);
    for (int count : countPieces(partition.labels, partition.num_labels))
        require(count == 1, "a superpixel is one piece");

    const int pixels = sumOf(areas), components = countPieces(inside, 1)[0];
    const double asked = settings.num_superpixels ? settings.num_superpixels
                                                  : pixels / (double(settings.region_size) * settings.region_size);
    const double met = std::max(std::min(std::max(asked, 1.), double(pixels)), double(components));
    const double slack = settings.num_superpixels ? 0.5 : std::max(0.5, 0.05 * asked); // full rows of squares
    require(std::abs(partition.num_labels - met) <= slack, "N is the number asked for");
}

//! Superpixels that grew from markers of the user.
static void checkMarked(const Partition& partition, const Mat& inside, const Mat& markers)
{
    std::set<int> values, reached;
    const Mat components = findPieces(inside);
    Mat given(markers.size(), CV_32SC1, Scalar(-1));
    for (int y = 0; y < markers.rows; y++)
        for (int x = 0; x < markers.cols; x++)
            if (inside.at<int>(y, x) == 0 && markers.at<int>(y, x) > 0)
            {
                values.insert(markers.at<int>(y, x));
                reached.insert(components.at<int>(y, x));
            }
    require(partition.num_labels == int(values.size()), "N is the number of markers");

    const std::vector<int> sorted(values.begin(), values.end());
    for (int y = 0; y < markers.rows; y++)
        for (int x = 0; x < markers.cols; x++)
        {
            const int marker = markers.at<int>(y, x), label = partition.labels.at<int>(y, x);
            const bool is_inside = inside.at<int>(y, x) == 0;
            require((label >= 0) == (is_inside && reached.count(components.at<int>(y, x)) == 1),
                    "pixels have a label where a marker reaches them, and no other ones");
            if (!is_inside || marker <= 0)
                continue;
            require(sorted[label] == marker, "markers keep their pixels, in the order of their values");
            given.at<int>(y, x) = label;
        }
    const std::vector<int> before = countPieces(given, partition.num_labels);
    const std::vector<int> after = countPieces(partition.labels, partition.num_labels);
    for (int i = 0; i < partition.num_labels; i++)
        require(after[i] <= before[i], "a superpixel has no more pieces than its marker");
}

void checkSegmentation(const Partition& partition, Size size, const Mat& mask, const Mat& markers,
                       const Settings& settings)
{
    require(partition.labels.size() == size, "labels have the size of the image");
    checkLabels(partition);
    Mat inside(size, CV_32SC1, Scalar(0)); // -1 outside of the mask
    if (!mask.empty())
        inside.setTo(Scalar(-1), mask == 0);
    if (markers.empty())
        checkUnmarked(partition, inside, settings);
    else
        checkMarked(partition, inside, markers);
}

void checkMerged(const Partition& fine, const Partition& coarse)
{
    require(coarse.labels.size() == fine.labels.size(), "merging keeps the size");
    require(coarse.num_labels <= fine.num_labels, "merging makes no superpixels");
    checkLabels(coarse);
    std::vector<int> merged_into(fine.num_labels, -1);
    for (int y = 0; y < fine.labels.rows; y++)
        for (int x = 0; x < fine.labels.cols; x++)
        {
            const int from = fine.labels.at<int>(y, x), to = coarse.labels.at<int>(y, x);
            require((from < 0) == (to < 0), "merging labels the same pixels");
            if (from < 0)
                continue;
            require(merged_into[from] < 0 || merged_into[from] == to, "partitions are nested");
            merged_into[from] = to;
        }
    const int pieces_of_fine = sumOf(countPieces(fine.labels, fine.num_labels));
    const int pieces_of_coarse = sumOf(countPieces(coarse.labels, coarse.num_labels));
    require(pieces_of_coarse - coarse.num_labels <= pieces_of_fine - fine.num_labels, "what is merged touches");
    if (coarse.num_labels == fine.num_labels)
        require(same(fine.labels, coarse.labels), "where nothing is merged, labels stay");
}

typedef std::map<std::pair<int, int>, int> Lengths;

//! Length of the common boundary of the pairs of superpixels that touch.
static Lengths findLengths(const Mat& labels)
{
    Lengths lengths;
    forNeighbors(labels.size(), [&](Point p, Point q)
    {
        const int a = labels.at<int>(p), b = labels.at<int>(q);
        if (a != b && a >= 0 && b >= 0)
            lengths[std::make_pair(std::min(a, b), std::max(a, b))]++;
    });
    return lengths;
}

void checkMergedNumber(const Partition& before, int wanted, const Partition& after)
{
    Sets sets(before.num_labels);
    int fewest = before.num_labels; // as many as can be reached
    for (const auto& pair : findLengths(before.labels))
        if (sets.find(pair.first.first) != sets.find(pair.first.second))
        {
            sets.join(pair.first.first, pair.first.second);
            fewest--;
        }
    require(after.num_labels == std::min(before.num_labels, std::max(wanted, fewest)),
            "mergeSimilar() reaches its number");
}

void checkAreaMerged(const Partition& before, int min_area, const Partition& after)
{
    if (min_area <= 1)
        require(same(before.labels, after.labels), "no superpixel has less than a pixel");
    const std::vector<int> areas = areasOf(after);
    for (const auto& pair : findLengths(after.labels))
        require(areas[pair.first.first] >= min_area && areas[pair.first.second] >= min_area,
                "superpixels with neighbours have the area in pixels");
}

void checkSmallMerged(const Partition& before, int percent, const Partition& after)
{
    if (percent == 0)
        require(same(before.labels, after.labels), "0 percent merge nothing");
    const std::vector<int> areas = areasOf(after);
    std::vector<bool> has_neighbor(after.num_labels, false);
    for (const auto& pair : findLengths(after.labels))
        has_neighbor[pair.first.first] = has_neighbor[pair.first.second] = true;
    const double pixels = sumOf(areas);
    for (int i = 0; i < after.num_labels; i++)
        require(!has_neighbor[i] || 100. * areas[i] * before.num_labels >= pixels * percent,
                "superpixels with neighbours are large enough");
}

//! Means over superpixels, and the means of the absolute values, which tell how exact they can be.
struct Means
{
    std::vector<double> means, magnitudes;
    std::vector<int> counts;
};

//! Means of one channel of a CV_64F matrix. The values may be restricted to those above 0 and finite.
static Means measureMeans(const Partition& partition, const Mat& values, int channel, bool valid_only)
{
    Means m;
    m.means.assign(partition.num_labels, 0);
    m.magnitudes = m.means;
    m.counts.assign(partition.num_labels, 0);
    for (int y = 0; y < values.rows; y++)
        for (int x = 0; x < values.cols; x++)
        {
            const int label = partition.labels.at<int>(y, x);
            const double value = values.ptr<double>(y, x)[channel];
            if (label < 0 || !(std::abs(value) <= DBL_MAX) || (valid_only && !(value <= FLT_MAX && float(value) > 0)))
                continue;
            m.means[label] += value;
            m.magnitudes[label] += std::abs(value);
            m.counts[label]++;
        }
    for (int i = 0; i < partition.num_labels; i++)
        if (m.counts[i] > 0)
        {
            m.means[i] /= m.counts[i];
            m.magnitudes[i] /= m.counts[i];
        }
    return m;
}

static void checkMeans(const Means& expected, const Mat& column)
{
    for (int i = 0; i < column.rows; i++)
    {
        const float mean = column.at<float>(i);
        if (expected.counts[i] == 0)
            require(std::isnan(mean), "the mean of no value is NaN");
        else if (expected.magnitudes[i] <= FLT_MAX)
            require(std::abs(mean - expected.means[i]) <= 1e-5 * expected.magnitudes[i] + FLT_MIN,
                    "means are those of the superpixels");
    }
}

//! A superpixel without depth has no position, and many have no normal. The square of a CV_64F may be too large.
static void checkSurfaces(const Mat& depth, const Mat& mean_depths, const Mat& positions, const Mat& normals)
{
    require(positions.size() == Size(3, mean_depths.rows) && normals.size() == positions.size(), "surfaces are N x 3");
    for (int i = 0; i < positions.rows; i++)
    {
        const float z = positions.at<float>(i, 2), mean_depth = mean_depths.at<float>(i);
        require(z == mean_depth || (std::isnan(z) && std::isnan(mean_depth)), "z is the mean depth");
        const double length = cv::norm(normals.row(i));
        require(std::isnan(length) || depth.depth() == CV_64F || std::abs(length - 1) < 1e-5, "normals have length 1");
    }
}

void checkStatistics(const SuperpixelGWatershed& gws, const Mat& image, const Mat& depth)
{
    const Partition partition = partitionOf(gws);
    const int n = partition.num_labels;
    Mat stats, centroids, colors, depths, positions, normals;
    gws.getStatistics(image, depth, stats, centroids, colors, depths, positions, normals);
    checkSurfaces(depth, depths, positions, normals);
    require(stats.type() == CV_32SC1 && stats.size() == Size(5, n), "stats is N x 5");
    require(centroids.type() == CV_64FC1 && centroids.size() == Size(2, n), "centroids is N x 2");
    require(colors.size() == (image.empty() ? Size() : Size(image.channels(), n)) &&
            depths.size() == (depth.empty() ? Size(1, 0) : Size(1, n)), "there are means of what was given");

    const std::vector<int> areas = checkLabels(partition);
    std::vector<Point> first(n, Point(INT_MAX, INT_MAX)), last(n, Point(-1, -1));
    std::vector<cv::Point2d> sums(n);
    for (int y = 0; y < partition.labels.rows; y++)
        for (int x = 0; x < partition.labels.cols; x++)
        {
            const int label = partition.labels.at<int>(y, x);
            if (label < 0)
                continue;
            first[label] = Point(std::min(first[label].x, x), std::min(first[label].y, y));
            last[label] = Point(std::max(last[label].x, x), std::max(last[label].y, y));
            sums[label] += cv::Point2d(x, y);
        }
    for (int i = 0; i < n; i++)
    {
        require(stats.at<int>(i, cv::CC_STAT_AREA) == areas[i], "areas are those of the superpixels");
        require(Rect(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                     stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)) ==
                    Rect(first[i], last[i] + Point(1, 1)), "boxes are those of the superpixels");
        require(std::abs(centroids.at<double>(i, 0) - sums[i].x / areas[i]) < 1e-9 &&
                std::abs(centroids.at<double>(i, 1) - sums[i].y / areas[i]) < 1e-9,
                "centroids are those of the superpixels");
    }
    Mat values;
    depth.convertTo(values, CV_64F);
    if (!depth.empty())
    {
        if (depth.depth() == CV_16U)
            values.setTo(Scalar(0), depth == 65535);
        checkMeans(measureMeans(partition, values, 0, true), depths);
    }
    image.convertTo(values, CV_64F);
    for (int k = 0; k < colors.cols; k++)
        checkMeans(measureMeans(partition, values, k, false), colors.col(k));
}

void checkAdjacency(const SuperpixelGWatershed& gws, const Mat& image, const Mat& depth)
{
    Mat pairs, lengths, contrasts;
    gws.getAdjacency(image, depth, pairs, lengths, contrasts);
    const Lengths expected = findLengths(partitionOf(gws).labels);
    require(pairs.type() == CV_32SC1 && pairs.size() == Size(2, int(expected.size())), "pairs is M x 2");
    require(lengths.type() == CV_32SC1 && lengths.size() == Size(1, pairs.rows), "lengths is M x 1");
    require(contrasts.rows == (image.empty() ? 0 : pairs.rows), "there are contrasts if there is an image");
    int i = 0;
    for (const auto& pair : expected)
    {
        require(pairs.at<int>(i, 0) == pair.first.first && pairs.at<int>(i, 1) == pair.first.second &&
                lengths.at<int>(i) == pair.second, "the graph is that of the labels");
        if (!image.empty())
            require(contrasts.at<float>(i) >= 0 && contrasts.at<float>(i) <= 255, "contrasts are in [0, 255]");
        i++;
    }
}

void checkMasks(const SuperpixelGWatershed& gws, int algorithm)
{
    const Mat labels = partitionOf(gws).labels;
    Mat thick(labels.size(), CV_8UC1, Scalar(0)), thin = thick.clone();
    forNeighbors(labels.size(), [&](Point p, Point q)
    {
        if (labels.at<int>(p) == labels.at<int>(q) || labels.at<int>(p) < 0 || labels.at<int>(q) < 0)
            return;
        thin.at<uchar>(p) = thick.at<uchar>(p) = thick.at<uchar>(q) = 255;
    });
    Mat contours(3, 2, CV_32FC3), lines;
    gws.getLabelContourMask(contours, true);
    require(same(contours, thick), "thick contours are those of the labels");
    gws.getLabelContourMask(contours, false);
    require(same(contours, thin), "thin contours are those of the labels");
    if (labels.rows == 1 || labels.cols == 1)
    {
        std::vector<uchar> line;
        gws.getLabelContourMask(line, false);
        require(same(Mat(line).reshape(1, thin.rows), thin), "a vector takes contours that are a line");
    }
    gws.getWatershedLineMask(lines);
    require(lines.type() == CV_8UC1 && lines.size() == labels.size(), "lines are a mask of the size of the image");
    for (int y = 0; y < lines.rows; y++)
        for (int x = 0; x < lines.cols; x++)
            require(lines.at<uchar>(y, x) == 0 ||
                    (lines.at<uchar>(y, x) == 255 && labels.at<int>(y, x) >= 0 &&
                     algorithm == cv::ximgproc::GWATERSHED), "lines are 0 or 255, of GWATERSHED, inside of the mask");
}

} // namespace
