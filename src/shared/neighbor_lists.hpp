// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_NEIGHBOR_LISTS_HPP
#define OPENCV_GWATERSHED_NEIGHBOR_LISTS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! A neighbour of a region, and their common boundary.
struct Neighbor
{
    int region;
    int length; //!< in pixel edges
};

//! Some pixel edges side by side between two regions.
struct BoundaryPiece
{
    int regions[2];
    int length;
};

//! The boundaries in some rows of a label map, in raster order.
struct BoundaryBand
{
    std::vector<BoundaryPiece> pieces; //!< the first count, then room
    size_t count;
    int first;                         //!< lowest of their regions
    std::vector<int> positions;        //!< by region from the first on: how many entries, then where the next one goes
};

//! The neighbours of each region, one list after the other. Each boundary is in the lists of both of its regions, so
//! that all there is to know of a region lies in one place.
struct NeighborLists
{
    std::vector<int> starts, counts;  //!< of the list of each region
    std::vector<Neighbor> neighbors;
    std::vector<int64> contrasts;     //!< sums over the boundaries; empty if they are not asked for
};

//! The boundaries of a label map, without contrasts; labels below 0 have none. A neighbour may be in a list several
//! times. bands are buffers.
void listNeighbors(const Mat& labels, int num_regions, std::vector<BoundaryBand>& bands, NeighborLists& lists);

}}} // namespace

#endif
