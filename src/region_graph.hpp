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
        int length; //!< in pixel edges
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

    //! Adds edges between pixels with labels a != b to their common boundary.
    void addEdges(int a, int b, int count);

    const std::vector<Boundary>& boundaries(int region) const { return boundaries_[region]; }

    //! Moves the boundaries of a region to a neighbour, which takes it in.
    void unite(int from, int to);

    //! Whether a region has not been taken in by another.
    bool isLeft(int region) const { return parents_[region] == region; }

    //! New number of each region: those that are left are numbered from 0 in the old order, those
    //! that were taken in have the number of the region they are in now. Returns how many are left.
    int number(std::vector<int>& numbers) const;

private:
    static Boundary* find(std::vector<Boundary>& boundaries, int neighbor);
    void add(int region, const Boundary& boundary);
    void remove(int region, int neighbor);

    std::vector<std::vector<Boundary> > boundaries_;
    std::vector<int> parents_; // the region that took this one in, or itself
};

//! Replaces each label by its number.
void renumber(const std::vector<int>& numbers, Mat& labels);

}}} // namespace

#endif
