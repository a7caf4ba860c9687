// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_GRAPH_HPP
#define OPENCV_GWATERSHED_REGION_GRAPH_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The regions of a label map and the boundaries between them; regions can be united, which takes time in
//! proportion to the number of neighbours of the one that goes.
class RegionGraph
{
public:
    enum { NONE = -1 };

    //! What two regions have in common. It is in a list of each of them.
    struct Boundary
    {
        int regions[2];
        int next[2];    //!< in the lists of the regions
        int length;     //!< in pixel edges; 0: it is no more
        int64 contrast; //!< sum over them, as long as no regions are united

        bool exists() const { return length > 0; }
        //! Which of the two a region is.
        int side(int region) const { return regions[1] == region; }
    };

    //! Regions without boundaries.
    explicit RegionGraph(int num_regions);

    //! Adds edges between pixels of the regions a != b, and the sum of their contrasts.
    void add(int a, int b, int length, int64 contrast);

    //! All boundaries that were ever made.
    const std::vector<Boundary>& boundaries() const { return boundaries_; }

    //! First boundary of a region, or NONE, and the next one.
    int first(int region);
    int next(int region, int boundary);

    //! Moves the boundaries of a region to a neighbour, which takes it in.
    void unite(int from, int to);

    //! The region that took a region in, or the region itself where it is left.
    const std::vector<int>& parents() const { return parents_; }

private:
    int skipGone(int region, int& link);
    int find(int a, int b) const;
    void addToTable(int boundary);
    void fillSlot(int boundary);
    size_t slotOf(int a, int b) const;

    std::vector<Boundary> boundaries_;
    std::vector<int> table_; // of the boundaries by their regions, in the first free slot; 2^k of them
    size_t num_filled_ = 0;  // slots, also by what is no more or has other regions now
    std::vector<int> firsts_;
    std::vector<int> parents_;
};

//! For graphs that need no contrasts.
struct NoContrast
{
    int operator()(Point, Point) const { return 0; }
};

//! Adds all boundaries of a label map; labels below 0 have none. contrast(p, q) is that of an edge.
//! Edges side by side between the same regions are added at once.
template <typename Contrast>
void addBoundaries(const Mat& labels, const Contrast& contrast, RegionGraph& graph)
{
    for (int y = 0; y < labels.rows; y++)
    {
        const int* row = labels.ptr<int>(y);
        const int* below = labels.ptr<int>(std::min(y + 1, labels.rows - 1));
        int length = 0;
        int64 sum = 0;
        for (int x = 0; x < labels.cols; x++)
        {
            const bool last = x == labels.cols - 1;
            const int label = row[x], right = last ? -1 : row[x + 1];
            if (label != below[x] && (label | below[x]) >= 0)
            {
                length++;
                sum += contrast(Point(x, y), Point(x, y + 1));
                if (last || right != label || below[x + 1] != below[x])
                {
                    graph.add(label, below[x], length, sum);
                    length = 0;
                    sum = 0;
                }
            }
            if (label != right && (label | right) >= 0)
                graph.add(label, right, 1, contrast(Point(x, y), Point(x + 1, y)));
        }
    }
}

}}} // namespace

#endif
