// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "attempts.hpp"

// Calls that merge superpixels, and those that ask for results.

namespace fuzz
{

using cv::noArray;

void Session::mergeSimilar()
{
    const int number = takeInt(isSegmented() ? unmerged_.num_labels + 2 : 3, bytes_);
    if (!attempt(isSegmented() && number >= 1, "mergeSimilar()", [&]() { gws_->mergeSimilar(number); }))
        return;
    const Partition now = partitionOf(*gws_);
    digest(now.labels);
    checkMerged(unmerged_, now);
    checkMergedNumber(unmerged_, number, now);
    if (!merged_.labels.empty() && merged_.num_labels >= now.num_labels)
        checkMerged(merged_, now);
    else if (!merged_.labels.empty())
        checkMerged(now, merged_);
    merged_ = now;
}

void Session::mergeSmall()
{
    if (!isSegmented())
        return queryUnsegmented();
    const Partition before = partitionOf(*gws_);
    const int percent = oneIn(4, bytes_) ? takeInt(100, bytes_) : 25, in_pixels = oneIn(3, bytes_);
    if (!attempt(percent >= 0 && (in_pixels || percent <= 100), "merging of small superpixels",
                 [&]() { in_pixels ? gws_->mergeSmall(percent) : gws_->enforceLabelConnectivity(percent); }))
        return;
    const Partition now = partitionOf(*gws_);
    digest(now.labels);
    checkMerged(before, now);
    (in_pixels ? checkAreaMerged : checkSmallMerged)(before, percent, now);
    if (now.num_labels == before.num_labels)
        return;
    unmerged_ = now;
    merged_ = Partition();
}

//! Const methods with arguments that they take.
void Session::query()
{
    if (!isSegmented())
        return queryUnsegmented();
    const State before = state();
    useThreads();
    const Mat values = oneIn(2, bytes_) ? makeValues(image_.size(), bytes_) : image_;
    const Mat nothing;
    const Mat& image = oneIn(4, bytes_) ? nothing : image_;
    const Mat& depth = oneIn(4, bytes_) ? nothing : depth_;
    checkStatistics(*gws_, oneIn(4, bytes_) ? nothing : values, depth);
    checkAdjacency(*gws_, image, image.empty() ? nothing : depth);
    checkMasks(*gws_, used_.algorithm);
    require(state() == before, "const methods change nothing");

    Mat stats, centroids, colors, depths, pairs, lengths, contrasts, positions, normals;
    gws_->getStatistics(values, depth_, stats, centroids, colors, depths, positions, normals);
    gws_->getAdjacency(image_, depth_, pairs, lengths, contrasts);
    for (const Mat& table : { colors, depths, contrasts, positions })
        digest(table);
}

//! Const methods with arguments of a wrong size or type.
void Session::queryWrong()
{
    if (!isSegmented())
        return queryUnsegmented();
    const Size size = image_.size(), other = size + Size(0, 1);
    const Mat wrong = makeImage(Mat(oneIn(2, bytes_) ? size : other, CV_32FC3, Scalar::all(0.5)), bytes_);
    const bool is_measured = wrong.empty() || (wrong.dims == 2 && wrong.size() == size);
    Mat a, b, c, d, e;
    attempt(is_measured, "getStatistics() of an image", [&]() { gws_->getStatistics(wrong, noArray(), a, b, c, d); });
    attempt(isDepth(wrong, size), "getStatistics() of depth",
            [&]() { gws_->getStatistics(noArray(), wrong, a, b, noArray(), c, d, e); });
    attempt(wrong.empty() || (is_measured && isImage(wrong)), "getAdjacency() of an image",
            [&]() { gws_->getAdjacency(wrong, noArray(), a, b, c); });
    attempt(isDepth(wrong, size), "getAdjacency() of depth",
            [&]() { gws_->getAdjacency(image_, wrong, a, b, noArray()); });
    attempt(wrong.empty(), "getAdjacency() of depth alone", [&]() { gws_->getAdjacency(noArray(), wrong, a, b, c); });
    attempt(false, "getLabels() to nowhere", [&]() { gws_->getLabels(noArray()); });
}

//! What needs a segmentation throws where there is none.
void Session::queryUnsegmented()
{
    Mat a, b, c, d;
    attempt(false, "getLabels()", [&]() { gws_->getLabels(a); });
    attempt(false, "getLabelContourMask()", [&]() { gws_->getLabelContourMask(a); });
    attempt(false, "getWatershedLineMask()", [&]() { gws_->getWatershedLineMask(a); });
    attempt(false, "enforceLabelConnectivity()", [&]() { gws_->enforceLabelConnectivity(); });
    attempt(false, "getStatistics()", [&]() { gws_->getStatistics(noArray(), noArray(), a, b, c, d); });
    attempt(false, "getAdjacency()", [&]() { gws_->getAdjacency(noArray(), noArray(), a, b, c); });
}

} // namespace
