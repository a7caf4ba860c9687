// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/filesystem.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <opencv2/gwatershed.hpp>
#ifdef GWATERSHED_HAVE_XIMGPROC
#include <opencv2/ximgproc.hpp>
#endif

#include "split_list.hpp"
#include "superpixel_metrics.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

using namespace cv;
using namespace cv::ximgproc;

static const char* const KEYS =
    "{help h       |     | print this text }"
    "{i images     |     | folder of the images: <id>.jpg, <id>.png or <id>_color.png }"
    "{g truth      |     | folder of the ground truth, 8- or 16-bit label maps of the size of the image:"
    " <id>-0.png, <id>-1.png, ... for several annotators, or <id>_labels.png }"
    "{d depth      |     | folder of depth maps <id>_depth.png (0: missing); methods that take depth run without, too }"
    "{z ignore_zero|     | label 0 of the ground truth means not labelled; such pixels do not count }"
    "{f focal      | 0   | focal length of the depth camera in pixels; 0: 0.8 of the longer side of the image }"
    "{k numbers    | 100,200,400,800,1600 | numbers of superpixels }"
    "{m methods    |     | names of methods to run, or beginnings of names, separated by commas; empty: all }"
    "{l limit      | 0   | number of images to use, the first ones by name; 0: all }"
    "{t threads    | 1   | number of threads }"
    "{o output     | benchmark.csv | file to write }";

//! Segments an image, with its depth if it takes any, into about k superpixels.
typedef std::function<Mat(const Mat& image, const Mat& depth, int k)> Segmenter;

struct Method
{
    String name;
    bool takes_depth;
    int merged_from; //!< so many superpixels, or 0
    Segmenter segment;
};

struct Example
{
    String id;
    Mat image, depth;
    std::vector<Mat> truths;
};

//! Side of the square that a superpixel fills.
static double side(const Mat& image, int k)
{
    return std::sqrt(double(image.total()) / k);
}

//! How SuperpixelGWatershed is called.
struct Settings
{
    int algorithm;
    float ruler;
    int iterations, effort;
    int merged_from; //!< so many superpixels, or 0: not merged
    float focal;     //!< length, 0: the default
};

static Mat segmentByGWatershed(const Mat& image, const Mat& depth, int k, const Settings& settings)
{
    const int num_superpixels = settings.merged_from > 0 ? settings.merged_from : k;
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, image.channels(),
                                                               num_superpixels, settings.algorithm, settings.ruler);
    gws->setEffort(settings.effort);
    gws->setFocalLength(settings.focal);
    if (depth.empty())
        gws->iterate(image, settings.iterations);
    else
        gws->iterate(image, depth, settings.iterations);
    if (settings.merged_from > 0)
        gws->mergeSimilar(k);
    Mat labels;
    gws->getLabels(labels);
    return labels;
}

//! cv::watershed from the centres of a grid; its lines and its frame go to the neighbours.
static Mat segmentByWatershed(const Mat& image, const Mat&, int k)
{
    Mat labels = Mat::zeros(image.size(), CV_32SC1);
    const double s = side(image, k);
    int n = 0;
    for (double y = s / 2; y < image.rows; y += s)
        for (double x = s / 2; x < image.cols; x += s)
            labels.at<int>(int(y), int(x)) = ++n;
    watershed(image, labels);
    while (countNonZero(labels == -1) > 0)
    {
        Mat wide;
        Mat as_float;
        labels.convertTo(as_float, CV_32F);
        dilate(as_float, wide, Mat());
        wide.convertTo(wide, CV_32S);
        wide.copyTo(labels, labels == -1);
    }
    return labels;
}

static Mat segmentByGrid(const Mat& image, const Mat&, int k)
{
    const int rows = std::max(1, cvRound(std::sqrt(double(k) * image.rows / image.cols)));
    const int cols = std::max(1, cvRound(double(k) / rows));
    Mat labels(image.size(), CV_32SC1);
    for (int y = 0; y < image.rows; y++)
        for (int x = 0; x < image.cols; x++)
            labels.at<int>(y, x) = y * rows / image.rows * cols + x * cols / image.cols;
    return labels;
}

#ifdef GWATERSHED_HAVE_XIMGPROC

static Mat toLab(const Mat& image, bool blur)
{
    Mat blurred, lab;
    if (blur)
        GaussianBlur(image, blurred, Size(3, 3), 0);
    cvtColor(blur ? blurred : image, lab, COLOR_BGR2Lab);
    return lab;
}

