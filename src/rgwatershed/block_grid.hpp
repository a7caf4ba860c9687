// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BLOCK_GRID_HPP
#define OPENCV_GWATERSHED_BLOCK_GRID_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! How the elements of a row, or of a column, are divided into blocks of a side. If the side does not divide their
//! number, one block is short: the one in the middle, so that a mirrored image has the mirrored blocks (nearly, if
//! the number of blocks is even), or the last one.
struct BlockAxis
{
    BlockAxis(int length, int side_, bool centered)
        : side(side_), count((length + side - 1) / side), missing(side * count - length),
          short_block(centered ? count / 2 : count - 1)
    {
    }

    //! The first element of a block.
    int start(int block) const { return side * block - (block > short_block ? missing : 0); }
    //! The block that an element is in.
    int blockOf(int element) const { return (element + (element < start(short_block + 1) ? 0 : missing)) / side; }

    int side, count;
    int missing;     //!< as many fewer elements has the short block
    int short_block;
};

//! The blocks of an image or of a level.
struct BlockGrid
{
    BlockGrid(Size size, int side_, bool centered)
        : side(side_), columns(size.width, side, centered), rows(size.height, side, centered)
    {
    }

    int side;
    BlockAxis columns, rows;
};

}}} // namespace

#endif
