// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// The order of mergeSimilar(), against its documentation.

typedef testing::TestWithParam<int> ximgproc_GWatershed_merging;

//! The features that merging compares: opponent colours, as in the documentation of RGWATERSHED.
Vec3d opponentColor(const Vec3b& c)
{
    const int b = c[0], g = c[1], r = c[2];
    return Vec3d(7. / 16 * ((r + 2 * g + b + 2) / 4), (r - g + 256) / 2, (r + g - 2 * b + 514) / 4);
}

//! A logarithm to base 2 that is straight between the powers of two, as merging takes it.
double straightLog(double x)
{
    int exponent;
    const double fraction = std::frexp(x, &exponent);
    return exponent - 2 + 2 * fraction;
}

//! The logarithm of the steps from pixel to pixel, of a region whose sums across and down these are.
double textureOf(const Vec2d& steps, double area)
{
    return straightLog(steps[0] + steps[1] + area) - straightLog(area);
}

//! The logarithm of those across over those down.
double directionOf(const Vec2d& steps, double area)
{
    return straightLog(steps[0] + 0.5 * area) - straightLog(steps[1] + 0.5 * area);
}

//! The square of the slope that two regions share, from the sums of the rises of lightness across and down in them and
//! those of all steps.
double commonSlope(const Vec2d& rise_a, const Vec2d& steps_a, double na, const Vec2d& rise_b, const Vec2d& steps_b,
                   double nb)
{
    const Vec2d a = rise_a / na, b = rise_b / nb;
    const double rough = std::max((steps_a[0] + steps_a[1]) / na - std::abs(a[0]) - std::abs(a[1]),
                                  (steps_b[0] + steps_b[1]) / nb - std::abs(b[0]) - std::abs(b[1]));
    return std::max(0., std::min(a.dot(a), b.dot(b)) - (a - b).dot(a - b) -
                            std::pow(0.33 * std::max(0., rough - 1.5), 2));
}

//! Logarithms of the cost of mergeSimilar() for all neighbours of a label map, from its documentation. Steps
//! from pixel to pixel are those inside of the first superpixels.
std::map<std::pair<int, int>, double> mergeCosts(const Mat& image, const Mat& first, const Mat& labels, int n)
{
    std::vector<double> areas(n, 0.);
    std::vector<Vec3d> means(n, Vec3d::all(0));
    std::vector<Vec2d> steps(n, Vec2d(0, 0)), rises(n, Vec2d(0, 0)); // across and down, in every second row
    std::map<std::pair<int, int>, std::pair<double, double> > boundaries; // length, sum of differences
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            const Vec3d color = opponentColor(image.at<Vec3b>(y, x));
            areas[labels.at<int>(y, x)]++;
            means[labels.at<int>(y, x)] += color;
            for (int k = 0; k < 2; k++)
            {
                const Point q(x + (k == 0), y + (k == 1));
                if (q.x == labels.cols || q.y == labels.rows)
                    continue;
                const Vec3d next = opponentColor(image.at<Vec3b>(q));
                const double step = cv::norm(color - next, NORM_L1);
                if (first.at<int>(q) == first.at<int>(y, x) && y % 2 == 0)
                {
                    steps[labels.at<int>(q)][k] += step;
                    rises[labels.at<int>(q)][k] += next[0] - color[0];
                }
                if (labels.at<int>(q) == labels.at<int>(y, x))
                    continue;
                const int a = std::min(labels.at<int>(q), labels.at<int>(y, x));
                const int b = std::max(labels.at<int>(q), labels.at<int>(y, x));
                std::pair<double, double>& boundary = boundaries[std::make_pair(a, b)];
                boundary.first++;
                boundary.second += step;
            }
        }
    for (int i = 0; i < n; i++)
        means[i] /= areas[i];
    int few = 1; // n, with zeros for all but the three highest bits, is few * (n / few)
    while (n / few >= 8)
        few *= 2;
    const double usual_area = std::max(1., 2.9 * double(image.total()) / (n / few * few));
    std::map<std::pair<int, int>, double> costs;
    std::map<std::pair<int, int>, std::pair<double, double> >::iterator e = boundaries.begin();
    for (; e != boundaries.end(); ++e)
    {
        const double na = areas[e->first.first], nb = areas[e->first.second], l = e->second.first;
        const Vec3d d = means[e->first.first] - means[e->first.second];
        const Vec2d ta = steps[e->first.first], tb = steps[e->first.second];
        const double light = 16. / 7 * (na * means[e->first.first][0] + nb * means[e->first.second][0]); // as it is
        const double slope = commonSlope(rises[e->first.first], ta, na, rises[e->first.second], tb, nb);
        costs[e->first] = 0.58 * straightLog(d.dot(d) + 4 * std::min(na, nb) * slope + 1.5) +
                          straightLog(na) + straightLog(nb) - straightLog(na + nb) +
                          0.95 * (straightLog(e->second.second + l) - straightLog(l)) -
                          0.66 * (straightLog(l) - straightLog(std::min(na, nb)) / 2) -
                          0.39 * straightLog(16 * std::abs(d[0]) + 7) -
                          0.47 * (straightLog(light + 16 * (na + nb)) - straightLog(na + nb)) +
                          0.16 * straightLog(std::abs(d[1]) + std::abs(d[2]) + 1) -
                          1.17 * std::min(textureOf(ta, na), textureOf(tb, nb)) +
                          0.5 * std::abs(directionOf(ta, na) - directionOf(tb, nb)) +
                          32 * std::max(0., straightLog(na + nb) - straightLog(usual_area));
    }
    return costs;
}

