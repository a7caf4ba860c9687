// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SAMPLE_HPP
#define OPENCV_GWATERSHED_SAMPLE_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! A number below `end` that looks drawn by lot, and is the same in every run.
inline int64 drawLot(int64 index, int64 end)
{
    uint64 value = uint64(index) * 0x9e3779b97f4a7c15u;
    value = (value ^ (value >> 32)) * 0xbf58476d1ce4e5b9u;
    return int64(((value >> 32) * uint64(end)) >> 32);
}

//! The step of a sample of so many of all elements, at most.
inline int64 sampleStep(int64 total, int64 most) { return (total + most - 1) / most; }

//! Takes one element of each `step` elements that follow one another in the order of rows. Which one of them is drawn
//! by lot, so that no lattice of elements is always met, or always missed. addressOf(y, x) says where it lies, or 0 if
//! it does not count. Calls take(row) for some of them at a time: all, where step is 1, would be a second image.
template <typename AddressOf, typename Take>
void readSample(Size size, int64 step, int type, const AddressOf& addressOf, const Take& take)
{
    const size_t AT_ONCE = 4096, bytes_of_one = CV_ELEM_SIZE(type);
    const int64 total = int64(size.width) * size.height;
    std::vector<uchar> bytes;
    int64 row_begin = 0;
    int y = 0;
    for (int64 first = 0; first < total; first += step)
    {
        const int64 index = first + drawLot(first, std::min(step, total - first));
        for (; index >= row_begin + size.width; row_begin += size.width)
            y++;
        if (const uchar* const element = addressOf(y, int(index - row_begin)))
            bytes.insert(bytes.end(), element, element + bytes_of_one);
        if (bytes.size() < AT_ONCE * bytes_of_one && first + step < total)
            continue;
        if (!bytes.empty())
            take(Mat(1, int(bytes.size() / bytes_of_one), type, bytes.data()));
        bytes.clear();
    }
}

//! Sixteen rows of an image, or some more, equally far apart, in the same memory; all if it has fewer.
inline Mat someRows(const Mat& image)
{
    const int ROWS = 16, apart = std::max(image.rows / ROWS, 1), first = apart / 2;
    return Mat((image.rows - first + apart - 1) / apart, image.cols, image.type(),
               const_cast<uchar*>(image.ptr(first)), image.step * size_t(apart));
}

template <typename T> struct RangeOf
{
    T first, last;
};

typedef RangeOf<float> FloatRange;

//! The range that is left without `outliers` of the lowest and of the highest values; values change their order.
//! There are more than 2 * outliers of them.
template <typename T> RangeOf<T> rangeWithout(size_t outliers, std::vector<T>& values)
{
    T *const begin = values.data(), *const end = begin + values.size();
    T *const low = begin + outliers, *const high = end - 1 - outliers;
    std::nth_element(begin, low, end);
    const T first = *low;
    std::nth_element(low, high, end);
    return { first, *high };
}

}}} // namespace

#endif
