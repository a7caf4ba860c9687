// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BOUNDARY_LIST_HPP
#define OPENCV_GWATERSHED_BOUNDARY_LIST_HPP

#include "rgwatershed/neighbor_masks.hpp"
#include "shared/regions.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! A pixel that may leave its region, and the mask of its neighbours in that.
struct BoundaryPixel
{
    int index, mask;
};

//! A pixel that goes from a region to another one.
struct Move
{
    int index, from, to;
};

//! The boundary in some rows of an image.
struct BoundaryList
{
    std::vector<BoundaryPixel> pixels;

    // Buffers, of a row:
    std::vector<int> masks, columns;
    std::vector<BoundaryPixel> found;
};

//! Rows of a band; bands have the same height for any number of threads, so that the result is the same.
enum { SWEEP_BAND_HEIGHT = 16 };

//! Adds the pixels of some rows that may leave their regions, in raster order, to a list.
void listBoundary(const Padded<int>& labels, const Range& rows, BoundaryList& list);

//! The same, in the order of the blocks, for labels that are those of blocks of 2x2 pixels. The first row is even.
void listBoundaryOfBlocks(const Padded<int>& blocks, const Padded<int>& labels, const Range& rows, BoundaryList& list);

//! Those of them that touch one of the pixels that moved in the sweep before; rows are those of a band.
//! moves are those of that sweep by bands, marks a buffer for the elements of labels.
void listBoundaryAroundMoves(const Padded<int>& labels, const Range& rows, const std::vector<std::vector<Move> >& moves,
                             std::vector<uchar>& marks, BoundaryList& list);

//! Takes the pixels of markers from the list, so that a sweep does not move them.
void keepMarkers(const Mat& markers, const Padded<int>& labels, BoundaryList& list);

}}} // namespace

#endif
