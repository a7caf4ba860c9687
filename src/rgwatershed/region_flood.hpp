// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_FLOOD_HPP
#define OPENCV_GWATERSHED_REGION_FLOOD_HPP

#include "rgwatershed/flood_region.hpp"
#include "shared/bucket_queue.hpp"
#include "shared/grid_markers.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Buffers of a flood.
struct FloodBuffers
{
    enum { PRIORITIES = 1024, MOST_GROUPS = 32 };
    typedef BucketQueue<PRIORITIES> Queue;

    //! What waits at the front of a flood.
    struct Front
    {
        Queue queues;
        std::vector<short> waiting;
    };
    std::vector<Front> fronts; // for groups of bands: those of a group are flooded one after the other
    std::vector<Point> seeds; // blocks that the flood begins with
    std::vector<FloodRegion> regions;
};

//! Floods the UNSEEN pixels from the markers, each band by itself; each marker grows a new region behind those that
//! are there: none, if there are several bands. middles are twice the places that the ruler counts from, or empty: then
//! it counts from the markers. ruler is the priority, in 1/16 of a level, of one pixel of distance from the marker,
//! times 256. Regions of more pixels than usual_area come last.
void floodFromPoints(const FeatureMap& features, const std::vector<Point>& markers, const std::vector<Point>& middles,
                     const std::vector<MarkerBand>& bands, const RegionDistance& distance, int ruler, int usual_area,
                     FloodBuffers& buffers, Padded<int>& labels, Regions& regions);

//! Floods the UNSEEN pixels from the regions that are there, by their means; what none of them reaches
//! stays UNSEEN. The ruler, 0 for none, counts from their centres.
void floodFromRegions(const FeatureMap& features, const RegionDistance& distance, int ruler, FloodBuffers& buffers,
                      Padded<int>& labels, Regions& regions);

}}} // namespace

#endif
