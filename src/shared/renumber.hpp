// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_RENUMBER_HPP
#define OPENCV_GWATERSHED_RENUMBER_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Gives each region the number of the region that it was merged into. The regions that are left are their own parents.
//! They are numbered from 0, in the order of the lowest old number in each. Returns how many are left.
int numberRegions(const std::vector<int>& parents, std::vector<int>& numbers);

//! Replaces each label by its number. Labels below 0 stay.
void renumber(const std::vector<int>& numbers, Mat& labels);

//! Writes the number of each label to another map of the same size. There are no labels below -1, which stays.
void copyNumbered(const Mat& from, const std::vector<int>& numbers, Mat& to);

}}} // namespace

#endif
