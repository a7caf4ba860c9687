// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/mixtures.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! A neighbour, and the length of the common boundary.
struct Side
{
    int region, length;

    bool isLonger(const Side& than) const
    {
        return length != than.length ? length > than.length : region < than.region;
    }
};

//! The two neighbours that a region has the longest boundaries with.
struct Sides
{
    Side longest, second;

    void add(const Side& side)
    {
        if (!side.isLonger(second))
            return;
        second = side;
        if (second.isLonger(longest))
            std::swap(longest, second);
    }
};

//! The two regions that another one is a mixture of.
struct Mixture
{
    int nearer, farther;
};

enum { NONE = -1 };

} // namespace

//! Those of narrow regions; of others, which have more pixels than neighbours beside them, none.
static std::vector<Sides> findSides(const MergeGraph& graph, const std::vector<MergeRegion>& records)
{
    std::vector<int> perimeters(records.size(), 0);
    graph.forEdges([&](const MergeEdge& edge)
    {
        perimeters[edge.a] += edge.length;
        perimeters[edge.b] += edge.length;
    });
    const Side no_side = { NONE, 0 };
    const Sides none = { no_side, no_side };
    std::vector<Sides> sides(records.size(), none);
    graph.forEdges([&](const MergeEdge& edge)
    {
        if (records[edge.a].area <= float(perimeters[edge.a]))
            sides[edge.a].add({ edge.b, edge.length });
        if (records[edge.b].area <= float(perimeters[edge.b]))
            sides[edge.b].add({ edge.a, edge.length });
    });
    return sides;
}

//! What a region is a mixture of, the one that it is more like first; {NONE, NONE} if it is none. It is at most two
//! pixels wide, and its colour lies on the straight line between those of its sides, which are an edge apart.
static Mixture mixtureOf(int region, const Sides& sides, const std::vector<MergeRegion>& records)
{
    const int EDGE = 24 * STEPS_PER_LEVEL; // less may be noise
    const int ASIDE = 20;                  // farther from the line than this part of it is a colour of its own
    if (sides.second.length == 0 || records[region].area > float(sides.longest.length + sides.second.length))
        return { NONE, NONE };
    const int a = sides.longest.region, b = sides.second.region;
    int64 whole = 0, along = 0, part = 0; // of the line from a to b
    for (int k = 0; k < 3; k++)
    {
        const int step = records[b].mean[k] - records[a].mean[k];
        const int step_to_region = records[region].mean[k] - records[a].mean[k];
        whole += step * step;
        along += step * step_to_region;
        part += step_to_region * step_to_region;
    }
    const bool is_between = along > 0 && along < whole && whole >= EDGE * EDGE;
    if (!is_between || (part * whole - along * along) * (ASIDE * ASIDE) > whole * whole)
        return { NONE, NONE };
    const bool is_nearer_to_b = 2 * along > whole;
    return { is_nearer_to_b ? b : a, is_nearer_to_b ? a : b };
}

void findMixtures(const MergeGraph& graph, const std::vector<MergeRegion>& records, std::vector<MergePair>& pairs)
{
    const int n = int(records.size());
    const std::vector<Sides> sides = findSides(graph, records);
    std::vector<Mixture> mixtures(n);
    for (int i = 0; i < n; i++)
        mixtures[i] = mixtureOf(i, sides[i], records);
    pairs.clear();
    for (int i = 0; i < n; i++)
    {
        if (mixtures[i].nearer == NONE)
            continue;
        const int to = mixtures[mixtures[i].nearer].nearer == NONE ? mixtures[i].nearer : mixtures[i].farther;
        if (mixtures[to].nearer == NONE)
            pairs.push_back(MergePair(priceOf(int(records[i].area), i, to), i, to));
    }
    std::sort(pairs.begin(), pairs.end());
}

}}} // namespace
