// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_GRAPH_HPP
#define OPENCV_GWATERSHED_MERGE_GRAPH_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What two regions have in common. 16 bytes, because merging reads all edges in each round.
struct MergeEdge
{
    int a, b;   //!< the regions, a < b
    int length; //!< in pixel edges
    int cost;   //!< of their union, once it is known
};

//! Some edges, and beside them the sums of their contrasts, if they are asked for. Behind them is room, which stays.
struct EdgeList
{
    std::vector<MergeEdge> edges;
    std::vector<int64> contrasts;
    size_t count = 0;

    void reserve(size_t room, bool with_contrasts)
    {
        if (edges.size() < room)
            edges.resize(room + room / 4);
        if (with_contrasts && contrasts.size() < room)
            contrasts.resize(room + room / 4);
    }
    //! Adds edges first..last-1 of another list.
    void append(const EdgeList& from, size_t first, size_t last, bool with_contrasts)
    {
        reserve(count + last - first, with_contrasts);
        std::copy(from.edges.data() + first, from.edges.data() + last, edges.data() + count);
        if (with_contrasts)
            std::copy(from.contrasts.data() + first, from.contrasts.data() + last, contrasts.data() + count);
        count += last - first;
    }
    void move(size_t from, size_t to, bool with_contrasts)
    {
        edges[to] = edges[from];
        if (with_contrasts)
            contrasts[to] = contrasts[from];
    }
};

//! Writes to `positions`, in order, where two rows differ; it has room for cols + 3. Returns how many these are.
int listDifferences(const int* row, const int* other, int cols, int* positions);

//! For graphs without contrasts.
struct WithoutContrast
{
    enum { COUNTS = 0 };
    int operator()(Point, Point) const { return 0; }
};

//! Some rows of a label map, and the edges in them, in raster order: of two regions there may be several.
struct EdgeRows
{
    //! Edges first..last-1, all of one list of the graph.
    struct Segment
    {
        int list;
        size_t first, last;
    };

    EdgeList pieces;
    std::vector<int> positions;
    std::vector<Segment> segments;
};

//! The regions of a label map and the edges between them, while regions are united. Regions lie in bands of consecutive
//! numbers. Edges inside of a band are in its list, the few between two bands in one more list. Bands depend on nothing
//! but the numbers, so that they can be worked on at the same time; and each fits into a cache.
class MergeGraph
{
public:
    enum { BAND_SHIFT = 11, BAND = 1 << BAND_SHIFT }; //!< regions in a band

    int numBands() const { return int(known_.size()) - 1; }
    Range band(int k) const { return Range(k * BAND, std::min((k + 1) * BAND, num_regions_)); }

    bool withContrasts() const { return with_contrasts_; }

    //! The edges of a band, or for numBands() those between bands. Those of known cost.
    EdgeList& known(int k) { return known_[k]; }
    //! The others. Two regions may have several of them, until they are joined.
    EdgeList& fresh(int k) { return fresh_[k]; }

    //! The graph of a CV_32SC1 label map; labels below 0 have no edges. contrast(p, q) is that of neighbouring pixels.
    template <typename Contrast> void build(const Mat& labels, int num_regions, const Contrast& contrast);

    //! Gives the edges the regions that took theirs in, in one step. Those of regions that changed become fresh.
    //! There must be no fresh ones before.
    void relabel(const std::vector<int>& parents, const std::vector<uchar>& changed);

    //! Makes one edge of the fresh ones between the same regions.
    void join(int k, std::vector<int>& table);

    //! The costs of the fresh ones are known now.
    void settle(int k);

    //! Calls body(k, table) for all bands, at the same time if that pays. A table is for calls one after the other.
    template <typename Body> void forBands(const Body& body);

private:
    int listOf(int a, int b) const { return (a ^ b) >> BAND_SHIFT ? numBands() : a >> BAND_SHIFT; }
    void setRegions(int num_regions, bool with_contrasts);
    void findSegments(EdgeRows& rows) const;
    void collect();
    template <bool CONTRAST> void relabel(int k, const int* parents, const uchar* changed);
    template <bool CONTRAST> static void join(EdgeList& list, std::vector<int>& table);
    void findLeaving(int k);
    void handOver();

