// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_LABEL_RUNS_HPP
#define OPENCV_GWATERSHED_LABEL_RUNS_HPP

#include "shared/vector_operators.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The rows of a label map in chunks that are worked on at the same time. These do not depend on the number of threads.
class RowChunks
{
public:
    explicit RowChunks(int num_rows) : num_rows_(num_rows), height_(std::max(16, (num_rows + MOST - 1) / MOST)) {}

    int size() const { return (num_rows_ + height_ - 1) / height_; }
    Range operator[](int k) const { return Range(k * height_, std::min((k + 1) * height_, num_rows_)); }

private:
    enum { MOST = 32 };

    int num_rows_, height_;
};

//! Of each set of four bits: how many are set, and where.
struct BitPositions
{
    BitPositions()
    {
        for (int bits = 0; bits < 16; bits++)
        {
            counts[bits] = 0;
            for (int k = 0; k < 4; k++)
                positions[bits][k] = 0;
            for (int k = 0; k < 4; k++)
                if ((bits >> k) & 1)
                    positions[bits][counts[bits]++] = k;
        }
    }

    int counts[16], positions[16][4];
};

//! Writes to `positions`, in order, where two rows differ; it has room for cols + 4. Returns how many these are.
//! Without branches: four positions are written each time, and the next ones over those that are none.
inline int listDifferences(const int* row, const int* other, int cols, int* positions)
{
    static const BitPositions TABLE;
    int count = 0, x = 0;
    const auto add_four = [&]()
    {
        const int bits = v_signmask(equal(v_load(row + x), v_load(other + x))) ^ 15;
        v_store(positions + count, add(v_load(TABLE.positions[bits]), v_setall_s32(x)));
        count += TABLE.counts[bits];
        x += 4;
    };
    while (x + 8 <= cols)
    {
        add_four();
        add_four();
    }
    for (; x < cols; x++)
    {
        positions[count] = x;
        count += row[x] != other[x];
    }
    return count;
}

}}} // namespace

#endif
