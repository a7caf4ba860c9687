// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "arguments.hpp"
#include "conversion.hpp"
#include "in_use.hpp"
#include "results/adjacency.hpp"
#include "results/contours.hpp"
#include "results/merge_small.hpp"
#include "results/statistics.hpp"
#include "segmenter.hpp"

#include <new>

namespace cv { namespace ximgproc {

namespace {

//! Turns the exception of the standard library for a lack of memory into that of OpenCV.
template <typename Work> void guardMemory(Work work)
{
    const auto refuse = [] { CV_Error(Error::StsNoMem, "Not enough memory"); };
    try
    {
        work();
    }
    catch (const std::bad_alloc&)
    {
        refuse();
    }
    catch (const std::length_error&) // of a vector that a pointer could not count
    {
        refuse();
    }
}

class SuperpixelGWatershedImpl CV_FINAL : public SuperpixelGWatershed
{
public:
    explicit SuperpixelGWatershedImpl(const gws::Parameters& wanted) : parameters_(wanted) {}

    //! Makes room for images of a size.
    void reserve(Size size)
    {
        segmenter_.reserve(parameters_.algorithm, size);
        result_.labels.create(size, CV_32SC1);
    }

    //! Keeps the image, and the depth if there is any, for iterate().
    void keep(const Mat& image, const Mat& depth)
    {
        image.copyTo(image_);
        depth.copyTo(depth_);
    }

    int getNumberOfSuperpixels() const CV_OVERRIDE
    {
        const gws::Reading use(in_use_);
        return result_.empty() ? 0 : result_.number;
    }

    void iterate(int num_iterations) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        if (image_.empty())
            CV_Error(Error::StsError, "There is no image: call iterate(image), or give one to the factory");
        gws::checkIterations(num_iterations);
        segment(image_, depth_, num_iterations);
    }

    void iterate(InputArray image, int num_iterations) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        const Mat checked = gws::checkImage(image);
        gws::checkIterations(num_iterations);
        segment(checked, Mat(), num_iterations);
    }

    void iterate(InputArray image, InputArray depth, int num_iterations) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        const Mat checked = gws::checkImage(image), checked_depth = gws::checkDepth(depth, checked.size());
        gws::checkIterations(num_iterations);
        segment(checked, checked_depth, num_iterations);
    }

    void getLabels(OutputArray labels_out) const CV_OVERRIDE
    {
        const gws::Reading use(in_use_);
        checkSegmented();
        gws::checkOutput(labels_out, CV_32SC1, result_.isLine(), "labels_out");
        guardMemory([&]() { giveAll({ { result_.labels, labels_out, "labels_out" } }); });
    }

    void getLabelContourMask(OutputArray image, bool thick_line) const CV_OVERRIDE
    {
        const gws::Reading use(in_use_);
        guardMemory([&]()
        {
            Mat mask = createMask(image);
            gws::drawContours(result_.labels, thick_line, mask);
        });
    }

    void getWatershedLineMask(OutputArray image) const CV_OVERRIDE
    {
        const gws::Reading use(in_use_);
        guardMemory([&]()
        {
            Mat mask = createMask(image);
            mask.setTo(Scalar(0));
            segmenter_.drawLines(result_, mask);
        });
    }

