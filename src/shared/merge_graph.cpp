// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/merge_graph.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Writes to `positions`, in order, where two rows differ; it has room for cols + 3. Returns how many these are.
//! Without branches: each position is written, and the next one over it if there is no difference.
static int listDifferences(const int* row, const int* other, int cols, int* positions)
{
    int count = 0;
    for (int x = 0; x < cols; x++)
    {
        positions[count] = x;
        count += row[x] != other[x];
    }
    return count;
}

//! Adds an edge without branches: what is none, or not complete, is written over by the next.
static inline void addEdge(int label, int neighbor, int length, int64 contrast, bool complete, EdgeList& to)
{
    const MergeEdge edge = { std::min(label, neighbor), std::max(label, neighbor), length, 0, contrast };
    to.edges[to.count] = edge;
    to.count += complete & (edge.a >= 0);
}

//! Edges between the pixels of a row.
static void listEdgesRight(const int* row, const Feature* features, int cols, const RegionDistance& distance,
                           int* positions, EdgeList& to)
{
    const int count = listDifferences(row, row + 1, cols - 1, positions);
    for (int i = 0; i < count; i++)
    {
        const int x = positions[i];
        addEdge(row[x], row[x + 1], 1, distance(features[x], features[x + 1]), true, to);
    }
}

//! Edges between a row and the one below. Those side by side between the same regions are one.
static void listEdgesBelow(const int* row, const int* below, const Feature* features, const Feature* features_below,
                           int cols, const RegionDistance& distance, int* positions, EdgeList& to)
{
    const int count = listDifferences(row, below, cols, positions);
    positions[count] = 0;
    int length = 0;
    int64 contrast = 0;
    for (int i = 0; i < count; i++)
    {
        const int x = positions[i], next = positions[i + 1];
        const bool ends = (next != x + 1) | (row[next] != row[x]) | (below[next] != below[x]);
        length++;
        contrast += distance(features[x], features_below[x]);
        addEdge(row[x], below[x], length, contrast, ends, to);
        length = ends ? 0 : length;
        contrast = ends ? 0 : contrast;
    }
}

static void listEdges(const Mat& labels, const Range& range, const Padded<Feature>& features,
                      const RegionDistance& distance, EdgeRows& rows)
{
    const int cols = labels.cols;
    rows.positions.resize(cols + 4);
    rows.pieces.count = 0;
    for (int y = range.start; y < range.end; y++)
    {
        const int* row = labels.ptr<int>(y);
        rows.pieces.reserve(rows.pieces.count + 2 * cols + 1);
        listEdgesRight(row, features.row(y), cols, distance, rows.positions.data(), rows.pieces);
        if (y + 1 < labels.rows)
            listEdgesBelow(row, labels.ptr<int>(y + 1), features.row(y), features.row(y + 1), cols, distance,
                           rows.positions.data(), rows.pieces);
    }
}

void MergeGraph::build(const Mat& labels, int num_regions, const Padded<Feature>& features,
                       const RegionDistance& distance)
{
    CV_TRACE_FUNCTION();
    const int LOWEST = 16, MOST = 32; // chunks of rows do not depend on the number of threads
    const RegionDistance between_pixels = distance.withoutSurface();
    const int height = std::max(LOWEST, (labels.rows + MOST - 1) / MOST);
    setRegions(num_regions);
    rows_.resize((labels.rows + height - 1) / height);
    parallel_for_(Range(0, int(rows_.size())), [&](const Range& range)
    {
        for (int k = range.start; k < range.end; k++)
        {
            const Range chunk(k * height, std::min((k + 1) * height, labels.rows));
            listEdges(labels, chunk, features, between_pixels, rows_[k]);
            findSegments(rows_[k]);
        }
    });
    collect();
}

void MergeGraph::setRegions(int num_regions)
{
    const int num_bands = (num_regions + BAND - 1) / BAND;
    num_regions_ = num_regions;
    known_.resize(num_bands + 1);
    fresh_.resize(num_bands + 1);
    leaving_.resize(num_bands + 1);
    for (int k = 0; k <= num_bands; k++)
        known_[k].count = fresh_[k].count = leaving_[k].count = 0;
}

//! Regions that touch a row mostly have numbers that are near each other, so segments are long.
void MergeGraph::findSegments(EdgeRows& rows) const
{
    rows.segments.clear();
    const std::vector<MergeEdge>& edges = rows.pieces.edges;
    for (size_t i = 0; i < rows.pieces.count; i++)
    {
        const int list = listOf(edges[i].a, edges[i].b);
        if (rows.segments.empty() || rows.segments.back().list != list)
        {
            const EdgeRows::Segment segment = { list, i, i };
            rows.segments.push_back(segment);
        }
        rows.segments.back().last = i + 1;
    }
}

