// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "attempts.hpp"

#include <cfloat>
#include <cmath>

namespace fuzz
{

using cv::FileStorage;
using cv::noArray;
using cv::ximgproc::createSuperpixelGWatershed;
using cv::ximgproc::GWATERSHED;
using cv::ximgproc::RGWATERSHED;

Session::State Session::state() const
{
    State s;
    s.settings = settingsOf(*gws_);
    s.is_segmented = isSegmented();
    s.partition.num_labels = 0;
    if (s.is_segmented)
        s.partition = partitionOf(*gws_);
    require(s.partition.num_labels == gws_->getNumberOfSuperpixels(), "N is 0 before the first iterate()");
    return s;
}

Session::Session(const std::vector<uint8_t>& bytes, int max_pixels, Threads* threads)
    : bytes_(bytes.data(), bytes.size()), max_pixels_(max_pixels), threads_(threads)
{
}

uint64 Session::run()
{
    const int MAX_CALLS = 40;
    create();
    for (int i = 0; i < MAX_CALLS && !gws_.empty() && bytes_.remaining_bytes() > 0; i++)
        callOne();
    return digest_;
}

void Session::digest(const Mat& result)
{
    const size_t bytes = result.cols * result.elemSize();
    for (int y = 0; y < result.rows; y++)
        for (size_t i = 0; i < bytes; i++)
            digest_ = (digest_ ^ result.ptr(y)[i]) * 1099511628211u;
}

void Session::useThreads()
{
    const int count = bytes_.PickValueInArray({ 0, 0, 0, 1, 1, 2 });
    if (threads_)
        threads_->use(count);
}

//! One of the three factories. There is no object if an argument was wrong.
void Session::create()
{
    scene_ = makeScene(takeSize(max_pixels_, bytes_), bytes_);
    const int algorithm = bytes_.PickValueInArray({ int(GWATERSHED), int(RGWATERSHED), int(RGWATERSHED),
                                                    oneIn(32, bytes_) ? 199 : int(RGWATERSHED) });
    const bool is_algorithm = algorithm == GWATERSHED || algorithm == RGWATERSHED;
    const float ruler = takeFloat(40, bytes_);
    const bool is_ruler = ruler >= 0 && ruler <= FLT_MAX;
    const int number = takeInt(200, bytes_);
    if (oneIn(3, bytes_))
    {
        const int channels = bytes_.PickValueInArray({ 1, 3, 3, 3, 4, 2, 0, 5 });
        const int width = oneIn(16, bytes_) ? bytes_.PickValueInArray({ 0, -1, INT_MIN, INT_MAX }) : scene_.cols;
        const bool is_valid = is_algorithm && is_ruler && number >= 1 && width >= 1 && width < INT_MAX &&
                              channels >= 1 && channels <= 4;
        require(succeeds([&]()
        {
            gws_ = createSuperpixelGWatershed(width, scene_.rows, channels, number, algorithm, ruler);
        }) == is_valid, "the factory takes sizes");
        return;
    }
    Guarded image(makeImage(scene_, bytes_), bytes_);
    kept_image_ = image.mat().clone();
    bool is_valid = is_algorithm && is_ruler && number >= 1 && isImage(kept_image_);
    if (oneIn(2, bytes_))
    {
        Guarded depth(makeDepth(scene_, bytes_), bytes_);
        kept_depth_ = depth.mat().clone();
        const float alpha = takeFloat(1, bytes_);
        is_valid = is_valid && alpha >= 0 && alpha <= 1 && isDepth(kept_depth_, kept_image_.size());
        require(succeeds([&]() { gws_ = createSuperpixelGWatershed(image.mat(), depth.mat(), algorithm, number, ruler,
                                                                   alpha); }) == is_valid,
                "the factory takes images with depth");
        require(depth.untouched(), "the factory does not write to depth");
        depth.overwrite(77);
    }
    else
        require(succeeds([&]() { gws_ = createSuperpixelGWatershed(image.mat(), algorithm, number, ruler); }) ==
                is_valid, "the factory takes images");
    require(image.untouched(), "the factory does not write to the image");
    image.overwrite(77);
}

void Session::callOne()
{
    switch (bytes_.ConsumeIntegralInRange(0, 19))
    {
    case 0: return setMask();
    case 1: return setMarkers();
    case 2: case 3: case 4: case 5: return setParameter();
    case 6: case 7: return mergeSimilar();
    case 8: return mergeSmall();
    case 9: case 10: return query();
    case 11: return queryWrong();
    case 12: return writeAndRead();
    case 13: return readNumbers();
    case 14: return clear();
    case 15: return iterateKept(takeInt(5, bytes_));
    default: return iterate();
    }
}

bool Session::fits(Size size) const
{
    return (mask_.empty() || mask_.size() == size) && (markers_.empty() || markers_.size() == size);
}

//! Most often a scene that the mask fits; else one that has to do with the last one or has not.
void Session::changeScene()
{
    if (oneIn(3, bytes_))
        scene_ = makeScene(takeSize(max_pixels_, bytes_), bytes_);
    else
        scene_ = fuzz::changeScene(scene_, bytes_);
    if (!fits(scene_.size()) && !oneIn(8, bytes_))
    {
        markers_ = Mat();
        gws_->setMask(noArray());
        maskHasBecome(Mat());
        gws_->setMarkers(noArray());
    }
}

//! Many iterations must come to an end, too: nothing moves any more.
static int takeIterations(Bytes& bytes)
{
    return bytes.PickValueInArray({ 1, 1, 1, 2, 3, 8, 1000, INT_MAX, 0, -1 });
}

void Session::iterate()
{
    changeScene();
    Guarded image(makeImage(scene_, bytes_), bytes_);
    const int num_iterations = takeIterations(bytes_);
    const bool with_depth = oneIn(3, bytes_);
    Guarded depth(with_depth ? makeDepth(scene_, bytes_) : Mat(), bytes_);
    const bool is_valid = isImage(image.mat()) && fits(image.mat().size()) && num_iterations >= 1 &&
                          isDepth(depth.mat(), image.mat().size());
    const bool as_umat = is_valid && oneIn(16, bytes_), as_vector = oneIn(64, bytes_);
    useThreads();
    const bool accepted = attempt(is_valid && !as_vector, "iterate() of an image", [&]()
    {
        if (as_vector)
            gws_->iterate(std::vector<Mat>(1, image.mat()), num_iterations);
        else if (with_depth)
            gws_->iterate(image.mat(), depth.mat(), num_iterations);
        else if (as_umat)
            gws_->iterate(image.mat().getUMat(cv::ACCESS_READ), num_iterations);
        else
            gws_->iterate(image.mat(), num_iterations);
    });
    require(image.untouched(), "iterate() does not write to the image");
    require(depth.untouched(), "iterate() does not write to depth");
    if (accepted)
        checkIterated(image.mat(), depth.mat(), num_iterations);
}

void Session::iterateKept(int num_iterations)
{
    const bool is_valid = !kept_image_.empty() && fits(kept_image_.size()) && num_iterations >= 1;
    useThreads();
    if (attempt(is_valid, "iterate() of the image of the factory", [&]() { gws_->iterate(num_iterations); }))
        checkIterated(kept_image_, kept_depth_, num_iterations);
}

//! Gives the twin the parameters and the maps of the object. If there is none, makes one.
void Session::updateTwin()
{
    FileStorage written(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    gws_->write(written);
    FileStorage kept(written.releaseAndGetString(), FileStorage::READ | FileStorage::MEMORY);
    if (!twin_)
    {
        twin_ = createSuperpixelGWatershed(7, 5, 1, 3);
        twin_->setMask(mask_);
    }
    twin_->read(kept.root());
    require(settingsOf(*twin_) == settingsOf(*gws_), "read() restores what write() stored");
    twin_->setMarkers(markers_);
}

void Session::checkIterated(const Mat& image, const Mat& depth, int num_iterations)
{
    image_ = image.clone();
    depth_ = depth.clone();
    used_ = settingsOf(*gws_);
    unmerged_ = partitionOf(*gws_);
    merged_ = Partition();
    digest(unmerged_.labels);
    checkSegmentation(unmerged_, image.size(), mask_, markers_, used_);
    if (!used_.temporal && oneIn(2, bytes_))
    {
        twin_.release();
        return;
    }
    updateTwin();
    if (!mask_.empty()) // what is outside does not matter
    {
        image_.setTo(Scalar::all(200), mask_ == 0);
        if (!depth_.empty())
            depth_.setTo(Scalar(100), mask_ == 0);
    }
    useThreads();
    if (depth.empty())
        twin_->iterate(image_, num_iterations);
    else
        twin_->iterate(image_, depth_, num_iterations);
    require(twin_->getNumberOfSuperpixels() == unmerged_.num_labels, "N is the same for another object");
    require(same(partitionOf(*twin_).labels, unmerged_.labels), "labels are the same for another object");
}

void Session::maskHasBecome(const Mat& mask)
{
    mask_ = mask;
    if (twin_) // two masks in turn are not the same as none: frames do not follow across them
        twin_->setMask(mask_);
}

void Session::setMask()
{
    Guarded mask(oneIn(4, bytes_) ? Mat() : makeMask(scene_.size(), bytes_), bytes_);
    const Mat given = mask.mat().clone();
    if (attempt(given.empty() || (given.dims == 2 && given.type() == CV_8UC1), "setMask()",
                [&]() { gws_->setMask(mask.mat()); }))
        maskHasBecome(given);
    require(mask.untouched(), "setMask() does not write to the mask");
    mask.overwrite(77);
}

void Session::setMarkers()
{
    Guarded markers(oneIn(4, bytes_) ? Mat() : makeMarkers(scene_.size(), bytes_), bytes_);
    const Mat given = markers.mat().clone();
    if (attempt(given.empty() || (given.dims == 2 && given.type() == CV_32SC1), "setMarkers()",
                [&]() { gws_->setMarkers(markers.mat()); }))
        markers_ = given;
    require(markers.untouched(), "setMarkers() does not write to the markers");
    markers.overwrite(77);
}

void Session::clear()
{
    const Settings before = settingsOf(*gws_);
    gws_->clear();
    require(settingsOf(*gws_) == before, "clear() keeps the parameters");
    require(gws_->empty(), "clear() drops the segmentation");
    kept_image_ = kept_depth_ = mask_ = markers_ = Mat();
    twin_.release();
    queryUnsegmented();
}

} // namespace