    void enforceLabelConnectivity(int min_element_size) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        checkSegmented();
        CV_Check(min_element_size, min_element_size >= 0 && min_element_size <= 100,
                 "min_element_size must be in [0, 100] percent");
        const int64 whole = int64(100) * std::max(result_.number, 1);
        int64 labelled = 0;
        guardMemory([&]() { labelled = countNonZero(result_.labels >= 0); });
        mergeBelow(int((labelled * min_element_size + whole - 1) / whole));
    }

    void mergeSmall(int min_area) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        checkSegmented();
        CV_CheckGE(min_area, 0, "min_area must be 0 or more");
        mergeBelow(min_area);
    }

    void mergeSimilar(int num_superpixels) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        checkSegmented();
        CV_CheckGE(num_superpixels, 1, "num_superpixels must be 1 or more");
        if (result_.number == 0)
            return;
        guardMemory([&]()
        {
            if (result_.hierarchy.empty())
                segmenter_.buildHierarchy(result_);
            result_.cut(num_superpixels);
        });
    }

    void getStatistics(InputArray image, InputArray depth, OutputArray stats, OutputArray centroids,
                       OutputArray mean_colors, OutputArray mean_depths, OutputArray positions,
                       OutputArray normals) const CV_OVERRIDE
    {
        const gws::Reading use(in_use_);
        checkSegmented();
        const Size size = result_.labels.size();
        Mat values = gws::checkValues(image, size), depths = gws::checkDepth(depth, size);
        checkTable(stats, CV_32SC1, false, "stats");
        checkTable(centroids, CV_64FC1, false, "centroids");
        checkTable(mean_colors, CV_32FC1, values.channels() == 1, "mean_colors");
        checkTable(mean_depths, CV_32FC1, true, "mean_depths");
        checkTable(positions, CV_32FC1, false, "positions");
        checkTable(normals, CV_32FC1, false, "normals");
        gws::StatisticsInput input;
        input.image = mean_colors.needed() ? values : Mat();
        input.with_mean_depths = mean_depths.needed();
        input.with_positions = positions.needed();
        input.with_normals = normals.needed();
        const bool with_depth = input.with_mean_depths || input.with_positions || input.with_normals;
        input.depth = with_depth ? depths : Mat();
        input.focal = result_.parameters.focalLength(size);
        guardMemory([&]()
        {
            gws::Statistics tables;
            gws::measureSuperpixels(result_.labels, result_.number, input, tables);
            input = gws::StatisticsInput();
            values = depths = Mat(); // a UMat of the caller may be an output, too
            giveAll({ { tables.stats, stats, "stats" }, { tables.centroids, centroids, "centroids" },
                      { tables.mean_colors, mean_colors, "mean_colors" },
                      { tables.mean_depths, mean_depths, "mean_depths" },
                      { tables.positions, positions, "positions" }, { tables.normals, normals, "normals" } });
        });
    }

    void getAdjacency(InputArray image, InputArray depth, OutputArray pairs, OutputArray lengths,
                      OutputArray contrasts) const CV_OVERRIDE
    {
        const gws::Reading use(in_use_);
        checkSegmented();
        Mat values = image.empty() ? Mat() : gws::checkImage(gws::checkValues(image, result_.labels.size()));
        if (image.empty() && !depth.empty())
            CV_Error(Error::StsBadArg, "depth must be empty where image is");
        Mat depths = gws::checkDepth(depth, result_.labels.size());
        checkTable(pairs, CV_32SC1, false, "pairs");
        checkTable(lengths, CV_32SC1, true, "lengths");
        checkTable(contrasts, CV_32FC1, true, "contrasts");
        guardMemory([&]()
        {
            Mat converted, scaled, tables[3];
            Mat depth_inside = depths.empty() ? Mat() : depths(result_.bounds);
            const Mat mask_inside = result_.mask.empty() ? Mat() : result_.mask.pixels(result_.bounds);
            const gws::Parameters& used = result_.parameters;
            Mat color = values.empty() ? Mat() : gws::convertImage(values(result_.bounds), mask_inside,
                                                                   used.valueRange(), converted);
            depth_inside = gws::scaleInside(depth_inside, mask_inside, used, scaled);
            gws::listAdjacency(result_.labels(result_.bounds), result_.number, color, depth_inside, used.alphaWeight(),
                               tables[0], tables[1], tables[2]);
            values = depths = color = depth_inside = Mat(); // a UMat of the caller may be an output, too
            giveAll({ { tables[0], pairs, "pairs" }, { tables[1], lengths, "lengths" },
                      { tables[2], contrasts, "contrasts" } });
        });
    }

    void setMask(InputArray mask) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        guardMemory([&]()
        {
            const gws::Mask checked(gws::checkMask(mask));
            if (!(checked == mask_)) // nothing fails from here on, so that all of the mask is set, or none of it
                segmenter_.forget();
            mask_ = checked;
        });
    }
    void setMarkers(InputArray markers) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        guardMemory([&]() { markers_ = gws::checkMarkers(markers).clone(); });
    }

    void setAlgorithm(int algorithm) CV_OVERRIDE { Change(*this)->setAlgorithm(algorithm); }
    int getAlgorithm() const CV_OVERRIDE { return parameters().algorithm; }
    void setRegionSize(int region_size) CV_OVERRIDE { Change(*this)->setRegionSize(region_size); }
    int getRegionSize() const CV_OVERRIDE { return parameters().region_size; }
    void setDesiredSuperpixels(int number) CV_OVERRIDE { Change(*this)->setDesiredSuperpixels(number); }
    int getDesiredSuperpixels() const CV_OVERRIDE { return parameters().num_superpixels; }
    void setRuler(float ruler) CV_OVERRIDE { Change(*this)->setRuler(ruler); }
    float getRuler() const CV_OVERRIDE { return parameters().ruler; }
    void setEffort(int effort) CV_OVERRIDE { Change(*this)->setEffort(effort); }
    int getEffort() const CV_OVERRIDE { return parameters().effort; }
    void setAlpha(float alpha) CV_OVERRIDE { Change(*this)->setAlpha(alpha); }
    float getAlpha() const CV_OVERRIDE { return parameters().alpha; }
    void setLabInput(bool lab_input) CV_OVERRIDE { Change(*this)->lab_input = lab_input; }
    bool getLabInput() const CV_OVERRIDE { return parameters().lab_input; }
    void setTemporal(bool temporal) CV_OVERRIDE { Change(*this)->temporal = temporal; }
    bool getTemporal() const CV_OVERRIDE { return parameters().temporal; }
    void setValueRange(float low, float high) CV_OVERRIDE { Change(*this)->setValueRange(low, high); }
    float getLowValue() const CV_OVERRIDE { return parameters().low_value; }
    float getHighValue() const CV_OVERRIDE { return parameters().high_value; }
    void setDepthRange(float first, float last) CV_OVERRIDE { Change(*this)->setDepthRange(first, last); }
    float getNearDepth() const CV_OVERRIDE { return parameters().near_depth; }
    float getFarDepth() const CV_OVERRIDE { return parameters().far_depth; }
    void setFocalLength(float fx, float fy) CV_OVERRIDE { Change(*this)->setFocalLength(fx, fy); }
    float getFocalLengthX() const CV_OVERRIDE { return parameters().focal_x; }
    float getFocalLengthY() const CV_OVERRIDE { return parameters().focal_y; }
    void setNormalWeight(float weight) CV_OVERRIDE { Change(*this)->setNormalWeight(weight); }
    float getNormalWeight() const CV_OVERRIDE { return parameters().normal_weight; }
    void setDepthAdaptive(bool adaptive) CV_OVERRIDE { Change(*this)->depth_adaptive = adaptive; }
    bool getDepthAdaptive() const CV_OVERRIDE { return parameters().depth_adaptive; }
    void setBorderThreshold(float threshold) CV_OVERRIDE { Change(*this)->setBorderThreshold(threshold); }
    float getBorderThreshold() const CV_OVERRIDE { return parameters().border_threshold; }

    void write(FileStorage& fs) const CV_OVERRIDE
    {
        const gws::Reading use(in_use_);
        writeFormat(fs);
        parameters_.write(fs);
    }
    void read(const FileNode& fn) CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        guardMemory([&]() { parameters_ = gws::Parameters::read(fn); });
    }
    void clear() CV_OVERRIDE
    {
        const gws::Writing use(in_use_);
        guardMemory([&]() { *this = SuperpixelGWatershedImpl(parameters_); });
    }
    bool empty() const CV_OVERRIDE { const gws::Reading use(in_use_); return result_.empty(); }
    String getDefaultName() const CV_OVERRIDE { return "SuperpixelGWatershed"; }

