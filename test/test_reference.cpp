// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_common.hpp"

#include <deque>

namespace opencv_test { namespace {

// Algorithm 1 of the paper in its simplest form: a deque for each priority, Mat::at, bounds tests. The class must give
// the same labels for every pixel.

const int S_BORDER = -1, S_INQ = -2;
const Point LEFT_TOP_RIGHT_BOTTOM[4] = { Point(-1, 0), Point(0, -1), Point(1, 0), Point(0, 1) };

struct PlainGWatershed
{
    Mat color;  // CV_8UC3
    Mat depth;  // CV_8UC1, 0 where missing; empty if there is none
    Mat mask;   // CV_8UC1; empty if all pixels are inside
    int alpha;  // in 1/256
    float border_threshold;
    Mat s;      // states, then labels 1..N
    Mat lines;

    bool inside(Point p) const
    {
        return Rect(Point(), color.size()).contains(p) && (mask.empty() || mask.at<uchar>(p));
    }
    // Whether the 3x3 window has a pixel of the image outside of the mask. Then the gradient is not known.
    bool besideOutside(Point p) const
    {
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++)
                if (Rect(Point(), color.size()).contains(p + Point(dx, dy)) && !inside(p + Point(dx, dy)))
                    return true;
        return false;
    }
    int state(Point p) const { return inside(p) ? s.at<int>(p) : S_BORDER; }

    int dist(Point p, Point q) const
    {
        const Vec3b a = color.at<Vec3b>(p), b = color.at<Vec3b>(q);
        int rgb = 0;
        for (int c = 0; c < 3; c++)
            rgb = std::max(rgb, std::abs(a[c] - b[c])); // (1)
        if (depth.empty() || depth.at<uchar>(p) == 0 || depth.at<uchar>(q) == 0)
            return rgb;
        const int d = std::abs(depth.at<uchar>(p) - depth.at<uchar>(q)); // (2)
        return (alpha * rgb + (256 - alpha) * d + 128) / 256; // (3), to the nearest
    }

    static Mat sobelMagnitude(const Mat& gray)
    {
        Mat dx, dy, magnitude(gray.size(), CV_32SC1);
        Sobel(gray, dx, CV_32F, 1, 0);
        Sobel(gray, dy, CV_32F, 0, 1);
        for (int y = 0; y < gray.rows; y++)
            for (int x = 0; x < gray.cols; x++)
                magnitude.at<int>(y, x) = int(std::sqrt(dx.at<float>(y, x) * dx.at<float>(y, x) +
                                                        dy.at<float>(y, x) * dy.at<float>(y, x)) + 0.5f);
        return magnitude;
    }

    bool holeAround(Point p) const
    {
        for (int dy = -1; dy <= 1; dy++)
            for (int dx = -1; dx <= 1; dx++)
                if (inside(p + Point(dx, dy)) && depth.at<uchar>(p + Point(dx, dy)) == 0)
                    return true;
        return false;
    }

    Mat gradient(const Mat& gray) const
    {
        Mat g = sobelMagnitude(gray);
        if (depth.empty())
            return g;
        const Mat gd = sobelMagnitude(depth);
        for (int y = 0; y < g.rows; y++)
            for (int x = 0; x < g.cols; x++)
                if (!holeAround(Point(x, y)))
                    g.at<int>(y, x) = (alpha * g.at<int>(y, x) + (256 - alpha) * gd.at<int>(y, x) + 128) / 256;
        return g;
    }

