// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SURFACES_HPP
#define OPENCV_GWATERSHED_SURFACES_HPP

#include "shared/features.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The surface of a region: its mean normal, and the plane with this normal through the centre of its pixels. On a
//! plane nearness is an affine function of the place.
struct SurfaceMean
{
    short x, y;             //!< of the normal, in steps; both 0 if no pixel has one
    short slope_x, slope_y; //!< of depth, in 1/PLANE_UNIT of a step for an element
    int base;               //!< depth of the plane at (0, 0), in the same unit
    Point center;           //!< of the pixels with depth, in 1/CENTER_UNIT of an element

    enum { PLANE_UNIT_LOG2 = 6, PLANE_UNIT = 1 << PLANE_UNIT_LOG2 };
    enum { CENTER_UNIT_LOG2 = 4, CENTER_UNIT = 1 << CENTER_UNIT_LOG2 };
    enum { LOWEST_DEPTH = STEPS_PER_LEVEL, HIGHEST_DEPTH = 255 * STEPS_PER_LEVEL };

    bool known() const { return x != 0; }

    //! Puts the plane through a depth, in steps, at the centre.
    void setDepth(int depth)
    {
        const int64 rise = int64(slope_x) * center.x + int64(slope_y) * center.y;
        base = PLANE_UNIT * depth - int(rise / CENTER_UNIT);
    }

    //! From blocks to the side x side elements in each.
    void divideBlocks(int side, int depth);

    //! The depth of the plane, in steps.
    int depthAt(int at_x, int at_y) const
    {
        return limit((base + slope_x * at_x + slope_y * at_y) >> PLANE_UNIT_LOG2);
    }

    //! Nearness ends at 1 and 255, and so do planes.
    static int limit(int depth) { return std::min(std::max(depth, int(LOWEST_DEPTH)), int(HIGHEST_DEPTH)); }
    static v_int16x8 limit(const v_int16x8& depths)
    {
        return v_min(v_max(depths, v_setall_s16(LOWEST_DEPTH)), v_setall_s16(HIGHEST_DEPTH));
    }
};

//! How much larger the surface is that an element at some depth, in steps, stands for than one at the near end.
float areaScale(int depth, const Camera& camera);

//! What of the surface is summed up over the pixels of a region.
struct SurfaceSum
{
    int64 normal_x, normal_y;
    int64 x, y;      //!< of the pixels with depth
    int normal_area; //!< pixels with a normal

    //! Adds a pixel, or removes it if times is -1.
    void add(const Feature& f, const Normal& n, Point p, int times = 1)
    {
        normal_x += times * n.x;
        normal_y += times * n.y;
        normal_area += n.known() ? times : 0;
        x += f.depth ? int64(times) * p.x : 0;
        y += f.depth ? int64(times) * p.y : 0;
    }

    void add(const SurfaceSum& s)
    {
        normal_x += s.normal_x;
        normal_y += s.normal_y;
        normal_area += s.normal_area;
        x += s.x;
        y += s.y;
    }

    //! From blocks to the side x side elements in each. depth_area is that of the blocks.
    void divideBlocks(int side, int depth_area);
};

//! Finds the means of surfaces from their sums, four at once.
class SurfaceSolver
{
public:
    explicit SurfaceSolver(const Camera& camera);

    //! What a surface is found from. depth is the mean of the pixels that have it, in steps.
    struct Source
    {
        const SurfaceSum* sum;
        int depth, depth_area;
    };

    //! Calls give(i, mean) with the mean of sourceOf(i), for 0..count-1.
    template <typename SourceOf, typename Give>
    void solveAll(int count, const SourceOf& sourceOf, const Give& give) const
    {
        for (int first = 0; first < count; first += 4)
        {
            Source sources[4];
            SurfaceMean means[4];
            for (int k = 0; k < 4; k++)
                sources[k] = sourceOf(std::min(first + k, count - 1));
            solve(sources, means);
            for (int k = 0; k < std::min(count - first, 4); k++)
                give(first + k, means[k]);
        }
    }

private:
    void solve(const Source* sources, SurfaceMean* means) const;

    const int horizon_;         // in steps
    const int axis_x_, axis_y_; // where the optical axis is, as centres are
    const Point2f per_focal_;   // one over the focal length
};

//! The surfaces of regions, if there are normals.
struct RegionSurfaces
{
    bool present = false;
    Camera camera; //!< of the elements
    std::vector<SurfaceMean> means;
    std::vector<SurfaceSum> sums;

    //! Surfaces of n regions with no pixels.
    void start(const Camera& camera_, int n)
    {
        present = true;
        camera = camera_;
        means.resize(n);
        sums.assign(n, SurfaceSum());
    }
    void resize(int n)
    {
        means.resize(present ? n : 0);
        sums.resize(means.size());
    }
};

}}} // namespace

#endif
