// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

namespace opencv_test { namespace {

// The order of mergeSimilar(), against the formula in shared/union_cost.hpp.

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

//! The slope of a region across and down, steps that are none, and whether it is one of all channels.
struct Slope
{
    Vec2d rise;
    double rough;
    bool is_shade;
};

//! From the sums of the rises of each channel across and down, and those of all steps. Limits are times a factor.
Slope slopeOf(const Matx32d& rises, const Vec2d& steps, double area, double limit)
{
    const Matx32d mean = rises * (1 / area);
    const double others = (steps[0] + steps[1]) / area - std::abs(mean(0, 0)) - std::abs(mean(0, 1));
    const double chroma = std::abs(mean(1, 0)) + std::abs(mean(1, 1)) + std::abs(mean(2, 0)) + std::abs(mean(2, 1));
    Slope slope = { Vec2d(mean(0, 0), mean(0, 1)), std::max(0., others - 2.5), false };
    slope.is_shade = chroma > 0.1 * limit && chroma < 3 * limit && 20 * (others - chroma - 0.75) <= limit * chroma;
    if (!slope.is_shade)
        return slope;
    slope.rough = 0;
    for (int i = 0; i < 2; i++)
    {
        const Vec3d rise(mean(0, i), 3 * mean(1, i), 3 * mean(2, i));
        slope.rise[i] = std::min(cv::norm(rise), 64.);
    }
    return slope;
}

//! What the slope that two regions share explains of their squared distance.
double explainedBySlopes(const Slope& a, const Slope& b, double area, double squared_distance, double limit)
{
    const bool are_shades = a.is_shade && b.is_shade;
    Vec2d turn;
    for (int i = 0; i < 2; i++)
        turn[i] = std::max(0., std::abs(a.rise[i] - b.rise[i]) - (are_shades ? 0.35 : 0));
    const double explained = area * std::max(0., std::min(a.rise.dot(a.rise), b.rise.dot(b.rise)) - turn.dot(turn) -
                                                     std::pow(std::max(a.rough, b.rough), 2));
    return are_shades && squared_distance > limit * 8 * explained ? 0 : explained;
}

//! The rows of a grid of n cells: a number near to that of square cells, if it divides n.
int gridRows(Size size, int n)
{
    const double square = std::sqrt(double(n) * size.height / size.width);
    int best = std::min({ cvRound(square), size.height, n });
    double least = 0.08;
    for (int rows = (n + size.width - 1) / size.width; rows <= std::min(size.height, n); rows++)
    {
        const double stretched = std::max(rows / square, square / rows) - 1;
        if (n % rows == 0 && stretched < least)
        {
            best = rows;
            least = stretched;
        }
    }
    return best;
}

typedef std::pair<Point, int> PlacedRegion; // the cell in which its centre lies, its label

//! The plan of mergeSimilar(): tiles of about ten cells of a grid with a cell for each region are divided into halves,
//! and these again.
struct Plan
{
    std::vector<int> parts; // of each label: the smallest part with others; negative and different if there is none
    std::vector<int> above; // of each part

    Plan(const Mat& labels, int n)
    {
        const int rows = gridRows(labels.size(), n), columns = std::max(1, cvRound(double(n) / rows));
        std::vector<Vec3i> sums(n, Vec3i::all(0));
        for (int i = 0; i < 4 * rows; i++)
            for (int j = 0; j < 4 * columns; j++)
            {
                const Point p(labels.cols * (2 * j + 1) / (8 * columns), labels.rows * (2 * i + 1) / (8 * rows));
                sums[labels.at<int>(p)] += Vec3i(2 * j + 1, 2 * i + 1, 8);
            }
        const std::vector<int> tiles = makeTiles(Size(columns, rows), n / 10);
        std::map<int, std::vector<PlacedRegion> > regions; // of a tile
        for (int i = 0; i < n; i++)
        {
            parts.push_back(-2 - i);
            const Vec3i& sum = sums[i];
            if (sum[2] > 0)
                regions[tiles[sum[1] / sum[2] * columns + sum[0] / sum[2]]].push_back(
                        PlacedRegion(Point(sum[0] / sum[2], sum[1] / sum[2]), i));
        }
        for (const auto& tile : regions)
            divide(tile.second, -2 - tile.second[0].second);
    }