    // One seed for each cell: among the pixels within a quarter of the cell, or one, from its centre the one
    // with the smallest (gradient, distance to the centre, y, x).
    static std::vector<Point> seeds(const Mat& g, int k)
    {
        int rows = cvRound(std::sqrt(double(k) * g.rows / g.cols));
        rows = std::min(rows, std::min(g.rows, k));
        while (rows * g.cols < k)
            rows++;
        std::vector<Point> found;
        for (int i = 0; i < rows; i++)
        {
            const int n = k * (i + 1) / rows - k * i / rows;
            for (int j = 0; j < n; j++)
            {
                const int x0 = g.cols * j / n, x1 = g.cols * (j + 1) / n;
                const int y0 = g.rows * i / rows, y1 = g.rows * (i + 1) / rows;
                const double cx = (x0 + x1 - 1) / 2., cy = (y0 + y1 - 1) / 2.;
                const int rx = x1 - x0 <= 2 ? 0 : std::max(1, (x1 - x0) / 4);
                const int ry = y1 - y0 <= 2 ? 0 : std::max(1, (y1 - y0) / 4);
                std::vector<Vec4d> candidates;
                for (int y = y0; y < y1; y++)
                    for (int x = x0; x < x1; x++)
                        if (std::abs(x - cx) < rx + 1 && std::abs(y - cy) < ry + 1)
                            candidates.push_back(Vec4d(g.at<int>(y, x),
                                                       (x - cx) * (x - cx) + (y - cy) * (y - cy), y, x));
                const Vec4d best = *std::min_element(candidates.begin(), candidates.end(), less);
                found.push_back(Point(int(best[3]), int(best[2])));
            }
        }
        return found;
    }
    static bool less(const Vec4d& a, const Vec4d& b)
    {
        return std::lexicographical_compare(a.val, a.val + 4, b.val, b.val + 4);
    }

    void flood(const Mat& g)
    {
        std::vector<std::deque<Point> > q(256);
        for (int y = 0; y < s.rows; y++)
            for (int x = 0; x < s.cols; x++)
            {
                const Point p(x, y);
                if (!inside(p))
                    continue;
                if (s.at<int>(p) == 0 && border_threshold > 0 && g.at<int>(p) >= border_threshold && !besideOutside(p))
                    s.at<int>(p) = S_BORDER;
                int h = 256;
                for (int k = 0; k < 4; k++)
                    if (state(p + LEFT_TOP_RIGHT_BOTTOM[k]) > 0)
                        h = std::min(h, dist(p, p + LEFT_TOP_RIGHT_BOTTOM[k])); // (4)
                if (s.at<int>(p) == 0 && h < 256)
                {
                    q[h].push_back(p);
                    s.at<int>(p) = S_INQ;
                }
            }
        bool repeat = true;
        while (repeat)
        {
            for (int h = 0; h < 256; h++)
                while (!q[h].empty())
                {
                    const Point p = q[h].front();
                    q[h].pop_front();
                    std::set<int> around;
                    for (int k = 0; k < 4; k++)
                        if (state(p + LEFT_TOP_RIGHT_BOTTOM[k]) > 0)
                            around.insert(state(p + LEFT_TOP_RIGHT_BOTTOM[k]));
                    if (around.size() > 1)
                    {
                        s.at<int>(p) = S_BORDER;
                        continue;
                    }
                    s.at<int>(p) = *around.begin();
                    for (int k = 0; k < 4; k++)
                    {
                        const Point a = p + LEFT_TOP_RIGHT_BOTTOM[k];
                        if (!inside(a) || s.at<int>(a) != 0)
                            continue;
                        q[dist(p, a)].push_back(a);
                        s.at<int>(a) = S_INQ;
                    }
                }
            repeat = false;
            for (int h = 0; h < 256; h++)
                repeat = repeat || !q[h].empty();
        }
    }

    void absorb()
    {
        lines = s <= 0;
        for (bool changed = true; changed;)
        {
            changed = false;
            Mat next = s.clone();
            for (int y = 0; y < s.rows; y++)
                for (int x = 0; x < s.cols; x++)
                {
                    const Point p(x, y);
                    int smallest = 256;
                    for (int k = 0; inside(p) && s.at<int>(p) <= 0 && k < 4; k++)
                    {
                        const Point a = p + LEFT_TOP_RIGHT_BOTTOM[k];
                        if (state(a) > 0 && dist(p, a) < smallest)
                        {
                            smallest = dist(p, a);
                            changed = true;
                            next.at<int>(p) = state(a);
                        }
                    }
                }
            s = next;
        }
        lines.setTo(Scalar(0), s <= 0); // no marker reaches these
    }

