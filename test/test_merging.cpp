// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_merge_reference.hpp"

namespace opencv_test { namespace {

// The order of mergeSimilar(), against the formula in shared/union_cost.hpp.

typedef testing::TestWithParam<int> ximgproc_GWatershed_merging;

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

//! Costs of the unions of a partition.
KeyedCosts keyedCosts(const std::vector<RegionKey>& keys, const std::map<RegionPair, CostSpan>& costs)
{
    KeyedCosts keyed;
    for (const auto& e : costs)
    {
        const RegionKey a = keys[e.first.first], b = keys[e.first.second];
        keyed[std::make_pair(std::min(a, b), std::max(a, b))] = e.second;
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

//! The partitions into n superpixels, n - 1, down to one.
std::vector<Mat> allPartitions(const Ptr<SuperpixelGWatershed>& gws)
{
    std::vector<Mat> partitions;
    for (int n = gws->getNumberOfSuperpixels(); n > 0; n--)
    {
        gws->mergeSimilar(n);
        partitions.push_back(labelsOf(gws));
    }
    return partitions;
}

//! Whether the union of two regions gives a mixture, a label of an earlier partition, to one of its sides.
bool isOfMixture(const std::pair<RegionKey, RegionKey>& pair, const Mixture& mixture,
                 const std::vector<RegionKey>& keys, const Mat& after)
{
    const auto labelOf = [&](int region)
    {
        return after.at<int>(keys[region].first / after.cols, keys[region].first % after.cols);
    };
    const int label = labelOf(mixture.region);
    return (pair.first == keys[mixture.region] || pair.second == keys[mixture.region]) &&
           (label == labelOf(mixture.nearer) || label == labelOf(mixture.farther));
}

//! The number of unions, from a partition on, that give mixtures of it to one of their sides. All that are mixtures
//! beyond doubt, beside a region that is none, must be among them.
size_t countUnionsOfMixtures(const Mat& image, const std::vector<Mat>& partitions, size_t start)
{
    const Mat &labels = partitions[start], &first = partitions[0];
    const int n = numberOfLabels(labels);
    const RegionMeasures regions(image, first, labels, n);
    const std::vector<Mixture> possible = findMixtures(regions, 1.03), certain = findMixtures(regions, 0.97);
    const std::vector<RegionKey> keys = regionKeys(labels, n);
    size_t end = start;
    std::set<int> given, mixed;
    for (const Mixture& mixture : possible)
        mixed.insert(mixture.region);
    for (bool found = true; found && end + 1 < partitions.size(); end += found)
    {
        const Mat &before = partitions[end], &after = partitions[end + 1];
        const std::pair<RegionKey, RegionKey> pair = findUnion(before, after, numberOfLabels(before));
        found = false;
        for (const Mixture& mixture : possible)
            if (!given.count(mixture.region) && isOfMixture(pair, mixture, keys, after))
            {
                given.insert(mixture.region);
                found = true;
                break;
            }
    }
    for (const Mixture& mixture : certain)
    {
        const bool can_be_given = !mixed.count(mixture.nearer) || !mixed.count(mixture.farther);
        EXPECT_TRUE(!can_be_given || given.count(mixture.region)) << "superpixel " << mixture.region << " of " << n;
    }
    return end - start;
}

//! The contexts of the regions of a partition, from those of an earlier one.
std::vector<MergeContext> meanContexts(const std::vector<MergeContext>& contexts, const Mat& earlier, const Mat& labels,
                                       int n)
{
    std::vector<MergeContext> means(n, MergeContext::all(0));
    std::vector<double> areas(n, 0.);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            means[labels.at<int>(y, x)] += contexts[earlier.at<int>(y, x)];
            areas[labels.at<int>(y, x)]++;
        }
    for (int i = 0; i < n; i++)
        means[i] *= 1 / areas[i];
    return means;
}

// Mixtures go first, twice. Then two regions are united only if they were the best neighbours of each other when their
// round began, which is at some time since both of them are what they are.
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
        const int num_first = gws->getNumberOfSuperpixels();
        const std::vector<Mat> partitions = allPartitions(gws);
        size_t num_mixtures = countUnionsOfMixtures(image, partitions, 0);
        num_mixtures += countUnionsOfMixtures(image, partitions, num_mixtures);
        const Mat first = partitions[0], unmixed = partitions[num_mixtures];
        const std::vector<MergeContext> contexts =
                spreadContexts(RegionMeasures(image, first, unmixed, numberOfLabels(unmixed)));
        const MergePlan plan(first, num_first);
        const std::vector<RegionKey> first_keys = regionKeys(first, num_first);
        std::map<RegionKey, int> parts, lowest; // lowest of the first labels
        for (int k = 0; k < num_first; k++)
        {
            parts[first_keys[k]] = plan.parts[k];
            lowest[first_keys[k]] = k;
        }
        std::vector<KeyedCosts> history;
        for (size_t step = 0; step + 1 < partitions.size(); step++)
        {
            const Mat &before = partitions[step], &after = partitions[step + 1];
            const int n = numberOfLabels(before);
            const std::pair<RegionKey, RegionKey> pair = findUnion(before, after, n);
            if (step >= num_mixtures)
            {
                const std::vector<RegionKey> keys = regionKeys(before, n);
                std::vector<int> part_of_label;
                for (const RegionKey& key : keys)
                    part_of_label.push_back(parts.find(key)->second);
                history.push_back(keyedCosts(keys, mergeCosts(RegionMeasures(image, first, before, n),
                                                              meanContexts(contexts, unmixed, before, n),
                                                              part_of_label)));
                bool found = false;
                for (int k = int(history.size()) - 1; k >= 0 && history[k].count(pair) && !found; k--)
                    found = areBestNeighbors(history[k], pair);
                ASSERT_TRUE(found) << n << " superpixels";
            }
            // Both halves of a part are the part. Else the larger region counts; of equal ones, that which began first.
            const RegionKey a = pair.first, b = pair.second;
            const bool a_counts = a.second > b.second || (a.second == b.second && lowest[a] < lowest[b]);
            const int part = parts[a_counts ? a : b];
            const RegionKey both(std::min(a.first, b.first), a.second + b.second);
            parts[both] = parts[a] == parts[b] && part >= 0 ? plan.above[part] : part;
            lowest[both] = std::min(lowest[a], lowest[b]);
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

//! Share of the superpixels that hold no square of 3x3 pixels.
double shareOfSlivers(const Mat& labels, int n)
{
    std::vector<uchar> is_sliver(n, 1);
    for (int y = 1; y + 1 < labels.rows; y++)
        for (int x = 1; x + 1 < labels.cols; x++)
        {
            const int label = labels.at<int>(y, x);
            if (is_sliver[label])
                is_sliver[label] = countNonZero(labels(Rect(x - 1, y - 1, 3, 3)) != label) > 0;
        }
    return double(countNonZero(is_sliver)) / n;
}

// A superpixel of pixels that are half one thing and half another is far from both, and would stay to the end.
TEST_P(ximgproc_GWatershed_merging, edges_of_drawings_are_no_superpixels)
{
    RNG& rng = theRNG();
    double slivers = 0;
    const int images = 6;
    for (int i = 0; i < images; i++)
    {
        Mat image(240, 320, CV_8UC3, Scalar(240, 230, 220));
        for (int k = 0; k < 25; k++)
        {
            const Scalar color(rng.uniform(0, 256), rng.uniform(0, 256), rng.uniform(0, 256));
            const Size axes(rng.uniform(10, 50), rng.uniform(10, 50));
            ellipse(image, Point(rng.uniform(0, 320), rng.uniform(0, 240)), axes, rng.uniform(0, 180), 0, 360, color,
                    FILLED, LINE_AA);
        }
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(320, 240, 3, 768, GetParam());
        gws->iterate(image);
        gws->mergeSimilar(192);
        slivers += shareOfSlivers(labelsOf(gws), 192) / images;
    }
    EXPECT_LE(slivers, 0.16);
}

INSTANTIATE_TEST_CASE_P(/**/, ximgproc_GWatershed_merging, testing::ValuesIn(ALGORITHMS));

}} // namespace
