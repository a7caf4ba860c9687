// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Prints a hash of all results of the module for each of 200 generated cases. scripts/sameness.sh compares the
// tables of many builds and settings.

#include "images.hpp"

#include <opencv2/core/parallel/backend/parallel_for.openmp.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/gwatershed.hpp>

#include <cstdio>

using namespace cv;
using namespace cv::ximgproc;

static const uint64 TIES[] = { 904, 3656, 4832 };
static const int NUM_TIES = 3, NUM_ROUNDINGS = 4, NUM_CASES = 200;

//! The hash FNV-1a of 64 bits.
class Hash
{
public:
    void add(const Mat& matrix)
    {
        const int header[] = { matrix.rows, matrix.cols, matrix.type() };
        addBytes(reinterpret_cast<const uchar*>(header), sizeof(header));
        for (int y = 0; y < matrix.rows; y++)
            addBytes(matrix.ptr(y), matrix.cols * matrix.elemSize());
    }
    unsigned long long value() const { return value_; }

private:
    void addBytes(const uchar* bytes, size_t count)
    {
        for (size_t i = 0; i < count; i++)
            value_ = (value_ ^ bytes[i]) * 0x100000001b3;
    }

    uint64 value_ = 0xcbf29ce484222325;
};

//! All that can be asked of a segmentation.
static void addResults(const SuperpixelGWatershed& gws, const Mat& image, const Mat& depth, Hash& hash)
{
    Mat out[12];
    gws.getLabels(out[0]);
    gws.getLabelContourMask(out[1], true);
    gws.getLabelContourMask(out[2], false);
    gws.getWatershedLineMask(out[3]);
    gws.getStatistics(image, depth, out[4], out[5], out[6], out[7]);
    gws.getAdjacency(image, depth, out[8], out[9], out[10]);
    out[11] = Mat(1, 1, CV_32SC1, Scalar(gws.getNumberOfSuperpixels()));
    for (int i = 0; i < 12; i++)
        hash.add(out[i]);
}

//! The two algorithms alternate from case to case. All other settings are random.
static Ptr<SuperpixelGWatershed> makeObject(int number, Size size, Numbers& numbers)
{
    const float rulers[] = { 0, 0.3f, 1, 5, 10, 10, 20, 40 }, alphas[] = { 0, 0.25f, 0.3f, 0.5f, 0.5f, 0.7f, 1 };
    const float thresholds[] = { 0, 40, 77.5f, 150, 150, 400 };
    const int asked = 1 + numbers.below(std::max(1, size.area() / (4 + numbers.below(400))));
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(
            size.width, size.height, 3, asked, number % 2 ? GWATERSHED : RGWATERSHED, numbers.from(rulers));
    if (numbers.below(2))
        gws->setRegionSize(2 + numbers.below(30));
    if (numbers.below(3) == 0)
        gws->setEffort(numbers.below(4));
    gws->setAlpha(numbers.from(alphas));
    gws->setBorderThreshold(numbers.from(thresholds));
    gws->setLabInput(numbers.below(4) == 0);
    gws->setTemporal(numbers.below(3) == 0);
    if (numbers.below(3) == 0)
        gws->setDepthRange(0.7f, 3000);
    if (numbers.below(3) == 0)
        gws->setMask(makeMask(size, numbers));
    if (numbers.below(5) == 0)
        gws->setMarkers(makeMarkers(size, numbers));
    return gws;
}

//! An image where a pixel lies half way between the means of two superpixels, so that the last bit of a product of
//! doubles made labels differ from processor to processor. Seeds of those are found by trying.
static unsigned long long hashTie(uint64 seed)
{
    const Scene scene = { FEW_COLORS, Size(131, 97), seed, 0 };
    const Mat image = makeImage(scene, 0, CV_8UC3);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, 1411);
    gws->iterate(image, 8);
    Hash hash;
    addResults(*gws, image, Mat(), hash);
    return hash.value();
}

