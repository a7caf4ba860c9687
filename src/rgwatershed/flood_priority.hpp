// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FLOOD_PRIORITY_HPP
#define OPENCV_GWATERSHED_FLOOD_PRIORITY_HPP

#include "rgwatershed/flood_region.hpp"
#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Priorities are in quarters of a level.
enum { PRIORITIES_PER_LEVEL_LOG2 = 2 };

//! Priorities of the four neighbours of a block: their distances to the mean of the region that reaches them, and to
//! its marker. The latter are found without a root, from the components of a vector, within 4 percent.
template <bool WITH_DEPTH> class NeighborPriorities
{
public:
    NeighborPriorities(const RegionDistance& distance, int ruler)
        : longer_(v_setall_s16(weigh(ruler, 9))), both_(v_setall_s16(weigh(ruler, 13))) // for half a block
    {
        const short (*w)[4] = distance.weights;
        for (int k = 0; k < 1 + WITH_DEPTH; k++)
        {
            even_[k] = setPair(w[k][0], w[k][2]);
            odd_[k] = setPair(w[k][1], w[k][3]);
        }
    }

    //! features: of left, top, right and bottom; at: the place of the block; excess: levels that are added.
    v_int16x8 operator()(const v_uint8x16& features, const FloodRegion& region, Point at, int excess) const
    {
        const Point offset = region.middle - 2 * at;
        const v_uint16x8 bytes = v_reinterpret_as_u16(features);
        const v_int16x8 even = v_reinterpret_as_s16(v_shr<8 - STEPS_PER_LEVEL_LOG2>(v_shl<8>(bytes))); // in steps
        const v_int16x8 odd = v_reinterpret_as_s16(v_shl<STEPS_PER_LEVEL_LOG2>(v_shr<8>(bytes)));
        const v_int16x8 even_away = difference(even, setPair(region.means[0], region.means[1]));
        const v_int16x8 odd_away = difference(odd, setPair(region.means[2], region.means[3]));
        const v_int32x4 least = v_setall_s32(excess << LEVEL_LOG2);
        v_int32x4 away = v_dotprod(odd_away, odd_[0], v_dotprod(even_away, even_[0], least));
        if (WITH_DEPTH && region.sum.depth_area > 0)
        {
            const v_int32x4 depth = v_reinterpret_as_s32(v_shr<24>(v_reinterpret_as_u32(features)));
            const v_int32x4 has_depth = isPositive(depth);
            const v_int16x8 odd_away_too = difference(odd, pairsWithDepth(region, at));
            const v_int32x4 with_depth = v_dotprod(odd_away_too, odd_[1], v_dotprod(even_away, even_[1], least));
            away = add(away, bitAnd(subtract(with_depth, away), has_depth));
        }
        const v_int32x4 offsets(offset.x, offset.y, offset.x, offset.y), turned(offset.y, offset.x, offset.y, offset.x);
        const v_int16x8 v = difference(limit(offsets), v_int16x8(-2, 0, 0, -2, 2, 0, 0, 2));
        const v_int16x8 swapped = difference(limit(turned), v_int16x8(0, -2, -2, 0, 0, 2, 2, 0));
        away = v_dotprod(v, both_, v_dotprod(v_max(v, swapped), longer_, away));
        const v_int32x4 priorities = v_shr<LEVEL_LOG2 - PRIORITIES_PER_LEVEL_LOG2>(away);
        return v_pack(priorities, priorities);
    }

private:
    enum { LEVEL_LOG2 = STEPS_PER_LEVEL_LOG2 + FULL_WEIGHT_LOG2 }; // weighted steps in a level
    enum { FARTHEST = 8000 }; // in halves of blocks, so that sums fit into 32 bits

    static short weigh(int ruler, int part) { return short(std::min(int64(ruler) * part / 64, int64(SHRT_MAX))); }

    static v_int16x8 setPair(short a, short b)
    {
        return v_reinterpret_as_s16(v_setall_u32(ushort(a) | unsigned(ushort(b)) << 16));
    }

    //! As pairs of 16 bits.
    static v_int16x8 limit(const v_int32x4& offsets)
    {
        return v_min(v_max(v_pack(offsets, offsets), v_setall_s16(-FARTHEST)), v_setall_s16(FARTHEST));
    }

    //! The means of the odd channels for the four neighbours, whose depths lie on the plane of the region.
    static v_int16x8 pairsWithDepth(const FloodRegion& region, Point at)
    {
        const int UNIT = SurfaceMean::PLANE_UNIT, depth = region.depthAt(at);
        const int dx = region.slope.x / UNIT, dy = region.slope.y / UNIT;
        const short color = region.means[2];
        return v_int16x8(color, short(depth - dx), color, short(depth - dy), color, short(depth + dx), color,
                         short(depth + dy));
    }

    v_int16x8 even_[2], odd_[2];      // weights of the channels 0 and 2, and 1 and 3, without depth and with it
    const v_int16x8 longer_, both_; // of the longer component, and of each
};

}}} // namespace

#endif
