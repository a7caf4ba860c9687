// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_TEST_MERGE_REFERENCE_HPP
#define OPENCV_TEST_MERGE_REFERENCE_HPP

#include "test_common.hpp"

namespace opencv_test {

// What mergeSimilar() does, from its description, and without a thought of time.

typedef std::pair<int, int> RegionPair; // labels a < b

//! What is measured of the regions of a label map. Steps from pixel to pixel are those inside of the first superpixels,
//! in every second row.
struct RegionMeasures
{
    std::vector<double> areas;
    std::vector<Vec3d> means;
    std::vector<Vec2d> steps; // across and down
    std::vector<Matx32d> rises;
    std::map<RegionPair, std::pair<double, double> > boundaries; // length, sum of differences

    RegionMeasures(const Mat& image, const Mat& first, const Mat& labels, int n);
};

//! A region that is nothing but an edge, and the two that it lies between, the one that it is more like first.
struct Mixture
{
    int region, nearer, farther;
};

//! Limits are times a factor, and the looser the larger it is.
std::vector<Mixture> findMixtures(const RegionMeasures& regions, double looseness);

//! Colour and logarithm of texture that have spread. Those of unions are the means over their pixels.
typedef Vec4d MergeContext;

//! They spread four times, each time from the neighbours, by likeness, what has changed already, too.
std::vector<MergeContext> spreadContexts(const RegionMeasures& regions);

//! The plan: tiles of about ten cells of a grid with a cell for each region are divided into halves, and these again.
struct MergePlan
{
    std::vector<int> parts; // of each label: the smallest part with others; negative and different if there is none
    std::vector<int> above; // of each part

    MergePlan(const Mat& labels, int n);

private:
    void divide(const std::vector<std::pair<Point, int> >& regions, int whole);
};

//! From the lowest to the highest: they differ where rounding decides whether a slope counts.
struct CostSpan
{
    double first, last;
};

//! Logarithms of the cost for all neighbours, from the formula. Regions of a part have less noise between them, and no
//! slope.
std::map<RegionPair, CostSpan> mergeCosts(const RegionMeasures& regions, const std::vector<MergeContext>& contexts,
                                          const std::vector<int>& parts);

} // namespace

#endif
