// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/block_normals.hpp"
#include "shared/features.hpp"

namespace cv { namespace ximgproc { namespace gws {

enum { NORMALS_AT_ONCE = 4 };

//! Adds up the normals of each column.
static void addColumns(const Mat& normals, const Range& rows, int* sums)
{
    for (int x = 0; x < normals.cols; x += NORMALS_AT_ONCE)
    {
        v_int32x4 sum = v_setzero_s32();
        for (int y = rows.start; y < rows.end; y++)
            sum = add(sum, NormalSum::of(normals.ptr<Normal>(y) + x));
        v_store(sums + x, sum);
    }
}

//! Adds up pairs of columns, those that blocks of a side touch.
static void addPairs(const int* columns, int side, int count, int* sums)
{
    if (side != 4)
    {
        for (int x = 0; x < count; x++)
            sums[x] = columns[x * side / 2] + columns[x * side / 2 + 1];
        return;
    }
    for (int x = 0; x < count; x += NORMALS_AT_ONCE)
    {
        v_int32x4 first, second;
        v_load_deinterleave(columns + 2 * x, first, second);
        v_store(sums + x, add(first, second));
    }
}

void uniteNormals(const Mat& normals, int side, Size size, Mat& united)
{
    united.create(size.height, int(alignSize(size.width, NORMALS_AT_ONCE)), CV_8UC2);
    parallel_for_(Range(0, size.height), [&](const Range& rows)
    {
        std::vector<int> columns(normals.cols + 1), sums(united.cols);
        for (int y = rows.start; y < rows.end; y++)
        {
            const Range own(y * side / 2, std::min(((y + 1) * side + 1) / 2, normals.rows));
            addColumns(normals, own, columns.data());
            addPairs(columns.data(), side, size.width, sums.data());
            for (int x = 0; x < size.width; x += NORMALS_AT_ONCE)
                NormalSum::mean(v_load(&sums[x]), united.ptr<Normal>(y) + x);
        }
    });
}

}}} // namespace