    int num_regions_ = 0;
    bool with_contrasts_ = false;
    std::vector<EdgeList> known_, fresh_, leaving_; // leaving: of each list, those that go to another one
    std::vector<EdgeRows> rows_;
    std::vector<std::vector<int> > tables_;
};

template <typename Body> void MergeGraph::forBands(const Body& body)
{
    const size_t FEW = 8192; // edges
    size_t num_edges = 0;
    for (int k = 0; k < numBands(); k++)
        num_edges += known_[k].count + fresh_[k].count;
    tables_.resize(numBands() + 1);
    const auto work = [&](const Range& range)
    {
        for (int k = range.start; k < range.end; k++)
            body(k, tables_[range.start]);
    };
    if (num_edges < FEW)
        work(Range(0, numBands()));
    else
        parallel_for_(Range(0, numBands()), work);
}

//! Adds an edge without branches: what is none, or not complete, is written over by the next.
inline void addEdge(int label, int neighbor, int length, int64 contrast, bool complete, bool with_contrast,
                    EdgeList& to)
{
    const MergeEdge edge = { std::min(label, neighbor), std::max(label, neighbor), length, 0 };
    to.edges[to.count] = edge;
    if (with_contrast)
        to.contrasts[to.count] = contrast;
    to.count += complete & (edge.a >= 0);
}

//! Edges between the pixels of a row.
template <typename Contrast>
void listEdgesRight(const Mat& labels, int y, const Contrast& contrast, int* positions, EdgeList& to)
{
    const int* row = labels.ptr<int>(y);
    const int count = listDifferences(row, row + 1, labels.cols - 1, positions);
    for (int i = 0; i < count; i++)
    {
        const int x = positions[i];
        addEdge(row[x], row[x + 1], 1, contrast(Point(x, y), Point(x + 1, y)), true, Contrast::COUNTS, to);
    }
}

//! Edges between a row and the one below. Those side by side between the same regions are one.
template <typename Contrast>
void listEdgesBelow(const Mat& labels, int y, const Contrast& contrast, int* positions, EdgeList& to)
{
    const int *row = labels.ptr<int>(y), *below = labels.ptr<int>(y + 1);
    const int count = listDifferences(row, below, labels.cols, positions);
    positions[count] = 0;
    int length = 0;
    int64 sum = 0;
    for (int i = 0; i < count; i++)
    {
        const int x = positions[i], next = positions[i + 1];
        const bool ends = (next != x + 1) | (row[next] != row[x]) | (below[next] != below[x]);
        length++;
        sum += contrast(Point(x, y), Point(x, y + 1));
        addEdge(row[x], below[x], length, sum, ends, Contrast::COUNTS, to);
        length = ends ? 0 : length;
        sum = ends ? 0 : sum;
    }
}

template <typename Contrast>
void listEdges(const Mat& labels, const Range& range, const Contrast& contrast, EdgeRows& rows)
{
    rows.positions.resize(labels.cols + 4);
    rows.pieces.count = 0;
    for (int y = range.start; y < range.end; y++)
    {
        rows.pieces.reserve(rows.pieces.count + 2 * labels.cols + 1, Contrast::COUNTS);
        listEdgesRight(labels, y, contrast, rows.positions.data(), rows.pieces);
        if (y + 1 < labels.rows)
            listEdgesBelow(labels, y, contrast, rows.positions.data(), rows.pieces);
    }
}

template <typename Contrast> void MergeGraph::build(const Mat& labels, int num_regions, const Contrast& contrast)
{
    CV_TRACE_FUNCTION();
    const int LOWEST = 16, MOST = 32; // chunks of rows do not depend on the number of threads
    const int height = std::max(LOWEST, (labels.rows + MOST - 1) / MOST);
    setRegions(num_regions, Contrast::COUNTS);
    rows_.resize((labels.rows + height - 1) / height);
    parallel_for_(Range(0, int(rows_.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; k++)
        {
            listEdges(labels, Range(k * height, std::min((k + 1) * height, labels.rows)), contrast, rows_[k]);
            findSegments(rows_[k]);
        }
    });
    collect();
}

}}} // namespace

#endif
