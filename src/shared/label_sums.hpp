// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_LABEL_SUMS_HPP
#define OPENCV_GWATERSHED_LABEL_SUMS_HPP

#include "shared/label_runs.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Sums over the pixels of each label in some rows, for those labels that are there.
template <typename Sum> class SumsOfRows
{
public:
    //! Of each label, `slots` names the sum that it has if it has one; else it may be anything.
    //! Calls runsOf(y)(sum, xs) for each run of pixels of one label.
    template <typename RunsOf>
    void add(const Mat& labels, const Range& rows, unsigned* slots, const RunsOf& runsOf)
    {
        std::vector<int> positions(labels.cols + 4);
        int* const ends = positions.data();
        for (int y = rows.start; y < rows.end; y++)
        {
            const int* row = labels.ptr<int>(y);
            const int count = listDifferences(row, row + 1, labels.cols - 1, ends);
            ends[count] = labels.cols - 1;
            const auto addRun = runsOf(y);
            for (int i = 0, x = 0; i <= count; i++)
            {
                const int label = row[x], end = ends[i] + 1;
                if (label >= 0)
                    addRun(sumOf(label, slots[label]), Range(x, end));
                x = end;
            }
        }
    }

    void addTo(std::vector<Sum>& sums) const
    {
        for (const Part& part : parts_)
            sums[part.label].add(part.sum);
    }

private:
    struct Part
    {
        int label;
        Sum sum;
    };

    Sum& sumOf(int label, unsigned& slot)
    {
        if (slot >= parts_.size() || parts_[slot].label != label)
        {
            slot = unsigned(parts_.size());
            parts_.push_back({ label, Sum() });
        }
        return parts_[slot].sum;
    }

    std::vector<Part> parts_;
};

//! Sums over the pixels of each label of a CV_32SC1 map. Labels below 0 do not count. Calls runsOf(y) for each row,
//! and what it gives, addRun(sum, xs), for each run of pixels of one label there, at the same time for different rows.
//! @note Sums must be of integers, so that their order does not matter.
template <typename Sum, typename RunsOf>
void sumByLabel(const Mat& labels, const RunsOf& runsOf, std::vector<Sum>& sums)
{
    const RowChunks chunks = fewChunks(labels.rows);
    std::vector<SumsOfRows<Sum> > parts(chunks.size());
    parallel_for_(Range(0, chunks.size()), [&](const Range& range)
    {
        std::vector<unsigned> slots(sums.size());
        for (int k = range.start; k < range.end; k++)
            parts[k].add(labels, chunks[k], slots.data(), runsOf);
    });
    std::fill(sums.begin(), sums.end(), Sum());
    for (const SumsOfRows<Sum>& part : parts)
        part.addTo(sums);
}

}}} // namespace

#endif
