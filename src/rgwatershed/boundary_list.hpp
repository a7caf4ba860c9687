// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BOUNDARY_LIST_HPP
#define OPENCV_GWATERSHED_BOUNDARY_LIST_HPP

#include "rgwatershed/neighbor_masks.hpp"

namespace cv { namespace ximgproc { namespace gws {

// An image is divided into quads of 2x2 pixels, each of which has one pixel of each of the four classes: class
// 2 * (y % 2) + x % 2. No two pixels of one class are neighbours.

enum { NUM_CLASSES = 4 };

//! The pixels that a sweep looks at in some rows of quads, by class and row.
class BoundaryList
{
public:
    //! Pixels by their index.
    struct Part
    {
        const int* pixels;
        int count;
    };

    //! Empties it. Rows from this one on will be added, with so many quads in all at most.
    void begin(int first_row, size_t most_quads);

    //! Adds some pixels of the next row of quads. first is the index of the upper left pixel in it, step the offset to
    //! the next row of pixels. find(x, in_upper, in_lower) tells which of the AT_ONCE pixels from column x on in
    //! the upper and in the lower row these are: 1 or 0.
    template <typename Find> void addRow(int cols, int first, int step, const Find& find);
    enum { AT_ONCE = 16 };

    Part part(int c, const Range& rows) const
    {
        const int first = ends_[c][rows.start - first_row_], last = ends_[c][rows.end - first_row_];
        return { pixels_[c].data() + first, last - first };
    }

private:
    enum { ROOM = 8 }; // so many are written at once

    int first_row_;
    std::vector<int> pixels_[NUM_CLASSES]; // with room at the end
    std::vector<int> ends_[NUM_CLASSES];   // of the rows; the first is 0
};

// Each of these adds some rows of quads to a list.

//! All pixels beside another label, also those that cannot leave before others have moved.
void listBoundary(const Padded<uchar>& masks, const Range& rows, BoundaryList& list);

//! Those of them that have marks. The marks are taken away.
void listMarked(const Padded<uchar>& masks, const Range& rows, Padded<uchar>& marks, BoundaryList& list);

}}} // namespace

#endif
