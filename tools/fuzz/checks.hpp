// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FUZZ_CHECKS_HPP
#define OPENCV_GWATERSHED_FUZZ_CHECKS_HPP

#include "opencv2/gwatershed.hpp"

#include <algorithm>
#include <climits>
#include <vector>

//! What the documentation of SuperpixelGWatershed promises, computed again in the simplest way.
namespace fuzz
{

using cv::Mat;
using cv::Point;
using cv::Ptr;
using cv::Rect;
using cv::RNG;
using cv::Scalar;
using cv::Size;
using cv::ximgproc::SuperpixelGWatershed;

//! From here on OpenCV does not print the exceptions that it throws.
void silenceErrors();

//! Ends the program with a message if a property does not hold.
void require(bool holds, const char* property);

//! Equal in size, type and every byte.
bool same(const Mat& a, const Mat& b);

//! The parameters of an object.
struct Settings
{
    int algorithm, region_size, num_superpixels, effort;
    float ruler, alpha;
    bool lab_input, temporal, depth_adaptive;
    float low_value, high_value, near_depth, far_depth, focal_x, focal_y, normal_weight, border_threshold;
};

Settings settingsOf(const SuperpixelGWatershed& gws);
bool operator==(const Settings& a, const Settings& b);
//! Whether all of them are in their documented ranges.
bool inRange(const Settings& settings);

struct Partition
{
    Mat labels;
    int num_labels;
};

Partition partitionOf(const SuperpixelGWatershed& gws);

//! Number of 4-connected pieces of each label of a map; labels below 0 are not counted.
std::vector<int> countPieces(const Mat& labels, int num_labels);

//! The first partition after an iterate(): types, labels, number, pieces and where there is no label.
//! Maps that were not set are empty.
void checkSegmentation(const Partition& partition, Size size, const Mat& mask, const Mat& markers,
                       const Settings& settings);
//! All labels occur, and every superpixel of the finer partition is in one of the coarser one, in no more pieces.
void checkMerged(const Partition& fine, const Partition& coarse);
//! mergeSimilar() reached the number, or what is left does not touch.
void checkMergedNumber(const Partition& before, int wanted, const Partition& after);
//! What is smaller than the percentage of the mean area has no neighbour.
void checkSmallMerged(const Partition& before, int percent, const Partition& after);
//! After mergeSmall().
void checkAreaMerged(const Partition& before, int min_area, const Partition& after);

//! getStatistics(); the image or the depth may be empty.
void checkStatistics(const SuperpixelGWatershed& gws, const Mat& image, const Mat& depth);
//! getAdjacency(), with contrasts if there is an image.
void checkAdjacency(const SuperpixelGWatershed& gws, const Mat& image, const Mat& depth);
//! getLabelContourMask() and getWatershedLineMask().
void checkMasks(const SuperpixelGWatershed& gws, int algorithm);

} // namespace

#endif
