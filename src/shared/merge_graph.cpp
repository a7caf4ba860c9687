// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/merge_graph.hpp"
#include "shared/label_runs.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The upper bits are those to use.
static inline unsigned hashOf(int a, int b)
{
    return unsigned(a) * 0x9E3779B1u ^ unsigned(b) * 0x85EBCA77u;
}

void EdgeBuilder::start(int cols, bool joins_rows)
{
    joins_rows_ = joins_rows;
    edges_.count = 0;
    edges_.reserve(1);
    edges_.edges[0] = { -1, -1, 0, 0, 0 }; // between no regions, for the first search
    positions_.resize(cols + NUM_BEHIND);
    contrasts_.resize(cols + NUM_BEHIND);
    latest_.assign(1 << LATEST_BITS, 0);
}

//! Of the pixels at the positions, four at a time.
template <bool WITH_DEPTH>
void EdgeBuilder::measureContrasts(const Feature* features, const Feature* others, int count,
                                   const RegionDistance& distance)
{
    const int* const positions = positions_.data();
    int* const contrasts = contrasts_.data();
    for (int i = 0; i < count; i += 4)
        v_store(contrasts + i,
                distance.between<WITH_DEPTH>(gather(features, positions + i), gather(others, positions + i)));
}

//! The lower one, without a branch: which one it is cannot be foreseen.
static inline int lowerOf(int a, int b)
{
    return a ^ ((a ^ b) & -int(b < a));
}

static inline bool isBetween(const MergeEdge& edge, int a, int b)
{
    return ((edge.a ^ a) | (edge.b ^ b)) == 0;
}

//! Edges between the same regions that follow each other are one. Which ones do cannot be foreseen, so there is no
//! branch: each is written, and the next one overwrites it if it is of the same.
void EdgeBuilder::addRow(const int* row, const int* other, int count)
{
    const int *positions = positions_.data(), *contrasts = contrasts_.data();
    MergeEdge* const edges = edges_.edges.data();
    MergeEdge last = { -1, -1, 0, 0, 0 };
    size_t num_edges = edges_.count;
    for (int i = 0; i < count; i++)
    {
        const int label = row[positions[i]], neighbor = other[positions[i]];
        const int a = lowerOf(label, neighbor), b = label ^ neighbor ^ a, same = -int(isBetween(last, a, b));
        num_edges += size_t((same + 1) & ~(last.a >> 31));
        const MergeEdge edge = { a, b, (last.length & same) + 1, 0, (last.contrast & same) + contrasts[i] };
        edges[num_edges] = last = edge;
    }
    edges_.count = num_edges + size_t(1 & ~(last.a >> 31));
}

//! Adds each to the edge between the same regions that was found last, here or in the rows above: most have one.
void EdgeBuilder::joinRow(const int* row, const int* other, int count)
{
    const int *positions = positions_.data(), *contrasts = contrasts_.data();
    MergeEdge* const edges = edges_.edges.data();
    int* const latest = latest_.data();
    size_t num_edges = edges_.count;
    for (int i = 0; i < count; i++)
    {
        const int label = row[positions[i]], neighbor = other[positions[i]];
        const int a = lowerOf(label, neighbor), b = label ^ neighbor ^ a;
        if (a < 0)
            continue;
        int& place = latest[hashOf(a, b) >> (32 - LATEST_BITS)];
        if (!isBetween(edges[place], a, b))
        {
            place = int(num_edges);
            edges[num_edges++] = { a, b, 0, 0, 0 };
        }
        edges[place].length++;
        edges[place].contrast += contrasts[i];
    }
    edges_.count = num_edges;
}

void EdgeBuilder::add(const int* row, const int* other, const Feature* features, const Feature* other_features,
                      int cols, const RegionDistance& distance)
{
    const int count = listDifferences(row, other, cols, positions_.data());
    std::fill_n(positions_.data() + count, int(NUM_BEHIND), 0);
    if (distance.with_depth)
        measureContrasts<true>(features, other_features, count, distance);
    else
        measureContrasts<false>(features, other_features, count, distance);
    edges_.reserve(edges_.count + count);
    if (joins_rows_)
        joinRow(row, other, count);
    else
        addRow(row, other, count);
}

