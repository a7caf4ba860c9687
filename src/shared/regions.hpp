// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGIONS_HPP
#define OPENCV_GWATERSHED_REGIONS_HPP

#include "shared/surfaces.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Means over the pixels of a region, in steps.
struct RegionMean
{
    short color[3];
    short depth; //!< NO_DEPTH if no pixel has one; after Regions::update() mostly also if !hasDepth()

    enum { NO_DEPTH = -1 };
};

//! The unit of reciprocals: STEPS_PER_LEVEL * sum / area * FIXED_ONE fits into 64 bits.
static const int FIXED_ONE_LOG2 = 48;
static const int64 FIXED_ONE = int64(1) << FIXED_ONE_LOG2;

//! FIXED_ONE over the areas that most regions have while they are flooded: everything waits for a division there.
struct Reciprocals
{
    Reciprocals();

    enum { COUNT = 256 };
    int64 of[COUNT]; //!< that of 0 is 0
};

inline const Reciprocals& reciprocals()
{
    static const Reciprocals table;
    return table;
}

inline int64 reciprocalOf(int area)
{
    return area < Reciprocals::COUNT ? reciprocals().of[area] : int64(double(FIXED_ONE) / area);
}

//! Sums over the pixels of a region.
struct RegionSum
{
    int64 color[3], depth;
    int area, depth_area; //!< pixels, and pixels with depth

    //! Adds a pixel, or removes it if times is -1.
    void add(const Feature& f, int times = 1)
    {
        for (int k = 0; k < 3; k++)
            color[k] += int64(times) * f.color[k];
        depth += int64(times) * f.depth;
        depth_area += f.depth ? times : 0;
        area += times;
    }

    void add(const RegionSum& r)
    {
        for (int k = 0; k < 3; k++)
            color[k] += r.color[k];
        depth += r.depth;
        depth_area += r.depth_area;
        area += r.area;
    }

    //! Whether enough pixels have depth, as one in 2x2: a few, at an edge of what has it, do not tell that of a region.
    bool hasDepth() const { return depth_area > 0 && 4 * int64(depth_area) >= area; }

    RegionMean mean() const
    {
        const int64 reciprocal = reciprocalOf(area);
        RegionMean m;
        for (int k = 0; k < 3; k++)
            m.color[k] = multiply(color[k], reciprocal);
        m.depth = depth_area ? multiply(depth, reciprocalOf(depth_area)) : short(RegionMean::NO_DEPTH);
        return m;
    }

private:
    static short multiply(int64 sum, int64 reciprocal)
    {
        return short((STEPS_PER_LEVEL * sum * reciprocal + FIXED_ONE / 2) >> FIXED_ONE_LOG2);
    }
};

//! The regions of an image. Means are kept apart from the sums because loops over pixels read only them. They
//! change when update() is called.
struct Regions
{
    std::vector<RegionMean> means;
    std::vector<RegionSum> sums;
    RegionSurfaces surfaces;

    int size() const { return int(sums.size()); }
    void resize(int n)
    {
        means.resize(n);
        sums.resize(n);
        surfaces.resize(n);
    }
    //! From sums over blocks to sums over what they are made of, side x side elements for each block. A block is their
    //! mean, so sums become so many times as large.
    void divideBlocks(int side);
    //! Copies a region to another number.
    void copy(int from, int to);
    //! Adds the pixels of a region to those of another one, whose means stay as they are.
    void unite(int from, int to);
    //! Takes the means of some regions anew. If few depths count, they are the depth of their region even where
    //! hasDepth() says that they are not enough.
    void update(const std::vector<int>& numbers, bool few_depths_count = false);
    void update(const Range& range, bool few_depths_count = false);
    void update(bool few_depths_count = false) { update(Range(0, size()), few_depths_count); }

private:
    template <typename NumberOf> void updateAll(int count, const NumberOf& numberOf, bool few_depths_count);
};

}}} // namespace

#endif
