// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Measures memory, times images of extreme shape, segments very large images, lets memory run out, and segments a
// stream of changing frames for a while. For Linux. scripts/scale.sh builds and runs it. The last line is "N passed, N
// failed".

#include "images.hpp"

#include <opencv2/core/utility.hpp>
#include <opencv2/gwatershed.hpp>

#include <cstdio>
#include <ctime>
#include <fstream>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>

using namespace cv;
using namespace cv::ximgproc;

static const int ALGORITHMS[] = { RGWATERSHED, GWATERSHED };

static const char* nameOf(int algorithm)
{
    return algorithm == GWATERSHED ? "GWATERSHED" : "RGWATERSHED";
}

static int passed = 0, failed = 0;

static void check(bool holds, const String& what)
{
    std::printf("  %s  %s\n", holds ? "ok    " : "FAILED", what.c_str());
    std::fflush(stdout);
    (holds ? passed : failed)++;
}

//! A field of /proc/self/status in bytes.
static double readStatus(const std::string& field)
{
    std::ifstream status("/proc/self/status");
    std::string name;
    double kilobytes = 0;
    while (status >> name && name != field + ":")
        status.ignore(1000, '\n');
    status >> kilobytes;
    return 1024 * kilobytes;
}

//! Memory in use, without what the C library keeps for later.
static double residentMemory()
{
    malloc_trim(0);
    return readStatus("VmRSS");
}

//! Resets the peak of memory, VmHWM.
static void forgetPeak()
{
    std::ofstream("/proc/self/clear_refs") << 5;
}

//! A large image of copies of a small one.
static Mat tile(const Mat& small, Size size)
{
    Mat large(size, small.type());
    for (int y = 0; y < size.height; y += small.rows)
        for (int x = 0; x < size.width; x += small.cols)
        {
            const Rect part = Rect(Point(x, y), small.size()) & Rect(Point(), size);
            small(Rect(Point(), part.size())).copyTo(large(part));
        }
    return large;
}

static const Scene SCENE_OF_TILES = { SCENE, Size(1000, 700), 1, 0 };

//! Number of 4-connected pieces of equal label.
static int countPieces(const Mat& labels)
{
    std::vector<int> parents; // of the runs of equal label in rows
    std::vector<int> above(labels.cols), here(labels.cols);
    int pieces = 0;
    const auto root = [&](int run)
    {
        while (parents[run] != run)
            run = parents[run] = parents[parents[run]];
        return run;
    };
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        const int* before = y > 0 ? labels.ptr<int>(y - 1) : 0;
        for (int x = 0; x < labels.cols; x++)
        {
            if (x > 0 && row[x] == row[x - 1])
                here[x] = here[x - 1];
            else
            {
                here[x] = int(parents.size());
                parents.push_back(here[x]);
                pieces++;
            }
            if (!before || before[x] != row[x])
                continue;
            const int a = root(above[x]), b = root(here[x]);
            pieces -= a != b;
            parents[b] = a;
        }
        above.swap(here);
    }
    return pieces;
}

//! Sum of the areas by getStatistics(), and the smallest of them.
static Vec2d measureAreas(const SuperpixelGWatershed& gws)
{
    Mat stats, centroids;
    gws.getStatistics(noArray(), noArray(), stats, centroids);
    double smallest = 0;
    minMaxLoc(stats.col(4), &smallest, 0);
    return Vec2d(sum(stats.col(4))[0], smallest);
}

static void measureMemory(int side, int region_size)
{
    std::printf("memory at %d x %d, superpixels of %d x %d, in bytes per pixel, 4 of them the labels\n", side, side,
                region_size, region_size);
    const Size size(side, side);
    for (int i = 0; i < 4; i++)
    {
        const int algorithm = ALGORITHMS[i / 2];
        const Mat image = tile(makeImage(SCENE_OF_TILES, 0, CV_8UC3), size);
        const Mat depth = i % 2 ? tile(makeDepth(SCENE_OF_TILES, 0, CV_16UC1), size) : Mat();
        const double before = residentMemory();
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(side, side, 3, 1, algorithm);
        gws->setRegionSize(region_size);
        forgetPeak();
        if (depth.empty())
            gws->iterate(image);
        else
            gws->iterate(image, depth);
        const double peak = readStatus("VmHWM") - before, kept = residentMemory() - before;
        gws->mergeSimilar(gws->getNumberOfSuperpixels() / 2);
        const double merged = residentMemory() - before, pixels = double(image.total());
        gws.release();
        const double left = residentMemory() - before;
        std::printf("  %-11s %-6s  peak %5.1f  kept %5.1f  after mergeSimilar() %5.1f\n", nameOf(algorithm),
                    i % 2 ? "RGB-D" : "colour", peak / pixels, kept / pixels, merged / pixels);
        check(left < 0.1 * pixels, "all of it is given back");
    }
}

