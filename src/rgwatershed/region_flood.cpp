// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/region_flood.hpp"
#include "rgwatershed/flood_priority.hpp"
#include "rgwatershed/region_labels.hpp"
#include "shared/region_measure.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! The flood of some rows; nothing crosses to others.
template <bool WITH_DEPTH> class RegionFlood
{
public:
    RegionFlood(const Padded<Feature>& features, const RegionDistance& distance, int ruler, int usual_area,
                const Range& rows, std::vector<FloodRegion>& regions, FloodBuffers::Front& front, Padded<int>& labels)
        : features_(features.data()), regions_(regions.data()), labels_(labels),
          priorities_of_(distance, ruler), usual_area_(usual_area), step_(labels.step()), offsets_(labels.neighbors()),
          first_(labels.index(Point(-1, rows.start - 1))), begin_(labels.index(Point(0, rows.start))),
          last_(labels.index(Point(labels.size().width - 1, rows.end - 1))), queues_(front.queues),
          waiting_(front.waiting)
    {
        queues_.clear();
        waiting_.assign(size_t(step_) * (rows.size() + 2), short(CLOSED));
        for (int y = rows.start; y < rows.end; y++)
        {
            const int* row = labels.row(y);
            short* waiting = &waiting_[labels.index(Point(0, y)) - first_];
            for (int x = 0; x < labels.size().width; x++)
                waiting[x] = short(row[x] == UNSEEN ? NOT_WAITING : CLOSED);
        }
    }

    //! Invariant: a block may wait several times, each time at a lower priority, and its label is the region
    //! that offered it; when it is first taken out, the last offer stands, and the block is closed.
    //! No priority lies below the one being flooded, and equal priorities keep their order,
    //! so the result depends on the order of the markers and nothing else.
    void run(const Point* first_seed, const Point* end_seed)
    {
        for (const Point* seed = first_seed; seed != end_seed; seed++)
            spread(labels_.index(*seed), *seed);
        int batch[FloodBuffers::Queue::CHUNK];
        while (const int count = queues_.take(batch))
        {
            int num_open = 0;
            for (int i = 0; i < count; i++) // others were taken out at a lower priority before
            {
                batch[num_open] = batch[i];
                num_open += waiting_[batch[i] - first_] != CLOSED;
            }
            for (int i = 0; i < num_open; i++)
            {
                const int block = batch[i];
                const Point p = labels_.point(block);
                if (WITH_DEPTH)
                    regions_[labels_.data()[block]].add(features_[block], p);
                else
                    regions_[labels_.data()[block]].add(features_[block]);
                spread(block, p);
            }
        }
    }

private:
    enum { CLOSED = -1, NOT_WAITING = FloodBuffers::Queue::NEVER };

    //! A region that holds both colours of a pattern is nearer to all blocks than others, which wait for their first
    //! block of the other colour. So it must not grow without end.
    int excessOf(const FloodRegion& region) const
    {
        const int LEVELS_PER_BLOCK = 32, MOST = FloodBuffers::PRIORITIES >> PRIORITIES_PER_LEVEL_LOG2;
        return std::min(std::max(region.sum.area - usual_area_, 0), MOST / LEVELS_PER_BLOCK) * LEVELS_PER_BLOCK;
    }

    //! Offers the neighbours of a block at p to its region, where none offers as much.
    void spread(int block, Point p)
    {
        const int label = labels_.data()[block];
        const FloodRegion& region = regions_[label];
        short* waiting = &waiting_[block - first_];
        const v_int16x8 before(waiting[-1], waiting[-step_], waiting[1], waiting[step_], 0, 0, 0, 0);
        const Feature* const at = features_ + block;
        const v_uint8x16 neighbors = loadFour(at[-1], at[-step_], at[1], at[step_]);
        const v_int16x8 limited = v_min(priorities_of_(neighbors, region, p, excessOf(region)),
                                        v_setall_s16(FloodBuffers::PRIORITIES - 1));
        const v_int16x8 offered = v_max(limited, v_setall_s16(short(queues_.priority())));
        // What waits for this region already, whose mean was another one, goes on waiting. Beside these rows nothing
        // waits, and other threads write labels: any of these rows stands for it.
        const int upper = std::max(block - step_, begin_), below = std::min(block + step_, last_);
        const int* const all = labels_.data();
        const v_int32x4 ours = equal(v_int32x4(all[block - 1], all[upper], all[block + 1], all[below]),
                                     v_setall_s32(label));
        const v_int16x8 lower = bitAnd(v_sub_wrap(offered, before), equal(v_pack(ours, ours), v_setzero_s16()));
        // Without branches, which cannot be foreseen: the block itself stands for the other neighbours.
        const v_int16x8 is_lower = v_shr<15>(lower);
        v_int32x4 is_lower_low, is_lower_high;
        v_expand(is_lower, is_lower_low, is_lower_high);
        short priorities[8];
        int to[4];
        v_store(priorities, v_select(is_lower, offered, v_setall_s16(short(NOT_WAITING))));
        v_store(to, bitAnd(is_lower_low, v_load(offsets_.val)));
        for (int k = 0; k < 4; k++)
        {
            labels_.data()[block + to[k]] = label;
            waiting[to[k]] = priorities[k];
            queues_.push(block + to[k], priorities[k]);
        }
        queues_.drop();
        waiting[0] = CLOSED;
    }

    const Feature* features_;
    FloodRegion* regions_;
    Padded<int>& labels_;
    const NeighborPriorities<WITH_DEPTH> priorities_of_;
    const int usual_area_, step_;
    const Vec4i offsets_; // of the neighbours
    const int first_, begin_, last_; // indices: of the rows with their frame, and without it
    FloodBuffers::Queue& queues_;
    std::vector<short>& waiting_; // priorities of the blocks that wait, CLOSED around the rows
};

} // namespace

