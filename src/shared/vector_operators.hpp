// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_VECTOR_OPERATORS_HPP
#define OPENCV_GWATERSHED_VECTOR_OPERATORS_HPP

#include "precomp.hpp"
#include <opencv2/core/hal/intrin.hpp>

#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
#error "gwatershed reads features and pairs of numbers in little-endian order; on this processor labels would be wrong"
#endif

namespace cv { namespace ximgproc { namespace gws {

//! @file Depending on its version, OpenCV has functions or operators for these operations on vectors. The function is
//! taken where there is one.

template <typename V> inline auto chooseAnd(const V& a, const V& b, int) -> decltype(v_and(a, b))
{
    return v_and(a, b);
}
template <typename V> inline V chooseAnd(const V& a, const V& b, long) { return a & b; }

template <typename V> inline auto chooseSub(const V& a, const V& b, int) -> decltype(v_sub(a, b))
{
    return v_sub(a, b);
}
template <typename V> inline V chooseSub(const V& a, const V& b, long) { return a - b; }

template <typename V> inline auto chooseAdd(const V& a, const V& b, int) -> decltype(v_add(a, b))
{
    return v_add(a, b);
}
template <typename V> inline V chooseAdd(const V& a, const V& b, long) { return a + b; }

template <typename V> inline auto chooseMul(const V& a, const V& b, int) -> decltype(v_mul(a, b))
{
    return v_mul(a, b);
}
template <typename V> inline V chooseMul(const V& a, const V& b, long) { return a * b; }

template <typename V> inline auto chooseDiv(const V& a, const V& b, int) -> decltype(v_div(a, b))
{
    return v_div(a, b);
}
template <typename V> inline V chooseDiv(const V& a, const V& b, long) { return a / b; }

template <typename V> inline auto chooseEqual(const V& a, const V& b, int) -> decltype(v_eq(a, b))
{
    return v_eq(a, b);
}
template <typename V> inline V chooseEqual(const V& a, const V& b, long) { return a == b; }

//! The bits of both.
template <typename V> inline V bitAnd(const V& a, const V& b) { return chooseAnd(a, b, 0); }

//! a - b; saturated for elements of 8 and 16 bits.
template <typename V> inline V subtract(const V& a, const V& b) { return chooseSub(a, b, 0); }

//! a + b; saturated for elements of 8 and 16 bits.
template <typename V> inline V add(const V& a, const V& b) { return chooseAdd(a, b, 0); }

//! All bits of the elements that are the same, none of the others.
template <typename V> inline V equal(const V& a, const V& b) { return chooseEqual(a, b, 0); }

inline v_float32x4 multiply(const v_float32x4& a, const v_float32x4& b) { return chooseMul(a, b, 0); }
inline v_float32x4 divide(const v_float32x4& a, const v_float32x4& b) { return chooseDiv(a, b, 0); }

//! All bits where a number is above 0.
inline v_int32x4 isPositive(const v_int32x4& a) { return v_shr<31>(subtract(v_setzero_s32(), a)); }

//! Absolute differences that fit into 15 bits.
inline v_int16x8 difference(const v_int16x8& a, const v_int16x8& b) { return v_reinterpret_as_s16(v_absdiff(a, b)); }

//! The lower and the upper eight of sixteen bytes, in 16 bits, which hold the sums of some of them.
struct Halves
{
    explicit Halves(const v_uint8x16& v) { v_expand(v, low, high); }
    v_uint16x8 low, high;
};

template <typename T> inline unsigned bitsOf(const T& value)
{
    unsigned bits = 0;
    memcpy(&bits, &value, sizeof(value));
    return bits;
}

//! Values of at most four bytes each, in words.
template <typename T> inline v_uint8x16 loadFour(const T& a, const T& b, const T& c, const T& d)
{
    return v_reinterpret_as_u8(v_uint32x4(bitsOf(a), bitsOf(b), bitsOf(c), bitsOf(d)));
}

//! The lower ones of pairs of 16 bits, with 0 in the place of the upper ones.
inline v_int16x8 lowerHalves(const v_int32x4& pairs)
{
    return v_reinterpret_as_s16(bitAnd(pairs, v_setall_s32(0xFFFF)));
}

//! Pairs of numbers that fit into 16 bits.
inline v_int16x8 makePairs(const v_int32x4& lower, const v_int32x4& upper)
{
    return v_add_wrap(lowerHalves(lower), v_reinterpret_as_s16(v_shl<16>(upper)));
}

//! Of two times two pairs of words, the first words and the second ones.
inline void splitPairs(const v_int32x4& a, const v_int32x4& b, v_int32x4& first, v_int32x4& second)
{
    v_int32x4 even, odd;
    v_zip(a, b, even, odd);
    v_zip(even, odd, first, second);
}

//! The same of pairs of 16 bits.
inline void splitPairs(const v_int16x8& a, const v_int16x8& b, v_int32x4& first, v_int32x4& second)
{
    splitPairs(v_reinterpret_as_s32(a), v_reinterpret_as_s32(b), first, second);
}

}}} // namespace

#endif