typedef std::pair<int, int> RegionKey; // first pixel in raster order, area: in nested partitions no two are the same
typedef std::map<std::pair<RegionKey, RegionKey>, double> KeyedCosts;

std::vector<RegionKey> regionKeys(const Mat& labels, int n)
{
    std::vector<RegionKey> keys(n, RegionKey(-1, 0));
    for (int i = 0; i < int(labels.total()); i++)
    {
        RegionKey& key = keys[labels.at<int>(i / labels.cols, i % labels.cols)];
        key.first = key.second == 0 ? i : key.first;
        key.second++;
    }
    return keys;
}

KeyedCosts keyedCosts(const Mat& image, const Mat& first, const Mat& labels, int n)
{
    const std::vector<RegionKey> keys = regionKeys(labels, n);
    const std::map<std::pair<int, int>, double> costs = mergeCosts(image, first, labels, n);
    KeyedCosts keyed;
    for (std::map<std::pair<int, int>, double>::const_iterator e = costs.begin(); e != costs.end(); ++e)
    {
        const RegionKey a = keys[e->first.first], b = keys[e->first.second];
        keyed[std::make_pair(std::min(a, b), std::max(a, b))] = e->second;
    }
    return keyed;
}

//! Whether no other boundary of either region is cheaper, but for the rounding of means and logarithms.
bool areBestNeighbors(const KeyedCosts& costs, const std::pair<RegionKey, RegionKey>& pair)
{
    const double cost = costs.find(pair)->second;
    for (KeyedCosts::const_iterator e = costs.begin(); e != costs.end(); ++e)
    {
        const bool touches = e->first.first == pair.first || e->first.second == pair.first ||
                             e->first.first == pair.second || e->first.second == pair.second;
        if (touches && cost > e->second + 0.2)
            return false;
    }
    return true;
}

//! The two regions of a partition that are one in the next.
std::pair<RegionKey, RegionKey> findUnion(const Mat& before, const Mat& after, int n)
{
    const std::vector<RegionKey> keys = regionKeys(before, n);
    std::map<int, RegionKey> seen; // by label after
    for (int i = 0; i < n; i++)
    {
        const int label = after.at<int>(keys[i].first / after.cols, keys[i].first % after.cols);
        if (!seen.insert(std::make_pair(label, keys[i])).second)
            return std::make_pair(std::min(seen[label], keys[i]), std::max(seen[label], keys[i]));
    }
    return std::pair<RegionKey, RegionKey>();
}

// Two regions are united only if they were the best neighbours of each other when their round began, which is at some
// time since both of them are what they are.
TEST_P(ximgproc_GWatershed_merging, merging_unites_mutual_best_neighbors)
{
    RNG& rng = theRNG();
    const int WIDTHS[] = { 80, 80, 80, 80, 7, 150 }; // narrower than what is read at once, and runs that are longer
    for (int i = 0; i < 6; i++)
    {
        const Mat image = makeScene(Size(WIDTHS[i], 4800 / WIDTHS[i]), rng);
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 9);
        gws->iterate();
        std::vector<KeyedCosts> history;
        const Mat first = labelsOf(gws);
        Mat before = first;
        for (int n = gws->getNumberOfSuperpixels(); n > 1; n--)
        {
            history.push_back(keyedCosts(image, first, before, n));
            gws->mergeSimilar(n - 1);
            const Mat after = labelsOf(gws);
            const std::pair<RegionKey, RegionKey> pair = findUnion(before, after, n);
            bool found = false;
            for (int k = int(history.size()) - 1; k >= 0 && history[k].count(pair) && !found; k--)
                found = areBestNeighbors(history[k], pair);
            ASSERT_TRUE(found) << n << " superpixels";
            before = after;
        }
    }
}

//! Labels of a picture, before and after they are merged.
std::vector<Mat> mergedLabels(const Ptr<SuperpixelGWatershed>& gws, const Mat& image)
{
    std::vector<Mat> labels;
    gws->iterate(image);
    labels.push_back(labelsOf(gws));
    const int number = gws->getNumberOfSuperpixels();
    gws->mergeSimilar(1 + number / 4);
    labels.push_back(labelsOf(gws));
    gws->mergeSimilar(1 + number / 2);
    labels.push_back(labelsOf(gws));
    return labels;
}

// The segmentation and merging share buffers, and the label map changes its place.
TEST_P(ximgproc_GWatershed_merging, merging_leaves_nothing_to_the_next_image)
{
    RNG& rng = theRNG();
    const int EFFORTS[] = { 1, 3, 0, 2 };
    Ptr<SuperpixelGWatershed> used = createSuperpixelGWatershed(8, 8, 3, 1, GetParam());
    for (int i = 0; i < 12; i++)
    {
        const Mat image = makeScene(Size(60 + 20 * (i % 3), 70), rng);
        Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(8, 8, 3, 1, GetParam());
        for (const Ptr<SuperpixelGWatershed>& gws : { used, fresh })
        {
            gws->setRegionSize(4 + 3 * (i % 4));
            gws->setEffort(EFFORTS[i % 4]);
        }
        const std::vector<Mat> labels = mergedLabels(used, image), expected = mergedLabels(fresh, image);
        for (size_t k = 0; k < expected.size(); k++)
            EXPECT_EQ(0, cv::norm(labels[k], expected[k], NORM_INF)) << "image " << i << ", labels " << k;
    }
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_merging, testing::ValuesIn(ALGORITHMS));

}} // namespace
