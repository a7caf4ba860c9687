// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/adjacency.hpp"
#include "results/region_graph.hpp"
#include "shared/alpha.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! A pixel for contrasts: 8-bit colour (all three equal in a grey image) and scaled depth, 0 if it is missing.
struct Pixel
{
    uchar b, g, r, depth;
};

//! Equations (1) to (3) of the paper, 0..255. alpha is in 1/256.
//! @note If the depth of p or q is missing, colour alone counts.
int distance(const Pixel& p, const Pixel& q, int alpha)
{
    const int color = std::max(std::max(std::abs(p.b - q.b), std::abs(p.g - q.g)), std::abs(p.r - q.r));
    if (p.depth == 0 || q.depth == 0)
        return color;
    return weighByAlpha(alpha, color, std::abs(p.depth - q.depth));
}

//! Contrast of neighbouring pixels: their distance, equations (1) to (3).
struct PixelContrast
{
    int operator()(Point p, Point q) const { return distance(at(p), at(q), alpha); }

    Pixel at(Point p) const
    {
        const int cn = color.channels();
        const uchar* value = color.ptr(p.y) + size_t(p.x) * cn;
        return { value[0], value[cn == 1 ? 0 : 1], value[cn == 1 ? 0 : 2],
                 depth.empty() ? uchar(0) : depth.at<uchar>(p) };
    }

    const Mat& color;
    const Mat& depth;
    const int alpha;
};

} // namespace

static bool comesFirst(const RegionGraph::Boundary& a, const RegionGraph::Boundary& b)
{
    return a.regions[0] < b.regions[0] || (a.regions[0] == b.regions[0] && a.regions[1] < b.regions[1]);
}

static void listPairs(const RegionGraph& graph, bool with_contrasts, Mat& pairs, Mat& lengths, Mat& contrasts)
{
    std::vector<RegionGraph::Boundary> sorted(graph.boundaries());
    const int count = int(sorted.size());
    for (int i = 0; i < count; i++)
        if (sorted[i].regions[1] < sorted[i].regions[0])
            std::swap(sorted[i].regions[0], sorted[i].regions[1]);
    std::sort(sorted.begin(), sorted.end(), comesFirst);

    pairs.create(count, 2, CV_32SC1);
    lengths.create(count, 1, CV_32SC1);
    contrasts.create(with_contrasts ? count : 0, 1, CV_32FC1);
    for (int i = 0; i < count; i++)
    {
        pairs.at<int>(i, 0) = sorted[i].regions[0];
        pairs.at<int>(i, 1) = sorted[i].regions[1];
        lengths.at<int>(i) = sorted[i].length;
        if (with_contrasts)
            contrasts.at<float>(i) = float(double(sorted[i].contrast) / sorted[i].length);
    }
}

void listAdjacency(const Mat& labels, int num_labels, const Mat& color, const Mat& depth, int alpha, Mat& pairs,
                   Mat& lengths, Mat& contrasts)
{
    CV_TRACE_FUNCTION();
    RegionGraph graph(num_labels);
    if (color.empty())
        addBoundaries(labels, NoContrast(), graph);
    else
    {
        const PixelContrast contrast = { color, depth, alpha };
        addBoundaries(labels, contrast, graph);
    }
    listPairs(graph, !color.empty(), pairs, lengths, contrasts);
}

}}} // namespace
