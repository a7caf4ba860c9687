// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/renumber.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

int numberRegions(const std::vector<int>& parents, std::vector<int>& numbers)
{
    const int n = int(parents.size());
    std::vector<int> roots(parents), number_of_root(n, -1);
    int count = 0;
    numbers.resize(n);
    for (int i = 0; i < n; i++)
    {
        int root = i;
        while (roots[root] != root)
            root = roots[root] = roots[roots[root]];
        if (number_of_root[root] < 0)
            number_of_root[root] = count++;
        numbers[i] = number_of_root[root];
    }
    return count;
}

void renumber(const std::vector<int>& numbers, Mat& labels)
{
    forRows(Range(0, labels.rows), [&](int y)
    {
        int* row = labels.ptr<int>(y);
        for (int x = 0; x < labels.cols; x++)
            row[x] = row[x] < 0 ? row[x] : numbers[row[x]];
    });
}

void copyNumbered(const Mat& from, const std::vector<int>& numbers, Mat& to)
{
    std::vector<int> shifted(1, -1);
    shifted.insert(shifted.end(), numbers.begin(), numbers.end());
    const int* const table = shifted.data() + 1;
    forRows(Range(0, from.rows), [&](int y)
    {
        const int *row = from.ptr<int>(y), *const end = row + from.cols;
        int* numbered = to.ptr<int>(y);
        for (; row + 4 <= end; row += 4, numbered += 4)
            for (int k = 0; k < 4; k++)
                numbered[k] = table[row[k]];
        for (; row < end; row++)
            *numbered++ = table[*row];
    });
}

}}} // namespace
