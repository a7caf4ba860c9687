// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arguments.hpp"
#include "conversion.hpp"
#include "gwatershed/gwatershed.hpp"
#include "results/adjacency.hpp"
#include "results/contours.hpp"
#include "results/merge_small.hpp"
#include "results/statistics.hpp"
#include "rgwatershed/rgwatershed.hpp"
#include "rgwatershed/tuning.hpp"
#include "segmentation.hpp"
#include "shared/user_markers.hpp"

#include <new>

namespace cv { namespace ximgproc {

namespace {

//! Turns the exception of the standard library for a lack of memory into that of OpenCV.
template <typename Work> void guardMemory(Work work)
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

class SuperpixelGWatershedImpl CV_FINAL : public SuperpixelGWatershed
{
public:
    explicit SuperpixelGWatershedImpl(const gws::Parameters& parameters) : parameters_(parameters) {}

    //! Makes room for images of a size.
    void reserve(Size size)
    {
        if (parameters_.algorithm == GWATERSHED)
            gwatershed_.reserve(size);
        else
            rgwatershed_.reserve(size);
        result_.labels.create(size, CV_32SC1);
    }

    //! Keeps the image, and the depth if there is any, for iterate().
    void keep(const Mat& image, const Mat& depth)
    {
        image.copyTo(image_);
        depth.copyTo(depth_);
    }

    int getNumberOfSuperpixels() const CV_OVERRIDE { return result_.number; }

    void iterate(int num_iterations) CV_OVERRIDE
    {
        if (image_.empty())
            CV_Error(Error::StsError, "There is no image: call iterate(image), or give one to the factory");
        gws::checkIterations(num_iterations);
        segment(image_, depth_, num_iterations);
    }

    void iterate(InputArray image, int num_iterations) CV_OVERRIDE
    {
        const Mat checked = gws::checkImage(image);
        gws::checkIterations(num_iterations);
        segment(checked, Mat(), num_iterations);
    }

    void iterate(InputArray image, InputArray depth, int num_iterations) CV_OVERRIDE
    {
        const Mat checked = gws::checkImage(image), checked_depth = gws::checkDepth(depth, checked.size());
        gws::checkIterations(num_iterations);
        segment(checked, checked_depth, num_iterations);
    }

    void getLabels(OutputArray labels_out) const CV_OVERRIDE
    {
        checkSegmented();
        gws::checkOutput(labels_out, CV_32SC1, result_.isLine(), "labels_out");
        guardMemory([&]() { give(result_.labels, labels_out); });
    }

    void getLabelContourMask(OutputArray image, bool thick_line) const CV_OVERRIDE
    {
        checkSegmented();
        gws::checkOutput(image, CV_8UC1, result_.isLine(), "image");
        guardMemory([&]()
        {
            Mat mask = gws::createOutput(image, result_.labels.size(), CV_8UC1);
            gws::drawContours(result_.labels, thick_line, mask);
        });
    }

    void getWatershedLineMask(OutputArray image) const CV_OVERRIDE
    {
        checkSegmented();
        gws::checkOutput(image, CV_8UC1, result_.isLine(), "image");
        guardMemory([&]()
        {
            Mat mask = gws::createOutput(image, result_.labels.size(), CV_8UC1);
            mask.setTo(Scalar(0));
            if (result_.number > 0 && result_.parameters.algorithm == GWATERSHED)
            {
                Mat part = mask(result_.bounds);
                gwatershed_.drawLines(part);
            }
        });
    }

    void enforceLabelConnectivity(int min_element_size) CV_OVERRIDE
    {
        checkSegmented();
        CV_Check(min_element_size, min_element_size >= 0 && min_element_size <= 100,
                 "min_element_size must be in [0, 100] percent");
        if (result_.number == 0)
            return;
        const int before = result_.number;
        guardMemory([&]()
        {
            const int64 whole = int64(100) * result_.number;
            const int64 min_area = (int64(countNonZero(result_.labels >= 0)) * min_element_size + whole - 1) / whole;
            result_.number = gws::mergeSmallRegions(result_.number, int(min_area), result_.labels);
        });
        if (result_.number < before)
            result_.hierarchy = gws::MergeHierarchy();
    }

