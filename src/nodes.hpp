// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_NODES_HPP
#define OPENCV_GWATERSHED_NODES_HPP

#include "padded.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! A pixel as the flood sees it: 8-bit colour (a gray value thrice) and scaled depth, 0 if missing.
struct Pixel
{
    uchar b, g, r, depth;
};

//! Equations (1) to (3) of the paper, 0..255. alpha is in 1/256.
//! @note Where either depth is missing, colour alone counts.
inline int distance(const Pixel& p, const Pixel& q, int alpha)
{
    const int color = std::max(std::max(std::abs(p.b - q.b), std::abs(p.g - q.g)), std::abs(p.r - q.r));
    if (p.depth == 0 || q.depth == 0)
        return color;
    return (alpha * color + (256 - alpha) * std::abs(p.depth - q.depth) + 128) >> 8;
}

//! State of a node that has no label yet; labels are 1..N. The names and values are the paper's.
enum NodeState
{
    UNLABELLED = 0,
    LINE = -1,      //!< S_border: a watershed line
    IN_QUEUE = -2,  //!< S_inq
    FRAME = INT_MIN //!< around the image, and outside of the mask
};

//! State and pixel lie together, so that a visit touches one cache line for each row of three.
struct Node
{
    int state;
    Pixel pixel;
};

typedef Padded<Node> NodeMap;

//! All nodes UNLABELLED. color is 8-bit with 1, 3 or 4 channels, depth CV_8UC1 or empty.
CV_EXPORTS void makeNodes(const Mat& color, const Mat& depth, NodeMap& nodes);

//! Makes the nodes outside of a mask part of the frame.
void closeOutside(const Mat& mask, NodeMap& nodes);

}}} // namespace

#endif
