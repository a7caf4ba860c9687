// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "boundary.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Each neighbour of a pixel lies in its block or in one of the neighbours of that.
static uchar findMaskInBlock(int block_mask, int pixel)
{
    const int DX[8] = { -1, 0, 1, 1, 1, 0, -1, -1 }, DY[8] = { -1, -1, -1, 0, 1, 1, 1, 0 };
    const int x = pixel % 2, y = pixel / 2;
    int mask = 0;
    for (int k = 0; k < 8; k++)
    {
        const int block_x = (x + DX[k] + 2) / 2 - 1, block_y = (y + DY[k] + 2) / 2 - 1;
        bool same = block_x == 0 && block_y == 0;
        for (int j = 0; j < 8 && !same; j++)
            same = DX[j] == block_x && DY[j] == block_y && ((block_mask >> j) & 1);
        mask |= same << k;
    }
    return uchar(mask);
}

MaskTable::MaskTable()
{
    for (int mask = 0; mask < 256; mask++)
    {
        int pieces = 0;
        agreement_[mask] = first_[mask] = 0;
        while (mask > 0 && !((mask >> first_[mask]) & 1))
            first_[mask]++;
        for (int k = 0; k < 8; k++)
        {
            const bool here = (mask >> k) & 1, corner = (mask >> ((k + 7) & 7)) & 1;
            const bool before = (mask >> ((k + 6) & 7)) & 1;
            agreement_[mask] += here ? 1 + (k & 1) : 0;
            // A 4-neighbour begins a piece unless the one before it reaches it over the corner.
            pieces += (k & 1) && here && !(corner && before);
        }
        can_leave_[mask] = pieces == 1 && (mask & FOUR_NEIGHBORS) != FOUR_NEIGHBORS;
        for (int pixel = 0; pixel < 4; pixel++)
            in_block_[pixel][mask] = findMaskInBlock(mask, pixel);
    }
}

const MaskTable& maskTable()
{
    static const MaskTable table;
    return table;
}

//! The masks of a row of pixels with their own labels, in a loop that compilers vectorise.
static void findMasks(const int* row, int step, int n, int* masks)
{
    for (int x = 0; x < n; x++)
        masks[x] = neighborMask(row + x, step, row[x]);
}

//! @note The pixels at the border of the image are listed, too: the frame has another label.
void listBoundary(const Padded<int>& labels, std::vector<BoundaryPixel>& boundary)
{
    CV_TRACE_FUNCTION();
    const MaskTable& table = maskTable();
    const Size size = labels.size();
    const int step = labels.step();
    std::vector<int> masks(size.width);
    size_t count = 0;
    for (int y = 0; y < size.height; y++)
    {
        const int* row = labels.row(y);
        findMasks(row, step, size.width, masks.data());
        boundary.resize(count + size.width);
        for (int x = 0; x < size.width; x++) // without a branch that no one could foresee: the next one goes over it
        {
            const BoundaryPixel pixel = { labels.index(Point(x, y)), masks[x] };
            boundary[count] = pixel;
            count += table.canLeave(masks[x]) & (row[x] >= 0);
        }
    }
    boundary.resize(count);
}

void listBoundaryOfBlocks(const Padded<int>& blocks, const Padded<int>& labels, std::vector<BoundaryPixel>& boundary)
{
    CV_TRACE_FUNCTION();
    const int INTERIOR = 255;
    const MaskTable& table = maskTable();
    const Size size = labels.size();
    const int width = blocks.size().width;
    std::vector<int> masks(width);
    size_t count = 0;
    for (int y = 0; y < blocks.size().height; y++)
    {
        findMasks(blocks.row(y), blocks.step(), width, masks.data());
        boundary.resize(count + 4 * size_t(width));
        for (int x = 0; x < width; x++)
        {
            if (masks[x] == INTERIOR)
                continue;
            for (int k = 0; k < 4; k++) // as above
            {
                const Point p(2 * x + k % 2, 2 * y + k / 2);
                const BoundaryPixel pixel = { labels.index(p), table.maskInBlock(masks[x], k) };
                boundary[count] = pixel;
                count += table.canLeave(pixel.mask) & (p.x < size.width) & (p.y < size.height);
            }
        }
    }
    boundary.resize(count);
}

//! Marks of the listed pixels, for as long as the list is made: they are taken away even if memory runs out.
class ListMarks
{
public:
    ListMarks(std::vector<uchar>& marks, const std::vector<BoundaryPixel>& listed) : marks_(marks), listed_(listed) {}
    ~ListMarks()
    {
        for (size_t i = 0; i < listed_.size(); i++)
            marks_[listed_[i].index] = 0;
    }

private:
    std::vector<uchar>& marks_;
    const std::vector<BoundaryPixel>& listed_;
};

void listBoundaryAround(const std::vector<int>& pixels, const Padded<int>& labels, std::vector<uchar>& marks,
                        std::vector<BoundaryPixel>& boundary)
{
    CV_TRACE_FUNCTION();
    const MaskTable& table = maskTable();
    const int step = labels.step();
    const int* label = labels.data();
    marks.resize(size_t(step) * (labels.size().height + 2), 0);
    boundary.clear();
    const ListMarks marked(marks, boundary);
    for (size_t i = 0; i < pixels.size(); i++)
        for (int dy = -step; dy <= step; dy += step)
            for (int p = pixels[i] + dy - 1; p <= pixels[i] + dy + 1; p++)
            {
                if (marks[p] || label[p] == OUTSIDE)
                    continue;
                const BoundaryPixel pixel = { p, neighborMask(label + p, step, label[p]) };
                if (!table.canLeave(pixel.mask))
                    continue;
                boundary.push_back(pixel);
                marks[p] = 1;
            }
}

void keepMarkers(const Mat& markers, const Padded<int>& labels, std::vector<BoundaryPixel>& boundary)
{
    boundary.erase(std::remove_if(boundary.begin(), boundary.end(), [&](const BoundaryPixel& pixel)
    {
        return markers.at<int>(labels.point(pixel.index)) >= 0;
    }), boundary.end());
}

}}} // namespace