    void mergeSimilar(int num_superpixels) CV_OVERRIDE
    {
        checkSegmented();
        CV_CheckGE(num_superpixels, 1, "num_superpixels must be 1 or more");
        if (result_.number == 0)
            return;
        guardMemory([&]()
        {
            Mat part = result_.labels(result_.bounds);
            if (result_.hierarchy.empty())
                buildHierarchy(part);
            result_.number = result_.hierarchy.cut(num_superpixels, part);
        });
    }

    void getStatistics(InputArray image, InputArray depth, OutputArray stats, OutputArray centroids,
                       OutputArray mean_colors, OutputArray mean_depths) const CV_OVERRIDE
    {
        checkSegmented();
        const Mat values = gws::checkValues(image, result_.labels.size());
        const Mat depths = depth.empty() ? Mat() : gws::checkDepth(depth, result_.labels.size());
        checkTable(stats, CV_32SC1, false, "stats");
        checkTable(centroids, CV_64FC1, false, "centroids");
        checkTable(mean_colors, CV_32FC1, values.channels() == 1, "mean_colors");
        checkTable(mean_depths, CV_32FC1, true, "mean_depths");
        guardMemory([&]()
        {
            Mat tables[4];
            gws::measureSuperpixels(result_.labels, result_.number, values, depths, tables[0], tables[1], tables[2],
                                    tables[3]);
            give(tables[0], stats);
            give(tables[1], centroids);
            give(tables[2], mean_colors);
            give(tables[3], mean_depths);
        });
    }

    void getAdjacency(InputArray image, InputArray depth, OutputArray pairs, OutputArray lengths,
                      OutputArray contrasts) const CV_OVERRIDE
    {
        checkSegmented();
        const Mat values = image.empty() ? Mat() : gws::checkImage(gws::checkValues(image, result_.labels.size()));
        if (image.empty() && !depth.empty())
            CV_Error(Error::StsBadArg, "depth must be empty where image is");
        const Mat depths = depth.empty() ? Mat() : gws::checkDepth(depth, result_.labels.size());
        checkTable(pairs, CV_32SC1, false, "pairs");
        checkTable(lengths, CV_32SC1, true, "lengths");
        checkTable(contrasts, CV_32FC1, true, "contrasts");
        guardMemory([&]()
        {
            Mat converted, scaled, tables[3];
            const Mat color = values.empty() ? Mat() : gws::convertImage(values(result_.bounds), converted);
            const Mat depth_inside = depths.empty() ? Mat() : depths(result_.bounds);
            const Mat mask_inside = result_.mask.empty() ? Mat() : result_.mask.pixels(result_.bounds);
            gws::listAdjacency(result_.labels(result_.bounds), result_.number, color,
                               scaleInside(depth_inside, mask_inside, scaled), result_.parameters.alphaWeight(),
                               tables[0], tables[1], tables[2]);
            give(tables[0], pairs);
            give(tables[1], lengths);
            give(tables[2], contrasts);
        });
    }

    void setMask(InputArray mask) CV_OVERRIDE
    {
        guardMemory([&]()
        {
            const gws::Mask checked(gws::checkMask(mask));
            if (!(checked == mask_)) // nothing fails from here on, so that all of the mask is set, or none of it
                last_ = Last();
            mask_ = checked;
        });
    }
    void setMarkers(InputArray markers) CV_OVERRIDE
    {
        guardMemory([&]() { markers_ = gws::checkMarkers(markers).clone(); });
    }

