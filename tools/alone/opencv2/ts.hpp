// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_ALONE_TS_HPP
#define OPENCV_GWATERSHED_ALONE_TS_HPP

// Stands for OpenCV's test module ts, which no package installs: what the files of test/ use of it, on top of
// GoogleTest as it is installed. With it the tests build without a build of OpenCV; see main.cpp, too.

#include <opencv2/core.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/imgproc.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <climits>
#include <cmath>
#include <iterator>
#include <limits>
#include <list>
#include <map>
#include <queue>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace cvtest
{

using std::get;
using std::make_tuple;
using std::tuple;

inline double norm(cv::InputArray a, cv::InputArray b, int type)
{
    return cv::norm(a, b, type);
}

} // namespace

namespace opencv_test
{

using namespace cvtest;
using namespace cv;

// ts has functions of these names, too. As there, a test must say which one it means.
struct NamespaceMissing;
using add = NamespaceMissing;
using compare = NamespaceMissing;
using copyMakeBorder = NamespaceMissing;
using divide = NamespaceMissing;
using filter2D = NamespaceMissing;
using minMaxIdx = NamespaceMissing;
using multiply = NamespaceMissing;
using norm = NamespaceMissing;
using threshold = NamespaceMissing;
using transpose = NamespaceMissing;

} // namespace

#endif