static void listEdges(const Mat& labels, const Range& rows, const Padded<Feature>& features,
                      const RegionDistance& distance, EdgeBuilder& builder)
{
    const int cols = labels.cols;
    for (int y = rows.start; y < rows.end; y++)
    {
        const int* row = labels.ptr<int>(y);
        builder.add(row, row + 1, features.row(y), features.row(y) + 1, cols - 1, distance);
        if (y + 1 < labels.rows)
            builder.add(row, labels.ptr<int>(y + 1), features.row(y), features.row(y + 1), cols, distance);
    }
}

void MergeGraph::build(const Mat& labels, int num_regions, const Padded<Feature>& features,
                       const RegionDistance& distance)
{
    CV_TRACE_FUNCTION();
    const RegionDistance between_pixels = distance.withoutSurface();
    const RowChunks chunks = fewChunks(labels.rows);
    const int LARGE = 64; // pixels; the boundaries of smaller ones have few in common with the rows above
    const bool large_regions = labels.total() > LARGE * size_t(num_regions);
    setRegions(num_regions);
    rows_.resize(chunks.size());
    spans_.resize(chunks.size());
    builders_.resize(chunks.size());
    parallel_for_(Range(0, chunks.size()), [&](const Range& range)
    {
        EdgeBuilder& builder = builders_[range.start];
        for (int k = range.start; k < range.end; k++)
        {
            builder.start(labels.cols, large_regions);
            listEdges(labels, chunks[k], features, between_pixels, builder);
            builder.moveTo(rows_[k]);
            divide(rows_[k], spans_[k]);
        }
    });
    for (const std::vector<EdgeSpan>& of_rows : spans_)
        for (const EdgeSpan& span : of_rows)
            found_[span.list].push_back(span);
}

//! Bands are large, because edges between them cost more, but if regions are few there must be some bands, too; if
//! they have few edges, which are fewer than three for each region, one band.
void MergeGraph::setRegions(int num_regions)
{
    const int SMALLEST = 9, LARGEST = 13; // bits of numbers of regions
    const int FEW = 8;                    // bands
    num_regions_ = num_regions;
    band_shift_ = SMALLEST;
    while (band_shift_ < LARGEST && ((num_regions >> band_shift_) >= FEW || num_regions < FEW_EDGES / 3))
        band_shift_++;
    const int num_bands = (num_regions + (1 << band_shift_) - 1) >> band_shift_;
    known_.resize(num_bands + 1);
    fresh_.resize(num_bands + 1);
    leaving_.resize(num_bands + 1);
    found_.assign(num_bands + 1, std::vector<EdgeSpan>());
    for (int k = 0; k <= num_bands; k++)
        known_[k].count = fresh_[k].count = leaving_[k].count = 0;
}

//! Shares edges that were found among the lists. Regions that touch a row mostly have numbers that are near each
//! other, so spans are long.
void MergeGraph::divide(const EdgeList& edges, std::vector<EdgeSpan>& spans) const
{
    spans.clear();
    const MergeEdge *edge = edges.edges.data(), *const end = edge + edges.count;
    while (edge != end)
    {
        const MergeEdge* const first = edge;
        const int own = listOf(first->a, first->b);
        while (edge != end && listOf(edge->a, edge->b) == own)
            edge++;
        spans.push_back({ own, first, size_t(edge - first) });
    }
}

size_t MergeGraph::countUnjoined(int k) const
{
    size_t count = fresh_[k].count;
    for (const EdgeSpan& span : found_[k])
        count += span.count;
    return count;
}

void MergeGraph::relabel(const std::vector<int>& parents, const std::vector<uchar>& changed)
{
    forLists([&](int k, std::vector<int>&) { relabel(k, parents.data(), changed.data()); });
    handOver();
}

