// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/mask_pyramid.hpp"
#include "rgwatershed/tuning.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! An odd last row or column is repeated, as in the means of blocks.
static void halveMask(const Mat& mask, Mat& halved)
{
    halved.create((mask.rows + 1) / 2, (mask.cols + 1) / 2, CV_8UC1);
    for (int y = 0; y < halved.rows; y++)
    {
        const uchar* upper = mask.ptr(2 * y);
        const uchar* lower = mask.ptr(std::min(2 * y + 1, mask.rows - 1));
        uchar* to = halved.ptr(y);
        for (int x = 0; x < halved.cols; x++)
        {
            const int left = 2 * x, right = std::min(2 * x + 1, mask.cols - 1);
            to[x] = upper[left] & upper[right] & lower[left] & lower[right];
        }
    }
}

//! Number of connected components of the pixels that hold no block.
static int countLost(const Mat& components, int num_components, const Mat& blocks, int level)
{
    std::vector<bool> kept(num_components, false);
    for (int y = 0; y < blocks.rows; y++)
        for (int x = 0; x < blocks.cols; x++)
            if (blocks.at<uchar>(y, x))
                kept[components.at<int>(y << level, x << level) - 1] = true;
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
        level.lost = i == 0 ? 0 : countLost(components_of_pixels, levels[0].components, level.mask, i);
    }
    levels_.swap(levels); // at the end, so that an exception before leaves the old ones
}

}}} // namespace
