// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Saliency filters on superpixels:
//   F. Perazzi, P. Kraehenbuehl, Y. Pritch, A. Hornung: Saliency filters: Contrast based filtering
//   for salient region detection. CVPR 2012.
// This is the application that Jiang et al. 2015 show in section IV.D and figure 6. "The paper" below
// is Perazzi et al. and names in quotes are its steps. What is not from the paper is marked as ours.

#include <opencv2/core/utility.hpp>
#include <opencv2/highgui.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <opencv2/gwatershed.hpp>

#include "split_list.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

using namespace cv;
using namespace cv::ximgproc;

static const char* const KEYS =
    "{help h         |     | print this text }"
    "{i images       |     | image, or several separated by commas }"
    "{d depths       |     | depth of the images, 8- or 16-bit or 32-bit float, 0 is missing; separated by commas,"
    " empty for an image without }"
    "{o output       |     | picture to write, without a window: a column for each image, with the rows image,"
    " superpixels, mean colours, saliency }"
    "{w depth_range  | 0   | range that mean depths are scaled to, to count as a colour; 100 is that of the lightness."
    " 0: depth shapes the superpixels only }"
    "{k superpixels  | 400 | number of superpixels }";

// Constants of the paper.
static const float SIGMA_P = 0.25f; // of positions, for the uniqueness; the larger side of the image is 1
static const float SIGMA_C = 20.f;  // of colours in CIELAB, for the distribution
static const float ALPHA = 1.f / 30, BETA = 1.f / 30; // of colour and position, for the assignment to pixels
static const float MIN_SALIENCY = 0.1f;

// Weight of the distribution: 6 in the paper, 3 in the code that its authors published. That code also has the
// squares of ALPHA and BETA, which makes a smoother map.
static const float K = 3.f;

// Ours: positions for BETA are in pixels of an image whose larger side is this, as in the images that the paper
// is measured on. So the saliency of an image does not depend on its resolution.
static const float REFERENCE_SIDE = 400.f;

struct Elements
{
    Mat_<int> labels;
    std::vector<Vec4f> colors; // CIELAB and the scaled depth, NaN where there is none
    std::vector<Point2f> positions; // the larger side of the image is 1
    std::vector<std::vector<int> > neighbors; // of each superpixel, itself first

    int size() const { return int(colors.size()); }
};

struct Times // in milliseconds
{
    double superpixels, statistics, uniqueness, distribution, assignment;
};

static float squaredDistance(const Point2f& a, const Point2f& b)
{
    return (a - b).dot(a - b);
}

static float squaredColorDistance(const Vec4f& a, const Vec3f& b)
{
    const float d0 = a[0] - b[0], d1 = a[1] - b[1], d2 = a[2] - b[2];
    return d0 * d0 + d1 * d1 + d2 * d2;
}

/* Ours: depth is the fourth coordinate of a colour. Where one of the two has none, colour alone counts. This helps
   where an object stands in front of all else. The far end of a table is unique in its depth, too: see -w. */
static float squaredColorDistance(const Vec4f& a, const Vec4f& b)
{
    const float depth = a[3] - b[3];
    return squaredColorDistance(a, Vec3f(b[0], b[1], b[2])) + (std::isnan(depth) ? 0.f : depth * depth);
}

//! From the minimum to the maximum, to 0..1; all 0 if they are equal.
static void normalize(std::vector<float>& values)
{
    const float low = *std::min_element(values.begin(), values.end());
    const float high = *std::max_element(values.begin(), values.end());
    const float scale = high > low ? 1 / (high - low) : 0.f;
    for (size_t i = 0; i < values.size(); i++)
        values[i] = (values[i] - low) * scale;
}

static Mat toLab(const Mat& image)
{
    Mat lab;
    image.convertTo(lab, CV_32F, 1 / 255.);
    cvtColor(lab, lab, COLOR_BGR2Lab);
    return lab;
}