static void segmentLargest(int side)
{
    std::printf("%d x %d\n", side, side);
    for (int i = 0; i < 2; i++)
    {
        const Mat image = tile(makeImage(SCENE_OF_TILES, 0, CV_8UC1), Size(side, side));
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(side, side, 1, 1000000, ALGORITHMS[i]);
        forgetPeak();
        const clock_t start = clock();
        gws->iterate(image);
        const double seconds = double(clock() - start) / CLOCKS_PER_SEC;
        std::printf("  %s: %.1f s, %.1f GB at the peak\n", nameOf(ALGORITHMS[i]), seconds, readStatus("VmHWM") / 1e9);
        const Vec2d areas = measureAreas(*gws);
        check(gws->getNumberOfSuperpixels() == 1000000 && areas[1] >= 1, "1000000 superpixels, none empty");
        check(areas[0] == double(image.total()), "every pixel has a label");
        Mat labels;
        gws->getLabels(labels);
        gws->clear();
        check(countPieces(labels) == 1000000, "each superpixel is one piece");
    }
}

//! The largest image. A mask leaves only its last corner inside.
static void segmentCorner()
{
    const int side = 46338;
    const Size size(side, side), corner(600, 400);
    const Rect part(Point(side, side) - Point(corner), corner);
    std::printf("%d x %d, all but a corner outside of the mask\n", side, side);
    const int flags = MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE; // takes memory where it is written to only
    void* const zeros = mmap(0, size_t(side) * side, PROT_READ | PROT_WRITE, flags, -1, 0);
    Mat image(size, CV_8UC1, zeros);
    makeImage(SCENE_OF_TILES, 0, CV_8UC1)(Rect(Point(), corner)).copyTo(image(part));
    for (int i = 0; i < 2; i++)
    {
        Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(1, 1, 1, 600, ALGORITHMS[i]);
        fresh->iterate(image(part));
        Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(1, 1, 1, 600, ALGORITHMS[i]);
        {
            Mat mask = Mat::zeros(size, CV_8UC1);
            mask(part).setTo(Scalar(1));
            gws->setMask(mask);
        }
        forgetPeak();
        gws->iterate(image);
        std::printf("  %s: %.1f GB at the peak\n", nameOf(ALGORITHMS[i]), readStatus("VmHWM") / 1e9);
        Mat expected_stats, stats, expected_centroids, centroids;
        fresh->getStatistics(noArray(), noArray(), expected_stats, expected_centroids);
        gws->getStatistics(noArray(), noArray(), stats, centroids);
        stats.col(0) -= part.x;
        stats.col(1) -= part.y;
        check(gws->getNumberOfSuperpixels() == 600 && countNonZero(stats != expected_stats) == 0,
              "the superpixels of the corner are those that it has as an image");
    }
    munmap(zeros, size_t(side) * side);
}

//! The address space may grow by `bytes` only while it lives.
class MemoryLimit
{
public:
    explicit MemoryLimit(double bytes)
    {
        getrlimit(RLIMIT_AS, &before_);
        rlimit now = before_;
        now.rlim_cur = rlim_t(readStatus("VmSize") + bytes);
        setrlimit(RLIMIT_AS, &now);
    }
    ~MemoryLimit() { setrlimit(RLIMIT_AS, &before_); }

private:
    rlimit before_;
};

