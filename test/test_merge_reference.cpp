// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_merge_reference.hpp"

#include <numeric>

namespace opencv_test {

namespace {

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

//! That of which this is the logarithm.
double powerOfTwo(double logarithm)
{
    const double floor = std::floor(logarithm);
    return std::ldexp(1 + logarithm - floor, int(floor));
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

} // namespace

MergePlan::MergePlan(const Mat& labels, int n)
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

void MergePlan::divide(const std::vector<PlacedRegion>& regions, int whole)
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

RegionMeasures::RegionMeasures(const Mat& image, const Mat& first, const Mat& labels, int n)
    : areas(n, 0.), means(n, Vec3d::all(0)), steps(n, Vec2d(0, 0)), rises(n, Matx32d::zeros())
{
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
                std::pair<double, double>& boundary = boundaries[RegionPair(a, b)];
                boundary.first++;
                boundary.second += step;
            }
        }
    for (int i = 0; i < n; i++)
        means[i] /= areas[i];
}

namespace {

//! A neighbour and the length of the common boundary: longer ones come first, then those of lower labels.
struct Side
{
    int region;
    double length;

    bool operator<(const Side& s) const { return length != s.length ? length > s.length : region < s.region; }
};

}

std::vector<Mixture> findMixtures(const RegionMeasures& regions, double looseness)
{
    const int n = int(regions.areas.size());
    std::vector<std::vector<Side> > sides(n);
    for (const auto& e : regions.boundaries)
    {
        sides[e.first.first].push_back({ e.first.second, e.second.first });
        sides[e.first.second].push_back({ e.first.first, e.second.first });
    }
    std::vector<Mixture> mixtures;
    for (int i = 0; i < n; i++)
    {
        std::sort(sides[i].begin(), sides[i].end());
        if (sides[i].size() < 2 || regions.areas[i] > sides[i][0].length + sides[i][1].length)
            continue;
        const int a = sides[i][0].region, b = sides[i][1].region;
        const Vec3d whole = regions.means[b] - regions.means[a], part = regions.means[i] - regions.means[a];
        const double along = whole.dot(part) / whole.dot(whole), distance = cv::norm(part - along * whole);
        const bool is_between = along > 0 && along < 1 && cv::norm(whole) * looseness >= 24;
        if (is_between && distance <= 0.05 * looseness * cv::norm(whole))
            mixtures.push_back({ i, along > 0.5 ? b : a, along > 0.5 ? a : b });
    }
    return mixtures;
}

std::vector<MergeContext> spreadContexts(const RegionMeasures& regions)
{
    std::vector<Vec4d> values;
    for (size_t i = 0; i < regions.areas.size(); i++)
    {
        const Vec3d& mean = regions.means[i];
        values.push_back(Vec4d(mean[0], mean[1], mean[2], textureOf(regions.steps[i], regions.areas[i])));
    }
    std::vector<std::map<int, double> > weights(values.size());
    for (const auto& e : regions.boundaries)
    {
        Vec4d d = values[e.first.first] - values[e.first.second];
        const double textures[] = { values[e.first.first][3], values[e.first.second][3] };
        d[3] = 0;
        const double length = e.second.first;
        const double steps = powerOfTwo(std::min(textures[0], textures[1]));
        const double weight = length * length * steps / ((e.second.second + length) * std::sqrt(d.dot(d) + 1.5));
        weights[e.first.first][e.first.second] = weights[e.first.second][e.first.first] = weight;
    }
    for (int round = 0; round < 4; round++)
        for (size_t i = 0; i < values.size(); i++)
        {
            Vec4d sum = Vec4d::all(0);
            double share = 0;
            for (const auto& w : weights[i])
            {
                sum += w.second * values[w.first];
                share += w.second;
            }
            if (share > 0)
                values[i] = sum * (1 / share);
        }
    return values;
}

std::map<RegionPair, CostSpan> mergeCosts(const RegionMeasures& regions, const std::vector<MergeContext>& contexts,
                                          const std::vector<int>& parts)
{
    const int n = int(regions.areas.size());
    const double num_pixels = std::accumulate(regions.areas.begin(), regions.areas.end(), 0.);
    const std::vector<Vec3d>& means = regions.means;
    int few = 1; // n, with zeros for all but the three highest bits, is few * (n / few)
    while (n / few >= 8)
        few *= 2;
    const double usual_area = std::max(1., 3.8 * num_pixels / (n / few * few));
    const double most_area = std::max(1., 4 * num_pixels / (n / few * few));
    std::map<RegionPair, CostSpan> costs;
    for (const auto& e : regions.boundaries)
    {
        const int a = e.first.first, b = e.first.second;
        const double na = regions.areas[a], nb = regions.areas[b], l = e.second.first;
        const Vec3d d = means[a] - means[b];
        const MergeContext c = contexts[a] - contexts[b];
        const double spread_squared = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
        const Vec2d ta = regions.steps[a], tb = regions.steps[b];
        const double light = 16. / 7 * (na * means[a][0] + nb * means[b][0]); // as it is
        const bool of_a_part = parts[a] == parts[b];
        CostSpan slopes = { INFINITE, -INFINITE };
        for (const double& limit : { 0.98, 1., 1.02 })
        {
            const double explained = explainedBySlopes(slopeOf(regions.rises[a], ta, na, limit),
                                                       slopeOf(regions.rises[b], tb, nb, limit),
                                                       std::min(na, nb), d.dot(d), limit);
            const double rest = of_a_part ? 0.1875 : 7 * explained + 1.5;
            const double cost = 0.46875 * straightLog(d.dot(d) + rest) + 0.171875 * straightLog(spread_squared + rest);
            slopes.first = std::min(slopes.first, cost);
            slopes.last = std::max(slopes.last, cost);
        }
        const double rest = straightLog(na) + straightLog(nb) - straightLog(na + nb) +
                            32 * std::max(0., straightLog(na + nb) - straightLog(usual_area)) +
                            (straightLog(na + nb) > straightLog(most_area) ? 32 : 0) +
                            0.95 * (straightLog(e.second.second + l) - straightLog(l)) -
                            0.640625 * (straightLog(l) - straightLog(std::min(na, nb)) / 2) -
                            0.3125 * straightLog(16 * std::abs(d[0]) + 7) -
                            0.47 * (straightLog(light + 16 * (na + nb)) - straightLog(na + nb)) +
                            0.1875 * straightLog(std::abs(d[1]) + std::abs(d[2]) + 1) -
                            1.17 * std::min(textureOf(ta, na), textureOf(tb, nb)) +
                            0.53125 * straightLog(std::abs(c[3]) + 0.1) +
                            0.625 * std::abs(directionOf(ta, na) - directionOf(tb, nb));
        costs[e.first] = { slopes.first + rest, slopes.last + rest };
    }
    return costs;
}

} // namespace
