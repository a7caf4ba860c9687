// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PADDED_HPP
#define OPENCV_GWATERSHED_PADDED_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! An image with a frame of one element around it, so that neighbours need no bounds test.
//! One index names an element, and each neighbour has a fixed offset to it.
template <typename T> class Padded
{
public:
    //! Allocates for images of a size. Does not set the elements and the frame.
    void reserve(Size size) { buffer_.create(size.height + 2, size.width + 2, type()); }

    void create(Size size, const T& frame)
    {
        reserve(size);
        std::fill_n(row(-1) - 1, step(), frame);
        std::fill_n(row(size.height) - 1, step(), frame);
        for (int y = 0; y < size.height; y++)
            row(y)[-1] = row(y)[size.width] = frame;
    }

    Size size() const { return Size(buffer_.cols - 2, buffer_.rows - 2); }
    int step() const { return buffer_.cols; }
    T* data() { return buffer_.ptr<T>(); }
    const T* data() const { return buffer_.ptr<T>(); }
    T* row(int y) { return buffer_.ptr<T>(y + 1) + 1; }
    const T* row(int y) const { return buffer_.ptr<T>(y + 1) + 1; }

    //! The image without its frame, in the same memory.
    Mat view() const { return buffer_(Rect(Point(1, 1), size())); }

    int index(Point p) const { return (p.y + 1) * step() + p.x + 1; }
    Point point(int index) const { return Point(index % step() - 1, index / step() - 1); }
    //! Offsets of the neighbours: left, top, right, bottom.
    Vec4i neighbors() const { return Vec4i(-1, -step(), 1, step()); }

private:
    static int type() { return typeOf(static_cast<const T*>(0)); }
    static int typeOf(const int*) { return CV_32SC1; }
    static int typeOf(const void*) { return CV_8UC(int(sizeof(T))); }

    Mat buffer_;
};

}}} // namespace

#endif
