// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGIONS_HPP
#define OPENCV_GWATERSHED_REGIONS_HPP

#include "shared/camera.hpp"
#include "shared/features.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Labels of RGWATERSHED while it works: regions are 0..n-1.
enum RegionLabel
{
    UNSEEN = -1,       //!< not reached by any region
    OUTSIDE = INT_MIN  //!< around the image, outside of the mask, or not reached by any marker
};

//! Fixed-point units of means, distances and weights.
static const int STEPS_PER_LEVEL = 16; //!< of the 8-bit grey levels of a feature: means and distances are in these
static const int FULL_WEIGHT = 256;    //!< a weight of 1

//! Means over the pixels of a region, in steps.
struct RegionMean
{
    short color[3];
    short depth; //!< NO_DEPTH if no pixel has depth

    enum { NO_DEPTH = -1 };
};

//! The mean of one pixel.
inline RegionMean meanOf(const Feature& f)
{
    RegionMean mean;
    for (int k = 0; k < 3; k++)
        mean.color[k] = short(STEPS_PER_LEVEL * f.color[k]);
    mean.depth = short(f.depth ? STEPS_PER_LEVEL * f.depth : int(RegionMean::NO_DEPTH));
    return mean;
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

    RegionMean mean() const
    {
        const int64 reciprocal = FIXED_ONE / area;
        RegionMean m;
        for (int k = 0; k < 3; k++)
            m.color[k] = divide(color[k], reciprocal);
        m.depth = depth_area ? divide(depth, FIXED_ONE / depth_area) : short(RegionMean::NO_DEPTH);
        return m;
    }

private:
    static const int64 FIXED_ONE = int64(1) << 48; // STEPS_PER_LEVEL * sum / area * FIXED_ONE fits into 64 bits

    static short divide(int64 sum, int64 reciprocal)
    {
        return short((STEPS_PER_LEVEL * sum * reciprocal + FIXED_ONE / 2) >> 48);
    }
};

//! The surface of a region: its mean normal, and the plane that it lies on, by the depth at its centre and its slopes.
struct SurfaceMean
{
    short x, y;             //!< of the normal, in steps; both 0 if no pixel has one
    short slope_x, slope_y; //!< of depth, in 1/64 of a step
    int center_x, center_y; //!< of the pixels with depth, in 1/16 of an element

    bool known() const { return x != 0; }
};

//! What of the surface is summed up over the pixels of a region.
struct SurfaceSum
{
    int64 normal_x, normal_y, x, y;
    int area; //!< pixels with a normal

    void add(const Feature& f, const Normal& n, Point p, int times = 1)
    {
        normal_x += times * n.x;
        normal_y += times * n.y;
        area += n.known() ? times : 0;
        x += f.depth ? int64(times) * p.x : 0;
        y += f.depth ? int64(times) * p.y : 0;
    }

    void add(const SurfaceSum& s)
    {
        normal_x += s.normal_x;
        normal_y += s.normal_y;
        x += s.x;
        y += s.y;
        area += s.area;
    }

    //! From an element that was divided into 2x2 to the sums over these.
    void divideBlocks(int depth_area)
    {
        normal_x *= 4;
        normal_y *= 4;
        x = 8 * x + 2 * depth_area;
        y = 8 * y + 2 * depth_area;
        area = int(std::min<int64>(4 * int64(area), INT_MAX));
    }

    //! Of a region with some mean depth, in steps.
    SurfaceMean mean(int depth, int depth_area, const Camera& camera) const;
};

//! The mean of a region with its depth at a place on its plane.
inline RegionMean meanAt(const RegionMean& mean, const SurfaceMean& surface, Point p)
{
    const int FARTHEST = 16 * 1023;
    RegionMean at = mean;
    const int dx = std::min(std::max(16 * p.x - surface.center_x, -FARTHEST), FARTHEST);
    const int dy = std::min(std::max(16 * p.y - surface.center_y, -FARTHEST), FARTHEST);
    const int depth = mean.depth + ((surface.slope_x * dx + surface.slope_y * dy) >> 10);
    at.depth = short(mean.depth < 0 ? int(mean.depth) : std::min(std::max(depth, STEPS_PER_LEVEL * 1), STEPS_PER_LEVEL * 255));
    return at;
}

//! The regions of an image. Means are kept apart from the sums because loops over pixels read only them. They
//! change when update() is called.
struct Regions
{
    std::vector<RegionMean> means;
    std::vector<RegionSum> sums;
    std::vector<SurfaceMean> surfaces; //!< these two are empty without normals
    std::vector<SurfaceSum> surface_sums;
    bool with_normals = false;
    Camera camera; //!< of the elements

    int size() const { return int(sums.size()); }
    void resize(int n)
    {
        means.resize(n);
        sums.resize(n);
        surfaces.resize(with_normals ? n : 0);
        surface_sums.resize(surfaces.size());
    }
    void clear(int n)
    {
        resize(n);
        std::fill(surface_sums.begin(), surface_sums.end(), SurfaceSum());
        std::fill(sums.begin(), sums.end(), RegionSum());
    }
    //! From sums over blocks to sums over the 2x2 elements in each block. A block is their mean, so sums become four
    //! times
//! as large.
    void divideBlocks()
    {
        for (size_t i = 0; i < surface_sums.size(); i++)
        {
            surface_sums[i].divideBlocks(sums[i].depth_area);
            surfaces[i].slope_x /= 2;
            surfaces[i].slope_y /= 2;
            surfaces[i].center_x = 2 * surfaces[i].center_x + 8;
            surfaces[i].center_y = 2 * surfaces[i].center_y + 8;
        }
        camera = twice(camera);
        for (int i = 0; i < size(); i++)
        {
            RegionSum& sum = sums[i];
            for (int k = 0; k < 3; k++)
                sum.color[k] *= 4;
            sum.depth *= 4;
            sum.area = int(std::min<int64>(4 * int64(sum.area), INT_MAX)); // less at odd borders
            sum.depth_area = int(std::min<int64>(4 * int64(sum.depth_area), INT_MAX));
        }
    }
    void update(int i)
    {
        means[i] = sums[i].mean();
        if (with_normals)
            surfaces[i] = surface_sums[i].mean(means[i].depth, sums[i].depth_area, camera);
    }
    //! Copies a region to another number.
    void copy(int from, int to)
    {
        means[to] = means[from];
        sums[to] = sums[from];
        if (with_normals)
        {
            surfaces[to] = surfaces[from];
            surface_sums[to] = surface_sums[from];
        }
    }
    //! Adds the pixels of a region to another one.
    void unite(int from, int to)
    {
        sums[to].add(sums[from]);
        if (with_normals)
            surface_sums[to].add(surface_sums[from]);
        update(to);
    }
    void update()
    {
        for (int i = 0; i < size(); i++)
            update(i);
    }
};

//! Computes sums and means of all regions. Labels below 0 do not count.
void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions);

}}} // namespace

#endif
