// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SUPERPIXEL_METRICS_HPP
#define OPENCV_GWATERSHED_SUPERPIXEL_METRICS_HPP

#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <map>
#include <vector>

//! Measures of a segmentation, as D. Stutz, A. Hermans, B. Leibe, "Superpixels: an evaluation of
//! the state-of-the-art", 2018, define them. Label maps are CV_32SC1.
namespace metrics
{

//! What a segmentation is measured by; means over the ground truths of an image.
struct Scores
{
    double recall = 0;       //!< boundary recall, equation (5) of Jiang et al., 2015
    double ue = 0;           //!< undersegmentation error, equation (6) there, min form
    double asa = 0;          //!< achievable segmentation accuracy
    double ev = 0;           //!< explained variation
    double co = 0;           //!< compactness
    double superpixels = 0;  //!< number of labels
    double components = 0;   //!< number of 4-connected pieces
    double milliseconds = 0;
};

//! Numbers the labels 0..n-1; returns n.
inline int numberLabels(cv::Mat& labels)
{
    std::map<int, int> numbers;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            int& label = labels.at<int>(y, x);
            label = numbers.insert(std::make_pair(label, int(numbers.size()))).first->second;
        }
    return int(numbers.size());
}

//! Number of 4-connected pieces of equal label.
inline int countComponents(const cv::Mat& labels)
{
    cv::Mat rest = labels.clone(); // non-negative labels; -1: seen
    std::vector<cv::Point> open;
    int pieces = 0;
    for (int y = 0; y < rest.rows; y++)
        for (int x = 0; x < rest.cols; x++)
        {
            const int label = rest.at<int>(y, x);
            if (label < 0)
                continue;
            pieces++;
            rest.at<int>(y, x) = -1;
            open.push_back(cv::Point(x, y));
            while (!open.empty())
            {
                const cv::Point p = open.back();
                open.pop_back();
                for (int k = 0; k < 4; k++)
                {
                    const cv::Point q(p.x + (k == 0) - (k == 1), p.y + (k == 2) - (k == 3));
                    if (q.inside(cv::Rect(cv::Point(), rest.size())) && rest.at<int>(q) == label)
                    {
                        rest.at<int>(q) = -1;
                        open.push_back(q);
                    }
                }
            }
        }
    return pieces;
}

//! CV_8UC1, 255 where a 4-neighbour has another label. Label `ignored` makes no boundary.
inline cv::Mat boundaries(const cv::Mat& labels, int ignored = -1)
{
    cv::Mat mask = cv::Mat::zeros(labels.size(), CV_8UC1);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
            for (int k = 0; k < 2; k++)
            {
                const cv::Point p(x, y), q(x + (k == 0), y + (k == 1));
                if (q.x >= labels.cols || q.y >= labels.rows)
                    continue;
                const int a = labels.at<int>(p), b = labels.at<int>(q);
                if (a != b && a != ignored && b != ignored)
                    mask.at<uchar>(p) = mask.at<uchar>(q) = 255;
            }
    return mask;
}

//! Share of the boundary of the truth that lies within 0.0025 of the diagonal of a boundary found.
inline double boundaryRecall(const cv::Mat& found, const cv::Mat& truth)
{
    const double diagonal = std::sqrt(double(found.cols) * found.cols + double(found.rows) * found.rows);
    const int radius = int(0.0025 * diagonal + 0.5);
    cv::Mat near_found;
    cv::dilate(found, near_found, cv::Mat(2 * radius + 1, 2 * radius + 1, CV_8UC1, cv::Scalar(1)));
    const int all = cv::countNonZero(truth);
    return all ? double(cv::countNonZero(near_found & truth)) / all : 0.;
}

