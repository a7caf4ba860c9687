// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_LABELS_HPP
#define OPENCV_GWATERSHED_REGION_LABELS_HPP

#include "rgwatershed/block_grid.hpp"
#include "shared/padded.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Labels of RGWATERSHED while it works: regions are 0..n-1.
enum RegionLabel
{
    UNSEEN = -1,       //!< not reached by any region
    OUTSIDE = INT_MIN  //!< around the image, or outside of the mask
};

//! Labels of blocks of 2x2 or 3x3 pixels to some rows of the pixels.
void spreadLabels(const Padded<int>& blocks, const BlockGrid& grid, const Range& rows, Padded<int>& labels);

//! The same for an image of a size.
void spreadLabels(const Padded<int>& blocks, const BlockGrid& grid, Size size, Padded<int>& labels);

//! All pixels become UNSEEN, those outside of the mask OUTSIDE if it is not empty.
void clearLabels(Size size, const Mat& mask, Padded<int>& labels);

//! Pixels outside of the mask lose their label, and those inside that have none become UNSEEN.
void fitToMask(const Mat& mask, Padded<int>& labels);

//! Each connected component of UNSEEN pixels becomes a region of its own. Returns the new number of
//! regions.
int labelUnseen(int num_regions, Padded<int>& labels);

}}} // namespace

#endif
