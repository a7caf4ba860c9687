// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_STEPS_HPP
#define OPENCV_GWATERSHED_STEPS_HPP

#include "height_queues.hpp"
#include "mask.hpp"
#include "nodes.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! @file The steps of the method, in their order. They are exported for the performance tests.

//! The image in 8 bits: itself if it has 8, else converted into the buffer. (convert.cpp)
CV_EXPORTS Mat convertImage(const Mat& image, Mat& buffer);

//! Depth as CV_8UC1 in the buffer, 1..255, 0 where missing; empty if depth is empty or tells
//! nothing apart. Both limits 0: the range is taken from the frame. (convert.cpp)
CV_EXPORTS Mat scaleDepth(const Mat& depth, float near_depth, float far_depth, Mat& buffer);

//! Sobel magnitude of gray and depth, weighted by alpha in 1/256: CV_16UC1, 0..1443. (gradient.cpp)
CV_EXPORTS void computeGradient(const Mat& color, const Mat& depth, int alpha, Mat& gray, Mat& gradient);

//! One marker for each of num_markers cells of a grid, num_markers <= pixels. (markers.cpp)
CV_EXPORTS void placeMarkers(const Mat& gradient, int num_markers, std::vector<Point>& markers);

//! Some rows of an image, and the markers in them.
struct MarkerBand
{
    Range rows, markers;
};

//! Whole rows of cells of that grid, as few as are not lower than a height; all of them if they are. (markers.cpp)
CV_EXPORTS void divideIntoBands(Size size, int num_markers, int height, std::vector<MarkerBand>& bands);

//! Buffers for placing markers in regions.
struct MarkerBuffers
{
    Mat components;
    std::vector<Point> points;
    std::vector<int> starts;
};

//! The same inside of a mask: at least one marker in each of its connected components, and more than
//! num_markers if there are more components. num_markers <= pixels inside. (region_markers.cpp)
void placeMarkers(const Mat& gradient, const Mat& mask, int num_markers, MarkerBuffers& buffers,
                  std::vector<Point>& markers);

//! Moves each marker into the middle of the region that it had in the last frame, of which labels is the label
//! map; markers of regions that have all but vanished go to those that are too large. (follow_markers.cpp)
void followMarkers(const Mat& gradient, const Mat& labels, bool masked, MarkerBuffers& buffers,
                   std::vector<Point>& markers);

//! Numbers the positive values of a CV_32SC1 map of markers, inside of the mask if that is not empty, from
//! 0 in their order; all else becomes -1. Returns how many there are. (user_markers.cpp)
int numberMarkers(const Mat& markers, const Mat& mask, Mat& numbered);

//! Marker i, a point or the pixels that have the value i, gets the label i + 1. (nodes.cpp)
CV_EXPORTS void labelMarkers(const std::vector<Point>& markers, NodeMap& nodes);
void labelMarkers(const Mat& markers, NodeMap& nodes);

//! The 256 queues of Algorithm 1.
typedef HeightQueues<int, 256> NodeQueues;

//! Buffers of the flood.
struct PlainFloodBuffers
{
    NodeQueues queues;
    std::vector<int> batch;
};

//! Algorithm 1: floods from the nodes that have a label. Leaves LINE and UNLABELLED nodes. (flood.cpp)
//! A node whose gradient is not below border_threshold becomes a LINE, unless the threshold is 0.
CV_EXPORTS void floodFromMarkers(const Mat& gradient, float border_threshold, int alpha, NodeMap& nodes,
                                 PlainFloodBuffers& buffers);

//! Indices of nodes.
struct LineBuffers
{
    std::vector<int> lines; //!< all that the flood left without a label
    std::vector<int> round, later; // that are given one now, and next
    std::vector<int> chosen; // labels of a round
};

//! Gives every node without a label to a neighbour. (lines.cpp)
CV_EXPORTS void absorbLines(int alpha, NodeMap& map, LineBuffers& buffers);

//! CV_32SC1 labels 0..N-1, -1 where a node has none. (labels.cpp)
CV_EXPORTS void extractLabels(NodeMap& nodes, Mat& labels);

//! Area, bounding box and centroid of each superpixel, and its mean colour and depth where image and
//! depth are not empty; tables as SuperpixelGWatershed::getStatistics() has them. (statistics.cpp)
void measureSuperpixels(const Mat& labels, int num_labels, const Mat& image, const Mat& depth, Mat& stats,
                        Mat& centroids, Mat& mean_colors, Mat& mean_depths);

//! Pairs of superpixels that touch, the length of their boundary, and its mean height where color is not
//! empty; tables as SuperpixelGWatershed::getAdjacency() has them. (adjacency.cpp)
void listAdjacency(const Mat& labels, int num_labels, const Mat& color, const Mat& depth, int alpha, Mat& pairs,
                   Mat& lengths, Mat& heights);

//! Mask of the pixels beside another label. (labels.cpp)
void drawContours(const Mat& labels, bool thick_line, Mat& mask);

//! Merges regions below min_area, smallest first; returns the new number of labels. (merge_small.cpp)
int mergeSmallRegions(int num_labels, int min_area, Mat& labels);

}}} // namespace

#endif
