// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/contours.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Marks the elements of a that differ from those of b and, if both is true, those of b. Beside pixels outside of a
//! mask there is no contour, as at the border of the image.
static void markDifferences(const int* a, const int* b, int n, uchar* mask_a, uchar* mask_b, bool both)
{
    for (int i = 0; i < n; i++)
    {
        const uchar contour = a[i] != b[i] && (a[i] | b[i]) >= 0 ? 255 : 0;
        mask_a[i] |= contour;
        if (both)
            mask_b[i] |= contour;
    }
}

void drawContours(const Mat& labels, bool thick_line, Mat& mask)
{
    CV_TRACE_FUNCTION();
    const int rows = labels.rows, cols = labels.cols;
    forRows(Range(0, rows), [&](int y)
    {
        const int* row = labels.ptr<int>(y);
        const int* below = labels.ptr<int>(std::min(y + 1, rows - 1));
        const int* above = labels.ptr<int>(std::max(y - 1, 0));
        uchar* to = mask.ptr(y);
        std::fill_n(to, cols, uchar(0));
        markDifferences(row, row + 1, cols - 1, to, to + 1, thick_line);
        markDifferences(row, below, cols, to, to, false);
        if (thick_line)
            markDifferences(row, above, cols, to, to, false);
    });
}

}}} // namespace