//! Undersegmentation error and achievable segmentation accuracy over the pixels of valid.
inline void overlaps(const cv::Mat& labels, const cv::Mat& truth, const cv::Mat& valid, Scores& scores)
{
    std::vector<std::map<int, int> > overlap; // by label: pixels for each segment of the truth
    std::vector<int> area;
    double total = 0, error = 0, achieved = 0;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            if (!valid.at<uchar>(y, x))
                continue;
            const size_t label = labels.at<int>(y, x);
            if (label >= area.size())
            {
                area.resize(label + 1, 0);
                overlap.resize(label + 1);
            }
            area[label]++;
            overlap[label][truth.at<int>(y, x)]++;
            total++;
        }
    for (size_t label = 0; label < area.size(); label++)
    {
        int largest = 0;
        for (std::map<int, int>::const_iterator it = overlap[label].begin(); it != overlap[label].end(); ++it)
        {
            error += std::min(it->second, area[label] - it->second);
            largest = std::max(largest, it->second);
        }
        achieved += largest;
    }
    scores.ue += total > 0 ? error / total : 0;
    scores.asa += total > 0 ? achieved / total : 1;
}

//! Share of the variance of the image that the mean colours of the superpixels keep.
inline double explainedVariation(const cv::Mat& labels, int n, const cv::Mat& image)
{
    std::vector<cv::Vec4d> sums(n, cv::Vec4d::all(0)); // blue, green, red, area
    cv::Vec4d all = cv::Vec4d::all(0);
    double squares = 0;
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            const cv::Vec3b& p = image.at<cv::Vec3b>(y, x);
            const cv::Vec4d value(p[0], p[1], p[2], 1);
            sums[labels.at<int>(y, x)] += value;
            all += value;
            squares += double(p[0]) * p[0] + double(p[1]) * p[1] + double(p[2]) * p[2];
        }
    double between = 0, variation = squares;
    for (int c = 0; c < 3; c++)
    {
        variation -= all[c] * all[c] / all[3];
        for (int i = 0; i < n; i++)
            between += sums[i][3] * std::pow(sums[i][c] / sums[i][3] - all[c] / all[3], 2);
    }
    return variation > 0 ? between / variation : 1.;
}

//! Mean over the pixels of 4 pi area / perimeter^2 of their superpixel; the frame counts.
inline double compactness(const cv::Mat& labels, int n)
{
    std::vector<double> area(n, 0), perimeter(n, 0);
    for (int y = 0; y < labels.rows; y++)
        for (int x = 0; x < labels.cols; x++)
        {
            const int label = labels.at<int>(y, x);
            area[label]++;
            for (int k = 0; k < 4; k++)
            {
                const cv::Point q(x + (k == 0) - (k == 1), y + (k == 2) - (k == 3));
                perimeter[label] += !q.inside(cv::Rect(cv::Point(), labels.size())) || labels.at<int>(q) != label;
            }
        }
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += area[i] * 4 * CV_PI * area[i] / (perimeter[i] * perimeter[i]);
    return sum / labels.total();
}

/** All measures of a segmentation.
@param segmentation CV_32SC1 labels.
@param image CV_8UC3.
@param truths CV_32SC1 label maps of the ground truth.
@param ignore_zero Pixels of label 0 in the truth are not labelled: they do not count. */
inline Scores evaluate(const cv::Mat& segmentation, const cv::Mat& image, const std::vector<cv::Mat>& truths,
                       bool ignore_zero)
{
    Scores scores;
    cv::Mat labels = segmentation.clone();
    const int n = numberLabels(labels);
    const cv::Mat found = boundaries(labels);
    for (size_t i = 0; i < truths.size(); i++)
    {
        scores.recall += boundaryRecall(found, boundaries(truths[i], ignore_zero ? 0 : -1));
        overlaps(labels, truths[i], ignore_zero ? cv::Mat(truths[i] != 0) : cv::Mat(truths[i] == truths[i]), scores);
    }
    scores.recall /= truths.size();
    scores.ue /= truths.size();
    scores.asa /= truths.size();
    scores.ev = explainedVariation(labels, n, image);
    scores.co = compactness(labels, n);
    scores.superpixels = n;
    scores.components = countComponents(labels);
    return scores;
}

} // namespace metrics

#endif