void MergeGraph::collect()
{
    for (size_t k = 0; k < rows_.size(); k++)
        for (size_t i = 0; i < rows_[k].segments.size(); i++)
        {
            const EdgeRows::Segment& segment = rows_[k].segments[i];
            fresh_[segment.list].append(rows_[k].pieces, segment.first, segment.last);
        }
}

void MergeGraph::relabel(const std::vector<int>& parents, const std::vector<uchar>& changed)
{
    forBands([&](int k, std::vector<int>&) { relabel(k, parents.data(), changed.data()); });
    relabel(numBands(), parents.data(), changed.data());
    handOver();
}

//! In place, and without branches: each edge is written to both lists, and stays in one of them.
void MergeGraph::relabel(int k, const int* parents, const uchar* changed)
{
    EdgeList &known = known_[k], &fresh = fresh_[k];
    fresh.reserve(known.count + 1);
    MergeEdge *edges = known.edges.data(), *fresh_edges = fresh.edges.data();
    const size_t count = known.count;
    size_t num_known = 0, num_fresh = 0;
    for (size_t i = 0; i < count; i++)
    {
        const int a = parents[edges[i].a], b = parents[edges[i].b];
        MergeEdge edge = edges[i];
        edge.a = std::min(a, b);
        edge.b = std::max(a, b);
        const size_t exists = a != b, is_fresh = changed[a] | changed[b];
        edges[num_known] = fresh_edges[num_fresh] = edge;
        num_known += exists & (is_fresh ^ 1);
        num_fresh += exists & is_fresh;
    }
    known.count = num_known;
    fresh.count = num_fresh;
    findLeaving(k);
}

//! What belongs to another list now is fresh: one of its regions was taken in.
void MergeGraph::findLeaving(int k)
{
    EdgeList &fresh = fresh_[k], &leaving = leaving_[k];
    size_t count = 0;
    for (size_t i = 0; i < fresh.count; i++)
    {
        if (listOf(fresh.edges[i].a, fresh.edges[i].b) != k)
            leaving.append(fresh, i, i + 1);
        else if (leaving.count > 0)
            fresh.edges[count++] = fresh.edges[i];
        else
            count++;
    }
    fresh.count = count;
}

//! Edges of regions that were united across the limit of a band.
void MergeGraph::handOver()
{
    for (size_t k = 0; k < leaving_.size(); k++)
    {
        const EdgeList& from = leaving_[k];
        for (size_t i = 0; i < from.count; i++)
            fresh_[listOf(from.edges[i].a, from.edges[i].b)].append(from, i, i + 1);
        leaving_[k].count = 0;
    }
}

//! The table has the index of each edge, in the first free slot; most slots stay free. An edge is written in any case,
//! and the next one over it if it was there before.
void MergeGraph::join(int k, std::vector<int>& table)
{
    EdgeList& list = fresh_[k];
    const int NONE = -1;
    int bits = 4;
    while ((size_t(1) << bits) < 3 * list.count)
        bits++;
    table.assign(size_t(1) << bits, NONE);
    const size_t last_slot = table.size() - 1;
    MergeEdge* edges = list.edges.data();
    int count = 0;
    for (size_t i = 0; i < list.count; i++)
    {
        MergeEdge edge = edges[i];
        size_t slot = (unsigned(edge.a) * 0x9E3779B1u ^ unsigned(edge.b) * 0x85EBCA77u) >> (32 - bits);
        int found = table[slot];
        while (found != NONE && (edges[found].a != edge.a || edges[found].b != edge.b))
        {
            slot = (slot + 1) & last_slot;
            found = table[slot];
        }
        const int length = edge.length, to = found == NONE ? count : found;
        const int64 contrast = edge.contrast;
        edge.length = 0;
        edge.contrast = 0;
        edges[count] = edge;
        edges[to].length += length;
        edges[to].contrast += contrast;
        table[slot] = to;
        count += found == NONE;
    }
    list.count = count;
}

void MergeGraph::forgetCosts()
{
    for (size_t k = 0; k < known_.size(); k++)
    {
        fresh_[k].append(known_[k], 0, known_[k].count);
        known_[k].count = 0;
    }
}

void MergeGraph::settle(int k)
{
    known_[k].append(fresh_[k], 0, fresh_[k].count);
    fresh_[k].count = 0;
}

}}} // namespace