    void run(const Mat& image, int k)
    {
        const Mat g = prepare(image);
        const std::vector<Point> markers = seeds(g, k);
        s = Mat::zeros(image.size(), CV_32SC1);
        for (size_t i = 0; i < markers.size(); i++)
            s.at<int>(markers[i]) = int(i) + 1;
        flood(g);
        absorb();
    }

    // Returns the number of markers inside of the mask.
    int run(const Mat& image, const Mat& markers)
    {
        const Mat g = prepare(image);
        std::map<int, int> labels;
        s = Mat::zeros(image.size(), CV_32SC1);
        for (int pass = 0; pass < 2; pass++)
        {
            int n = 0;
            for (std::map<int, int>::iterator i = labels.begin(); i != labels.end(); ++i)
                i->second = ++n;
            for (int y = 0; y < s.rows; y++)
                for (int x = 0; x < s.cols; x++)
                    if (inside(Point(x, y)) && markers.at<int>(y, x) > 0)
                        s.at<int>(y, x) = labels[markers.at<int>(y, x)];
        }
        flood(g);
        absorb();
        return int(labels.size());
    }

    Mat prepare(const Mat& image)
    {
        Mat gray = image;
        if (image.channels() == 1)
            cvtColor(image, color, COLOR_GRAY2BGR);
        else
        {
            color = image;
            cvtColor(image, gray, COLOR_BGR2GRAY);
        }
        return gradient(gray);
    }
};

// Depth as it is in the paper's equation (2): 1..255 from near to far, 0 where missing.
Mat scaleDepthPlainly(const Mat& depth, float near_depth, float far_depth)
{
    Mat scaled(depth.size(), CV_8UC1);
    for (int y = 0; y < depth.rows; y++)
        for (int x = 0; x < depth.cols; x++)
        {
            const float d = depth.at<ushort>(y, x);
            const float clamped = std::min(std::max(d, near_depth), far_depth);
            scaled.at<uchar>(y, x) = d == 0 ? uchar(0)
                                            : uchar(1.5 + 254. / (far_depth - near_depth) * (clamped - near_depth));
        }
    return scaled;
}

// Whether a depth map has one value only, apart from holes. It must have no effect then.
bool tellsNothing(const Mat& scaled)
{
    double smallest = 0, largest = 0;
    if (countNonZero(scaled) == 0)
        return true;
    minMaxLoc(scaled, &smallest, &largest, 0, 0, scaled != 0);
    return smallest == largest;
}

enum DepthKind { NO_DEPTH, FULL_DEPTH, DEPTH_WITH_HOLES, BYTE_DEPTH, DEPTH_KINDS };

TEST(ximgproc_SuperpixelGWatershed, equals_plain_transcription_of_algorithm_1)
{
    const float thresholds[] = { 0, 0, 30, 200, 700 };
    const float alphas[] = { 0.5f, 0.25f, 1.f, 0.f };
    const float near_depth = 600, far_depth = 3500;
    RNG rng(20150901);
    int compared = 0;
    for (int i = 0; i < 600; i++)
    {
        const Size size = i < 64 ? Size(1 + i % 8, 1 + i / 8) : Size(rng.uniform(1, 98), rng.uniform(1, 84));
        const ImageKind image_kind = ImageKind(i % IMAGE_KINDS);
        const int channels = i / IMAGE_KINDS % 2 ? 1 : 3;
        const DepthKind depth_kind = DepthKind(rng.uniform(0, int(DEPTH_KINDS)));
        const int k = std::min(size.area(), i % 7 == 0 ? 1 : rng.uniform(1, 2 + size.area() / rng.uniform(1, 100)));

        const Mat image = makeImage(image_kind, size, channels, rng);
        PlainGWatershed plain;
        plain.border_threshold = thresholds[rng.uniform(0, 5)];
        const float alpha = alphas[rng.uniform(0, 4)];
        plain.alpha = cvRound(alpha * 256);

        Mat depth;
        if (depth_kind != NO_DEPTH)
        {
            depth = makeDepth(size, depth_kind == DEPTH_WITH_HOLES ? 0.3 : 0, rng);
            plain.depth = scaleDepthPlainly(depth, near_depth, far_depth);
            if (depth_kind == BYTE_DEPTH)
                depth = plain.depth.clone();
            if (tellsNothing(plain.depth))
                plain.depth = Mat();
        }
        plain.run(image, k);

        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(size.width, size.height, channels, k);
        gws->setAlgorithm(GWATERSHED);
        gws->setBorderThreshold(plain.border_threshold);
        gws->setAlpha(alpha);
        gws->setDepthRange(near_depth, far_depth);
        if (depth.empty())
            gws->iterate(image);
        else
            gws->iterate(image, depth);

        Mat lines;
        gws->getWatershedLineMask(lines);
        ASSERT_EQ(k, gws->getNumberOfSuperpixels());
        ASSERT_TRUE(equalMats(plain.lines, lines)) << "case " << i << ", " << size;
        ASSERT_TRUE(equalMats(plain.s, labelsOf(gws) + 1)) << "case " << i << ", " << size;
        compared += size.area();
    }
    EXPECT_GT(compared, 500000) << "pixels compared";
}

// Markers of the user, in a mask or not. What is outside of the bounding box of a mask does not exist.
TEST(ximgproc_SuperpixelGWatershed, equals_plain_transcription_with_markers_and_mask)
{
    RNG& rng = theRNG();
    int compared = 0;
    for (int i = 0; i < 200; i++)
    {
        const Size size(rng.uniform(1, 98), rng.uniform(1, 84));
        const Mat image = makeImage(ImageKind(i % IMAGE_KINDS), size, i % 5 ? 3 : 1, rng);
        const Mat markers = makeMarkers(size, rng.uniform(1, 40), rng);
        const Mat mask = i % 2 ? makeMask(MaskKind(i / 2 % MASK_KINDS), size, rng) : Mat();
        std::vector<Point> points;
        findNonZero(mask.empty() ? Mat(size, CV_8UC1, Scalar(1)) : mask, points);
        const Rect box = boundsOf(points);

        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GWATERSHED, 10);
        gws->setMask(mask);
        gws->setMarkers(markers);
        gws->setBorderThreshold(i % 3 * 100.f);
        gws->iterate();
        Mat expected = Mat::zeros(size, CV_32SC1), expected_lines = Mat::zeros(size, CV_8UC1), lines;
        if (!box.empty())
        {
            PlainGWatershed plain;
            plain.border_threshold = i % 3 * 100.f;
            if (!mask.empty())
                plain.mask = mask(box);
            ASSERT_EQ(plain.run(image(box).clone(), markers(box)), gws->getNumberOfSuperpixels());
            Mat(cv::max(plain.s, 0)).copyTo(expected(box));
            plain.lines.copyTo(expected_lines(box));
        }
        gws->getWatershedLineMask(lines);
        ASSERT_TRUE(equalMats(expected, labelsOf(gws) + 1)) << "case " << i << ", " << size;
        ASSERT_TRUE(equalMats(expected_lines, lines)) << "case " << i << ", " << size;
        compared += box.area();
    }
    EXPECT_GT(compared, 200000) << "pixels compared";
}

// What iterations mean to a flood of one pass.
TEST(ximgproc_SuperpixelGWatershed, iterations_and_ruler_do_not_change_algorithm_1)
{
    RNG& rng = theRNG();
    const Mat image = makeScene(Size(120, 90), rng);
    const Mat expected = segment(image, GWATERSHED, 10);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, GWATERSHED, 10, 55.f);
    gws->iterate(7);
    EXPECT_TRUE(equalMats(expected, labelsOf(gws)));
}

}} // namespace