static Mat segmentBySLIC(const Mat& image, int k, int algorithm)
{
    Ptr<SuperpixelSLIC> slic = createSuperpixelSLIC(toLab(image, true), algorithm, cvRound(side(image, k)), 10.f);
    slic->iterate(10);
    slic->enforceLabelConnectivity(25);
    Mat labels;
    slic->getLabels(labels);
    return labels;
}

static Mat segmentBySEEDS(const Mat& image, const Mat&, int k)
{
    Ptr<SuperpixelSEEDS> seeds = createSuperpixelSEEDS(image.cols, image.rows, image.channels(), k, 4);
    seeds->iterate(image);
    Mat labels;
    seeds->getLabels(labels);
    return labels;
}

static Mat segmentByLSC(const Mat& image, const Mat&, int k)
{
    Ptr<SuperpixelLSC> lsc = createSuperpixelLSC(toLab(image, true), cvRound(side(image, k)));
    lsc->iterate(10);
    lsc->enforceLabelConnectivity(25);
    Mat labels;
    lsc->getLabels(labels);
    return labels;
}

static Mat segmentByScanSegment(const Mat& image, const Mat&, int k)
{
    Ptr<ScanSegment> scan = createScanSegment(image.cols, image.rows, k);
    scan->iterate(toLab(image, false));
    Mat labels;
    scan->getLabels(labels);
    return labels;
}

#endif

static Method gwatershed(const String& name, const Settings& settings)
{
    const Method method = { name, true, settings.merged_from, [=](const Mat& image, const Mat& depth, int k)
    {
        return segmentByGWatershed(image, depth, k, settings);
    } };
    return method;
}

static Method peer(const String& name, const Segmenter& segment)
{
    const Method method = { name, false, 0, segment };
    return method;
}

static std::vector<Method> allMethods(float focal)
{
    const String merged = "merged from 1600 ";
    std::vector<Method> methods;
    methods.push_back(gwatershed("RGWATERSHED", { RGWATERSHED, 10, 1, 1, 0, focal }));
    methods.push_back(gwatershed("RGWATERSHED 4 iterations", { RGWATERSHED, 10, 4, 1, 0, focal }));
    methods.push_back(gwatershed("RGWATERSHED ruler 1 8 iterations", { RGWATERSHED, 1, 8, 1, 0, focal }));
    methods.push_back(gwatershed("RGWATERSHED effort 0", { RGWATERSHED, 10, 1, 0, 0, focal }));
    methods.push_back(gwatershed("RGWATERSHED effort 2", { RGWATERSHED, 10, 1, 2, 0, focal }));
    methods.push_back(gwatershed("RGWATERSHED effort 3", { RGWATERSHED, 10, 1, 3, 0, focal }));
    methods.push_back(gwatershed("GWATERSHED", { GWATERSHED, 10, 1, 1, 0, focal }));
    methods.push_back(gwatershed(merged + "RGWATERSHED", { RGWATERSHED, 10, 1, 1, 1600, focal }));
    methods.push_back(gwatershed(merged + "RGWATERSHED ruler 5", { RGWATERSHED, 5, 1, 1, 1600, focal }));
    methods.push_back(gwatershed(merged + "RGWATERSHED ruler 5 effort 2", { RGWATERSHED, 5, 1, 2, 1600, focal }));
    methods.push_back(gwatershed(merged + "GWATERSHED", { GWATERSHED, 10, 1, 1, 1600, focal }));
#ifdef GWATERSHED_HAVE_XIMGPROC
    methods.push_back(peer("SLIC", [](const Mat& image, const Mat&, int k) { return segmentBySLIC(image, k, SLIC); }));
    methods.push_back(
            peer("SLICO", [](const Mat& image, const Mat&, int k) { return segmentBySLIC(image, k, SLICO); }));
    methods.push_back(peer("SEEDS", segmentBySEEDS));
    methods.push_back(peer("LSC", segmentByLSC));
    methods.push_back(peer("ScanSegment", segmentByScanSegment));
#endif
    methods.push_back(peer("cv::watershed", segmentByWatershed));
    methods.push_back(peer("grid", segmentByGrid));
    return methods;
}

//! Those with one of the names, or else whose name begins with it. All, if there are no names.
static std::vector<Method> chooseMethods(const std::vector<Method>& methods, const std::vector<String>& names)
{
    std::vector<Method> chosen;
    for (const Method& method : methods)
    {
        const auto matches = [&](const String& name)
        {
            const auto is_it = [&](const Method& other) { return other.name == name; };
            return std::any_of(methods.begin(), methods.end(), is_it) ? is_it(method)
                                                                      : method.name.compare(0, name.size(), name) == 0;
        };
        if (names.empty() || std::any_of(names.begin(), names.end(), matches))
            chosen.push_back(method);
    }
    return chosen;
}