    void setAlgorithm(int algorithm) CV_OVERRIDE { parameters_.setAlgorithm(algorithm); }
    int getAlgorithm() const CV_OVERRIDE { return parameters_.algorithm; }
    void setRegionSize(int region_size) CV_OVERRIDE { parameters_.setRegionSize(region_size); }
    int getRegionSize() const CV_OVERRIDE { return parameters_.region_size; }
    void setDesiredSuperpixels(int number) CV_OVERRIDE { parameters_.setDesiredSuperpixels(number); }
    int getDesiredSuperpixels() const CV_OVERRIDE { return parameters_.num_superpixels; }
    void setRuler(float ruler) CV_OVERRIDE { parameters_.setRuler(ruler); }
    float getRuler() const CV_OVERRIDE { return parameters_.ruler; }
    void setAlpha(float alpha) CV_OVERRIDE { parameters_.setAlpha(alpha); }
    float getAlpha() const CV_OVERRIDE { return parameters_.alpha; }
    void setLabInput(bool uniform) CV_OVERRIDE { parameters_.lab_input = uniform; }
    bool getLabInput() const CV_OVERRIDE { return parameters_.lab_input; }
    void setTemporal(bool temporal) CV_OVERRIDE { parameters_.temporal = temporal; }
    bool getTemporal() const CV_OVERRIDE { return parameters_.temporal; }
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
    bool empty() const CV_OVERRIDE { return result_.empty(); }
    String getDefaultName() const CV_OVERRIDE { return "SuperpixelGWatershed"; }

private:
    void checkSegmented() const
    {
        if (empty())
            CV_Error(Error::StsError, "There is no segmentation: call iterate() first");
    }

    //! What the next frame must have in common with the last one to go on from it in temporal mode.
    struct Last
    {
        int algorithm = 0; // 0: there is nothing to go on from
        Size size;
        int num_superpixels = 0;

        bool operator==(const Last& other) const
        {
            return algorithm == other.algorithm && size == other.size && num_superpixels == other.num_superpixels;
        }
    };

    //! Checks an output that may be left out.
    static void checkTable(OutputArray output, int type, bool is_line, const char* name)
    {
        if (output.needed())
            gws::checkOutput(output, type, is_line, name);
    }

    //! Copies a table to an output, if that is wanted. Without rows, too, it has its columns and its type.
    static void give(const Mat& table, OutputArray output)
    {
        if (!output.needed())
            return;
        Mat copy = gws::createOutput(output, table.size(), table.type());
        table.copyTo(copy);
    }

    //! Scaled depth. What is outside of the mask is dropped first, so that it has no influence on the scale.
    Mat scaleInside(const Mat& depth, const Mat& mask, Mat& buffer) const
    {
        const float near_depth = result_.parameters.near_depth, far_depth = result_.parameters.far_depth;
        if (depth.empty() || mask.empty())
            return gws::scaleDepth(depth, near_depth, far_depth, buffer);
        Mat inside(depth.size(), depth.type(), Scalar(0));
        depth.copyTo(inside, mask);
        return gws::scaleDepth(inside, near_depth, far_depth, buffer);
    }

    void checkMaps(Size size) const
    {
        if (!mask_.empty())
            CV_CheckEQ(mask_.pixels.size(), size, "mask must have the size of image; setMask() of an empty one drops"
                                                  " it");
        if (!markers_.empty())
            CV_CheckEQ(markers_.size(), size, "markers must have the size of image; setMarkers() of empty ones"
                                              " drops them");
    }

    //! Checks, makes the frame, runs the algorithm and keeps what the next frame goes on from. If something fails on
    //! the way, there is no segmentation, and the next call goes on from nothing.
    void segment(const Mat& image, const Mat& depth, int num_iterations)
    {
        CV_TRACE_FUNCTION();
        checkMaps(image.size());
        result_.complete = false;
        const Last last = last_;
        last_ = Last();
        guardMemory([&]()
        {
            result_.start(image.size(), parameters_, mask_);
            if (!result_.bounds.empty())
                run(makeFrame(image(result_.bounds), depth.empty() ? Mat() : depth(result_.bounds)), last,
                    num_iterations);
        });
        result_.complete = true;
    }

