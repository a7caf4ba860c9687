// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "user_markers.hpp"
#include "shared/row_chunks.hpp"

namespace cv { namespace ximgproc { namespace gws {

int numberMarkers(const Mat& markers, const Mat& mask, Mat& numbered)
{
    CV_TRACE_FUNCTION();
    std::vector<int> values;
    numbered.create(markers.size(), CV_32SC1);
    for (int y = 0; y < markers.rows; y++)
    {
        const int* from = markers.ptr<int>(y);
        int* to = numbered.ptr<int>(y);
        int last = 0;
        for (int x = 0; x < markers.cols; x++)
        {
            to[x] = from[x] > 0 && (mask.empty() || mask.at<uchar>(y, x)) ? from[x] : 0;
            if (to[x] != last && to[x] > 0)
                values.push_back(to[x]);
            last = to[x];
        }
    }
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());

    forRows(Range(0, numbered.rows), [&](int y)
    {
        int* row = numbered.ptr<int>(y);
        for (int x = 0; x < numbered.cols; x++)
            row[x] = row[x] ? int(std::lower_bound(values.begin(), values.end(), row[x]) - values.begin()) : -1;
    });
    return int(values.size());
}

int divideMarkers(int num_markers, Mat& numbered, std::vector<int>& owners)
{
    CV_TRACE_FUNCTION();
    const int MANY = 32, SIDE = 8; // pixels of a cell
    owners.clear();
    if (num_markers >= MANY)
        return num_markers;
    std::vector<int> parts(num_markers, -1); // the last one of each marker
    const Rect all(Point(), numbered.size());
    for (int top = 0; top < all.height; top += SIDE)
        for (int left = 0; left < all.width; left += SIDE)
        {
            const int first = int(owners.size());
            const Rect cell = Rect(left, top, SIDE, SIDE) & all;
            for (int y = cell.y; y < cell.br().y; y++)
                for (int x = cell.x; x < cell.br().x; x++)
                {
                    int& number = numbered.at<int>(y, x);
                    if (number < 0)
                        continue;
                    int& part = parts[number];
                    if (part < first)
                    {
                        part = int(owners.size());
                        owners.push_back(number);
                    }
                    number = part;
                }
        }
    return int(owners.size());
}

}}} // namespace