static void runOutOfMemory()
{
    const Size size(1500, 1000);
    const Mat image = tile(makeImage(SCENE_OF_TILES, 0, CV_8UC3), size);
    const Mat depth = tile(makeDepth(SCENE_OF_TILES, 0, CV_16UC1), size);
    const Rect part(0, 0, 300, 200);
    for (int i = 0; i < 2; i++)
    {
        Ptr<SuperpixelGWatershed> fresh = createSuperpixelGWatershed(1, 1, 3, 500, ALGORITHMS[i]);
        fresh->iterate(image(part), depth(part), 2);
        Mat expected, labels;
        fresh->getLabels(expected);
        int refused = 0, other = 0, unusable = 0;
        for (int step = 0; step <= 100; step++)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(1, 1, 3, 500, ALGORITHMS[i]);
            malloc_trim(0);
            try
            {
                MemoryLimit memory(step * 5e5);
                gws->iterate(image, depth, 2);
            }
            catch (const cv::Exception& e)
            {
                (e.code == Error::StsNoMem ? refused : other)++;
            }
            gws->iterate(image(part), depth(part), 2);
            gws->getLabels(labels);
            unusable += countNonZero(labels != expected) > 0;
        }
        check(refused > 0 && refused < 101 && other == 0 && unusable == 0,
              format("%s, memory for 0 to 50 MB more: %d of 101 images refused, and the next one is as ever",
                     nameOf(ALGORITHMS[i]), refused));
    }
}

//! Processor time of a call in seconds.
template <typename Call>
static double timeOf(const Call& call)
{
    const clock_t start = clock();
    call();
    return double(clock() - start) / CLOCKS_PER_SEC;
}

static Mat makeNoise(Size size)
{
    const Scene noise = { NOISE, size, 1, 0 };
    return makeImage(noise, 0, CV_8UC3);
}

//! A strip takes about as long as a square of its area, whatever the number of superpixels.
static void timeStrips()
{
    const Size sizes[] = { Size(70000, 1), Size(1, 70000), Size(70000, 2), Size(3, 40000), Size(300000, 1) };
    for (int i = 0; i < 10; i++)
    {
        const Size size = sizes[i / 2];
        const int side = cvRound(std::sqrt(double(size.area())));
        const Mat strip = makeNoise(size), square = makeNoise(Size(side, side));
        double of_strip = 0, of_square = 0;
        for (int region_size = 1; region_size <= 70000; region_size = region_size * 7 + 1)
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(strip, ALGORITHMS[i % 2], region_size);
            of_strip += timeOf([&] { gws->iterate(); });
            gws->setDesiredSuperpixels(gws->getNumberOfSuperpixels());
            of_square += timeOf([&] { gws->iterate(square); });
        }
        check(of_strip < 20 * of_square, // rows have a price, too
              format("%s, %d x %d in linear time: %.1f times that of a square", nameOf(ALGORITHMS[i % 2]), size.width,
                     size.height, of_strip / of_square));
    }
}

//! Tables and merging of superpixels of one pixel, without and with another one that lies between all of them.
static void timeNeighbours()
{
    const int SIDE = 320;
    const Mat image = makeNoise(Size(2 * SIDE, 2 * SIDE));
    for (int i = 0; i < 2; i++)
    {
        double seconds[2];
        for (int between = 0; between < 2; between++)
        {
            Mat markers(image.size(), CV_32SC1, Scalar(between)), pairs, lengths;
            for (int k = 0; k < SIDE * SIDE; k++)
                markers.at<int>(2 * (k / SIDE) + 1, 2 * (k % SIDE) + 1) = k + 2;
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, ALGORITHMS[i]);
            gws->setMarkers(markers);
            gws->iterate();
            seconds[between] = timeOf([&] {
                gws->getAdjacency(noArray(), noArray(), pairs, lengths);
                gws->mergeSimilar(1);
                gws->iterate();
                gws->enforceLabelConnectivity(100);
            });
        }
        check(seconds[1] < 5 * seconds[0],
              format("%s, a superpixel with %d neighbours: %.1f times the time without it", nameOf(ALGORITHMS[i]),
                     SIDE * SIDE, seconds[1] / seconds[0]));
    }
}

//! Where pixels were flooded instead of blocks, more effort would take eight times as long.
static void timeEffort()
{
    const Mat image = makeImage(SCENE_OF_TILES, 0, CV_8UC3);
    for (int effort = 2; effort <= 3; effort++)
    {
        double shortest[] = { DBL_MAX, DBL_MAX };
        for (int call = 0; call < 10; call++) // in turns, so that both are disturbed alike
        {
            Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image, RGWATERSHED, call % 2 ? 8 : 12);
            gws->setEffort(effort);
            shortest[call % 2] = std::min(shortest[call % 2], timeOf([&] { gws->iterate(); }));
        }
        check(shortest[1] < 5 * shortest[0],
              format("effort %d, superpixels of 8x8 pixels: %.1f times the time of 12x12", effort,
                     shortest[1] / shortest[0]));
    }
}

