// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ROW_CHUNKS_HPP
#define OPENCV_GWATERSHED_ROW_CHUNKS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Calls body(y) for some rows, at the same time for different ones.
template <typename Body> void forRows(const Range& rows, const Body& body)
{
    parallel_for_(rows, [&](const Range& range)
    {
        for (int y = range.start; y < range.end; y++)
            body(y);
    });
}

//! Rows in chunks of one height, but the last one, that are worked on at the same time. They do not depend on the
//! number of threads.
class RowChunks
{
public:
    RowChunks(int num_rows, int height) : num_rows_(num_rows), height_(height) {}

    int size() const { return (num_rows_ + height_ - 1) / height_; }
    Range operator[](int k) const { return Range(k * height_, std::min((k + 1) * height_, num_rows_)); }

    //! Calls body(k, rows) for all chunks.
    template <typename Body> void forAll(const Body& body) const
    {
        forRows(Range(0, size()), [&](int k) { body(k, (*this)[k]); });
    }

private:
    int num_rows_, height_;
};

//! At most 32 of at least 16 rows, where something is kept for each.
inline RowChunks fewChunks(int num_rows) { return RowChunks(num_rows, std::max(16, (num_rows + 31) / 32)); }

}}} // namespace

#endif
