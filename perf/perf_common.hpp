// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_PERF_GWATERSHED_COMMON_HPP
#define OPENCV_PERF_GWATERSHED_COMMON_HPP

#include "perf_precomp.hpp"

namespace opencv_test
{

//! The sizes that every case is timed at.
#define GWATERSHED_PERF_SIZES testing::Values(szVGA, sz720p, sz1080p, sz2160p)

//! Side in pixels of the superpixels that every case makes.
const int PERF_REGION_SIZE = 20;

inline int perfNumSuperpixels(Size size)
{
    return size.area() / (PERF_REGION_SIZE * PERF_REGION_SIZE);
}

/** Different pictures of one size, used in turn: a branch predictor learns a single one.

They are cut out of the photographs of OpenCV's samples/data (OPENCV_SAMPLES_DATA_PATH), with
the disparity of aloeL.jpg as depth; out of generated scenes where these are not found. */
class Pictures
{
public:
    explicit Pictures(Size size);

    //! Goes on to the next picture.
    void next() { index_ = (index_ + 1) % images_.size(); }
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
