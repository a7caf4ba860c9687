// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/merge_region.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Of all channels, without a sign.
static int riseOfColors(int lightness, int chroma, int other_chroma, float weight)
{
    const int64 x = lightness, y = cvRound(weight * float(chroma)), z = cvRound(weight * float(other_chroma));
    return std::min(cvRound(std::sqrt(double(x * x + y * y + z * z))), int(STEEPEST_SLOPE));
}

//! Steps are divided by pixels, not by their own number. So a narrow region, with few of them, counts as a smooth one.
void RegionDescriber::describeTexture(int region, MergeRegion& record) const
{
    const float FINE = STEPS_PER_LEVEL, FLAT = FINE / 2; // for each pixel; less is like none
    const RegionTexture& texture = textures_[region];
    const float area = float(regions_.sums[region].area), steps = texture.across + texture.down;
    record.texture = short(logarithm(steps + FINE * area) - logarithm(area));
    record.direction = short(logarithm(texture.across + FLAT * area) - logarithm(texture.down + FLAT * area));
    describeSlope(texture, 1 / area, record);
}

//! How unlike the rises of some channels are in the blocks of a region, squared, less what is even: on a slope all of
//! them rise alike, at an edge a few rise much.
static float unevennessOf(const float* squares, const float (*rises)[2], int num_channels, float share, float even)
{
    float sum = (squares[0] + squares[1]) * share - even * even;
    for (int k = 0; k < num_channels; k++)
        for (int i = 0; i < 2; i++)
            sum -= rises[k][i] * rises[k][i] * share * share;
    return std::max(sum, 0.f);
}

//! Steps that are no slope go up and down, or are of the other channels: noise, as far as they are small. Where nearly
//! all steps are one slope of all channels, this is that of the region, and it has no roughness. So it is, as far as
//! blocks rise alike, where chroma rises among noise. Chroma that rises much for each pixel is an edge or a pattern.
void RegionDescriber::describeSlope(const RegionTexture& texture, float share, MergeRegion& record) const
{
    const float LEVEL = SLOPE_OF_LEVEL;
    int rises[3][2], light = 0, chroma = 0;
    float squared_chroma = 0;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
        {
            rises[k][i] = cvRound(texture.rises[k][i] * share);
            (k == 0 ? light : chroma) += std::abs(rises[k][i]);
            squared_chroma += k == 0 ? 0.f : float(rises[k][i]) * float(rises[k][i]);
        }
    const int others = cvRound((texture.across + texture.down) * share * LEVEL / STEPS_PER_LEVEL) - light;
    const float uneven_light = unevennessOf(texture.squares[0], texture.rises, 1, share, 0.35f * LEVEL);
    const float uneven = uneven_light + unevennessOf(texture.squares[1], texture.rises + 1, 2, share, 0.4f * LEVEL);
    const bool is_clean = (others - chroma - cvRound(rules_.uneven * LEVEL)) * 20 <= chroma;
    const bool is_ramp = is_clean && chroma < 3 * SLOPE_OF_LEVEL;
    const bool are_blocks = texture.squares[1][0] + texture.squares[1][1] > 0;
    const bool are_alike = are_blocks && uneven < squared_chroma && 2 * chroma > light;
    const bool is_noisy_ramp = are_alike && 4 * chroma < 5 * SLOPE_OF_LEVEL;
    const bool is_shade = (is_ramp || is_noisy_ramp) && chroma > SLOPE_OF_LEVEL / 10;
    const float part = is_shade && !is_ramp ? std::sqrt(1 - uneven / squared_chroma) : 1;
    for (int i = 0; i < 2; i++)
        record.slope[i] = short(!is_shade ? rises[0][i] : cvRound(
                part * float(riseOfColors(rises[0][i], rises[1][i], rises[2][i], rules_.chroma_slope))));
    const int noise = std::max(others - cvRound(rules_.grain * LEVEL), 0) * rules_.roughness / 64;
    const float rough = std::sqrt(float(noise) * float(noise) + uneven_light);
    record.rough = is_shade ? int(IS_SHADE) : cvRound(std::min(rough, float(STEEPEST_SLOPE)));
}

MergeRegion RegionDescriber::describe(int region) const
{
    const RegionMean& mean = regions_.means[region];
    const RegionSum& sum = regions_.sums[region];
    const float scale = rules_.on_surface && mean.depth != RegionMean::NO_DEPTH
            ? areaScale(mean.depth, regions_.surfaces.camera) : 1.f;
    const float area = float(sum.area) * scale;
    MergeRegion record = { { 0, 0, 0, mean.depth }, area, { 0, 0 },
                           0, 0, float(sum.color[0] + 16 * int64(sum.area)) * scale,
                           plan_.parts.empty() ? region / rules_.in_cell : plan_.parts[region], 0 };
    for (int k = 0; k < 3; k++)
        record.mean[k] = short((distance_.weights[0][k] * mean.color[k]) >> FULL_WEIGHT_LOG2);
    if (!textures_.empty())
        describeTexture(region, record);
    return record;
}

void RegionDescriber::describe(const Range& range, std::vector<MergeRegion>& records) const
{
    for (int i = range.start; i < range.end; i++)
        records[i] = describe(i);
}

void RegionDescriber::describe(const std::vector<int>& numbers, std::vector<MergeRegion>& records) const
{
    for (int i : numbers)
        records[i] = describe(i);
}

}}} // namespace