private:
    //! The parameters, to be set while nobody else uses the object.
    struct Change
    {
        explicit Change(SuperpixelGWatershedImpl& object) : use(object.in_use_), parameters(object.parameters_) {}
        gws::Parameters* operator->() { return &parameters; }

        const gws::Writing use;
        gws::Parameters& parameters;
    };

    gws::Parameters parameters() const
    {
        const gws::Reading use(in_use_);
        return parameters_;
    }

    void checkSegmented() const
    {
        if (result_.empty())
            CV_Error(Error::StsError, "There is no segmentation: call iterate() first");
    }

    //! Checks an output that may be left out.
    static void checkTable(OutputArray output, int type, bool is_line, const char* name)
    {
        if (output.needed())
            gws::checkOutput(output, type, is_line, name);
    }

    //! Throws where an output that keeps its size has another one.
    static void checkSize(OutputArray output, Size size, const char* name)
    {
        if (output.fixedSize() && output.size() != size)
            CV_Error_(Error::StsUnmatchedSizes, ("%s must have %d rows and %d columns", name, size.height, size.width));
    }

    //! A mask of the size of the label map.
    Mat createMask(OutputArray image) const
    {
        checkSegmented();
        gws::checkOutput(image, CV_8UC1, result_.isLine(), "image");
        checkSize(image, result_.labels.size(), "image");
        return gws::createOutput(image, result_.labels.size(), CV_8UC1);
    }

    struct Table
    {
        const Mat& values;
        OutputArray output;
        const char* name;
    };

    //! Copies tables to the outputs that are wanted: to all, or, if a size does not fit, to none. Without rows, too, a
    //! table has its columns and its type.
    static void giveAll(std::initializer_list<Table> tables)
    {
        for (const Table& table : tables)
            if (table.output.needed())
                checkSize(table.output, table.values.size(), table.name);
        for (const Table& table : tables)
            if (table.output.needed())
            {
                Mat copy = gws::createOutput(table.output, table.values.size(), table.values.type());
                table.values.copyTo(copy);
            }
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

    void segment(const Mat& image, const Mat& depth, int num_iterations)
    {
        checkMaps(image.size());
        result_.complete = false;
        guardMemory([&]()
        {
            segmenter_.segment(image, depth, markers_, mask_, parameters_, num_iterations, result_);
        });
    }

    void mergeBelow(int min_area)
    {
        if (result_.number == 0)
            return;
        const int before = result_.number;
        guardMemory([&]() { result_.number = gws::mergeSmallRegions(before, min_area, result_.labels); });
        if (result_.number < before)
            result_.hierarchy = gws::MergeHierarchy();
    }

    gws::InUse in_use_;
    gws::Parameters parameters_;
    Mat image_, depth_; // copies of what the factory was given
    gws::Mask mask_;    // copies of what was set
    Mat markers_;

    gws::Segmentation result_;
    gws::Segmenter segmenter_;
};

} // namespace

Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        int image_width, int image_height, int image_channels, int num_superpixels,
        int algorithm, float ruler)
{
    CV_CheckGE(image_width, 1, "image_width must be 1 or more");
    CV_CheckGE(image_height, 1, "image_height must be 1 or more");
    CV_Check(image_channels, image_channels >= 1 && image_channels <= gws::MAX_CHANNELS,
             "image_channels must be 1 to 4");
    gws::checkSize(image_width, image_height);
    gws::Parameters parameters;
    parameters.setDesiredSuperpixels(num_superpixels);
    parameters.setAlgorithm(algorithm);
    parameters.setRuler(ruler);

    Ptr<SuperpixelGWatershedImpl> created;
    guardMemory([&]()
    {
        created = makePtr<SuperpixelGWatershedImpl>(parameters);
        created->reserve(Size(image_width, image_height));
    });
    return created;
}

//! @note In Python, None is the number 0: it stands for no depth here, and the arguments are those after it.
Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(InputArray image, int algorithm, int region_size,
                                                     float ruler)
{
    const bool is_shifted = algorithm == 0 && (region_size == GWATERSHED || region_size == RGWATERSHED);
    if (is_shifted)
        return createSuperpixelGWatershed(image, noArray(), region_size, saturate_cast<int>(ruler));
    return createSuperpixelGWatershed(image, noArray(), algorithm ? algorithm : int(RGWATERSHED), region_size, ruler);
}

Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(InputArray image, InputArray depth, int algorithm,
                                                     int region_size, float ruler, float alpha)
{
    const Mat checked = gws::checkImage(image), checked_depth = gws::checkDepth(depth, checked.size());
    gws::Parameters parameters;
    parameters.setAlgorithm(algorithm);
    parameters.setRegionSize(region_size);
    parameters.setRuler(ruler);
    parameters.setAlpha(alpha);

    Ptr<SuperpixelGWatershedImpl> created;
    guardMemory([&]()
    {
        created = makePtr<SuperpixelGWatershedImpl>(parameters);
        created->keep(checked, checked_depth);
    });
    return created;
}

}} // namespace