//! Ours: mean depths, from their minimum to their maximum, to 0..range.
static void scaleDepths(Mat_<float>& depths, double range)
{
    double low, high;
    const Mat valid = depths == depths;
    minMaxLoc(depths, &low, &high, 0, 0, valid);
    if (countNonZero(valid) > 0)
        depths = (depths - low) * (high > low ? range / (high - low) : 0);
}

//! "Abstraction": the image as superpixels with a mean colour and a position each. The paper has SLIC in CIELAB.
static Elements measure(const SuperpixelGWatershed& gws, const Mat& lab, const Mat& depth, double depth_range)
{
    Mat stats;
    Mat_<double> centroids;
    Mat_<float> colors, depths;
    gws.getStatistics(lab, depth, stats, centroids, colors, depths);
    if (depth.empty())
        depths = Mat_<float>(colors.rows, 1, std::numeric_limits<float>::quiet_NaN());
    scaleDepths(depths, depth_range);

    Elements elements;
    gws.getLabels(elements.labels);
    const double side = std::max(lab.cols, lab.rows);
    for (int i = 0; i < colors.rows; i++)
    {
        elements.colors.push_back(Vec4f(colors(i, 0), colors(i, 1), colors(i, 2), depths(i)));
        elements.positions.push_back(Point2f(float(centroids(i, 0) / side), float(centroids(i, 1) / side)));
        elements.neighbors.push_back(std::vector<int>(1, i));
    }
    Mat_<int> pairs;
    gws.getAdjacency(noArray(), noArray(), pairs, noArray(), noArray());
    for (int i = 0; i < pairs.rows; i++)
    {
        elements.neighbors[pairs(i, 0)].push_back(pairs(i, 1));
        elements.neighbors[pairs(i, 1)].push_back(pairs(i, 0));
    }
    return elements;
}

/* "Element uniqueness": how much the colour of an element differs from those of the others, the near ones first:
   U_i = sum_j |c_i - c_j|^2 w(p_i, p_j), equation (1). The paper divides by the sum of the weights. The code that its
   authors published does not and calls that a typo: the middle of the image, where weights are larger, counts more. */
static std::vector<float> computeUniqueness(const Elements& elements)
{
    std::vector<float> uniqueness(elements.size(), 0.f);
    for (int i = 0; i < elements.size(); i++)
    {
        for (int j = 0; j < elements.size(); j++)
        {
            const float distance = squaredDistance(elements.positions[i], elements.positions[j]);
            const float weight = std::exp(-0.5f / (SIGMA_P * SIGMA_P) * distance);
            uniqueness[i] += weight * squaredColorDistance(elements.colors[i], elements.colors[j]);
        }
    }
    normalize(uniqueness);
    return uniqueness;
}

/* "Element distribution": how far the elements of about the same colour lie apart:
   D_i = sum_j |p_j - mu_i|^2 w(c_i, c_j) with mu_i = sum_j p_j w(c_i, c_j) and weights of sum 1. It is computed
   as sum_j |p_j|^2 w(c_i, c_j) - |mu_i|^2. */
static std::vector<float> computeDistribution(const Elements& elements)
{
    std::vector<float> distribution(elements.size());
    for (int i = 0; i < elements.size(); i++)
    {
        Point2d mean;
        double square = 0, sum_of_weights = 0;
        for (int j = 0; j < elements.size(); j++)
        {
            const float distance = squaredColorDistance(elements.colors[i], elements.colors[j]);
            const double weight = std::exp(-0.5f / (SIGMA_C * SIGMA_C) * distance);
            const Point2d position = elements.positions[j];
            mean += weight * position;
            square += weight * position.dot(position);
            sum_of_weights += weight;
        }
        mean /= sum_of_weights;
        distribution[i] = float(square / sum_of_weights - mean.dot(mean));
    }
    normalize(distribution);
    return distribution;
}

//! "Saliency assignment": S_i = U_i exp(-k D_i).
static std::vector<float> combine(const std::vector<float>& uniqueness, const std::vector<float>& distribution)
{
    std::vector<float> saliency(uniqueness.size());
    for (size_t i = 0; i < saliency.size(); i++)
        saliency[i] = uniqueness[i] * std::exp(-K * distribution[i]);
    return saliency;
}

