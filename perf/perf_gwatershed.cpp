// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "perf_common.hpp"

namespace opencv_test { namespace {

typedef PicturesTest<tuple<SuperpixelAlgorithm, Size, int> > Perf_GWatershed; // region_size last

//! scripts/profile.sh reads the times of the steps from a trace of this.
PERF_TEST_P(Perf_GWatershed, iterate, testing::Combine(SuperpixelAlgorithm::all(),
                                                       testing::Values(szVGA, sz720p, sz1080p, sz2160p),
                                                       testing::Values(5, 10, 20)))
{
    const Size size = get<1>(GetParam());
    Pictures pictures(size);
    Ptr<SuperpixelGWatershed> gws = createSuperpixelGWatershed(
            size.width, size.height, 3, countSuperpixels(size, get<2>(GetParam())), get<0>(GetParam()));
    timeOver(pictures, [&]() { gws->iterate(pictures.image()); });
}

}} // namespace
