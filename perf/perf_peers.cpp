// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"
#include "gwatershed/gradient_map.hpp"
#include "shared/grid_markers.hpp"

#ifdef GWATERSHED_HAVE_XIMGPROC
#include "opencv2/ximgproc.hpp"
#endif

namespace opencv_test { namespace {

// The same job on the same pictures, done by others: about one superpixel for 20x20 pixels. Where
// their documentation asks for another colour space or a blur, these are counted.

typedef PicturesTest<Size> Perf_GWatershed_peer;

PERF_TEST_P(Perf_GWatershed_peer, watershed, GWATERSHED_PERF_SIZES)
{
    Pictures pictures(GetParam());
    Mat gradient, labels;
    std::vector<Point> markers;
    timeOver(pictures, [&]()
    {
        gws::computeGradientMap(pictures.image(), Mat(), 256, gradient);
        gws::placeGridMarkers(gradient, perfNumSuperpixels(GetParam()), markers);
        labels = Mat::zeros(GetParam(), CV_32SC1);
        for (size_t i = 0; i < markers.size(); i++)
            labels.at<int>(markers[i]) = int(i) + 1;
    }, [&]() { watershed(pictures.image(), labels); });
}

#ifdef GWATERSHED_HAVE_XIMGPROC

#define SIZES_OF_SLOW_PEERS testing::Values(szVGA, sz720p, sz1080p)

static Mat blurredLab(const Mat& image)
{
    Mat lab;
    GaussianBlur(image, lab, Size(3, 3), 0);
    cvtColor(lab, lab, COLOR_BGR2Lab);
    return lab;
}

static void segmentBySLIC(const Mat& image, int algorithm)
{
    Ptr<SuperpixelSLIC> slic = createSuperpixelSLIC(blurredLab(image), algorithm, PERF_REGION_SIZE, 10.f);
    slic->iterate(10);
    slic->enforceLabelConnectivity(25);
}

PERF_TEST_P(Perf_GWatershed_peer, SLIC, SIZES_OF_SLOW_PEERS)
{
    Pictures pictures(GetParam());
    timeOver(pictures, [&]() { segmentBySLIC(pictures.image(), SLIC); });
}

PERF_TEST_P(Perf_GWatershed_peer, SLICO, SIZES_OF_SLOW_PEERS)
{
    Pictures pictures(GetParam());
    timeOver(pictures, [&]() { segmentBySLIC(pictures.image(), SLICO); });
}

PERF_TEST_P(Perf_GWatershed_peer, SEEDS, SIZES_OF_SLOW_PEERS)
{
    Pictures pictures(GetParam());
    Ptr<SuperpixelSEEDS> seeds = createSuperpixelSEEDS(GetParam().width, GetParam().height, 3,
                                                       perfNumSuperpixels(GetParam()), 4);
    timeOver(pictures, [&]()
    {
        Mat lab;
        cvtColor(pictures.image(), lab, COLOR_BGR2Lab);
        seeds->iterate(lab);
    });
}

PERF_TEST_P(Perf_GWatershed_peer, LSC, testing::Values(szVGA))
{
    Pictures pictures(GetParam());
    timeOver(pictures, [&]()
    {
        Ptr<SuperpixelLSC> lsc = createSuperpixelLSC(blurredLab(pictures.image()), PERF_REGION_SIZE);
        lsc->iterate(10);
        lsc->enforceLabelConnectivity(25);
    });
}

PERF_TEST_P(Perf_GWatershed_peer, ScanSegment, GWATERSHED_PERF_SIZES)
{
    Pictures pictures(GetParam());
    Ptr<ScanSegment> scan = createScanSegment(GetParam().width, GetParam().height, perfNumSuperpixels(GetParam()));
    timeOver(pictures, [&]()
    {
        Mat lab;
        cvtColor(pictures.image(), lab, COLOR_BGR2Lab);
        scan->iterate(lab);
    });
}

#endif // GWATERSHED_HAVE_XIMGPROC

}} // namespace