/* "Saliency assignment" to pixels: S~(x) = sum_j w_xj S_j with
   w_xj = exp(-1/2 (alpha |c_x - c_j|^2 + beta |x - p_j|^2)) / Z_x.
   Ours: the sum runs over the superpixel of the pixel and its neighbours. Others would change a pixel in a hundred.
   Colours are without depth here, which is missing or blurred where it matters, at the outline of objects. */
static Mat_<float> assignToPixels(const Elements& elements, const std::vector<float>& saliency, const Mat_<Vec3f>& lab)
{
    Mat_<float> result(lab.size());
    const float side = float(std::max(lab.cols, lab.rows)), beta = BETA * REFERENCE_SIDE * REFERENCE_SIDE;
    parallel_for_(Range(0, lab.rows), [&](const Range& rows)
    {
        std::vector<float> exponents;
        for (int y = rows.start; y < rows.end; y++)
            for (int x = 0; x < lab.cols; x++)
            {
                const std::vector<int>& neighbors = elements.neighbors[elements.labels(y, x)];
                const Point2f position(x / side, y / side);
                exponents.clear();
                for (size_t k = 0; k < neighbors.size(); k++)
                    exponents.push_back(ALPHA * squaredColorDistance(elements.colors[neighbors[k]], lab(y, x)) +
                                        beta * squaredDistance(elements.positions[neighbors[k]], position));
                // The largest weight is 1, so that not all of them become 0.
                const float least = *std::min_element(exponents.begin(), exponents.end());
                float sum = 0, sum_of_weights = 0;
                for (size_t k = 0; k < neighbors.size(); k++)
                {
                    const float weight = std::exp(-0.5f * (exponents[k] - least));
                    sum += weight * saliency[neighbors[k]];
                    sum_of_weights += weight;
                }
                result(y, x) = sum / sum_of_weights;
            }
    });
    return result;
}

/* The paper: to 0..1, or so that at least 10 % of the pixels are salient. As in the code of the authors, that means
   a mean of 0.1: all values grow by the same factor, those above 1 become 1, and again if that is not enough. */
static void rescale(Mat_<float>& saliency)
{
    double low, high;
    minMaxLoc(saliency, &low, &high);
    saliency = (saliency - low) * (high > low ? 1 / (high - low) : 0);
    for (int i = 0; i < 20; i++)
    {
        const double mean_saliency = mean(saliency)[0];
        if (mean_saliency <= 0 || mean_saliency >= MIN_SALIENCY)
            break;
        saliency = min(saliency * (MIN_SALIENCY / mean_saliency), 1);
    }
}

//! Runs one stage and returns what it took.
template <typename Stage>
static double timed(const Stage& stage)
{
    TickMeter timer;
    timer.start();
    stage();
    timer.stop();
    return timer.getTimeMilli();
}

static Mat_<float> findSaliency(const Mat& image, const Mat& depth, int num_superpixels, double depth_range,
                                Elements& elements, Times& times)
{
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, num_superpixels);
    Mat lab;
    std::vector<float> uniqueness, distribution;
    Mat_<float> saliency;
    times.superpixels = timed([&]()
    {
        if (depth.empty())
            gws->iterate(image);
        else
            gws->iterate(image, depth);
    });
    times.statistics = timed([&]()
    {
        lab = toLab(image);
        elements = measure(*gws, lab, depth, depth_range);
    });
    times.uniqueness = timed([&]() { uniqueness = computeUniqueness(elements); });
    times.distribution = timed([&]() { distribution = computeDistribution(elements); });
    times.assignment = timed([&]()
    {
        saliency = assignToPixels(elements, combine(uniqueness, distribution), lab);
        rescale(saliency);
    });
    return saliency;
}

static Mat drawContours(const Mat& image, const Mat_<int>& labels)
{
    Mat_<Vec3b> result = image.clone();
    for (int y = 0; y + 1 < labels.rows; y++)
        for (int x = 0; x + 1 < labels.cols; x++)
            if (labels(y, x) != labels(y, x + 1) || labels(y, x) != labels(y + 1, x))
                result(y, x) = Vec3b(0, 0, 255);
    return result;
}