static void addTruth(const String& file, Example& example)
{
    Mat truth = imread(file, IMREAD_UNCHANGED);
    if (truth.size() != example.image.size() || truth.channels() != 1)
    {
        std::cerr << "Left out: " << file << " is no label map of the size of its image" << std::endl;
        return;
    }
    truth.convertTo(truth, CV_32S);
    example.truths.push_back(truth);
}

static Example readExample(const String& file, const String& truth_dir, const String& depth_dir)
{
    Example example;
    const size_t slash = file.find_last_of("/\\");
    example.id = file.substr(slash + 1, file.rfind('.') - slash - 1);
    const size_t suffix = example.id.rfind("_color");
    if (suffix != String::npos)
        example.id = example.id.substr(0, suffix);
    example.image = imread(file, IMREAD_COLOR);
    if (!depth_dir.empty())
        example.depth = imread(depth_dir + "/" + example.id + "_depth.png", IMREAD_UNCHANGED);

    const String truth = truth_dir + "/" + example.id;
    if (utils::fs::exists(truth + "_labels.png"))
        addTruth(truth + "_labels.png", example);
    for (int i = 0; utils::fs::exists(truth + format("-%d.png", i)); i++)
        addTruth(truth + format("-%d.png", i), example);
    return example;
}

static std::vector<Example> readExamples(const String& image_dir, const String& truth_dir, const String& depth_dir,
                                         size_t limit)
{
    std::vector<String> files, more;
    utils::fs::glob(image_dir, "*.jpg", files);
    utils::fs::glob(image_dir, "*.png", more);
    for (size_t i = 0; i < more.size(); i++)
        if (more[i].rfind("_depth.png") == String::npos && more[i].rfind("_labels.png") == String::npos)
            files.push_back(more[i]);
    std::sort(files.begin(), files.end());

    std::vector<Example> examples;
    for (size_t i = 0; i < files.size() && (limit == 0 || examples.size() < limit); i++)
    {
        const Example example = readExample(files[i], truth_dir, depth_dir);
        if (!depth_dir.empty() && example.depth.empty())
            std::cerr << "Left out: " << files[i] << " has no depth" << std::endl;
        else if (!example.image.empty() && !example.truths.empty())
            examples.push_back(example);
    }
    return examples;
}

//! Numbers of superpixels that all methods can make of all images: of three pixels in width or more, and of half of
//! the shorter side of an image or less. Some of the methods crash for other numbers.
static std::vector<int> readNumbers(const std::vector<String>& texts, const std::vector<Example>& examples)
{
    double fewest = 1, most = INT_MAX;
    for (size_t i = 0; i < examples.size(); i++)
    {
        const Size size = examples[i].image.size();
        const double shorter = std::min(size.width, size.height);
        fewest = std::max(fewest, std::ceil(4. * size.width * size.height / (shorter * shorter)));
        most = std::min(most, std::floor(size.width * double(size.height) / 9));
    }
    std::vector<int> numbers(texts.size());
    for (size_t i = 0; i < texts.size(); i++)
    {
        std::istringstream in(texts[i]);
        if (!(in >> numbers[i]) || !in.eof() || numbers[i] < fewest || numbers[i] > most)
            CV_Error_(Error::StsOutOfRange, ("numbers must be integers from %g to %g for these images, not %s", fewest,
                                             most, texts[i].c_str()));
    }
    return numbers;
}

static void writeRow(std::ostream& out, const String& method, int k, const String& image, const metrics::Scores& s)
{
    out << format("%s,%d,%s,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.8g,%.4g\n", method.c_str(), k, image.c_str(), s.recall,
                  s.ue, s.asa, s.ev, s.co, s.superpixels, s.components, s.milliseconds);
}

static void addScores(const metrics::Scores& s, double weight, metrics::Scores& sum)
{
    sum.recall += weight * s.recall;
    sum.ue += weight * s.ue;
    sum.asa += weight * s.asa;
    sum.ev += weight * s.ev;
    sum.co += weight * s.co;
    sum.superpixels += weight * s.superpixels;
    sum.components += weight * s.components;
    sum.milliseconds += weight * s.milliseconds;
}

