// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "rgwatershed/region_flood.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Length of a vector in 1/16 within 4 percent, without a root.
static inline int64 octagonalLength(Point v)
{
    const int64 x = 16 * int64(std::abs(v.x)), y = 16 * int64(std::abs(v.y));
    const int64 longer = std::max(x, y), shorter = std::min(x, y);
    return longer - (longer >> 5) + ((13 * shorter) >> 5);
}

//! The flood of some rows; nothing crosses to others.
class RegionFlood
{
public:
    RegionFlood(const Padded<Feature>& features, const RegionDistance& distance, int ruler, const Range& rows,
                FloodBuffers::Band& band, FloodBuffers& buffers, Padded<int>& labels, Regions& regions)
        : features_(features), centers_(buffers.centers), distance_(distance), ruler_(ruler),
          neighbors_(labels.neighbors()), first_block_(labels.index(Point(0, rows.start))),
          end_block_(labels.index(Point(0, rows.end))), labels_(labels), regions_(regions), queues_(band.queues),
          batch_(band.batch), updates_(buffers.updates), priorities_(buffers.priorities)
    {
    }

    //! The mean of many hardly moves.
    static int nextUpdate(int area) { return area + area / 4 + 1; }

    //! Invariant: a block may wait several times, each time at a lower priority and for the region
    //! that offered it; when it is first taken out, the last offer stands, and the block takes
    //! that label. No priority lies below the one being flooded, and equal priorities keep their order,
    //! so the result depends on the order of the markers and nothing else.
    void run(const Point* first_seed, const Point* end_seed)
    {
        queues_.clear();
        for (const Point* seed = first_seed; seed != end_seed; seed++)
            spread(*seed, labels_.row(seed->y)[seed->x]);
        while (queues_.take(batch_))
            for (size_t i = 0; i < batch_.size(); i++)
            {
                const int label = labels_.row(batch_[i].y)[batch_[i].x];
                if (label >= 0)
                    continue; // it was taken out at a lower priority before
                settle(labels_.index(batch_[i]), OFFERED - label);
                spread(batch_[i], OFFERED - label);
            }
    }

private:
    enum { OFFERED = -2 }; // OFFERED - i: waits for the region i

    void settle(int block, int i)
    {
        labels_.data()[block] = i;
        RegionSum& sum = regions_.sums[i];
        sum.add(features_.data()[block]);
        if (sum.area < updates_[i])
            return;
        regions_.update(i);
        updates_[i] = nextUpdate(sum.area);
    }

    void spread(Point block, int i)
    {
        const int index = labels_.index(block);
        for (int k = 0; k < 4; k++)
        {
            const int to = index + neighbors_[k];
            if (to < first_block_ || to >= end_block_)
                continue; // where another thread may be writing
            const int label = labels_.data()[to];
            if (label >= 0 || label == OUTSIDE || label == OFFERED - i)
                continue;
            const Point neighbor(block.x + (k == 2) - (k == 0), block.y + (k == 3) - (k == 1));
            const int priority = std::max(priorityOf(to, i, neighbor - centers_[i]), queues_.priority());
            if (label != UNSEEN && priority >= priorities_[to])
                continue; // another region offers as much
            labels_.data()[to] = OFFERED - i;
            priorities_[to] = ushort(priority);
            queues_.push(neighbor, priority);
        }
    }

    //! In quarters of a level; what is higher than all queues waits in the last one.
    int priorityOf(int block, int i, Point offset) const
    {
        const int64 away = (ruler_ * octagonalLength(offset)) >> 12;
        const int64 priority = (distance_(features_.data()[block], regions_.means[i]) + away) >> 2;
        return int(std::min<int64>(priority, FloodBuffers::PRIORITIES - 1));
    }

    const Padded<Feature>& features_;
    const std::vector<Point>& centers_;
    const RegionDistance distance_;
    const int ruler_;
    const Vec4i neighbors_;
    const int first_block_, end_block_;
    Padded<int>& labels_;
    Regions& regions_;
    BucketQueue<Point, FloodBuffers::PRIORITIES>& queues_;
    std::vector<Point>& batch_;
    std::vector<int>& updates_;
    std::vector<ushort>& priorities_;
};

//! Makes the buffers ready for the regions and blocks that there are.
static void prepare(const Padded<int>& labels, const Regions& regions, int num_bands, FloodBuffers& buffers)
{
    buffers.bands.resize(num_bands);
    buffers.updates.resize(regions.size());
    for (int i = 0; i < regions.size(); i++)
        buffers.updates[i] = RegionFlood::nextUpdate(regions.sums[i].area);
    buffers.priorities.resize(size_t(labels.step()) * (labels.size().height + 2));
}

//! @note Section III.B with a region in the place of the neighbour: the priority of a pixel is its
//! distance to the mean of the region that reaches it, plus its distance to the marker.
void floodFromPoints(const Padded<Feature>& features, const std::vector<Point>& markers,
                     const std::vector<MarkerBand>& bands, const RegionDistance& distance, int ruler,
                     FloodBuffers& buffers, Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    const int first = regions.size();
    buffers.centers.assign(first, Point());
    buffers.centers.insert(buffers.centers.end(), markers.begin(), markers.end());
    regions.resize(first + int(markers.size()));
    for (int i = 0; i < int(markers.size()); i++)
    {
        const int seed = labels.index(markers[i]);
        labels.data()[seed] = first + i;
        regions.sums[first + i] = RegionSum();
        regions.sums[first + i].add(features.data()[seed]);
        regions.update(first + i);
    }
    prepare(labels, regions, int(bands.size()), buffers);
    parallel_for_(Range(0, int(bands.size())), [&](const Range& range)
    {
        for (int i = range.start; i < range.end; i++)
            RegionFlood(features, distance, ruler, bands[i].rows, buffers.bands[i], buffers, labels, regions)
                .run(markers.data() + bands[i].markers.start, markers.data() + bands[i].markers.end);
    });
    regions.update();
}

void floodFromRegions(const Padded<Feature>& features, const RegionDistance& distance, FloodBuffers& buffers,
                      Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    const Size size = labels.size();
    const int step = labels.step();
    std::vector<Point>& seeds = buffers.seeds;
    seeds.clear();
    for (int y = 0; y < size.height; y++)
    {
        const int* row = labels.row(y);
        for (int x = 0; x < size.width; x++)
            if (row[x] >= 0 && (row[x - 1] == UNSEEN || row[x + 1] == UNSEEN ||
                                row[x - step] == UNSEEN || row[x + step] == UNSEEN))
                seeds.push_back(Point(x, y));
    }
    const int NO_RULER = 0;
    buffers.centers.assign(regions.size(), Point());
    prepare(labels, regions, 1, buffers);
    RegionFlood(features, distance, NO_RULER, Range(0, size.height), buffers.bands[0], buffers, labels, regions)
        .run(seeds.data(), seeds.data() + seeds.size());
    regions.update();
}

}}} // namespace