static Mat drawMeans(const Elements& elements)
{
    Mat_<Vec3f> palette(1, elements.size());
    for (int i = 0; i < elements.size(); i++)
        palette(i) = Vec3f(elements.colors[i].val);
    cvtColor(palette, palette, COLOR_Lab2BGR);
    Mat_<Vec3b> colors, result(elements.labels.size());
    palette.convertTo(colors, CV_8U, 255);
    for (int y = 0; y < result.rows; y++)
        for (int x = 0; x < result.cols; x++)
            result(y, x) = colors(elements.labels(y, x));
    return result;
}

//! One column of figure 6: image, superpixels, mean colours, saliency.
static Mat drawColumn(const Mat& image, const Elements& elements, const Mat_<float>& saliency)
{
    const int HEIGHT = 240;
    const Size size(std::max(1, cvRound(double(image.cols) * HEIGHT / image.rows)), HEIGHT);
    Mat rows[4], labels, gray, column;
    resize(image, rows[0], size, 0, 0, INTER_AREA);
    // Lines that are drawn after the resize have a width of one pixel.
    resize(elements.labels, labels, size, 0, 0, INTER_NEAREST);
    rows[1] = drawContours(rows[0], labels);
    resize(drawMeans(elements), rows[2], size, 0, 0, INTER_AREA);
    saliency.convertTo(gray, CV_8U, 255);
    resize(gray, gray, size, 0, 0, INTER_AREA);
    cvtColor(gray, rows[3], COLOR_GRAY2BGR);
    for (int i = 0; i < 4; i++)
        copyMakeBorder(rows[i], rows[i], 2, 2, 2, 2, BORDER_CONSTANT, Scalar::all(255));
    vconcat(rows, 4, column);
    return column;
}

static Mat read(const String& file, int flags)
{
    const Mat image = imread(file, flags);
    if (image.empty())
        CV_Error(Error::StsBadArg, "cannot read the image " + file);
    return image;
}

int main(int argc, char** argv)
{
    CommandLineParser parser(argc, argv, KEYS);
    parser.about("Saliency filters (Perazzi et al. 2012) on the superpixels of cv::ximgproc::SuperpixelGWatershed.");
    const std::vector<String> files = splitList(parser.get<String>("images"));
    std::vector<String> depth_files = splitList(parser.get<String>("depths"));
    const String output = parser.get<String>("output");
    const int num_superpixels = parser.get<int>("superpixels");
    const double depth_range = parser.get<double>("depth_range");
    if (parser.has("help") || files.empty() || depth_files.size() > files.size() || !parser.check())
    {
        parser.printErrors();
        parser.printMessage();
        return parser.has("help") ? 0 : 1;
    }
    depth_files.resize(files.size());

    try
    {
        std::vector<Mat> columns;
        for (size_t i = 0; i < files.size(); i++)
        {
            const Mat image = read(files[i], IMREAD_COLOR);
            const Mat depth = depth_files[i].empty() ? Mat() : read(depth_files[i], IMREAD_UNCHANGED);
            Elements elements;
            Times t;
            const Mat_<float> saliency = findSaliency(image, depth, num_superpixels, depth_range, elements, t);
            columns.push_back(drawColumn(image, elements, saliency));
            std::cout << files[i] << ", " << image.cols << "x" << image.rows << (depth.empty() ? "" : " with depth")
                      << format(": %d superpixels %.2f ms, statistics %.2f ms, uniqueness %.2f ms, ",
                                elements.size(), t.superpixels, t.statistics, t.uniqueness)
                      << format("distribution %.2f ms, assignment %.2f ms", t.distribution, t.assignment) << std::endl;
        }
        Mat picture;
        hconcat(columns, picture);
        if (output.empty())
        {
            imshow("saliency filters", picture);
            waitKey();
        }
        else if (!imwrite(output, picture))
            CV_Error(Error::StsError, "cannot write " + output);
    }
    catch (const cv::Exception& e)
    {
        std::cerr << e.what() << std::endl;
        return 1;
    }
    return 0;
}
