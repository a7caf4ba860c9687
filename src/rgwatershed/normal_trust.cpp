// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "rgwatershed/normal_trust.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Of the normals that are known, those that turned little since another frame.
static float shareOfSteady(const Mat& normals, const Mat& before)
{
    const int MOST_TURN = 16; // levels of a normal
    int known = 0, steady = 0;
    for (int y = 0; y < normals.rows; y++)
    {
        const Normal *row = normals.ptr<Normal>(y), *row_before = before.ptr<Normal>(y);
        for (int x = 0; x < normals.cols; x++)
        {
            const int turn = std::abs(row[x].x - row_before[x].x) + std::abs(row[x].y - row_before[x].y);
            known += row[x].known();
            steady += row[x].known() & (turn <= MOST_TURN);
        }
    }
    return float(steady) / float(std::max(known, 1));
}

void NormalTrust::start(const Mat& normals)
{
    normals.copyTo(last_);
    steady_ = 0; // what a cut right after it costs, one frame, is less than a second frame of boundaries in noise
    trust_ = 1;
}

//! At a cut of the scene all normals are new, but only once. So the better one of two frames with new depth counts.
float NormalTrust::next(const Mat& normals)
{
    const bool can_compare = normals.size() == last_.size();
    if (normals.empty() || (can_compare && norm(normals, last_, NORM_INF) == 0))
        return trust_; // depth that comes more slowly than colour is given again as it was
    const float steady = can_compare ? shareOfSteady(normals, last_) : 1;
    const float share = std::max(steady, steady_);
    normals.copyTo(last_);
    steady_ = steady;
    trust_ = share * share;
    return trust_;
}

}}} // namespace
