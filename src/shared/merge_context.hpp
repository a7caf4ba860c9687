// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_CONTEXT_HPP
#define OPENCV_GWATERSHED_MERGE_CONTEXT_HPP

#include "shared/merge_graph.hpp"
#include "shared/merge_region.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What is known of a region beside what it is itself.
struct MergeContext
{
    short color[3]; //!< that has spread to it from all around, as MergeRegion has it
    short texture;  //!< the same
};

//! Colours and textures that have spread from each region to its neighbours, the more the more these are like it, and
//! on from there, as in the diffusion of images by P. Perona and J. Malik (1990). So regions of one thing become alike,
//! and those of two things do not.
class MergeContexts
{
public:
    void clear() { means_.clear(); }
    bool empty() const { return means_.empty(); }
    //! Lets those of regions spread along the edges of their graph, which are joined.
    void spread(const std::vector<MergeRegion>& regions, const MergeGraph& graph);
    //! Adds those of a region to those of another one.
    void unite(int from, int to);
    //! Takes the means of some regions anew.
    void update(const std::vector<int>& numbers, const std::vector<MergeRegion>& regions);
    //! Of all regions, or null.
    const MergeContext* data() const { return empty() ? nullptr : means_.data(); }

private:
    void update(int number, const MergeRegion& region);

    std::vector<Vec4f> sums_;     // over the areas
    std::vector<MergeContext> means_;
};

}}} // namespace

#endif
