// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plain_watershed.hpp"
#include "region_watershed.hpp"
#include "steps.hpp"

#include <new>

namespace cv { namespace ximgproc {

namespace {

void checkIterations(int num_iterations)
{
    CV_CheckGE(num_iterations, 1, "num_iterations must be 1 or more");
}

void checkSize(int64 width, int64 height)
{
    const double nodes = double(width + 2) * (height + 2);
    CV_Check(nodes, nodes < INT_MAX - 2, "image, with a frame of one pixel, must have fewer than 2^31 - 3 pixels");
}

//! Takes the header of an image that can be segmented.
Mat checkImage(InputArray input)
{
    CV_Assert(!input.empty() && "image must not be empty");
    CV_Assert(!input.isMatVector() && !input.isUMatVector() && "image must be one Mat or UMat");
    Mat image = input.getMat();
    CV_CheckEQ(image.dims, 2, "image must have two dimensions");
    CV_Check(image.depth(), image.depth() == CV_8U || image.depth() == CV_16U || image.depth() == CV_32F,
             "image must be CV_8U, CV_16U or CV_32F");
    CV_Check(image.channels(), image.channels() == 1 || image.channels() == 3 || image.channels() == 4,
             "image must have 1, 3 or 4 channels");
    checkSize(image.cols, image.rows);
    return image;
}

//! Takes the header of the depth of an image.
Mat checkDepth(InputArray input, Size size)
{
    CV_Assert(!input.empty() && "depth must not be empty; call iterate(image) where there is none");
    CV_Assert(!input.isMatVector() && !input.isUMatVector() && "depth must be one Mat or UMat");
    Mat depth = input.getMat();
    CV_CheckEQ(depth.dims, 2, "depth must have two dimensions");
    CV_CheckType(depth.type(), depth.type() == CV_8UC1 || depth.type() == CV_16UC1 || depth.type() == CV_32FC1,
                 "depth must be CV_8UC1, CV_16UC1 or CV_32FC1");
    CV_CheckEQ(depth.size(), size, "depth must have the size of image");
    return depth;
}

class SuperpixelGWatershedImpl CV_FINAL : public SuperpixelGWatershed
{
public:
    explicit SuperpixelGWatershedImpl(const gws::Parameters& parameters) : parameters_(parameters) {}

    //! Makes room for images of a size.
    void reserve(Size size)
    {
        if (parameters_.algorithm == GWATERSHED)
            plain_.reserve(size);
        else
            region_guided_.reserve(size);
        labels_.create(size, CV_32SC1);
    }

    //! Keeps the image, and the depth if there is any, for iterate().
    void keep(const Mat& image, const Mat& depth)
    {
        image.copyTo(image_);
        depth.copyTo(depth_);
    }

    int getNumberOfSuperpixels() const CV_OVERRIDE { return num_labels_; }

    void iterate(int num_iterations) CV_OVERRIDE
    {
        if (image_.empty())
            CV_Error(Error::StsError, "There is no image: call iterate(image), or give one to the factory");
        checkIterations(num_iterations);
        segment(image_, depth_, num_iterations);
    }

    void iterate(InputArray image, int num_iterations) CV_OVERRIDE
    {
        const Mat checked = checkImage(image);
        checkIterations(num_iterations);
        segment(checked, Mat(), num_iterations);
    }

    void iterate(InputArray image, InputArray depth, int num_iterations) CV_OVERRIDE
    {
        const Mat checked = checkImage(image), checked_depth = checkDepth(depth, checked.size());
        checkIterations(num_iterations);
        segment(checked, checked_depth, num_iterations);
    }

    void getLabels(OutputArray labels_out) const CV_OVERRIDE
    {
        checkSegmented();
        labels_.copyTo(labels_out);
    }

    void getLabelContourMask(OutputArray image, bool thick_line) const CV_OVERRIDE
    {
        checkSegmented();
        image.create(labels_.size(), CV_8UC1);
        Mat mask = image.getMat();
        gws::drawContours(labels_, thick_line, mask);
    }

    void getWatershedLineMask(OutputArray image) const CV_OVERRIDE
    {
        checkSegmented();
        image.create(labels_.size(), CV_8UC1);
        Mat mask = image.getMat();
        mask.setTo(Scalar(0));
        if (has_lines_)
            plain_.drawLines(mask);
    }

    void enforceLabelConnectivity(int min_element_size) CV_OVERRIDE
    {
        checkSegmented();
        CV_Check(min_element_size, min_element_size >= 0 && min_element_size <= 100,
                 "min_element_size must be in [0, 100] percent");
        const double mean_area = double(labels_.rows) * labels_.cols / num_labels_;
        guardMemory([&]()
        {
            num_labels_ = gws::mergeSmallRegions(num_labels_, cvCeil(mean_area * min_element_size / 100), labels_);
        });
    }

