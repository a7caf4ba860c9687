// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"

#include <algorithm>
#include <functional>

#ifdef GWATERSHED_HAVE_XIMGPROC
#include "opencv2/ximgproc.hpp"
#endif

namespace opencv_test { namespace {

typedef std::function<void(const Pictures&)> Work;

struct Method
{
    String name;
    Work prepare; //!< what comes before, not timed
    Work run;
    std::function<int()> count; //!< superpixels of the last run; may be empty
};

typedef std::vector<Method> Methods;

void nothing(const Pictures&) {}

/** Methods take turns, each on another picture, so that each of them finds caches full of what the others left, as in
a program that does other things, too. The framework times the rounds. The median of each method, in milliseconds, and
the number of superpixels become properties of the case in the report (--gtest_output=xml), and scripts/perf.sh makes a
table of these. */
class Perf_Superpixels : public TestBaseWithParam<tuple<Size, int> >
{
protected:
    void takeTurns(const Methods& methods, Pictures& pictures)
    {
        for (const Method& method : methods)
            timeOnce(method, pictures); // it makes its buffers
        std::vector<std::vector<double> > samples(methods.size());
        declare.strategy(PERF_STRATEGY_BASE).iterations(countRounds(pictures.image().size())).time(600);
        for (size_t round = 0; next(); round++)
        {
            startTimer();
            for (size_t i = 0; i < methods.size(); i++)
            {
                pictures.choose(round + i);
                samples[i].push_back(timeOnce(methods[i], pictures));
            }
            stopTimer();
        }
        for (size_t i = 0; i < methods.size(); i++)
        {
            RecordProperty(methods[i].name, cv::format("%.4f", median(samples[i])));
            if (methods[i].count)
                RecordProperty(methods[i].name + "_superpixels", methods[i].count());
        }
        setVerified(); // times only: the tests of accuracy are elsewhere
    }

private:
    static unsigned countRounds(Size size) { return size.area() < 1000000 ? 25 : 10; }

    //! Milliseconds.
    static double timeOnce(const Method& method, const Pictures& pictures)
    {
        method.prepare(pictures);
        TickMeter meter;
        meter.start();
        method.run(pictures);
        meter.stop();
        return meter.getTimeMilli();
    }

