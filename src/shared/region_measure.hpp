// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_REGION_MEASURE_HPP
#define OPENCV_GWATERSHED_REGION_MEASURE_HPP

#include "shared/region_distance.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! How rough a region is: sums of the differences of colour between its pixels and those of it beside them, and those
//! below them, weighted, in 1/16 of a level, in every second row; of blocks, what lies in them. It grows with details,
//! but hardly with shading. And how its colours rise: sums of the same differences with their signs, in 1/256, and the
//! squares of these, which tell a slope from a few edges.
//! @note Sums of floats depend on their order, which is the same for every number of threads.
struct RegionTexture
{
    float rises[3][2]; //!< of each channel, across and down
    float across, down;
    float squares[2][2]; //!< of the rises of lightness, and of both others, 0 where only pixels were measured

    //! The sums of a block.
    void add(const v_float32x4& first, const v_float32x4& last)
    {
        const v_float32x4 last_chroma = v_combine_low(v_setzero_f32(), last);
        add(first, last, gws::add(multiply(first, first), multiply(last_chroma, last_chroma)));
    }
    void add(const RegionTexture& t) { add(v_load(t.rises[0]), v_load(t.rises[2]), v_load(t.squares[0])); }

    //! From levels, with the weights of the channels.
    void scaleRises(const short* weights, float scale)
    {
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 2; i++)
                rises[k][i] *= scale * float(weights[k]);
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < 2; i++)
                squares[k][i] *= scale * scale * float(weights[k] * weights[k]);
    }

private:
    //! What lies side by side.
    void add(const v_float32x4& first, const v_float32x4& last, const v_float32x4& squared)
    {
        v_store(rises[0], gws::add(v_load(rises[0]), first));
        v_store(rises[2], gws::add(v_load(rises[2]), last));
        v_store(squares[0], gws::add(v_load(squares[0]), squared));
    }
};
static_assert(sizeof(RegionTexture) == 48, "it is read as three vectors");

//! Computes sums and means of all regions of a CV_32SC1 label map. Labels below 0 do not count.
void measureRegions(const FeatureMap& features, const Mat& labels, Regions& regions);

//! The same for regions that are to be merged: few depths count, and textures are measured, too.
void measureRegions(const FeatureMap& features, const Mat& labels, const RegionDistance& distance, Regions& regions,
                    std::vector<RegionTexture>& textures);

//! Computes the surfaces of regions whose other sums are known, and all means.
void measureSurfaces(const FeatureMap& features, const Mat& labels, Regions& regions, bool few_depths_count = false);

}}} // namespace

#endif
