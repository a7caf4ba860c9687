// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_STEPS_HPP
#define OPENCV_GWATERSHED_REGION_STEPS_HPP

#include "boundary.hpp"
#include "region.hpp"
#include "region_graph.hpp"
#include "steps.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! @file The steps of RGWATERSHED, in their order. Some are exported for the performance tests.

//! Opponent colours, or colours as they are, and depth, on the levels 0 (of pixels) to top. A level has the means of
//! blocks of 2x2 of the one before; an odd last row or column is repeated. (features.cpp)
//! color is 8-bit with 1, 3 or 4 channels, depth CV_8UC1 or empty.
CV_EXPORTS void makePyramid(const Mat& color, const Mat& depth, bool uniform_color, int top, Padded<Feature>* levels);

//! Gradient map of all colours and depth, weighted as in the distance, CV_16UC1. (features.cpp)
CV_EXPORTS void computeGradient(const Padded<Feature>& features, const RegionDistance& distance, Mat& gradient);

//! Buffers of a flood.
struct FloodBuffers
{
    enum { HEIGHTS = 1024 };

    struct Band
    {
        HeightQueues<Point, HEIGHTS> queues;
        std::vector<Point> batch;
    };
    std::vector<Band> bands;
    std::vector<Point> seeds;    // nodes that the flood begins with
    std::vector<Point> centers;  // that the ruler counts from
    std::vector<int> updates;    // area at which the means of a region are taken anew
    std::vector<ushort> heights; // at which a node waits
};

//! Floods the UNSEEN pixels from the markers, each band by itself; each marker grows a new region behind those that
//! are there. (region_flood.cpp)
//! ruler is the height, in 1/16 of a level, of one pixel of distance from the marker, times 256.
CV_EXPORTS void floodFromPoints(const Padded<Feature>& features, const std::vector<Point>& markers,
                     const std::vector<MarkerBand>& bands, const RegionDistance& distance, int ruler,
                     FloodBuffers& buffers, Padded<int>& labels, Regions& regions);

//! Floods the UNSEEN pixels from the regions that are there, by their means; what none of them reaches
//! stays UNSEEN. (region_flood.cpp)
void floodFromRegions(const Padded<Feature>& features, const RegionDistance& distance, FloodBuffers& buffers,
                      Padded<int>& labels, Regions& regions);

//! Buffers of merging.
struct MergeBuffers
{
    struct Entry
    {
        int boundary, next;
    };
    RegionGraph graph;
    std::vector<int> queued_at;   // cost of each boundary when it was queued last
    std::vector<Entry> entries;   // of the queues, one for each cost
    std::vector<int> first, last; // entries of each queue
};

//! Merges the most similar neighbours until num_regions are left. (merge_similar.cpp)
//! length_exponent, in 1/16, is how much a long common boundary counts.
CV_EXPORTS void mergeSimilarRegions(int num_regions, const RegionDistance& distance, int length_exponent,
                         MergeBuffers& buffers, Padded<int>& labels, Regions& regions);

//! Labels for the groups of regions that were merged. parents name the region that took each one in, areas are
//! from before, and names are the labels that they had: the first num_kept still have them, the others lie
//! where these were. A group keeps the label of the largest of the former, or else of the latter if it is free, or
//! else gets a free one. There are as many labels as groups. (follow.cpp)
void nameGroups(const std::vector<int>& parents, const std::vector<int>& areas, const std::vector<int>& names,
                int num_kept, std::vector<int>& labels);

//! Sum of the squared distances of the pixels of each region to its mean, in squared levels. (follow.cpp)
void measureErrors(const Padded<Feature>& features, const RegionDistance& distance, const Padded<int>& labels,
                   const Regions& regions, std::vector<int64>& errors);

//! Labels of blocks of 2x2 pixels to the pixels. (region_labels.cpp)
CV_EXPORTS void doubleLabels(const Padded<int>& labels, Size size, Padded<int>& doubled);

//! All pixels become UNSEEN, those outside of the mask OUTSIDE if it is not empty. (region_labels.cpp)
CV_EXPORTS void clearLabels(Size size, const Mat& mask, Padded<int>& labels);

//! The pixels inside of the mask that have no label become UNSEEN. (region_labels.cpp)
void openUnlabelled(const Mat& mask, Padded<int>& labels);

//! The UNSEEN pixels become OUTSIDE. (region_labels.cpp)
void closeUnseen(Padded<int>& labels);

//! Each connected component of UNSEEN pixels becomes a region of its own. Returns the new number of
//! regions. (region_labels.cpp)
int labelUnseen(int num_regions, Padded<int>& labels);

//! Regions measured anew; labels below 0 do not count. (region_labels.cpp)
void measureRegions(const Padded<Feature>& features, const Mat& labels, Regions& regions);

//! Keeps sweeps from making the superpixels worse as an approximation of the colours. (guard.cpp)
class VariationGuard
{
public:
    //! color is 8-bit with any number of channels; the first three count.
    VariationGuard(const Mat& color, const Padded<int>& labels, int num_regions);

    //! Whether a pixel is as near to the mean colour of the region `to` as to that of `from`, or nearer.
    bool permits(Point p, int from, int to) const;
    //! From here on it must be nearer.
    void forbidTies() { permits_ties_ = false; }
    void move(Point p, int from, int to);
    //! Takes the means anew.
    void update();

private:
    Vec3d colorAt(Point p) const;

    Mat color_;
    std::vector<Vec3d> sums_, means_;
    std::vector<int> areas_;
    bool permits_ties_ = true;
};

//! One pass over the boundary: the pixels that are listed go to the neighbouring region of the lowest energy, while
//! each region stays one piece. (refine.cpp)
//! length_price is the energy, in squared levels, of a quarter of a pixel edge of boundary.
//! guard may be 0.
CV_EXPORTS void sweepBoundary(const Padded<Feature>& features, const RegionDistance& distance, int length_price,
                   VariationGuard* guard, const ListBoundary& list, SweepBuffers& buffers, Padded<int>& labels,
                   Regions& regions);

}}} // namespace

#endif