    //! Frame of what is inside of the bounds. A mask without a pixel outside is left out.
    gws::Frame makeFrame(const Mat& image, const Mat& depth)
    {
        const Rect bounds = result_.bounds;
        gws::Frame frame;
        frame.num_pixels = mask_.empty() ? bounds.area() : mask_.area;
        if (frame.num_pixels < bounds.area())
            frame.mask = mask_.pixels(bounds);
        frame.color = gws::convertImage(image, converted_);
        frame.depth = scaleInside(depth, frame.mask, scaled_);
        frame.num_superpixels = parameters_.countSuperpixels(frame.num_pixels);
        if (!markers_.empty())
        {
            frame.num_superpixels = gws::numberMarkers(markers_(bounds), frame.mask, numbered_);
            frame.markers = numbered_;
        }
        return frame;
    }

    void run(gws::Frame frame, const Last& last, int num_iterations)
    {
        Mat labels = result_.labels(result_.bounds);
        if (frame.num_superpixels == 0)
        {
            labels.setTo(Scalar(-1));
            return;
        }
        Last now;
        now.algorithm = parameters_.algorithm;
        now.size = result_.labels.size();
        now.num_superpixels = frame.num_superpixels;
        const bool temporal = parameters_.temporal && markers_.empty();
        frame.continues = temporal && now == last;
        result_.number = parameters_.algorithm == GWATERSHED
                ? gwatershed_.run(frame, parameters_, labels)
                : rgwatershed_.run(frame, parameters_, num_iterations, labels);
        if (!frame.mask.empty())
            max(labels, Scalar(-1), labels);
        if (temporal)
            last_ = now;
    }

    void buildHierarchy(const Mat& labels)
    {
        const gws::Parameters& used = result_.parameters;
        const gws::Padded<gws::Feature> features = used.algorithm == GWATERSHED
                ? gwatershed_.features(used.lab_input) : rgwatershed_.features();
        result_.hierarchy.build(features, gws::floodDistance(used.alpha, true), labels, result_.number);
    }

    gws::Parameters parameters_;
    Mat image_, depth_; // copies of what the factory was given
    gws::Mask mask_;    // copies of what was set
    Mat markers_;

    gws::Segmentation result_;
    Last last_;

    // The algorithms, and buffers that stay from one image to the next.
    gws::GWatershed gwatershed_;
    gws::RGWatershed rgwatershed_;
    Mat converted_, scaled_, numbered_;
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
    gws::checkSize(image_width, image_height);
    gws::Parameters parameters;
    parameters.setDesiredSuperpixels(num_superpixels);
    parameters.setAlgorithm(algorithm);
    parameters.setRuler(ruler);

    Ptr<SuperpixelGWatershedImpl> gws;
    guardMemory([&]()
    {
        gws = makePtr<SuperpixelGWatershedImpl>(parameters);
        gws->reserve(Size(image_width, image_height));
    });
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

    Ptr<SuperpixelGWatershedImpl> gws;
    guardMemory([&]()
    {
        gws = makePtr<SuperpixelGWatershedImpl>(parameters);
        gws->keep(image, depth);
    });
    return gws;
}

Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(InputArray image, int algorithm, int region_size,
                                                     float ruler)
{
    return createForImage(gws::checkImage(image), Mat(), algorithm, region_size, ruler, gws::Parameters().alpha);
}

Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(InputArray image, InputArray depth, int algorithm,
                                                     int region_size, float ruler, float alpha)
{
    const Mat checked = gws::checkImage(image);
    return createForImage(checked, gws::checkDepth(depth, checked.size()), algorithm, region_size, ruler, alpha);
}

}} // namespace
