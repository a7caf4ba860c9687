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
    lists_.resize(num_bands + 1);
    leaving_.resize(num_bands + 1);
    for (int k = 0; k <= num_bands; k++)
        lists_[k].clear();
}

//! Regions that touch a row mostly have numbers that are near each other, so segments are long.
void MergeGraph::findSegments(EdgeRows& rows) const
{
    rows.segments.clear();
    const std::vector<MergeEdge>& edges = rows.pieces.edges;
    for (size_t i = 0; i < edges.size(); i++)
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
            lists_[segment.list].append(rows_[k].pieces, segment.first, segment.last);
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

//! In place, so edges keep their order.
template <bool CONTRAST> void MergeGraph::relabel(int k, const int* parents, const uchar* changed)
{
    EdgeList& list = lists_[k];
    MergeEdge* edges = list.edges.data();
    size_t count = 0;
    for (size_t i = 0; i < list.edges.size(); i++)
    {
        const int a = parents[edges[i].a], b = parents[edges[i].b];
        const bool is_new = (changed[a] | changed[b]) != 0;
        const MergeEdge edge = { std::min(a, b), std::max(a, b), edges[i].length,
                                 is_new ? int(MergeEdge::UNKNOWN) : edges[i].cost };
        edges[count] = edge;
        if (CONTRAST)
            list.contrasts[count] = list.contrasts[i];
        if (listOf(a, b) != k && a != b)
            leaving_[k].append(list, count, count + 1);
        else
            count += a != b;
    }
    list.resize(count, CONTRAST);
}

//! Edges of regions that were united across the limit of a band.
void MergeGraph::handOver()
{
    for (size_t k = 0; k < leaving_.size(); k++)
    {
        const EdgeList& from = leaving_[k];
        for (size_t i = 0; i < from.edges.size(); i++)
            lists_[listOf(from.edges[i].a, from.edges[i].b)].append(from, i, i + 1);
        leaving_[k].clear();
    }
}

void MergeGraph::join(int k, std::vector<int>& table)
{
    if (with_contrasts_)
        join<true>(lists_[k], table);
    else
        join<false>(lists_[k], table);
}

//! The table has the index of each edge of unknown cost, in the first free slot; half of the slots stay free.
template <bool CONTRAST> void MergeGraph::join(EdgeList& list, std::vector<int>& table) const
{
    const int NONE = -1;
    int bits = 4;
    while ((size_t(1) << bits) < 2 * list.edges.size())
        bits++;
    table.assign(size_t(1) << bits, NONE);
    const size_t last_slot = table.size() - 1;
    MergeEdge* edges = list.edges.data();
    int count = 0;
    for (size_t i = 0; i < list.edges.size(); i++)
    {
        const MergeEdge edge = edges[i];
        int known = NONE;
        if (edge.cost == MergeEdge::UNKNOWN)
        {
            size_t slot = (unsigned(edge.a) * 0x9E3779B1u ^ unsigned(edge.b) * 0x85EBCA77u) >> (32 - bits);
            while ((known = table[slot]) != NONE && (edges[known].a != edge.a || edges[known].b != edge.b))
                slot = (slot + 1) & last_slot;
            table[slot] = known == NONE ? count : known;
        }
        const int to = known == NONE ? count : known;
        edges[count] = edge;
        if (CONTRAST)
            list.contrasts[count] = list.contrasts[i];
        if (known != NONE)
        {
            edges[to].length += edge.length;
            if (CONTRAST)
                list.contrasts[to] += list.contrasts[i];
        }
        count += known == NONE;
    }
    list.resize(count, CONTRAST);
}

}}} // namespace
