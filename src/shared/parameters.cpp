// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "shared/parameters.hpp"
#include "shared/grid_markers.hpp"

namespace cv { namespace ximgproc { namespace gws {

void Parameters::setAlgorithm(int value)
{
    CV_Check(value, value == GWATERSHED || value == RGWATERSHED,
             "algorithm must be GWATERSHED (200) or RGWATERSHED (201)");
    algorithm = value;
}

void Parameters::setRegionSize(int value)
{
    CV_CheckGE(value, 1, "region_size must be 1 or more");
    region_size = value;
    num_superpixels = 0;
}

void Parameters::setDesiredSuperpixels(int value)
{
    CV_CheckGE(value, 1, "num_superpixels must be 1 or more");
    num_superpixels = value;
    region_size = 0;
}

void Parameters::setRuler(float value)
{
    CV_Check(value, value >= 0 && value <= FLT_MAX, "ruler must be 0 or more, and finite");
    ruler = value;
}

void Parameters::setEffort(int value)
{
    CV_Check(value, value >= 0 && value <= 3, "effort must be in [0, 3]");
    effort = value;
}

void Parameters::setAlpha(float value)
{
    CV_Check(value, value >= 0 && value <= 1, "alpha must be in [0, 1]");
    alpha = value;
}

void Parameters::setValueRange(float low, float high)
{
    CV_Check(low, low >= -FLT_MAX && low <= FLT_MAX, "low_value must be finite");
    CV_Check(high, (high > low && high <= FLT_MAX) || (low == 0 && high == 0),
             "high_value must be larger than low_value, and finite, or both 0");
    low_value = low;
    high_value = high;
}

void Parameters::setDepthRange(float first, float last)
{
    CV_Check(first, first >= 0 && first <= FLT_MAX, "near_depth must be 0 or more, and finite");
    CV_Check(last, (last > first && last <= FLT_MAX) || (first == 0 && last == 0),
             "far_depth must be larger than near_depth, and finite, or both 0");
    near_depth = first;
    far_depth = last;
}

void Parameters::setFocalLength(float x, float y)
{
    CV_Check(x, x >= 0 && x <= FLT_MAX, "fx must be 0 or more, and finite");
    CV_Check(y, y >= 0 && y <= FLT_MAX && (x > 0 || y == 0), "fy must be 0 or more, finite, and 0 if fx is");
    focal_x = x;
    focal_y = y;
}

void Parameters::setNormalWeight(float value)
{
    CV_Check(value, value >= 0 && value <= 1, "normal_weight must be in [0, 1]");
    normal_weight = value;
}

void Parameters::setBorderThreshold(float value)
{
    CV_Check(value, value >= 0 && value <= FLT_MAX, "border_threshold must be 0 or more, and finite");
    border_threshold = value;
}

void Parameters::write(FileStorage& fs) const
{
    fs << "algorithm" << algorithm
       << "region_size" << region_size
       << "num_superpixels" << num_superpixels
       << "ruler" << ruler
       << "effort" << effort
       << "alpha" << alpha
       << "lab_input" << int(lab_input)
       << "temporal" << int(temporal)
       << "low_value" << low_value
       << "high_value" << high_value
       << "near_depth" << near_depth
       << "far_depth" << far_depth
       << "focal_x" << focal_x
       << "focal_y" << focal_y
       << "normal_weight" << normal_weight
       << "depth_adaptive" << int(depth_adaptive)
       << "border_threshold" << border_threshold;
}

template <typename T> static T readValue(const FileNode& fn, const char* name)
{
    const FileNode node = fn[name];
    if (!node.isInt() && !node.isReal())
        CV_Error_(Error::StsParseError, ("read: %s must be given, as a number", name));
    return static_cast<T>(node);
}

static int readInteger(const FileNode& fn, const char* name)
{
    const double value = readValue<double>(fn, name);
    if (value != std::floor(value) || std::abs(value) > INT_MAX)
        CV_Error_(Error::StsParseError, ("read: %s must be an integer", name));
    return int(value);
}

static bool readFlag(const FileNode& fn, const char* name)
{
    const int value = readInteger(fn, name);
    if (value != 0 && value != 1)
        CV_Error_(Error::StsOutOfRange, ("read: %s must be 0 or 1", name));
    return value == 1;
}

Parameters Parameters::read(const FileNode& fn)
{
    Parameters parameters;
    parameters.setAlgorithm(readInteger(fn, "algorithm"));
    const int region_size = readInteger(fn, "region_size"), num_superpixels = readInteger(fn, "num_superpixels");
    CV_Check(region_size, (region_size == 0) != (num_superpixels == 0),
             "one of region_size and num_superpixels must be 0, and not the other");
    if (num_superpixels != 0)
        parameters.setDesiredSuperpixels(num_superpixels);
    else
        parameters.setRegionSize(region_size);
    parameters.setRuler(readValue<float>(fn, "ruler"));
    parameters.setEffort(readInteger(fn, "effort"));
    parameters.setAlpha(readValue<float>(fn, "alpha"));
    parameters.lab_input = readFlag(fn, "lab_input");
    parameters.temporal = readFlag(fn, "temporal");
    parameters.setValueRange(readValue<float>(fn, "low_value"), readValue<float>(fn, "high_value"));
    parameters.setDepthRange(readValue<float>(fn, "near_depth"), readValue<float>(fn, "far_depth"));
    parameters.setFocalLength(readValue<float>(fn, "focal_x"), readValue<float>(fn, "focal_y"));
    parameters.setNormalWeight(readValue<float>(fn, "normal_weight"));
    parameters.depth_adaptive = readFlag(fn, "depth_adaptive");
    parameters.setBorderThreshold(readValue<float>(fn, "border_threshold"));
    return parameters;
}

Point2f Parameters::focalLength(Size size) const
{
    const float USUAL = 0.8f; // of the longer side: 64 degrees, between those of the Kinect (0.82) and RealSense (0.72)
    if (focal_x == 0)
        return Point2f(1, 1) * (USUAL * float(std::max(size.width, size.height)));
    return Point2f(focal_x, focal_y > 0 ? focal_y : focal_x);
}

int Parameters::countSuperpixels(Size size, double pixels) const
{
    const bool all = pixels == double(size.width) * size.height;
    double wanted = num_superpixels;
    if (region_size > 0)
        wanted = all ? countSquares(size, region_size) : pixels / (double(region_size) * region_size);
    return cvRound(std::min(std::max(wanted, 1.), pixels));
}

}}} // namespace
