// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "session.hpp"

#include <cstdio>
#include <cstdlib>

using namespace fuzz;

//! A session of random calls; what is random depends on its number alone.
static uint64 runSession(int number, int max_pixels)
{
    std::vector<uint8_t> bytes(600);
    RNG(uint64(number) + 1).fill(bytes, RNG::UNIFORM, cv::Scalar::all(0), cv::Scalar::all(256));
    return Session(bytes, max_pixels, 0).run();
}

//! Sessions in two threads at the same time, each with objects of its own.
static void runAtOnce(const std::vector<uint64>& expected, int max_pixels)
{
    cv::parallel_for_(cv::Range(0, 2), [&](const cv::Range& threads)
    {
        for (int first = threads.start; first < threads.end; first++)
            for (int i = first; i < int(expected.size()); i += 2)
                require(runSession(i, max_pixels) == expected[i], "objects can be used at the same time");
    });
}

//! The const methods of one object in two threads at the same time.
static void queryAtOnce(int max_pixels)
{
    const int side = cvFloor(std::sqrt(double(max_pixels)));
    for (int algorithm : { cv::ximgproc::GWATERSHED, cv::ximgproc::RGWATERSHED })
    {
        Mat image(side, side, CV_8UC3), depth(side, side, CV_16UC1);
        RNG().fill(image.reshape(1), RNG::UNIFORM, cv::Scalar::all(0), cv::Scalar::all(256));
        RNG().fill(depth, RNG::UNIFORM, cv::Scalar::all(0), cv::Scalar::all(5000));
        const Ptr<SuperpixelGWatershed> gws = cv::ximgproc::createSuperpixelGWatershed(image, depth, algorithm);
        gws->iterate();
        cv::parallel_for_(cv::Range(0, 2), [&](const cv::Range&)
        {
            checkStatistics(*gws, image, depth);
            checkAdjacency(*gws, image, depth);
            checkMasks(*gws, algorithm);
        });
    }
}

//! A run of more pixels than a sum of 32 bits holds.
static void segmentLongStrip()
{
    const Mat strip(1, 9000000, CV_8UC1, cv::Scalar(255));
    const Ptr<SuperpixelGWatershed> gws = cv::ximgproc::createSuperpixelGWatershed(strip.cols, 1, 1, 1);
    gws->iterate(strip, 2);
    require(gws->getNumberOfSuperpixels() == 1, "the number of superpixels is the one asked for");
}

//! Sessions with one thread and with several, without the fuzzer: stress [number of sessions [pixels of an image]].
int main(int argc, char** argv)
{
    const int count = argc > 1 ? std::atoi(argv[1]) : 200, max_pixels = argc > 2 ? std::atoi(argv[2]) : 64 * 64;
    const std::shared_ptr<Threads> threads = Threads::install();
    silenceErrors();
    std::vector<uint64> results;
    threads->use(1);
    for (int i = 0; i < count; i++)
        results.push_back(runSession(i, max_pixels));
    threads->use(3);
    for (int i = 0; i < count; i++)
        require(runSession(i, max_pixels) == results[i], "results do not depend on the number of threads");
    runAtOnce(results, max_pixels);
    queryAtOnce(max_pixels);
    if (max_pixels >= 64 * 64)
        segmentLongStrip();
    std::printf("%d sessions with 1 thread, 3 threads and at the same time\n", count);
}
