// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/mask_pyramid.hpp"
#include "rgwatershed/tuning.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Whether elements inside of two blocks touch. `from` is the first element of one along their border, `to` that of the
//! other one, and `step` leads to the second ones.
static bool touch(const uchar* from, const uchar* to, size_t step)
{
    return (from[0] & to[0]) || (from[step] & to[step]);
}

//! Blocks of 2x2 elements, of which one may be outside, as a small hole. Those inside are connected, and so are those
//! of blocks side by side: a block that does not touch the one before it, or above it, with them is left out.
//! An odd last row or column is repeated, as in the means of blocks.
static void halveMask(const Mat& mask, Mat& halved)
{
    Mat whole;
    copyMakeBorder(mask, whole, 0, mask.rows % 2, 0, mask.cols % 2, BORDER_REPLICATE | BORDER_ISOLATED);
    halved.create(whole.rows / 2, whole.cols / 2, CV_8UC1);
    const size_t next_row = whole.step;
    for (int y = 0; y < halved.rows; y++)
    {
        const uchar* from = whole.ptr(2 * y);
        uchar* to = halved.ptr(y);
        const uchar* above = halved.ptr(std::max(y - 1, 0));
        for (int x = 0; x < halved.cols; x++, from += 2)
        {
            const int inside = (from[0] & 1) + (from[1] & 1) + (from[next_row] & 1) + (from[next_row + 1] & 1);
            const bool apart = inside == 3 && ((x > 0 && to[x - 1] && !touch(from - 1, from, next_row)) ||
                                               (y > 0 && above[x] && !touch(from - next_row, from, 1)));
            to[x] = inside >= 3 && !apart ? 255 : 0;
        }
    }
}

//! Number of connected components of the pixels that hold no block.
int MaskPyramid::countLost(const Mat& components, const std::vector<Level>& levels, int top)
{
    const Mat& blocks = levels[top].mask;
    std::vector<bool> kept(levels[0].components, false);
    for (int y = 0; y < blocks.rows; y++)
        for (int x = 0; x < blocks.cols; x++)
        {
            if (!blocks.at<uchar>(y, x))
                continue;
            Point p(x, y); // down to a pixel of the block: if its first element is outside, the second one is not
            for (int i = top; i > 0; i--)
                p = Point(2 * p.x + !levels[i - 1].mask.at<uchar>(2 * p), 2 * p.y);
            kept[components.at<int>(p) - 1] = true;
        }
    return int(std::count(kept.begin(), kept.end(), false));
}

void MaskPyramid::build(const Mat& mask)
{
    CV_TRACE_FUNCTION();
    if (!levels_.empty() && levels_[0].mask.data == mask.data && levels_[0].mask.size() == mask.size())
        return; // it is the mask of the last image
    std::vector<Level> levels(MAX_LEVEL + 1);
    Mat components, components_of_pixels;
    for (int i = 0; i <= MAX_LEVEL; i++)
    {
        Level& level = levels[i];
        if (i == 0)
            level.mask = mask;
        else
            halveMask(levels[i - 1].mask, level.mask);
        level.blocks = countNonZero(level.mask);
        level.components = connectedComponents(level.mask, components, 4, CV_32S) - 1;
        if (i == 0)
            swap(components, components_of_pixels);
        level.lost = i == 0 ? 0 : countLost(components_of_pixels, levels, i);
    }
    levels_.swap(levels); // at the end, so that an exception before leaves the old ones
}

}}} // namespace
