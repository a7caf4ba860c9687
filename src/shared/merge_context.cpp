// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/merge_context.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! An edge along which values spread.
struct Link
{
    int a, b;
    float likeness; //!< of what lies on its two sides
};

} // namespace

static inline int squareOf(const short* color)
{
    return color[0] * color[0] + color[1] * color[1] + color[2] * color[2];
}

//! Less across contrasts and differences, more along long boundaries.
static float likenessAt(const MergeEdge& edge, const MergeRegion& a, const MergeRegion& b)
{
    const float NOISE = 1.5f * STEPS_PER_LEVEL * STEPS_PER_LEVEL; // a squared distance that means little
    int squared_distance = 0;
    for (int k = 0; k < 3; k++)
        squared_distance += (a.mean[k] - b.mean[k]) * (a.mean[k] - b.mean[k]);
    const float length = float(edge.length), contrasts = float(edge.contrast) + STEPS_PER_LEVEL * length;
    return length * length / (contrasts * std::sqrt(float(squared_distance) + NOISE));
}

static std::vector<Link> linksOf(const MergeGraph& graph, const std::vector<MergeRegion>& regions)
{
    std::vector<Link> links;
    graph.forEdges([&](const MergeEdge& edge)
    {
        links.push_back({ edge.a, edge.b, likenessAt(edge, regions[edge.a], regions[edge.b]) });
    });
    return links;
}

static inline void addTimes(float factor, const Vec4f& values, Vec4f& sum)
{
    v_store(sum.val, add(v_load(sum.val), multiply(v_load(values.val), v_setall_f32(factor))));
}

//! Each region takes the mean of its neighbours, by likeness, and again.
static void spreadAlong(const std::vector<Link>& links, std::vector<Vec4f>& values)
{
    const int ROUNDS = 8;
    std::vector<float> shares(values.size(), 0.f);
    for (const Link& link : links)
    {
        shares[link.a] += link.likeness;
        shares[link.b] += link.likeness;
    }
    for (float& share : shares)
        share = share > 0 ? 1 / share : 0;
    std::vector<Vec4f> sums(values.size());
    for (int round = 0; round < ROUNDS; round++)
    {
        std::fill(sums.begin(), sums.end(), Vec4f::all(0));
        for (const Link& link : links)
        {
            addTimes(link.likeness, values[link.b], sums[link.a]);
            addTimes(link.likeness, values[link.a], sums[link.b]);
        }
        for (size_t i = 0; i < values.size(); i++)
            if (shares[i] > 0) // else it has no neighbour
                v_store(values[i].val, multiply(v_load(sums[i].val), v_setall_f32(shares[i])));
    }
}

void MergeContexts::spread(const std::vector<MergeRegion>& regions, const MergeGraph& graph)
{
    CV_TRACE_FUNCTION();
    const int n = int(regions.size());
    sums_.resize(n);
    squares_.resize(n);
    means_.resize(n);
    for (int i = 0; i < n; i++)
        sums_[i] = Vec4f(regions[i].mean[0], regions[i].mean[1], regions[i].mean[2], regions[i].texture);
    spreadAlong(linksOf(graph, regions), sums_);
    for (int i = 0; i < n; i++)
    {
        sums_[i] *= regions[i].area;
        squares_[i] = double(regions[i].area) * squareOf(regions[i].mean);
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
    mean.variation = cvRound(squares_[number] / region.area - squareOf(region.mean));
}

void MergeContexts::update(const std::vector<int>& numbers, const std::vector<MergeRegion>& regions)
{
    for (int i : numbers)
        update(i, regions[i]);
}

void MergeContexts::unite(int from, int to)
{
    sums_[to] += sums_[from];
    squares_[to] += squares_[from];
}

}}} // namespace
