// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "shared/region_measure.hpp"
#include "shared/label_sums.hpp"

namespace cv { namespace ximgproc { namespace gws {

namespace {

//! Colour and depth of some pixels, as a region sums them up, and squared colours.
struct ColorSum
{
    uint64 channels[4], squares;
    int area, depth_area;

    void add(const ColorSum& s)
    {
        for (int k = 0; k < 4; k++)
            channels[k] += s.channels[k];
        squares += s.squares;
        area += s.area;
        depth_area += s.depth_area;
    }

    RegionSum toRegion() const
    {
        const RegionSum sum = { { int64(channels[0]), int64(channels[1]), int64(channels[2]) }, int64(channels[3]),
                                area, depth_area };
        return sum;
    }
};

inline void addTo(uint64* sums, const v_uint64x2& values) { v_store(sums, add(v_load(sums), values)); }

//! Sums of a few features, four at a time.
class FeatureSums
{
public:
    explicit FeatureSums(const v_uint16x8& weights)
        : weights_(weights), sums_(v_setzero_u16()), squares_(v_setzero_s32())
    {
    }

    void add(const v_uint8x16& features)
    {
        v_uint16x8 pairs[2];
        v_expand(features, pairs[0], pairs[1]);
        for (int k = 0; k < 2; k++)
        {
            const v_int16x8 weighted = v_reinterpret_as_s16(v_mul_wrap(pairs[k], weights_));
            sums_ = v_add_wrap(sums_, pairs[k]);
            squares_ = v_dotprod(weighted, weighted, squares_);
        }
    }

    void addTo(ColorSum& to) const
    {
        v_uint32x4 even, odd;
        v_expand(sums_, even, odd);
        v_uint64x2 first, second;
        v_expand(gws::add(even, odd), first, second);
        gws::addTo(to.channels, first);
        gws::addTo(to.channels + 2, second);
        to.squares += v_reduce_sum(v_reinterpret_as_u32(squares_));
    }

private:
    const v_uint16x8 weights_;
    v_uint16x8 sums_;
    v_int32x4 squares_;
};

enum { AT_ONCE = 16 };

//! Adds the first ones of some features.
inline void addColors(const Feature* features, int count, const v_uint16x8& weights, ColorSum& to)
{
    static const int MASKS[2 * AT_ONCE] = { -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1 };
    const int* masks = MASKS + AT_ONCE - count;
    FeatureSums sums(weights);
    for (int k = 0; k < AT_ONCE; k += 4)
        sums.add(bitAnd(v_load(reinterpret_cast<const uchar*>(features + k)), v_reinterpret_as_u8(v_load(masks + k))));
    sums.addTo(to);
}

//! Adds a run of features. Most are short: so many are read at once, with those behind the end masked, which takes less
//! time than a branch that is not foreseen. `room` features may be read.
void addColors(const Feature* features, int count, int room, const v_uint16x8& weights, ColorSum& to)
{
    for (; count > 0; count -= AT_ONCE, room -= AT_ONCE, features += AT_ONCE)
    {
        if (room >= AT_ONCE)
        {
            addColors(features, std::min<int>(count, AT_ONCE), weights, to);
            continue;
        }
        Feature copies[AT_ONCE] = {};
        std::copy_n(features, room, copies);
        addColors(copies, count, weights, to);
    }
}

int countDepths(const Feature* features, int count)
{
    int with_depth = 0;
    for (int i = 0; i < count; i++)
        with_depth += features[i].depth != 0;
    return with_depth;
}

void addRun(const Feature* features, int count, int room, const v_uint16x8& weights, ColorSum& to)
{
    const uint64 depth = to.channels[3];
    addColors(features, count, room, weights, to);
    to.area += count;
    if (to.channels[3] != depth)
        to.depth_area += countDepths(features, count);
}

} // namespace

void measureRegions(const FeatureMap& features, const Mat& labels, const RegionDistance& distance, Regions& regions,
                    std::vector<int64>& squares)
{
    CV_TRACE_FUNCTION();
    ushort weights[8] = {}; // of two features, for steps
    for (int k = 0; k < 8; k++)
    {
        const int weight = distance.weights[0][k % 4] * STEPS_PER_LEVEL;
        CV_DbgAssert(weight % FULL_WEIGHT == 0 && weight <= STEPS_PER_LEVEL * FULL_WEIGHT); // so squares fit
        weights[k] = ushort(weight / FULL_WEIGHT);
    }
    std::vector<ColorSum> sums(regions.size());
    sumByLabel(labels, [&](ColorSum& sum, int y, const Range& xs)
    {
        addRun(features.row(y) + xs.start, xs.size(), labels.cols - xs.start, v_load(weights), sum);
    }, sums);
    regions.surfaces.present = false;
    regions.resize(regions.size());
    squares.resize(regions.size());
    for (int i = 0; i < regions.size(); i++)
    {
        regions.sums[i] = sums[i].toRegion();
        squares[i] = int64(sums[i].squares);
    }
    if (features.withNormals())
        measureSurfaces(features, labels, regions);
    else
        regions.update();
}

void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions)
{
    std::vector<int64> squares;
    measureRegions(features, labels, RegionDistance(0, 0, 1, false), regions, squares);
}

//! Sums of places and normals fit into 32 bits in a row, whose places are those of 16 bits.
static void addRun(const FeatureMap& features, int y, const Range& xs, SurfaceSum& to)
{
    const Feature* row = features.row(y);
    const Normal* normals = features.normalsOfRow(y);
    int normal_x = 0, normal_y = 0, normal_area = 0, x_sum = 0, count = 0;
    for (int x = xs.start; x < xs.end; x++)
    {
        const Normal& n = normals[x >> features.normal_shift];
        const int has_depth = row[x].depth != 0;
        normal_x += n.x;
        normal_y += n.y;
        normal_area += n.known();
        x_sum += x & -has_depth;
        count += has_depth;
    }
    to.normal_x += normal_x;
    to.normal_y += normal_y;
    to.normal_area += normal_area;
    to.x += x_sum;
    to.y += int64(count) * y;
}

void measureSurfaces(const FeatureMap& features, const Mat& labels, Regions& regions)
{
    CV_TRACE_FUNCTION();
    regions.surfaces.start(features.camera, regions.size());
    sumByLabel(labels, [&](SurfaceSum& sum, int y, const Range& xs) { addRun(features, y, xs, sum); },
               regions.surfaces.sums);
    regions.update();
}

}}} // namespace
