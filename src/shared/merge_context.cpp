// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/merge_context.hpp"
#include <numeric>

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! A neighbour of a region, to which values spread.
struct Neighbor
{
    int region;
    float likeness; //!< of what lies on the two sides of the edge
};

//! The neighbours of all regions, those of one after those of another.
struct Neighbors
{
    std::vector<Neighbor> all;
    std::vector<int> ends; // of those of each region
};

} // namespace

//! Less across contrasts and differences, more along long boundaries, and where both sides are rough.
static float likenessAt(const MergeEdge& edge, const MergeRegion& a, const MergeRegion& b)
{
    const float NOISE = 1.5f * STEPS_PER_LEVEL * STEPS_PER_LEVEL; // a squared distance that means little
    int squared_distance = 0;
    for (int k = 0; k < 3; k++)
        squared_distance += (a.mean[k] - b.mean[k]) * (a.mean[k] - b.mean[k]);
    const float length = float(edge.length), contrasts = float(edge.contrast) + STEPS_PER_LEVEL * length;
    const float steps = powerOfTwo(std::min(a.texture, b.texture)); // contrasts mean less among as many others
    return length * length * steps / (contrasts * std::sqrt(float(squared_distance) + NOISE));
}

static Neighbors listNeighbors(const MergeGraph& graph, const std::vector<MergeRegion>& regions)
{
    Neighbors neighbors;
    neighbors.ends.assign(regions.size() + 1, 0);
    graph.forEdges([&](const MergeEdge& edge)
    {
        neighbors.ends[edge.a + 1]++;
        neighbors.ends[edge.b + 1]++;
    });
    std::partial_sum(neighbors.ends.begin(), neighbors.ends.end(), neighbors.ends.begin());
    neighbors.all.resize(neighbors.ends.back());
    graph.forEdges([&](const MergeEdge& edge)
    {
        const float likeness = likenessAt(edge, regions[edge.a], regions[edge.b]);
        neighbors.all[neighbors.ends[edge.a]++] = { edge.b, likeness };
        neighbors.all[neighbors.ends[edge.b]++] = { edge.a, likeness };
    });
    return neighbors;
}

//! Each region takes the mean of its neighbours, by likeness, and again. What some have taken already spreads at once.
static void spreadAlong(const Neighbors& neighbors, std::vector<Vec4f>& values)
{
    const int ROUNDS = 4;
    for (int round = 0; round < ROUNDS; round++)
    {
        const Neighbor* neighbor = neighbors.all.data();
        for (size_t i = 0; i < values.size(); i++)
        {
            v_float32x4 sum = v_setzero_f32();
            float share = 0;
            for (const Neighbor* end = neighbors.all.data() + neighbors.ends[i]; neighbor != end; neighbor++)
            {
                sum = add(sum, multiply(v_load(values[neighbor->region].val), v_setall_f32(neighbor->likeness)));
                share += neighbor->likeness;
            }
            if (share > 0) // else it has no neighbour
                v_store(values[i].val, multiply(sum, v_setall_f32(1 / share)));
        }
    }
}

void MergeContexts::spread(const std::vector<MergeRegion>& regions, const MergeGraph& graph)
{
    CV_TRACE_FUNCTION();
    const int n = int(regions.size());
    sums_.resize(n);
    means_.resize(n);
    for (int i = 0; i < n; i++)
        sums_[i] = Vec4f(regions[i].mean[0], regions[i].mean[1], regions[i].mean[2], regions[i].texture);
    spreadAlong(listNeighbors(graph, regions), sums_);
    for (int i = 0; i < n; i++)
    {
        sums_[i] *= regions[i].area;
        update(i, regions[i]);
    }
}

void MergeContexts::update(int number, const MergeRegion& region)
{
    MergeContext& mean = means_[number];
    const Vec4f of_pixels = sums_[number] * (1 / region.area);
    for (int k = 0; k < 3; k++)
        mean.color[k] = short(cvRound(of_pixels[k]));
    mean.texture = short(cvRound(of_pixels[3]));
}

void MergeContexts::update(const std::vector<int>& numbers, const std::vector<MergeRegion>& regions)
{
    for (int i : numbers)
        update(i, regions[i]);
}

void MergeContexts::unite(int from, int to)
{
    sums_[to] += sums_[from];
}

}}} // namespace
