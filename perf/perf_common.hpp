// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_PERF_GWATERSHED_COMMON_HPP
#define OPENCV_PERF_GWATERSHED_COMMON_HPP

#include "perf_precomp.hpp"

namespace opencv_test
{

CV_ENUM(SuperpixelAlgorithm, RGWATERSHED, GWATERSHED)

//! One for each square of region_size x region_size pixels.
inline int countSuperpixels(Size size, int region_size)
{
    return cvRound(double(size.area()) / (region_size * region_size));
}

//! One pixel in the middle of each square of region_size x region_size pixels, numbered from 1 on; CV_32SC1.
Mat makeGridMarkers(Size size, int region_size);

/** Mosaics of one size, used in turn: caches and branch predictors know a picture that they have seen before.

The mosaics are made of pieces of the photographs in OpenCV's samples/data (OPENCV_SAMPLES_DATA_PATH), and their
depth of pieces of aloeGT.png. What is not found is replaced by generated scenes. */
class Pictures
{
public:
    explicit Pictures(Size size);

    //! Goes on to the next picture.
    void next() { index_ = (index_ + 1) % images_.size(); }
    //! Goes to one picture; beyond the last one follows the first one.
    void choose(size_t index) { index_ = index % images_.size(); }
    const Mat& image() const { return images_[index_]; } //!< CV_8UC3
    const Mat& depth() const { return depths_[index_]; } //!< CV_16UC1

private:
    std::vector<Mat> images_, depths_;
    size_t index_;
};

//! Times work, and not what prepares it, over the pictures of a size.
template <typename Param>
class PicturesTest : public TestBaseWithParam<Param>
{
protected:
    template <typename Prepare, typename Work>
    void timeOver(Pictures& pictures, Prepare prepare, Work work)
    {
        while (this->next())
        {
            pictures.next();
            prepare();
            this->startTimer();
            work();
            this->stopTimer();
        }
        this->setVerified(); // times only: the tests of accuracy are elsewhere
    }

    template <typename Work>
    void timeOver(Pictures& pictures, Work work)
    {
        timeOver(pictures, []() {}, work);
    }
};

} // namespace

#endif