    static double median(std::vector<double>& values)
    {
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        return values[values.size() / 2];
    }
};

Ptr<SuperpixelGWatershed> create(Size size, int num_superpixels, int algorithm)
{
    return createSuperpixelGWatershed(size.width, size.height, 3, num_superpixels, algorithm);
}

Method callOurs(const String& name, Size size, int region_size, int algorithm, int num_iterations)
{
    const Ptr<SuperpixelGWatershed> gws = create(size, countSuperpixels(size, region_size), algorithm);
    return { name, nothing, [=](const Pictures& p) { gws->iterate(p.image(), num_iterations); },
             [=]() { return gws->getNumberOfSuperpixels(); } };
}

Method callOursWithDepth(const String& name, Size size, int region_size)
{
    const Ptr<SuperpixelGWatershed> gws = create(size, countSuperpixels(size, region_size), RGWATERSHED);
    return { name, nothing, [=](const Pictures& p) { gws->iterate(p.image(), p.depth()); }, {} };
}

//! These are timed with all settings and peers.
bool isCommon(int region_size)
{
    return region_size == 10 || region_size == 20;
}

void addOurs(Size size, int region_size, Methods& methods)
{
    methods.push_back(callOurs("RGWATERSHED", size, region_size, RGWATERSHED, 1));
    methods.push_back(callOurs("GWATERSHED", size, region_size, GWATERSHED, 1));
    if (!isCommon(region_size))
        return;
    methods.push_back(callOursWithDepth("RGWATERSHED_depth", size, region_size));
    methods.push_back(callOurs("RGWATERSHED_2_iterations", size, region_size, RGWATERSHED, 2));
    methods.push_back(callOurs("RGWATERSHED_4_iterations", size, region_size, RGWATERSHED, 4));
}

//! The flood alone.
void addWatershed(int region_size, Methods& methods)
{
    const Ptr<Mat> labels = makePtr<Mat>();
    methods.push_back({ "watershed", [=](const Pictures& p)
    {
        *labels = makeGridMarkers(p.image().size(), region_size);
    }, [=](const Pictures& p) { watershed(p.image(), *labels); }, {} });
}

#ifdef GWATERSHED_HAVE_XIMGPROC

// Where the documentation of a method asks for another colour space or a blur, these are counted.

Mat convertToLab(const Mat& image)
{
    Mat lab;
    cvtColor(image, lab, COLOR_BGR2Lab);
    return lab;
}

void addScanSegment(Size size, int region_size, Methods& methods)
{
    const Ptr<ScanSegment> scan = createScanSegment(size.width, size.height, countSuperpixels(size, region_size));
    methods.push_back({ "ScanSegment", nothing, [=](const Pictures& p) { scan->iterate(convertToLab(p.image())); },
                        [=]() { return scan->getNumberOfSuperpixels(); } }); // 0: it fails, and all labels are -1
}

void addSEEDS(Size size, int region_size, Methods& methods)
{
    const int LEVELS = 4;
    const Ptr<SuperpixelSEEDS> seeds =
            createSuperpixelSEEDS(size.width, size.height, 3, countSuperpixels(size, region_size), LEVELS);
    methods.push_back({ "SEEDS", nothing, [=](const Pictures& p) { seeds->iterate(convertToLab(p.image())); },
                        [=]() { return seeds->getNumberOfSuperpixels(); } });
}

void addSLIC(int region_size, Methods& methods)
{
    methods.push_back({ "SLIC", nothing, [=](const Pictures& p)
    {
        Mat blurred;
        GaussianBlur(p.image(), blurred, Size(3, 3), 0);
        const Ptr<SuperpixelSLIC> slic = createSuperpixelSLIC(convertToLab(blurred), SLIC, region_size, 10.f);
        slic->iterate(10);
        slic->enforceLabelConnectivity(25);
    }, {} });
}

#endif // GWATERSHED_HAVE_XIMGPROC

//! The slow ones, SLIC and SEEDS, are left out on the largest images, and for most region sizes on large ones.
void addPeers(Size size, int region_size, Methods& methods)
{
    addWatershed(region_size, methods);
#ifdef GWATERSHED_HAVE_XIMGPROC
    addScanSegment(size, region_size, methods);
    if (size == sz2160p || (size == sz1080p && !isCommon(region_size)))
        return;
    addSLIC(region_size, methods);
    if (region_size >= 10) // below, its four levels of blocks do not fit into a superpixel
        addSEEDS(size, region_size, methods);
#endif
}

PERF_TEST_P(Perf_Superpixels, take_turns, testing::Combine(testing::Values(szVGA, sz1080p, sz2160p),
                                                           testing::Values(3, 5, 10, 20, 40))) // region_size
{
    const Size size = get<0>(GetParam());
    const int region_size = get<1>(GetParam());
    if (size == sz2160p && region_size == 3)
        throw SkipTestException("it takes too long");
    Pictures pictures(size);
    Methods methods;
    addOurs(size, region_size, methods);
    addPeers(size, region_size, methods);
    takeTurns(methods, pictures);
}

//! The first call, which finds the order of merging, beside the segmentation before it.
PERF_TEST_P(Perf_Superpixels, merge_similar, testing::Combine(testing::Values(szVGA), testing::Values(1600)))
{
    const Size size = get<0>(GetParam());
    const int number = get<1>(GetParam());
    Pictures pictures(size);
    const Ptr<SuperpixelGWatershed> gws = create(size, number, RGWATERSHED);
    const Work iterate = [=](const Pictures& p) { gws->iterate(p.image()); };
    takeTurns({ { "RGWATERSHED", nothing, iterate, {} },
                { "mergeSimilar", iterate, [=](const Pictures&) { gws->mergeSimilar(number / 4); }, {} } }, pictures);
}

}} // namespace