//! Lines on the standard error while a long run goes on, one every few seconds.
class Progress
{
public:
    void show(const String& text)
    {
        const double SECONDS = 5;
        if ((getTickCount() - last_) / getTickFrequency() < SECONDS)
            return;
        std::cerr << text << std::endl;
        last_ = getTickCount();
    }

private:
    int64 last_ = getTickCount();
};

//! Runs a method on all images, writes a row for each and returns the mean.
static metrics::Scores runMethod(const Method& method, const String& name, bool with_depth, int k,
                                 const std::vector<Example>& examples, bool ignore_zero, std::ostream& out,
                                 Progress& progress)
{
    metrics::Scores mean;
    for (size_t i = 0; i < examples.size(); i++)
    {
        const Example& example = examples[i];
        TickMeter timer;
        timer.start();
        const Mat labels = method.segment(example.image, with_depth ? example.depth : Mat(), k);
        timer.stop();
        metrics::Scores scores = metrics::evaluate(labels, example.image, example.truths, ignore_zero);
        scores.milliseconds = timer.getTimeMilli();
        writeRow(out, name, k, example.id, scores);
        addScores(scores, 1. / examples.size(), mean);
        progress.show(name + format(", %d superpixels: image %d of %d", k, int(i) + 1, int(examples.size())));
    }
    writeRow(out, name, k, "mean", mean);
    return mean;
}

static int run(int argc, char** argv)
{
    CommandLineParser parser(argc, argv, KEYS);
    parser.about("Compares superpixels with ground truth and writes a table (CSV); gwatershed_plot.py draws it.");
    const String image_dir = parser.get<String>("images"), truth_dir = parser.get<String>("truth");
    const String depth_dir = parser.get<String>("depth"), output = parser.get<String>("output");
    const std::vector<String> texts = splitList(parser.get<String>("numbers"));
    const bool ignore_zero = parser.has("ignore_zero");
    const int limit = parser.get<int>("limit"), threads = parser.get<int>("threads");
    const float focal = parser.get<float>("focal");
    if (parser.has("help") || image_dir.empty() || truth_dir.empty() || !parser.check())
    {
        parser.printErrors();
        parser.printMessage();
        return parser.has("help") ? 0 : 2;
    }
    if (limit < 0)
        CV_Error_(Error::StsOutOfRange, ("limit must be 0 or more, not %d", limit));
    const std::vector<Example> examples = readExamples(image_dir, truth_dir, depth_dir, size_t(limit));
    const std::vector<Method> methods = chooseMethods(allMethods(focal), splitList(parser.get<String>("methods")));
    if (examples.empty() || methods.empty())
    {
        std::cerr << (examples.empty() ? "No image with ground truth in " + image_dir : "No method has such a name")
                  << std::endl;
        return 1;
    }
    const std::vector<int> numbers = readNumbers(texts, examples);
    std::ofstream out(output.c_str()); // now, so that wrong arguments leave the table of another run as it is
    out << "method,asked,image,recall,ue,asa,ev,co,superpixels,components,milliseconds" << std::endl;
    if (!out)
        CV_Error(Error::StsError, "cannot write " + output);
    setNumThreads(threads);
    std::cout << format("%-46s %6s %8s %8s %8s %8s %8s %8s %8s %9s\n", "method", "asked", "recall", "UE", "ASA", "EV",
                        "CO", "N", "pieces", "ms");
    Progress progress;
    for (size_t i = 0; i < methods.size(); i++)
        for (int with_depth = 0; with_depth <= (methods[i].takes_depth && !depth_dir.empty() ? 1 : 0); with_depth++)
            for (int k : numbers)
            {
                if (methods[i].merged_from > 0 && k >= methods[i].merged_from)
                    continue; // nothing to merge
                const String name = methods[i].name + (with_depth ? " with depth" : "");
                const metrics::Scores s = runMethod(methods[i], name, with_depth != 0, k, examples, ignore_zero, out,
                                                    progress);
                std::cout << format("%-46s %6d %8.4f %8.4f %8.4f %8.4f %8.4f %8.1f %8.1f %9.2f\n", name.c_str(), k,
                                    s.recall, s.ue, s.asa, s.ev, s.co, s.superpixels, s.components, s.milliseconds)
                          << std::flush;
            }
    out.flush();
    if (!out)
        CV_Error(Error::StsError, "cannot write " + output);
    return 0;
}

int main(int argc, char** argv)
{
    try
    {
        return run(argc, argv);
    }
    catch (const cv::Exception& e)
    {
        std::cerr << e.what() << std::endl;
        return 1;
    }
}
