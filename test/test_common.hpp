// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_TEST_GWATERSHED_COMMON_HPP
#define OPENCV_TEST_GWATERSHED_COMMON_HPP

#include "test_precomp.hpp"

#include <functional>
#include <limits>

namespace opencv_test
{

//! The algorithms that every property is asked of.
const int ALGORITHMS[] = { GWATERSHED, RGWATERSHED };

const float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN(), INFINITE = std::numeric_limits<float>::infinity();

//! Whether a call throws a cv::Exception whose message has a word.
testing::AssertionResult isRefused(const std::function<void()>& call, const String& word);

enum ImageKind { FLAT, NOISE, RAMP, STRIPES, CHECKERBOARD, SCENE, IMAGE_KINDS };

//! Discs and boxes of many colours on a ramp, with a little blur and noise, so that superpixels behave as on a
//! photograph. CV_8UC3.
Mat makeScene(Size size, RNG& rng);
//! An image of a kind with 1 or 3 channels, 8-bit.
Mat makeImage(ImageKind kind, Size size, int channels, RNG& rng);
//! CV_16UC1 depth in millimetres: planes at several distances; a share of holes, in blobs.
Mat makeDepth(Size size, double holes, RNG& rng);

enum MaskKind { DISCS, DUST, MESH, THIN_LINES, FRAME_MASK, BRIDGE, FEW_PIXELS, EMPTY_MASK, FULL_MASK, MASK_KINDS };

//! CV_8UC1 mask of a kind; inside are values from 1 to 255.
Mat makeMask(MaskKind kind, Size size, RNG& rng);
//! CV_32SC1 markers with up to `count` values, some of them negative or in several pieces: strokes,
//! boxes and single pixels.
Mat makeMarkers(Size size, int count, RNG& rng);

Mat labelsOf(const Ptr<SuperpixelGWatershed>& gws);
//! Segments with a fresh object.
Mat segment(InputArray image, int algorithm, int region_size);
Mat segment(InputArray image, InputArray depth, int algorithm, int region_size);

//! Share of the pixels that are in a superpixel whose most pixels are of their class, a value of a CV_8UC1 map.
double purity(const Mat& labels, int number, const Mat& classes);

//! CV_32SC1 cells of random points.
Mat makeCells(Size size, int count, RNG& rng);
//! A colour for each cell, with shading, blur and noise. CV_8UC3.
Mat paintCells(const Mat& cells, int count, RNG& rng);
//! Pixels that are not in the cell that most of their superpixel lies in. Labels below 0 do not count.
int countLeaks(const Mat& labels, int num_labels, const Mat& cells, int num_cells);

//! Number of 4-connected pieces of equal label.
int countPieces(const Mat& labels);
//! All pixels labelled, labels 0..N-1 without gaps, each of them one 4-connected piece.
void expectPartition(const Mat& labels, Size size, int num_labels);
//! The same inside of a mask, -1 outside.
void expectMaskedPartition(const Mat& labels, const Mat& mask, int num_labels);
//! Bounding box of points; cv::boundingRect() is in another module in OpenCV 5, and wrong for masks two pixels wide
//! in 4.6.
Rect boundsOf(const std::vector<Point>& points);
//! The pixels of each label, of which some may have none.
std::vector<std::vector<Point> > pixelsOf(const Mat& labels);
//! Areas of the smallest and of the largest superpixel, in mean areas.
Vec2d extremeAreas(const Mat& labels);
//! The median over the superpixels of the longer side of the bounding box over the shorter one. Labels may be missing.
double medianAspect(const Mat& labels);
//! Number of 4-connected pieces of a mask.
int countMaskPieces(const Mat& mask);
bool equalMats(const Mat& a, const Mat& b);
//! One more than the largest label.
int numberOfLabels(const Mat& labels);
//! Share of the variance of a CV_8UC3 image that the mean colours of the superpixels keep.
double explainedVariation(const Mat& labels, const Mat& image);
//! Mean over the pixels of 4 pi area / perimeter^2 of their superpixel.
double compactness(const Mat& labels);

//! The new after `count` others fails, once; a count below 0 lets none fail.
void failNewAfter(int count);
//! Whether none is to fail any more.
bool newHasFailed();

// What is set for the program is set for a scope, so that it is as before after a test that fails.

//! Looks at the sizes that are asked of operator new.
class NewRecorder
{
public:
    NewRecorder();
    ~NewRecorder();
    size_t largest() const;
};

//! Sets something of OpenCV for as long as it lives.
template <typename Value, Value (*get)(), void (*set)(Value)> class Guard
{
public:
    explicit Guard(Value now) : before_(get()) { set(now); }
    ~Guard() { set(before_); }

private:
    const Value before_;
};

typedef Guard<MatAllocator*, Mat::getDefaultAllocator, Mat::setDefaultAllocator> AllocatorGuard;
typedef Guard<int, getNumThreads, setNumThreads> ThreadsGuard;
typedef Guard<bool, useOptimized, setUseOptimized> UseOptimizedGuard;

} // namespace

#endif