//! In place, and without branches: each edge is written to both lists, and stays in one of them.
void MergeGraph::relabel(int k, const int* parents, const uchar* changed)
{
    EdgeList &known = known_[k], &fresh = fresh_[k];
    fresh.reserve(known.count + 1);
    MergeEdge *known_end = known.edges.data(), *fresh_end = fresh.edges.data();
    const MergeEdge* const end = known_end + known.count;
    for (const MergeEdge* edge = known_end; edge != end; edge++)
    {
        const int a = parents[edge->a], b = parents[edge->b], lower = lowerOf(a, b);
        const size_t exists = a != b, is_fresh = changed[a] | changed[b];
        *fresh_end = *edge;
        *known_end = *edge;
        fresh_end->a = known_end->a = lower;
        fresh_end->b = known_end->b = a ^ b ^ lower;
        known_end += exists & (is_fresh ^ 1);
        fresh_end += exists & is_fresh;
    }
    known.count = size_t(known_end - known.edges.data());
    fresh.count = size_t(fresh_end - fresh.edges.data());
    findLeaving(k);
}

//! What belongs to another list now is fresh: one of its regions was taken in. The last edge takes its place.
void MergeGraph::findLeaving(int k)
{
    if (numBands() == 1)
        return;
    EdgeList &fresh = fresh_[k], &leaving = leaving_[k];
    size_t i = 0;
    while (i < fresh.count)
    {
        if (listOf(fresh.edges[i].a, fresh.edges[i].b) == k)
        {
            i++;
            continue;
        }
        leaving.add(fresh.edges[i]);
        fresh.edges[i] = fresh.edges[--fresh.count];
    }
}

//! Edges of regions that were united across the limit of a band.
void MergeGraph::handOver()
{
    for (EdgeList& from : leaving_)
    {
        for (size_t i = 0; i < from.count; i++)
            fresh_[listOf(from.edges[i].a, from.edges[i].b)].add(from.edges[i]);
        from.count = 0;
    }
}

enum { FREE = INT_MAX }; // in a table of edges

//! Makes one edge of those between the same regions, behind `count` of them. Returns how many there are then. The
//! table, of so many bits, has the index of each edge, in the first free slot; most slots stay free. Behind the edges
//! one is ready that the pair of regions gets if it is new, which cannot be foreseen. FREE is above all indices, so the
//! lower one of a free slot and `count` is the edge that is ready, and there is no branch.
static int joinEdges(const EdgeSpan& from, int bits, int* table, MergeEdge* edges, int count)
{
    const unsigned last_slot = (1u << bits) - 1;
    for (const MergeEdge *edge = from.first, *end = edge + from.count; edge != end; edge++)
    {
        const int a = edge->a, b = edge->b;
        edges[count] = { a, b, 0, 0, 0 };
        unsigned slot = hashOf(a, b) >> (32 - bits);
        int to = lowerOf(table[slot], count);
        while (!isBetween(edges[to], a, b)) // seldom
        {
            slot = (slot + 1) & last_slot;
            to = lowerOf(table[slot], count);
        }
        edges[to].length += edge->length;
        edges[to].contrast += edge->contrast;
        table[slot] = to;
        count += to == count;
    }
    return count;
}

size_t MergeGraph::join(int k, std::vector<int>& table)
{
    EdgeList &known = known_[k], &fresh = fresh_[k];
    const size_t first = known.count, num_edges = countUnjoined(k);
    int bits = 4;
    while ((size_t(1) << bits) < 3 * num_edges)
        bits++;
    table.assign(size_t(1) << bits, FREE);
    known.reserve(first + num_edges);
    found_[k].push_back({ k, fresh.edges.data(), fresh.count });
    int count = 0;
    for (const EdgeSpan& span : found_[k])
        count = joinEdges(span, bits, table.data(), known.edges.data() + first, count);
    known.count += size_t(count);
    found_[k].clear();
    fresh.count = 0;
    return first;
}

}}} // namespace
