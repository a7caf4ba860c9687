// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "conversion.hpp"
#include "shared/valid_depth.hpp"

namespace cv { namespace ximgproc { namespace gws {

Mat convertImage(const Mat& image, Mat& buffer)
{
    CV_TRACE_FUNCTION();
    if (image.depth() == CV_8U)
        return image;
    buffer.create(image.size(), CV_8UC(image.channels()));
    parallel_for_(Range(0, image.rows), [&](const Range& range)
    {
        Mat row; // NaN and large values are replaced, because they cannot be rounded to integers
        for (int y = range.start; y < range.end; y++)
        {
            Mat to = buffer.row(y);
            if (image.depth() == CV_16U)
            {
                image.row(y).convertTo(to, CV_8U, 255. / 65535);
                continue;
            }
            image.row(y).copyTo(row);
            patchNaNs(row, 0);
            threshold(row, row, 1, 1, THRESH_TRUNC);
            row.convertTo(to, CV_8U, 255);
        }
    });
    return buffer;
}

struct DepthRange
{
    float first, last;
};

//! Smallest and largest valid depth; {0, 0} if there is none.
template <typename T> static DepthRange findExtrema(const Mat& depth)
{
    DepthRange range = { FLT_MAX, 0 };
    for (int y = 0; y < depth.rows; y++)
    {
        const T* row = depth.ptr<T>(y);
        for (int x = 0; x < depth.cols; x++)
            if (isValidDepth(row[x]))
            {
                range.first = std::min(range.first, float(row[x]));
                range.last = std::max(range.last, float(row[x]));
            }
    }
    return range.last > 0 ? range : DepthRange();
}

//! The 1st and the 99th percentile of a regular sample. So a few outliers do not matter.
//! @note The paper says only that D is scaled.
template <typename T> static DepthRange findRange(const Mat& depth)
{
    const double MAX_SAMPLES = 65536;
    const int step = cvCeil(std::sqrt(double(depth.rows) * depth.cols / MAX_SAMPLES));
    std::vector<float> sample;
    for (int y = std::min(step, depth.rows) / 2; y < depth.rows; y += step)
    {
        const T* row = depth.ptr<T>(y);
        for (int x = std::min(step, depth.cols) / 2; x < depth.cols; x += step)
            if (isValidDepth(row[x]))
                sample.push_back(float(row[x]));
    }
    if (!sample.empty())
    {
        const ptrdiff_t rank = ptrdiff_t(sample.size() / 100);
        std::nth_element(sample.begin(), sample.begin() + rank, sample.end());
        const float first = *(sample.begin() + rank);
        std::nth_element(sample.begin(), sample.end() - 1 - rank, sample.end());
        const DepthRange range = { first, *(sample.end() - 1 - rank) };
        if (range.first < range.last)
            return range;
    }
    return findExtrema<T>(depth);
}

template <typename T> static void scaleRows(const Mat& depth, DepthRange range, Mat& scaled)
{
    const double factor = 254. / (double(range.last) - range.first);
    parallel_for_(Range(0, depth.rows), [&](const Range& rows)
    {
        for (int y = rows.start; y < rows.end; y++)
        {
            const T* from = depth.ptr<T>(y);
            uchar* to = scaled.ptr(y);
            for (int x = 0; x < depth.cols; x++)
            {
                const float value = std::min(std::max(float(from[x]), range.first), range.last);
                to[x] = isValidDepth(from[x]) ? uchar(1.5 + factor * (value - range.first)) : uchar(0);
            }
        }
    });
}

//! Returns false, and leaves scaled as it is, if all valid depths are equal.
template <typename T>
static bool scaleToBytes(const Mat& depth, float near_depth, float far_depth, Mat& scaled)
{
    DepthRange range = { near_depth, far_depth };
    if (far_depth == 0)
        range = findRange<T>(depth);
    if (range.first < range.last)
        scaleRows<T>(depth, range, scaled);
    return range.first < range.last;
}

//! @note Depth that is the same everywhere is dropped. Equation (3) would halve all distances, so some of them would
//! become equal and the flood would change, although depth adds no information.
Mat scaleDepth(const Mat& depth, float near_depth, float far_depth, Mat& buffer)
{
    CV_TRACE_FUNCTION();
    if (depth.empty())
        return Mat();
    bool scaled = true;
    buffer.create(depth.size(), CV_8UC1);
    switch (depth.depth())
    {
    case CV_8U: depth.copyTo(buffer); break;
    case CV_16U: scaled = scaleToBytes<ushort>(depth, near_depth, far_depth, buffer); break;
    default: scaled = scaleToBytes<float>(depth, near_depth, far_depth, buffer);
    }
    if (!scaled)
        return Mat();
    const DepthRange found = findExtrema<uchar>(buffer);
    return found.first < found.last ? buffer : Mat();
}

}}} // namespace