    void setAlgorithm(int algorithm) CV_OVERRIDE { parameters_.setAlgorithm(algorithm); }
    int getAlgorithm() const CV_OVERRIDE { return parameters_.algorithm; }
    void setRegionSize(int region_size) CV_OVERRIDE { parameters_.setRegionSize(region_size); }
    int getRegionSize() const CV_OVERRIDE { return parameters_.region_size; }
    void setNumSuperpixels(int number) CV_OVERRIDE { parameters_.setNumSuperpixels(number); }
    int getNumSuperpixels() const CV_OVERRIDE { return parameters_.num_superpixels; }
    void setRuler(float ruler) CV_OVERRIDE { parameters_.setRuler(ruler); }
    float getRuler() const CV_OVERRIDE { return parameters_.ruler; }
    void setAlpha(float alpha) CV_OVERRIDE { parameters_.setAlpha(alpha); }
    float getAlpha() const CV_OVERRIDE { return parameters_.alpha; }
    void setUniformColor(bool uniform) CV_OVERRIDE { parameters_.uniform_color = uniform; }
    bool getUniformColor() const CV_OVERRIDE { return parameters_.uniform_color; }
    void setDepthRange(float first, float last) CV_OVERRIDE { parameters_.setDepthRange(first, last); }
    float getNearDepth() const CV_OVERRIDE { return parameters_.near_depth; }
    float getFarDepth() const CV_OVERRIDE { return parameters_.far_depth; }
    void setBorderThreshold(float threshold) CV_OVERRIDE { parameters_.setBorderThreshold(threshold); }
    float getBorderThreshold() const CV_OVERRIDE { return parameters_.border_threshold; }

    void write(FileStorage& fs) const CV_OVERRIDE
    {
        writeFormat(fs);
        parameters_.write(fs);
    }
    void read(const FileNode& fn) CV_OVERRIDE { parameters_ = gws::Parameters::read(fn); }
    void clear() CV_OVERRIDE { *this = SuperpixelGWatershedImpl(parameters_); }
    bool empty() const CV_OVERRIDE { return num_labels_ == 0; }
    String getDefaultName() const CV_OVERRIDE { return "SuperpixelGWatershed"; }

private:
    void checkSegmented() const
    {
        if (num_labels_ == 0)
            CV_Error(Error::StsError, "There is no segmentation: call iterate() first");
    }

    //! Turns the exception of the standard library for a lack of memory into that of OpenCV.
    template <typename Work> static void guardMemory(Work work)
    {
        try
        {
            work();
        }
        catch (const std::bad_alloc&)
        {
            CV_Error(Error::StsNoMem, "Not enough memory for an image of this size");
        }
    }

    //! If something fails on the way, there is no segmentation, and the next call starts anew.
    void segment(const Mat& image, const Mat& depth, int num_iterations)
    {
        num_labels_ = 0;
        if (!complete_)
            region_guided_ = gws::RegionWatershed();
        complete_ = false;
        guardMemory([&]()
        {
            const Mat color = gws::convertImage(image, converted_);
            const Mat scaled = gws::scaleDepth(depth, parameters_.near_depth, parameters_.far_depth, scaled_);
            has_lines_ = parameters_.algorithm == GWATERSHED;
            if (has_lines_)
                plain_.run(color, scaled, parameters_, labels_);
            else
                region_guided_.run(color, scaled, parameters_, num_iterations, labels_);
        });
        complete_ = true;
        num_labels_ = parameters_.countSuperpixels(image.size());
    }

    gws::Parameters parameters_;
    Mat image_, depth_; // copies of what the factory was given

    int num_labels_ = 0; // 0: there is no segmentation
    Mat labels_;
    bool has_lines_ = false; // the segmentation is by GWATERSHED

    // The algorithms, and buffers that stay from one image to the next.
    gws::PlainWatershed plain_;
    gws::RegionWatershed region_guided_;
    bool complete_ = true; // the last run was not broken off by an exception
    Mat converted_, scaled_;
};

} // namespace

Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        int image_width, int image_height, int image_channels, int num_superpixels,
        int algorithm, float ruler)
{
    CV_CheckGE(image_width, 1, "image_width must be 1 or more");
    CV_CheckGE(image_height, 1, "image_height must be 1 or more");
    CV_Check(image_channels, image_channels == 1 || image_channels == 3 || image_channels == 4,
             "image_channels must be 1, 3 or 4");
    checkSize(image_width, image_height);
    gws::Parameters parameters;
    parameters.setNumSuperpixels(num_superpixels);
    parameters.setAlgorithm(algorithm);
    parameters.setRuler(ruler);

    Ptr<SuperpixelGWatershedImpl> gws = makePtr<SuperpixelGWatershedImpl>(parameters);
    gws->reserve(Size(image_width, image_height));
    return gws;
}

static Ptr<SuperpixelGWatershed> createForImage(const Mat& image, const Mat& depth, int algorithm,
                                                int region_size, float ruler, float alpha)
{
    gws::Parameters parameters;
    parameters.setAlgorithm(algorithm);
    parameters.setRegionSize(region_size);
    parameters.setRuler(ruler);
    parameters.setAlpha(alpha);

    Ptr<SuperpixelGWatershedImpl> gws = makePtr<SuperpixelGWatershedImpl>(parameters);
    gws->keep(image, depth);
    return gws;
}

Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(InputArray image, int algorithm, int region_size,
                                                     float ruler)
{
    return createForImage(checkImage(image), Mat(), algorithm, region_size, ruler, gws::Parameters().alpha);
}

Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(InputArray image, InputArray depth, int algorithm,
                                                     int region_size, float ruler, float alpha)
{
    const Mat checked = checkImage(image);
    return createForImage(checked, checkDepth(depth, checked.size()), algorithm, region_size, ruler, alpha);
}

}} // namespace