//! Rulers for which a product plus a number is an integer and a half, or not, if the product is not rounded first.
//! Depth has a gap, and is taken as it is.
static unsigned long long hashRounding(int number)
{
    const float rulers[] = { 10.0833349f, 2.49999976f, 10.0833349f, 2.49999976f };
    const Scene scene = { SCENE, Size(239, 181), uint64(number), 0 };
    const Mat image = makeImage(scene, 0, CV_8UC3);
    Mat depth(image.size(), CV_16UC1);
    for (int y = 0; y < depth.rows; y++)
        for (int x = 0; x < depth.cols; x++)
            depth.at<ushort>(y, x) = ushort(x < 80 ? 419 + y : 53000 + (x + y) * 8);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(image.cols, image.rows, 3, 300);
    gws->setRuler(rulers[number]);
    gws->setNormalWeight(0);
    gws->iterate(image, number < 2 ? Mat() : depth);
    Hash hash;
    addResults(*gws, image, depth, hash);
    return hash.value();
}

static unsigned long long hashCase(int number)
{
    const Size sizes[] = { Size(1, 1), Size(300, 1), Size(1, 170), Size(2, 2), Size(17, 13), Size(64, 48),
                           Size(131, 97), Size(131, 97), Size(98, 150), Size(160, 120), Size(160, 120),
                           Size(239, 181), Size(61, 401), Size(333, 222) };
    const int types[] = { CV_8U, CV_8U, CV_16U, CV_16U, CV_16S, CV_32F }, channels[] = { 1, 3, 3, 4 };
    const int depths[] = { CV_8U, CV_8U, CV_16U, CV_32F };
    Numbers numbers(number);
    const Size size = numbers.from(sizes);
    const ImageKind kind = ImageKind(numbers.below(2) ? SCENE : numbers.below(IMAGE_KINDS));
    const Scene scene = { kind, size, uint64(1000 + number), numbers.below(5) };
    const int type = CV_MAKETYPE(numbers.from(types), numbers.from(channels)), depth_type = numbers.from(depths);
    const bool with_depth = numbers.below(2) == 0, merges = numbers.below(2) == 0;
    const int iterations = 1 + numbers.below(4);
    Ptr<SuperpixelGWatershed> gws = makeObject(number, size, numbers);
    if (CV_MAT_DEPTH(type) == CV_16U && numbers.below(2))
        gws->setValueRange(777.7f, 60000);

    Hash hash;
    const int frames = gws->getTemporal() ? 5 : 1;
    for (int frame = 0; frame < frames; frame++)
    {
        const Mat image = makeImage(scene, frame, type);
        const Mat depth = with_depth ? makeDepth(scene, frame, depth_type) : Mat();
        if (with_depth)
            gws->iterate(image, depth, iterations);
        else
            gws->iterate(image, iterations);
        addResults(*gws, image, depth, hash);
        if (!merges)
            continue;
        gws->mergeSimilar(1 + gws->getNumberOfSuperpixels() / 2);
        addResults(*gws, image, depth, hash);
        gws->enforceLabelConnectivity(60);
        gws->mergeSimilar(5);
        addResults(*gws, image, depth, hash);
    }
    return hash.value();
}

int main(int argc, char** argv)
{
    const CommandLineParser parser(argc, argv,
        "{threads | 1     | number of threads }"
        "{openmp  | false | run loops under OpenMP instead of what OpenCV was built with }"
        "{plain   | false | without the optimized code of OpenCV }");
    if (parser.get<bool>("openmp"))
        parallel::setParallelForBackend(std::make_shared<parallel::openmp::ParallelForBackend>());
    setNumThreads(parser.get<int>("threads"));
    setUseOptimized(!parser.get<bool>("plain"));
    for (int i = 0; i < NUM_CASES; i++)
        std::printf("%d %016llx\n", i, i < NUM_TIES ? hashTie(TIES[i])
                    : i < NUM_TIES + NUM_ROUNDINGS ? hashRounding(i - NUM_TIES) : hashCase(i));
    return 0;
}
