// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_GRAPH_HPP
#define OPENCV_GWATERSHED_MERGE_GRAPH_HPP

#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! What two regions have in common. Small, because merging reads all edges in each round.
struct MergeEdge
{
    int a, b;       //!< the regions, a < b
    int length;     //!< in pixel edges
    int cost;       //!< of their union, once it is known
    int64 contrast; //!< sum of the distances of the pixels on its two sides, in 1/16 of a level
};

//! Some edges. Behind them is room, which stays.
struct EdgeList
{
    std::vector<MergeEdge> edges;
    size_t count = 0;

    void reserve(size_t room)
    {
        if (edges.size() < room)
            edges.resize(room + room / 4);
    }
    //! Adds an edge that is not in this list.
    void add(const MergeEdge& edge)
    {
        reserve(count + 1);
        edges[count++] = edge;
    }
};

//! Some edges that lie one after the other, all for one list of a graph.
struct EdgeSpan
{
    int list;
    const MergeEdge* first;
    size_t count;
};

//! The edges that were found in some rows, and what finds them.
class EdgeBuilder
{
public:
    //! Forgets all edges. Rows have up to so many pixels. If joins_rows, there are few edges between the same regions,
    //! else one or more for each row, which takes less time where boundaries are short.
    void start(int cols, bool joins_rows);

    //! Adds the edges between the pixels of a row and those beside them in another one, or in the same one shifted.
    void add(const int* row, const int* other, const Feature* features, const Feature* other_features, int cols,
             const RegionDistance& distance);

    //! Gives the edges away.
    void moveTo(EdgeList& to) { std::swap(edges_, to); }

private:
    enum { LATEST_BITS = 10, NUM_BEHIND = 4 };

    template <bool WITH_DEPTH>
    void measureContrasts(const Feature* features, const Feature* others, int count, const RegionDistance& distance);
    void addRow(const int* row, const int* other, int count);
    void joinRow(const int* row, const int* other, int count);

    bool joins_rows_ = false;
    EdgeList edges_;
    std::vector<int> positions_, contrasts_; // in a row, with room behind them
    std::vector<int> latest_; // for each pair of labels, but shared by many: where an edge between them may be
};

//! The regions of a label map and the edges between them, while regions are united. Regions lie in bands of consecutive
//! numbers. Edges inside of a band are in its list, the few between two bands in one more list, the last one. Bands
//! depend on nothing but the numbers, so that they can be worked on at the same time; and each fits into a cache.
class MergeGraph
{
public:
    int numBands() const { return int(known_.size()) - 1; }
    Range band(int k) const { return Range(k << band_shift_, std::min((k + 1) << band_shift_, num_regions_)); }

    //! The edges of a list, each between two regions that no other one is between.
    EdgeList& edges(int k) { return known_[k]; }

    //! The graph of a CV_32SC1 label map; labels below 0 have no edges.
    void build(const Mat& labels, int num_regions, const Padded<Feature>& features, const RegionDistance& distance);

    //! Gives the edges the regions that took theirs in, in one step. Those of regions that changed are set aside until
    //! they are joined.
    void relabel(const std::vector<int>& parents, const std::vector<uchar>& changed);

    //! Adds the edges that were set aside, or found in the label map, to the others of a list, one for each two
    //! regions. Returns where they begin.
    size_t join(int k, std::vector<int>& table);

    //! Calls body(k, table) for all bands, at the same time if that pays. A table is for calls one after the other.
    template <typename Body> void forBands(const Body& body) { forAll(numBands(), body); }
    //! The same for all lists of edges.
    template <typename Body> void forLists(const Body& body) { forAll(numBands() + 1, body); }

    //! Calls body(edge) for the edges of all lists, one after the other.
    template <typename Body> void forEdges(const Body& body) const
    {
        for (const EdgeList& list : known_)
            std::for_each(list.edges.begin(), list.edges.begin() + ptrdiff_t(list.count), body);
    }

private:
    enum { FEW_EDGES = 6000 }; // of less, most of the time is that until threads have what others wrote

    int listOf(int a, int b) const { return (a ^ b) >> band_shift_ ? numBands() : a >> band_shift_; }
    void setRegions(int num_regions);
    void divide(const EdgeList& edges, std::vector<EdgeSpan>& spans) const;
    size_t countUnjoined(int k) const;
    void relabel(int k, const int* parents, const uchar* changed);
    void findLeaving(int k);
    void handOver();
    template <typename Body> void forAll(int count, const Body& body);

    int num_regions_ = 0, band_shift_ = 0;
    std::vector<EdgeList> known_, fresh_, leaving_; // of each list: fresh are set aside, leaving go to another list
    std::vector<EdgeList> rows_;                    // edges as they were found in some rows of the label map
    std::vector<std::vector<EdgeSpan> > spans_;     // the same
    std::vector<std::vector<EdgeSpan> > found_;     // those of each list, until they are joined
    std::vector<EdgeBuilder> builders_;
    std::vector<std::vector<int> > tables_;
};

template <typename Body> void MergeGraph::forAll(int count, const Body& body)
{
    size_t num_edges = 0;
    for (int k = 0; k <= numBands(); k++)
        num_edges += known_[k].count + countUnjoined(k);
    tables_.resize(known_.size());
    const auto work = [&](const Range& range)
    {
        for (int k = range.start; k < range.end; k++)
            body(k, tables_[range.start]);
    };
    if (num_edges < FEW_EDGES)
        work(Range(0, count));
    else
        parallel_for_(Range(0, count), work);
}

}}} // namespace

#endif
