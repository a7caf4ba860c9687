// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FUZZ_SESSION_HPP
#define OPENCV_GWATERSHED_FUZZ_SESSION_HPP

#include "pictures.hpp"
#include "threads.hpp"

namespace fuzz
{

//! Makes an object and calls it as the bytes say. Every call must do what it is documented to do, or, where an
//! argument is wrong, throw cv::Exception and change nothing.
class Session
{
public:
    //! @param max_pixels Largest image.
    //! @param threads If there are any, the bytes tell how many are used.
    Session(const std::vector<uint8_t>& bytes, int max_pixels, Threads* threads);

    //! Returns a number made of all results; the same bytes give the same number.
    uint64 run();

private:
    struct State;

    void create();
    void callOne();

    void changeScene();
    void iterate();
    void iterateKept(int num_iterations);
    void setMask();
    void maskHasBecome(const Mat& mask);
    void setMarkers();
    void setParameter();
    void mergeSimilar();
    void mergeSmall();
    void query();
    void queryWrong();
    void queryUnsegmented();
    void writeAndRead();
    void readNumbers();
    void clear();

    void checkIterated(const Mat& image, const Mat& depth, int num_iterations);
    void updateTwin();
    bool fits(Size size) const;
    bool isSegmented() const { return !gws_->empty(); }
    State state() const;
    void useThreads();
    void digest(const Mat& result);
    template <typename Call> bool attempt(bool is_valid, const char* name, Call call);

    Bytes bytes_;
    const int max_pixels_;
    Threads* const threads_;
    uint64 digest_ = 14695981039346656037u; // FNV-1a

    Ptr<SuperpixelGWatershed> gws_;
    Ptr<SuperpixelGWatershed> twin_; // has seen all frames since frames follow each other, but not the outside of masks
    Mat kept_image_, kept_depth_; // what the factory was given
    Mat mask_, markers_;          // what was set, as it was then
    Mat scene_;

    // Of the last iterate().
    Mat image_, depth_;
    Settings used_;
    Partition unmerged_;          // what mergeSimilar() starts from
    Partition merged_;            // what it gave the last time, if that is not empty
};

} // namespace

#endif
