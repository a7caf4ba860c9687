// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_MERGE_REGION_HPP
#define OPENCV_GWATERSHED_MERGE_REGION_HPP

#include "shared/merge_rules.hpp"
#include "shared/region_measure.hpp"
#include "shared/union_plan.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Units of slopes in a level for each pixel; steeper ones count as the steepest.
enum { SLOPE_OF_LEVEL = 256, STEEPEST_SLOPE = 64 * SLOPE_OF_LEVEL };
//! Differences of slopes that are none where colours shade, in addition to the others; and minus that in both halves of
//! a word, for what shades.
enum { SHADE_ROUNDING = SLOPE_OF_LEVEL * 35 / 100, IS_SHADE = 0x10000 - SHADE_ROUNDING * 0x10001 };
static_assert(short(IS_SHADE & 0xFFFF) == -SHADE_ROUNDING && (IS_SHADE >> 16) == -SHADE_ROUNDING, "in both halves");

//! What the cost of a union reads of a region: two vectors of four words.
struct MergeRegion
{
    short mean[4]; //!< colour, weighted, and depth, as it is, in 1/16 of a level
    float area;
    short slope[2]; //!< of lightness across and down, or where colours shade of all channels, without signs
    short texture;  //!< logarithm of the steps of colour for each pixel
    short direction; //!< logarithm of those across over those down
    float light;    //!< sum of the lightness of its pixels, each of them 16 levels lighter than it is
    int cell;       //!< of the grid of markers, in which the region began, or the part of the plan of unions
    int rough;      //!< steps that are no slope, as far as they count, in the unit of slopes; or IS_SHADE
};
static_assert(sizeof(MergeRegion) == 32, "it is read as two vectors");

//! Logarithms to the base 2 are in 1/LOG_ONE, and linear between the powers of two. The bits of a float are just that:
//! its exponent, plus 127, with 23 bits behind the point.
enum { LOG_ONE_LOG2 = 8, LOG_ONE = 1 << LOG_ONE_LOG2, LOG_SHIFT = 23 - LOG_ONE_LOG2, LOG_BIAS = 127 * LOG_ONE };

//! For value >= 1.
inline int logarithm(float value)
{
    Cv32suf bits;
    bits.f = value;
    return (bits.i >> LOG_SHIFT) - LOG_BIAS;
}

//! The value >= 1 of which this is the logarithm.
inline float powerOfTwo(int logarithm)
{
    Cv32suf bits;
    bits.i = (logarithm + LOG_BIAS) << LOG_SHIFT;
    return bits.f;
}

//! Describes regions as the cost of a union reads them.
class RegionDescriber
{
public:
    //! Textures may be empty: they are not measured. So may the plan: then the cells of the rules count.
    RegionDescriber(const RegionDistance& distance, const MergeRules& rules, const Regions& regions,
                    const std::vector<RegionTexture>& textures, const UnionPlan& plan)
        : distance_(distance), rules_(rules), regions_(regions), textures_(textures), plan_(plan)
    {
    }

    //! Those of some numbers, to their places in the records.
    void describe(const Range& range, std::vector<MergeRegion>& records) const;
    void describe(const std::vector<int>& numbers, std::vector<MergeRegion>& records) const;

private:
    MergeRegion describe(int region) const;
    void describeTexture(int region, MergeRegion& record) const;
    void describeSlope(const RegionTexture& texture, float share, MergeRegion& record) const;

    const RegionDistance& distance_;
    const MergeRules& rules_;
    const Regions& regions_;
    const std::vector<RegionTexture>& textures_;
    const UnionPlan& plan_;
};

}}} // namespace

#endif
