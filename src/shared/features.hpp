// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FEATURES_HPP
#define OPENCV_GWATERSHED_FEATURES_HPP

#include "shared/camera.hpp"
#include "shared/padded.hpp"
#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Fixed-point units of means, distances and weights. Everywhere, a shift by NAME_LOG2 multiplies or divides by NAME.
static const int STEPS_PER_LEVEL_LOG2 = 4, FULL_WEIGHT_LOG2 = 8;
static const int STEPS_PER_LEVEL = 1 << STEPS_PER_LEVEL_LOG2; //!< of the 8-bit grey levels of a feature: the unit of
                                                              //!< means and distances
static const int FULL_WEIGHT = 1 << FULL_WEIGHT_LOG2;         //!< a weight of 1

//! A pixel, or a block of pixels, as RGWATERSHED compares it: lightness and two colour differences
//! of an opponent space, and scaled depth, 0 if missing.
struct Feature
{
    uchar color[3];
    uchar depth;
};

//! Features at four positions.
inline v_uint8x16 gather(const Feature* features, const int* at)
{
    return loadFour(features[at[0]], features[at[1]], features[at[2]], features[at[3]]);
}

//! Direction of the surface at a pixel, or of a block: x and y of its unit normal in the axes of the camera, 1..255 for
//! -1..1; both 0 if it is not known.
struct Normal
{
    uchar x, y;

    enum { ZERO = 128, ONE = 127 };
    bool known() const { return x != 0; }
};

//! Normals with their number, in the parts of a word: up to 16 of them are added up at once.
//! @note Halves of a level are exact in the quotients, so they are rounded as they are in integers.
struct NormalSum
{
    enum { Y_SHIFT = 12, COUNT_SHIFT = 24, PART = (1 << 12) - 1 };

    //! Of the four normals that begin at one.
    static v_int32x4 of(const Normal* n)
    {
        const v_uint32x4 words = v_load_expand(reinterpret_cast<const ushort*>(n)), first = v_setall_u32(1);
        const v_uint8x16 known = v_min(v_reinterpret_as_u8(words), v_reinterpret_as_u8(first));
        const v_uint32x4 x = bitAnd(words, v_setall_u32(255)), y = v_shl<Y_SHIFT>(v_shr<8>(words));
        const v_uint32x4 counts = v_shl<COUNT_SHIFT>(v_reinterpret_as_u32(known));
        return v_reinterpret_as_s32(add(add(x, y), counts));
    }

    //! The means of those that are known, of four sums.
    static void mean(const v_int32x4& sums, Normal* to)
    {
        const v_float32x4 counts = v_max(v_cvt_f32(v_shr<COUNT_SHIFT>(sums)), v_setall_f32(1));
        const v_int32x4 part = v_setall_s32(PART);
        const v_int32x4 x = divide(bitAnd(sums, part), counts), y = divide(bitAnd(v_shr<Y_SHIFT>(sums), part), counts);
        const v_int32x4 pairs = v_shr<16>(add(v_shl<16>(x), v_shl<24>(y))); // as signed numbers
        v_store_low(reinterpret_cast<short*>(to), v_pack(pairs, pairs));
    }

private:
    static v_int32x4 divide(const v_int32x4& sums, const v_float32x4& counts)
    {
        return v_trunc(add(v_setall_f32(0.5f), gws::divide(v_cvt_f32(sums), counts)));
    }
};

//! Features of the pixels of an image, or of the blocks of a level, and beside them their normals, if there are any.
//! Normals change slowly, so pixels have those of blocks of 2x2.
struct FeatureMap : Padded<Feature>
{
    Mat normals;          //!< CV_8UC2, as Normal; empty if there are none
    int normal_shift = 0; //!< an element of normals is that of 2^normal_shift elements, along both axes
    Camera camera;        //!< of the normals, in elements of this map

    bool withNormals() const { return !normals.empty(); }
    const Normal* normalsOfRow(int y) const { return normals.ptr<Normal>(y >> normal_shift); }
    const Normal& normalAt(Point p) const { return normalsOfRow(p.y)[p.x >> normal_shift]; }
};

//! Features of some rows of pixels of 1, 3 or 4 channels; depth may be empty. If lab_input is false, colours are BGR
//! and become those of the opponent space.
void makeFeatures(const Mat& color, const Mat& depth, bool lab_input, const Range& rows, Padded<Feature>& features);

}}} // namespace

#endif
