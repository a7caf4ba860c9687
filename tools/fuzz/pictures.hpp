// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FUZZ_PICTURES_HPP
#define OPENCV_GWATERSHED_FUZZ_PICTURES_HPP

#include "checks.hpp"

#include <fuzzer/FuzzedDataProvider.h>

//! Images, depth maps, masks and markers that a few bytes describe.
namespace fuzz
{

typedef FuzzedDataProvider Bytes;

//! One time in `count`, if bytes are random.
bool oneIn(int count, Bytes& bytes);
//! A size of up to a number of pixels; thin and tiny ones are frequent.
Size takeSize(int max_pixels, Bytes& bytes);
//! A float: usual, at an edge of a range, or any at all.
float takeFloat(float usual_max, Bytes& bytes);
//! An integer: usual, at an edge of a range, or any at all.
int takeInt(int usual_max, Bytes& bytes);

//! What a camera sees: CV_32FC3 in [0, 1].
Mat makeScene(Size size, Bytes& bytes);
//! What it sees a moment later.
Mat changeScene(const Mat& scene, Bytes& bytes);

//! An image of the scene, of any type that iterate() takes; seldom one that it does not take.
Mat makeImage(const Mat& scene, Bytes& bytes);
bool isImage(const Mat& image);
//! The same for depth: holes, infinity and NaN are frequent.
Mat makeDepth(const Mat& scene, Bytes& bytes);
bool isDepth(const Mat& depth, Size size);
//! Values of any type for getStatistics().
Mat makeValues(Size size, Bytes& bytes);

Mat makeMask(Size size, Bytes& bytes);
Mat makeMarkers(Size size, Bytes& bytes);

//! A matrix that is handed over, often as a part of a larger one, and that nobody may write to.
class Guarded
{
public:
    Guarded(const Mat& values, Bytes& bytes);
    const Mat& mat() const { return part_; }
    //! Neither the matrix nor what lies around it was written to.
    bool untouched() const { return same(whole_, before_); }
    //! Writes to it, as its owner may do after the call.
    void overwrite(int value);

private:
    Mat whole_, part_, before_;
};

} // namespace

#endif
