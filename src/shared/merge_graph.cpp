// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/merge_graph.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Without branches: each position is written, and the next one over it if there is no difference.
int listDifferences(const int* row, const int* other, int cols, int* positions)
{
    int count = 0;
    for (int x = 0; x < cols; x++)
    {
        positions[count] = x;
        count += row[x] != other[x];
    }
    return count;
}

void MergeGraph::setRegions(int num_regions, bool with_contrasts)
{
    const int num_bands = (num_regions + BAND - 1) / BAND;
    num_regions_ = num_regions;
    with_contrasts_ = with_contrasts;
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
            fresh_[segment.list].append(rows_[k].pieces, segment.first, segment.last, with_contrasts_);
        }
}

void MergeGraph::relabel(const std::vector<int>& parents, const std::vector<uchar>& changed)
{
    const auto work = [&](int k)
    {
        if (with_contrasts_)
            relabel<true>(k, parents.data(), changed.data());
        else
            relabel<false>(k, parents.data(), changed.data());
    };
    forBands([&](int k, std::vector<int>&) { work(k); });
    work(numBands());
    handOver();
}

//! In place, and without branches: each edge is written to both lists, and stays in one of them.
template <bool CONTRAST> void MergeGraph::relabel(int k, const int* parents, const uchar* changed)
{
    EdgeList &known = known_[k], &fresh = fresh_[k];
    fresh.reserve(known.count + 1, CONTRAST);
    MergeEdge *edges = known.edges.data(), *fresh_edges = fresh.edges.data();
    int64 *contrasts = known.contrasts.data(), *fresh_contrasts = fresh.contrasts.data();
    const size_t count = known.count;
    size_t num_known = 0, num_fresh = 0;
    for (size_t i = 0; i < count; i++)
    {
        const int a = parents[edges[i].a], b = parents[edges[i].b];
        const MergeEdge edge = { std::min(a, b), std::max(a, b), edges[i].length, edges[i].cost };
        const size_t exists = a != b, is_fresh = changed[a] | changed[b];
        edges[num_known] = fresh_edges[num_fresh] = edge;
        if (CONTRAST)
            contrasts[num_known] = fresh_contrasts[num_fresh] = contrasts[i];
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
            leaving.append(fresh, i, i + 1, with_contrasts_);
        else if (leaving.count > 0)
            fresh.move(i, count++, with_contrasts_);
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
            fresh_[listOf(from.edges[i].a, from.edges[i].b)].append(from, i, i + 1, with_contrasts_);
        leaving_[k].count = 0;
    }
}

void MergeGraph::join(int k, std::vector<int>& table)
{
    if (with_contrasts_)
        join<true>(fresh_[k], table);
    else
        join<false>(fresh_[k], table);
}

//! The table has the index of each edge, in the first free slot; most slots stay free. An edge is written in any case,
//! and the next one over it if it was there before.
template <bool CONTRAST> void MergeGraph::join(EdgeList& list, std::vector<int>& table)
{
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
        edge.length = 0;
        edges[count] = edge;
        edges[to].length += length;
        if (CONTRAST)
        {
            const int64 contrast = list.contrasts[i];
            list.contrasts[count] = 0;
            list.contrasts[to] += contrast;
        }
        table[slot] = to;
        count += found == NONE;
    }
    list.count = count;
}

void MergeGraph::settle(int k)
{
    known_[k].append(fresh_[k], 0, fresh_[k].count, with_contrasts_);
    fresh_[k].count = 0;
}

}}} // namespace