struct StreamFrame
{
    Mat image, depth, mask, markers;
};

//! One frame of the stream, and all calls for it.
static void segmentFrame(const StreamFrame& frame, int region_size, Numbers& numbers, SuperpixelGWatershed& gws)
{
    gws.setRegionSize(region_size);
    gws.setRuler(float(numbers.below(30)));
    gws.setTemporal(numbers.below(2) == 0);
    gws.setMask(numbers.below(4) == 0 ? frame.mask : Mat());
    gws.setMarkers(numbers.below(6) == 0 ? frame.markers : Mat());
    const int repeats = 1 + numbers.below(3);
    for (int i = 0; i < repeats; i++)
    {
        if (numbers.below(2))
            gws.iterate(frame.image, frame.depth, 1 + numbers.below(3));
        else
            gws.iterate(frame.image, 1 + numbers.below(3));
    }
    Mat out[7];
    if (numbers.below(2))
        gws.mergeSimilar(1 + numbers.below(200));
    gws.enforceLabelConnectivity(numbers.below(101));
    gws.getLabels(out[0]);
    gws.getLabelContourMask(out[1]);
    gws.getStatistics(frame.image, frame.depth, out[2], out[3]);
    gws.getAdjacency(frame.image, frame.depth, out[4], out[5], out[6]);
}

static void soak(int num_frames)
{
    Numbers numbers(1);
    const int depths[] = { CV_8U, CV_16U, CV_32F };
    std::vector<StreamFrame> frames(48);
    for (size_t i = 0; i < frames.size(); i++)
    {
        const int width = 1 + numbers.below(640), height = 1 + numbers.below(480);
        const ImageKind kind = i % 3 ? SCENE : ImageKind(numbers.below(IMAGE_KINDS));
        const Scene scene = { kind, Size(width, height), uint64(i), 0 };
        frames[i].image = makeImage(scene, 0, CV_MAKETYPE(numbers.from(depths), i % 4 ? 3 : 1));
        frames[i].depth = makeDepth(scene, 0, numbers.from(depths));
        frames[i].mask = makeMask(scene.size, numbers);
        frames[i].markers = makeMarkers(scene.size, numbers);
    }
    Ptr<SuperpixelGWatershed> objects[2];
    for (int i = 0; i < 2; i++)
        objects[i] = createSuperpixelGWatershed(640, 480, 3, 100, ALGORITHMS[i]);

    std::printf("%d changing frames\n", num_frames);
    const int PARTS = 10, SMALLEST_REGION = 4;
    double kept[PARTS];
    int count = 0;
    const clock_t start = clock();
    for (size_t i = 0; i < 16 * frames.size(); i++) // what takes most memory comes first
        segmentFrame(frames[i / 16], SMALLEST_REGION, numbers, *objects[i % 2]);
    for (int part = 0; part < PARTS; part++)
    {
        for (; count < num_frames / PARTS * (part + 1); count++)
            segmentFrame(frames[numbers.below(int(frames.size()))], SMALLEST_REGION + numbers.below(30), numbers,
                         *objects[count % 2]);
        for (int i = 0; i < 2; i++) // the same each time, because what is kept depends on the size of the last frame
        {
            Numbers same(1);
            segmentFrame(frames[0], SMALLEST_REGION, same, *objects[i]);
        }
        kept[part] = residentMemory();
        std::printf("  %d frames, %.0f s: %.2f MB\n", count, double(clock() - start) / CLOCKS_PER_SEC,
                    kept[part] / 1e6);
        std::fflush(stdout);
    }
    check(kept[PARTS - 1] < 1.03 * kept[0], "memory is flat");
}

int main(int argc, char** argv)
{
    const CommandLineParser parser(argc, argv,
        "{side  | 20000 | side of the largest image; 20000 takes 11 GB }"
        "{soak  | 6000  | changing frames }");
    setNumThreads(1);
    mallopt(M_MMAP_THRESHOLD, 1 << 16); // else memory that was given back would still be in the address space
    runOutOfMemory();
    timeStrips();
    timeNeighbours();
    timeEffort();
    measureMemory(4000, 20);
    measureMemory(1000, 3);
    soak(parser.get<int>("soak"));
    segmentLargest(parser.get<int>("side"));
    segmentCorner();
    std::printf("%d passed, %d failed\n", passed, failed);
    return failed > 0;
}