//! Floods some rows from seeds, by regions that are ready in the buffers.
static void floodRows(const Padded<Feature>& features, const RegionDistance& distance, int ruler, int usual_area,
                      const Range& rows, const Point* first_seed, const Point* end_seed, FloodBuffers& buffers,
                      FloodBuffers::Front& front, Padded<int>& labels)
{
    if (distance.with_depth)
        RegionFlood<true>(features, distance, ruler, usual_area, rows, buffers.regions, front, labels)
            .run(first_seed, end_seed);
    else
        RegionFlood<false>(features, distance, ruler, usual_area, rows, buffers.regions, front, labels)
            .run(first_seed, end_seed);
}

//! Slopes of depth by the normals at the places of some markers, where flooding begins.
static void findSlopes(const FeatureMap& features, const Point* markers, int n, FloodRegion* regions)
{
    std::vector<SurfaceSum> sums(n);
    SurfaceSolver(features.camera).solveAll(n, [&](int i) -> SurfaceSolver::Source
    {
        const Point p = markers[i];
        const Feature& feature = features.row(p.y)[p.x];
        sums[i] = SurfaceSum();
        sums[i].add(feature, features.normalAt(p), p);
        return { &sums[i], STEPS_PER_LEVEL * feature.depth, feature.depth != 0 };
    }, [&](int i, const SurfaceMean& mean) { regions[i].slope = Point(mean.slope_x, mean.slope_y); });
}

//! Adds up the surfaces of regions over some rows that hold no part of what others add up. measureSurfaces(), after the
//! flood, would do, but that takes a hundredth of all time with depth.
static void addSurfaces(const FeatureMap& features, const Padded<int>& labels, const Range& rows, SurfaceSum* sums)
{
    for (int y = rows.start; y < rows.end; y++)
    {
        const int *row = labels.row(y), width = labels.size().width, shift = features.normal_shift;
        const Feature* elements = features.row(y);
        const Normal* normals = features.normalsOfRow(y);
        for (int x = 0; x < width; x++)
            if (row[x] >= 0)
                sums[row[x]].add(elements[x], normals[x >> shift], Point(x, y));
    }
}

//! Each marker becomes a region of one element: those of a band, whose first one has a number.
static void plantMarkers(const FeatureMap& features, const std::vector<Point>& markers,
                         const std::vector<Point>& middles, const Range& own, int first, Padded<int>& labels,
                         FloodRegion* regions)
{
    for (int m = own.start; m < own.end; m++)
    {
        const int seed = labels.index(markers[m]), region = first + m - own.start;
        labels.data()[seed] = region;
        regions[region] = FloodRegion(RegionSum(), markers[m], middles.empty() ? 2 * markers[m] : middles[m]);
        regions[region].add(features.data()[seed]);
    }
    if (features.withNormals())
        findSlopes(features, markers.data() + own.start, own.size(), regions + first);
}