    //! The tile of each cell. Bands have three rows, or four, and as many of the tiles that are left as of the rows.
    static std::vector<int> makeTiles(const Size& grid, int num_tiles)
    {
        std::vector<int> tiles;
        const int bands = std::max(1, grid.height / 3);
        int used = 0;
        for (int band = 0; band < bands; band++)
        {
            const int top = band * grid.height / bands, bottom = (band + 1) * grid.height / bands;
            const int pieces = std::max(1, cvRound(double(num_tiles - used) * (bottom - top) / (grid.height - top)));
            for (int y = top; y < bottom; y++)
                for (int x = 0; x < grid.width; x++)
                    tiles.push_back(used + x * pieces / grid.width);
            used += pieces;
        }
        return tiles;
    }

    void divide(const std::vector<PlacedRegion>& regions, int whole)
    {
        Point lowest = regions[0].first, highest = lowest;
        for (const PlacedRegion& region : regions)
        {
            lowest = Point(std::min(lowest.x, region.first.x), std::min(lowest.y, region.first.y));
            highest = Point(std::max(highest.x, region.first.x), std::max(highest.y, region.first.y));
        }
        int part = whole;
        if (regions.size() > 1)
        {
            part = int(above.size());
            above.push_back(whole);
        }
        if (lowest == highest)
        {
            for (const PlacedRegion& region : regions)
                parts[region.second] = part;
            return;
        }
        const bool wide = highest.x - lowest.x > highest.y - lowest.y;
        std::vector<PlacedRegion> halves[2];
        for (const PlacedRegion& region : regions)
            halves[wide ? 2 * region.first.x >= lowest.x + highest.x + (lowest.x + highest.x) % 2
                        : 2 * region.first.y >= lowest.y + highest.y + (lowest.y + highest.y) % 2].push_back(region);
        divide(halves[0], part);
        divide(halves[1], part);
    }
};

typedef std::map<std::pair<int, int>, std::pair<double, double> > Boundaries; // length, sum of differences

//! Colours and logarithms of textures after they have spread eight times, each time to the neighbours, by likeness.
std::vector<Vec4d> spread(std::vector<Vec4d> values, const Boundaries& boundaries)
{
    std::map<std::pair<int, int>, double> weights;
    for (const auto& e : boundaries)
    {
        Vec4d d = values[e.first.first] - values[e.first.second];
        d[3] = 0;
        const double length = e.second.first;
        weights[e.first] = length * length / ((e.second.second + length) * std::sqrt(d.dot(d) + 1.5));
    }
    for (int round = 0; round < 8; round++)
    {
        std::vector<Vec4d> sums(values.size(), Vec4d::all(0));
        std::vector<double> shares(values.size(), 0.);
        for (const auto& w : weights)
        {
            sums[w.first.first] += w.second * values[w.first.second];
            sums[w.first.second] += w.second * values[w.first.first];
            shares[w.first.first] += w.second;
            shares[w.first.second] += w.second;
        }
        for (size_t i = 0; i < values.size(); i++)
            if (shares[i] > 0)
                values[i] = sums[i] * (1 / shares[i]);
    }
    return values;
}

//! From the lowest to the highest: they differ where rounding decides whether a slope counts.
struct CostSpan
{
    double first, last;
};

//! Logarithms of the cost of mergeSimilar() for all neighbours of a label map, from its formula. Steps
//! from pixel to pixel are those inside of the first superpixels. Regions of a part have less noise between them, and
//! no slope.
std::map<std::pair<int, int>, CostSpan> mergeCosts(const Mat& image, const Mat& first, const Mat& labels, int n,
                                                 const std::vector<int>& parts, std::vector<Vec4d>& first_contexts)
{
    std::vector<double> areas(n, 0.);
    std::vector<Vec3d> means(n, Vec3d::all(0));
    std::vector<Vec2d> steps(n, Vec2d(0, 0)); // across and down, in every second row
    std::vector<Matx32d> rises(n, Matx32d::zeros());
    Boundaries boundaries;
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
                if (first.at<int>(q) == first.at<int>(y, x) && ((y ^ (y >> 2)) & 1) == 0)
                {
                    steps[labels.at<int>(q)][k] += step;
                    for (int c = 0; c < 3; c++)
                        rises[labels.at<int>(q)](c, k) += next[c] - color[c];
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
    std::vector<Vec4d> contexts(n, Vec4d::all(0));
    if (first_contexts.empty()) // these are the first superpixels
    {
        for (int i = 0; i < n; i++)
            first_contexts.push_back(Vec4d(means[i][0], means[i][1], means[i][2], textureOf(steps[i], areas[i])));
        first_contexts = spread(first_contexts, boundaries);
    }
    for (int i = 0; i < int(labels.total()); i++)
    {
        const int label = labels.at<int>(i / labels.cols, i % labels.cols);
        contexts[label] += first_contexts[first.at<int>(i / labels.cols, i % labels.cols)] * (1 / areas[label]);
    }
    int few = 1; // n, with zeros for all but the three highest bits, is few * (n / few)
    while (n / few >= 8)
        few *= 2;
    const double usual_area = std::max(1., 2.9 * double(image.total()) / (n / few * few));
    std::map<std::pair<int, int>, CostSpan> costs;
    Boundaries::iterator e = boundaries.begin();
    for (; e != boundaries.end(); ++e)
    {
        const double na = areas[e->first.first], nb = areas[e->first.second], l = e->second.first;
        const Vec3d d = means[e->first.first] - means[e->first.second];
        const Vec4d c = contexts[e->first.first] - contexts[e->first.second];
        const double spread_squared = c.dot(c) - c[3] * c[3];
        const Vec2d ta = steps[e->first.first], tb = steps[e->first.second];
        const double light = 16. / 7 * (na * means[e->first.first][0] + nb * means[e->first.second][0]); // as it is
        const bool of_a_part = parts[e->first.first] == parts[e->first.second];
        CostSpan slopes = { INFINITE, -INFINITE };
        for (const double& limit : { 0.98, 1., 1.02 })
        {
            const double explained = explainedBySlopes(slopeOf(rises[e->first.first], ta, na, limit),
                                                       slopeOf(rises[e->first.second], tb, nb, limit),
                                                       std::min(na, nb), d.dot(d), limit);
            const double rest = of_a_part ? 0.1875 : 4 * explained + 1.5;
            const double cost = 0.4375 * straightLog(d.dot(d) + rest) + 0.21875 * straightLog(spread_squared + rest);
            slopes.first = std::min(slopes.first, cost);
            slopes.last = std::max(slopes.last, cost);
        }
        const double rest = straightLog(na) + straightLog(nb) - straightLog(na + nb) +
                            0.95 * (straightLog(e->second.second + l) - straightLog(l)) -
                            0.59 * (straightLog(l) - straightLog(std::min(na, nb)) / 2) -
                            0.39 * straightLog(16 * std::abs(d[0]) + 7) -
                            0.47 * (straightLog(light + 16 * (na + nb)) - straightLog(na + nb)) +
                            0.16 * straightLog(std::abs(d[1]) + std::abs(d[2]) + 1) -
                            1.17 * std::min(textureOf(ta, na), textureOf(tb, nb)) +
                            0.34 * straightLog(std::abs(c[3]) + 0.1) +
                            0.5 * std::abs(directionOf(ta, na) - directionOf(tb, nb)) +
                            32 * std::max(0., straightLog(na + nb) - straightLog(usual_area));
        costs[e->first] = { slopes.first + rest, slopes.last + rest };
    }
    return costs;
}

typedef std::pair<int, int> RegionKey; // first pixel in raster order, area: in nested partitions no two are the same
typedef std::map<std::pair<RegionKey, RegionKey>, CostSpan> KeyedCosts;

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

KeyedCosts keyedCosts(const Mat& image, const Mat& first, const Mat& labels, int n,
                      const std::map<RegionKey, int>& parts, std::vector<Vec4d>& first_contexts)
{
    const std::vector<RegionKey> keys = regionKeys(labels, n);
    std::vector<int> part_of_label;
    for (const RegionKey& key : keys)
        part_of_label.push_back(parts.find(key)->second);
    const std::map<std::pair<int, int>, CostSpan> costs = mergeCosts(image, first, labels, n, part_of_label,
                                                                        first_contexts);
    KeyedCosts keyed;
    for (std::map<std::pair<int, int>, CostSpan>::const_iterator e = costs.begin(); e != costs.end(); ++e)
    {
        const RegionKey a = keys[e->first.first], b = keys[e->first.second];
        keyed[std::make_pair(std::min(a, b), std::max(a, b))] = e->second;
    }
    return keyed;
}

//! Whether no other boundary of either region is cheaper, but for the rounding of means and logarithms.
bool areBestNeighbors(const KeyedCosts& costs, const std::pair<RegionKey, RegionKey>& pair)
{
    const double cost = costs.find(pair)->second.first;
    for (KeyedCosts::const_iterator e = costs.begin(); e != costs.end(); ++e)
    {
        const bool touches = e->first.first == pair.first || e->first.second == pair.first ||
                             e->first.first == pair.second || e->first.second == pair.second;
        if (touches && cost > e->second.last + 0.2)
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

//! Two ramps of colours beside each other, with a blurred edge between them.
Mat makeShades(Size size)
{
    Mat image(size, CV_8UC3);
    for (int y = 0; y < size.height; y++)
        for (int x = 0; x < size.width; x++)
        {
            const int share = 255 * x / (size.width - 1);
            image.at<Vec3b>(y, x) = y < size.height / 2 ? Vec3b(uchar(255 - share / 2), 90, uchar(share / 2))
                                                        : Vec3b(150, uchar(share / 2), 60);
        }
    GaussianBlur(image, image, Size(), 4);
    return image;
}

// Two regions are united only if they were the best neighbours of each other when their round began, which is at some
// time since both of them are what they are.
TEST_P(ximgproc_GWatershed_merging, merging_unites_mutual_best_neighbors)
{
    RNG& rng = theRNG();
    const int WIDTHS[] = { 80, 80, 80, 80, 7, 150 }; // narrower than what is read at once, and runs that are longer
    for (int i = 0; i < 8; i++)
    {
        const Mat image = i < 6 ? makeScene(Size(WIDTHS[i], 4800 / WIDTHS[i]), rng)
                                : makeShades(Size(60 * i - 260, 60));
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GetParam(), 9);
        gws->iterate();
        std::vector<KeyedCosts> history;
        std::vector<Vec4d> contexts; // of the first superpixels
        const Mat first = labelsOf(gws);
        Mat before = first;
        const int num_first = gws->getNumberOfSuperpixels();
        const Plan plan(first, num_first);
        const std::vector<RegionKey> keys = regionKeys(first, num_first);
        std::map<RegionKey, int> parts, lowest; // lowest of the first labels
        for (int k = 0; k < num_first; k++)
        {
            parts[keys[k]] = plan.parts[k];
            lowest[keys[k]] = k;
        }
        for (int n = num_first; n > 1; n--)
        {
            history.push_back(keyedCosts(image, first, before, n, parts, contexts));
            gws->mergeSimilar(n - 1);
            const Mat after = labelsOf(gws);
            const std::pair<RegionKey, RegionKey> pair = findUnion(before, after, n);
            bool found = false;
            for (int k = int(history.size()) - 1; k >= 0 && history[k].count(pair) && !found; k--)
                found = areBestNeighbors(history[k], pair);
            ASSERT_TRUE(found) << n << " superpixels";
            // Both halves of a part are the part. Else the larger region counts; of equal ones, that which began first.
            const RegionKey a = pair.first, b = pair.second;
            const bool a_counts = a.second > b.second || (a.second == b.second && lowest[a] < lowest[b]);
            const int part = parts[a_counts ? a : b];
            const RegionKey both(std::min(a.first, b.first), a.second + b.second);
            parts[both] = parts[a] == parts[b] && part >= 0 ? plan.above[part] : part;
            lowest[both] = std::min(lowest[a], lowest[b]);
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
