// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_GRAPH_HPP
#define OPENCV_GWATERSHED_REGION_GRAPH_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The regions of a label map and which of them touch; regions can be united.
class RegionGraph
{
public:
    //! The boundary between a region and one of its neighbours.
    struct Boundary
    {
        int neighbor;
        int length;   //!< in pixel edges
        int64 height; //!< sum over them
    };

    explicit RegionGraph(int num_regions) : boundaries_(num_regions), parents_(num_regions)
    {
        const int USUAL_NEIGHBORS = 8;
        for (int i = 0; i < num_regions; i++)
        {
            boundaries_[i].reserve(USUAL_NEIGHBORS);
            parents_[i] = i;
        }
    }

    //! Adds edges between pixels with labels a != b, and the sum of their heights, to the boundary.
    void addEdges(int a, int b, int count, int64 height);

    const std::vector<Boundary>& boundaries(int region) const { return boundaries_[region]; }

    //! Moves the boundaries of a region to a neighbour, which takes it in.
    void unite(int from, int to);

    //! The region that took a region in, or the region itself where it is left.
    const std::vector<int>& parents() const { return parents_; }

private:
    static Boundary* find(std::vector<Boundary>& boundaries, int neighbor);
    void add(int region, const Boundary& boundary);
    void remove(int region, int neighbor);

    std::vector<std::vector<Boundary> > boundaries_;
    std::vector<int> parents_;
};

//! New number of each region: those that are left, which are their own parents, are numbered from 0
//! in the old order; the others have the number of the region they are in now. Returns how many are left.
int numberRegions(const std::vector<int>& parents, std::vector<int>& numbers);

//! Replaces each label by its number; what is below 0 stays.
void renumber(const std::vector<int>& numbers, Mat& labels);

//! For graphs that need no heights.
struct NoHeight
{
    int operator()(Point, Point) const { return 0; }
};

//! Adds all boundaries of a label map; labels below 0 have none. height(p, q) is that of an edge.
//! Edges side by side between the same regions are added at once.
template <typename Height>
void addBoundaries(const Mat& labels, const Height& height, RegionGraph& graph)
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
                sum += height(Point(x, y), Point(x, y + 1));
                if (last || right != label || below[x + 1] != below[x])
                {
                    graph.addEdges(label, below[x], length, sum);
                    length = 0;
                    sum = 0;
                }
            }
            if (label != right && (label | right) >= 0)
                graph.addEdges(label, right, 1, height(Point(x, y), Point(x + 1, y)));
        }
    }
}

}}} // namespace

#endif