//! What the flood found of some regions, which lie in some rows.
static void takeSums(const FeatureMap& features, const std::vector<FloodRegion>& flooded, const Range& numbers,
                     const Range& rows, const Padded<int>& labels, Regions& regions)
{
    for (int i = numbers.start; i < numbers.end; i++)
        regions.sums[i] = flooded[i].sum;
    if (features.withNormals())
        addSurfaces(features, labels, rows, regions.surfaces.sums.data());
    regions.update(numbers);
}

//! @note Section III.B with a region in the place of the neighbour: the priority of a pixel is its
//! distance to the mean of the region that reaches it, plus its distance to the marker.
void floodFromPoints(const FeatureMap& features, const std::vector<Point>& markers, const std::vector<Point>& middles,
                     const std::vector<MarkerBand>& bands, const RegionDistance& distance, int ruler, int usual_area,
                     FloodBuffers& buffers, Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    const int first = regions.size();
    regions.resize(first + int(markers.size()));
    if (features.withNormals())
        regions.surfaces.start(features.camera, regions.size());
    buffers.regions.resize(regions.size());
    const int num_bands = int(bands.size()), num_groups = std::min<int>(num_bands, FloodBuffers::MOST_GROUPS);
    const auto firstOf = [&](int group) { return int(int64(num_bands) * group / num_groups); };
    buffers.fronts.resize(num_groups);
    parallel_for_(Range(0, num_groups), [&](const Range& groups)
    {
        for (int i = firstOf(groups.start); i < firstOf(groups.end); i++)
        {
            const Range &own = bands[i].markers, numbers(first + own.start, first + own.end);
            plantMarkers(features, markers, middles, own, numbers.start, labels, buffers.regions.data());
            floodRows(features, distance, ruler, usual_area, bands[i].rows, markers.data() + own.start,
                      markers.data() + own.end, buffers, buffers.fronts[groups.start], labels);
            takeSums(features, buffers.regions, numbers, bands[i].rows, labels, regions);
        }
    });
    regions.update(Range(0, first));
}

//! Twice the centres of regions.
static std::vector<Point> findMiddles(const Padded<int>& labels, const Regions& regions)
{
    std::vector<Vec2d> sums(regions.size(), Vec2d::all(0)); // of integers, so they are exact
    for (int y = 0; y < labels.size().height; y++)
    {
        const int* row = labels.row(y);
        for (int x = 0; x < labels.size().width; x++)
            if (row[x] >= 0)
                sums[row[x]] += Vec2d(2 * x, 2 * y);
    }
    std::vector<Point> middles(regions.size());
    for (int i = 0; i < regions.size(); i++)
        middles[i] = Point(cvRound(sums[i][0] / regions.sums[i].area), cvRound(sums[i][1] / regions.sums[i].area));
    return middles;
}

//! The elements of regions beside those that no region has reached.
static void findSeeds(const Padded<int>& labels, std::vector<Point>& seeds)
{
    const Size size = labels.size();
    const int step = labels.step();
    seeds.clear();
    for (int y = 0; y < size.height; y++)
    {
        const int* row = labels.row(y);
        for (int x = 0; x < size.width; x++)
            if (row[x] >= 0 && (row[x - 1] == UNSEEN || row[x + 1] == UNSEEN ||
                                row[x - step] == UNSEEN || row[x + step] == UNSEEN))
                seeds.push_back(Point(x, y));
    }
}

void floodFromRegions(const FeatureMap& features, const RegionDistance& distance, int ruler, FloodBuffers& buffers,
                      Padded<int>& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    const int ANY_AREA = INT_MAX;
    std::vector<Point>& seeds = buffers.seeds;
    findSeeds(labels, seeds);
    const std::vector<Point> middles = ruler > 0 ? findMiddles(labels, regions) : std::vector<Point>(regions.size());
    buffers.regions.resize(regions.size());
    buffers.fronts.resize(1);
    for (int i = 0; i < regions.size(); i++)
        buffers.regions[i] = FloodRegion(regions.sums[i], Point(), middles[i]);
    floodRows(features, distance, ruler, ANY_AREA, Range(0, labels.size().height), seeds.data(),
              seeds.data() + seeds.size(), buffers, buffers.fronts[0], labels);
    if (features.withNormals())
    {
        measureRegions(features, labels.view(), regions); // sums over blocks count the depths that blocks lack, too
        return;
    }
    for (int i = 0; i < regions.size(); i++)
        regions.sums[i] = buffers.regions[i].sum;
    regions.update();
}

}}} // namespace
