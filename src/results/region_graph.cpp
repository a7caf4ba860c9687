// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "results/region_graph.hpp"
#include <numeric>

namespace cv { namespace ximgproc { namespace gws {

RegionGraph::RegionGraph(int num_regions) : firsts_(num_regions, int(NONE)), parents_(num_regions)
{
    const size_t usual = 3 * size_t(num_regions); // boundaries
    size_t slots = 16;
    while (slots < 2 * usual)
        slots *= 2;
    table_.assign(slots, int(NONE));
    boundaries_.reserve(usual);
    std::iota(parents_.begin(), parents_.end(), 0);
}

//! Takes the boundaries that are no more out of the list of a region, from a link on.
int RegionGraph::skipGone(int region, int& link)
{
    while (link != NONE && !boundaries_[link].exists())
        link = boundaries_[link].next[boundaries_[link].side(region)];
    return link;
}

int RegionGraph::first(int region)
{
    return skipGone(region, firsts_[region]);
}

int RegionGraph::next(int region, int boundary)
{
    Boundary& b = boundaries_[boundary];
    return skipGone(region, b.next[b.side(region)]);
}

//! Where a search begins; the slots after it follow. The same for both orders of the regions.
size_t RegionGraph::slotOf(int a, int b) const
{
    const uint64 key = (uint64(std::max(a, b)) << 32) + std::min(a, b);
    return size_t((key * CV_BIG_UINT(0x9E3779B97F4A7C15)) >> 32) & (table_.size() - 1);
}

int RegionGraph::find(int a, int b) const
{
    for (size_t slot = slotOf(a, b); table_[slot] != NONE; slot = (slot + 1) & (table_.size() - 1))
    {
        const Boundary& known = boundaries_[table_[slot]];
        if (known.exists() && known.regions[known.side(a)] == a && known.regions[!known.side(a)] == b)
            return table_[slot];
    }
    return NONE;
}

void RegionGraph::fillSlot(int boundary)
{
    size_t slot = slotOf(boundaries_[boundary].regions[0], boundaries_[boundary].regions[1]);
    while (table_[slot] != NONE)
        slot = (slot + 1) & (table_.size() - 1);
    table_[slot] = boundary;
    num_filled_++;
}

//! Half of the slots stay free.
void RegionGraph::addToTable(int boundary)
{
    if (2 * num_filled_ < table_.size())
    {
        fillSlot(boundary);
        return;
    }
    table_.assign(2 * table_.size(), int(NONE));
    num_filled_ = 0;
    for (size_t i = 0; i < boundaries_.size(); i++) // this one, too
        if (boundaries_[i].exists())
            fillSlot(int(i));
}

void RegionGraph::add(int a, int b, int length, int64 contrast)
{
    const int known = find(a, b);
    if (known != NONE)
    {
        boundaries_[known].length += length;
        boundaries_[known].contrast += contrast;
        return;
    }
    const Boundary boundary = { { a, b }, { firsts_[a], firsts_[b] }, length, contrast };
    firsts_[a] = firsts_[b] = int(boundaries_.size());
    boundaries_.push_back(boundary);
    addToTable(int(boundaries_.size()) - 1);
}

void RegionGraph::unite(int from, int to)
{
    for (int i = first(from); i != NONE;)
    {
        Boundary& boundary = boundaries_[i];
        const int side = boundary.side(from), neighbor = boundary.regions[!side], following = next(from, i);
        const int known = neighbor == to ? i : find(to, neighbor);
        if (known == NONE)
        {
            boundary.regions[side] = to;
            boundary.next[side] = firsts_[to];
            firsts_[to] = i;
            addToTable(i);
        }
        else
        {
            if (known != i)
                boundaries_[known].length += boundary.length;
            boundary.length = 0;
        }
        i = following;
    }
    parents_[from] = to;
}

}}} // namespace
