// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

//! @file The module gwatershed._native: the class, with the names, keywords and behaviour of cv2.ximgproc. Where an
//! argument can be an array or a number, the overloads with arrays come first.

#include "arrays.hpp"
#include "errors.hpp"
#include "parameters.hpp"
#include "arguments.hpp"
#include "results/statistics.hpp"
#include "shared/parameters.hpp"

#include <opencv2/core/utility.hpp>
#include <pybind11/stl.h>

#include <fstream>
#include <memory>
#include <optional>
#include <utility>

namespace gwatershed
{

using cv::Mat;
using SessionPtr = std::shared_ptr<Session>;
using OptionalInt = std::optional<int>;
using OptionalFloat = std::optional<float>;

namespace
{

const float default_ruler = 10.f;
const float default_alpha = 0.5f;
const int default_region_size = 10;

template <typename Make> SessionPtr makeSession(Make make)
{
    py::gil_scoped_release released;
    return std::make_shared<Session>(make());
}

//! One that waits for images of any size.
SessionPtr construct(const py::kwargs& parameters)
{
    const SessionPtr session = makeSession([] { return cv::ximgproc::createSuperpixelGWatershed(1, 1, 3, 1); });
    session->call([](SuperpixelGWatershed& superpixels) { superpixels.setRegionSize(default_region_size); });
    setParameters(*session, parameters);
    return session;
}

SessionPtr createForSize(int image_width, int image_height, int image_channels, int num_superpixels,
                         OptionalInt algorithm, OptionalFloat ruler)
{
    return makeSession([&] {
        return cv::ximgproc::createSuperpixelGWatershed(image_width, image_height, image_channels, num_superpixels,
                                                        algorithm.value_or(cv::ximgproc::RGWATERSHED),
                                                        ruler.value_or(default_ruler));
    });
}

SessionPtr createForImage(const Array& image, int algorithm, OptionalInt region_size, OptionalFloat ruler)
{
    const Pixels pixels = takePixels(image, "image");
    return makeSession([&] {
        return cv::ximgproc::createSuperpixelGWatershed(pixels.matrix, algorithm,
                                                        region_size.value_or(default_region_size),
                                                        ruler.value_or(default_ruler));
    });
}

SessionPtr createForDepth(const Array& image, const OptionalArray& depth, OptionalInt algorithm,
                          OptionalInt region_size, OptionalFloat ruler, OptionalFloat alpha)
{
    const Pixels pixels = takePixels(image, "image"), depths = takeDepth(depth);
    const int method = algorithm.value_or(cv::ximgproc::RGWATERSHED);
    const int size = region_size.value_or(default_region_size);
    return makeSession([&] {
        if (!depth.values.is_none())
            return cv::ximgproc::createSuperpixelGWatershed(pixels.matrix, depths.matrix, method, size,
                                                            ruler.value_or(default_ruler),
                                                            alpha.value_or(default_alpha));
        const auto made = cv::ximgproc::createSuperpixelGWatershed(pixels.matrix, method, size,
                                                                   ruler.value_or(default_ruler));
        made->setAlpha(alpha.value_or(default_alpha));
        return made;
    });
}

//! None is not the default here: it may be an image that could not be read.
void iterateAgain(Session& session, int num_iterations)
{
    session.call([&](SuperpixelGWatershed& superpixels) { superpixels.iterate(num_iterations); });
}

void iterateImage(Session& session, const Array& image, OptionalInt num_iterations)
{
    const Pixels pixels = takePixels(image, "image");
    session.call([&](SuperpixelGWatershed& superpixels) {
        superpixels.iterate(pixels.matrix, num_iterations.value_or(1));
    });
}

void iterateDepth(Session& session, const Array& image, const OptionalArray& depth, OptionalInt num_iterations)
{
    if (depth.values.is_none())
        return iterateImage(session, image, num_iterations);
    const Pixels pixels = takePixels(image, "image"), depths = takeDepth(depth);
    session.call([&](SuperpixelGWatershed& superpixels) {
        superpixels.iterate(pixels.matrix, depths.matrix, num_iterations.value_or(1));
    });
}

//! An output of the size of the image: into the array that is given, or a new one.
template <typename Work> py::object getMap(Session& session, const py::object& given, const char* name, Work work)
{
    Mat map = takeOutput(given, name);
    session.call([&](SuperpixelGWatershed& superpixels) { work(superpixels, map); });
    return giveArray(map, given);
}

py::object getLabels(Session& session, const py::object& labels_out)
{
    return getMap(session, labels_out, "labels_out",
                  [](SuperpixelGWatershed& superpixels, Mat& map) { superpixels.getLabels(map); });
}

py::object getLabelContourMask(Session& session, const py::object& image, bool thick_line)
{
    return getMap(session, image, "image", [=](SuperpixelGWatershed& superpixels, Mat& map) {
        superpixels.getLabelContourMask(map, thick_line);
    });
}

py::object getWatershedLineMask(Session& session, const py::object& image)
{
    return getMap(session, image, "image",
                  [](SuperpixelGWatershed& superpixels, Mat& map) { superpixels.getWatershedLineMask(map); });
}

py::tuple getStatistics(Session& session, const OptionalArray& image, const OptionalArray& depth,
                        const py::object& stats, const py::object& centroids, const py::object& mean_colors,
                        const py::object& mean_depths, const py::object& positions, const py::object& normals)
{
    const Pixels pixels = takePixels(image, "image"), depths = takeDepth(depth);
    Mat tables[] = {takeOutput(stats, "stats"), takeOutput(centroids, "centroids"),
                    takeOutput(mean_colors, "mean_colors"), takeOutput(mean_depths, "mean_depths"),
                    takeOutput(positions, "positions"), takeOutput(normals, "normals")};
    session.call([&](SuperpixelGWatershed& superpixels) {
        superpixels.getStatistics(pixels.matrix, depths.matrix, tables[0], tables[1], tables[2], tables[3], tables[4],
                                  tables[5]);
    });
    return py::make_tuple(giveArray(tables[0], stats), giveArray(tables[1], centroids),
                          giveArray(tables[2], mean_colors), giveArray(tables[3], mean_depths),
                          giveArray(tables[4], positions), giveArray(tables[5], normals));
}

py::tuple getAdjacency(Session& session, const OptionalArray& image, const OptionalArray& depth,
                       const py::object& pairs, const py::object& lengths, const py::object& contrasts)
{
    const Pixels pixels = takePixels(image, "image"), depths = takeDepth(depth);
    Mat tables[] = {takeOutput(pairs, "pairs"), takeOutput(lengths, "lengths"), takeOutput(contrasts, "contrasts")};
    session.call([&](SuperpixelGWatershed& superpixels) {
        superpixels.getAdjacency(pixels.matrix, depths.matrix, tables[0], tables[1], tables[2]);
    });
    return py::make_tuple(giveArray(tables[0], pairs), giveArray(tables[1], lengths),
                          giveArray(tables[2], contrasts));
}

void setMask(Session& session, const OptionalArray& mask)
{
    const Pixels pixels = takeMask(mask);
    session.call([&](SuperpixelGWatershed& superpixels) { superpixels.setMask(pixels.matrix); });
}

void setMarkers(Session& session, const OptionalArray& markers)
{
    const Pixels pixels = takeMarkers(markers);
    session.call([&](SuperpixelGWatershed& superpixels) { superpixels.setMarkers(pixels.matrix); });
}

//! Tables of any label map; labels are below num_labels, and pixels with one below 0 do not count. Without a focal length
//! there are no positions and normals.
py::tuple measure(const Array& labels, int num_labels, const OptionalArray& image, const OptionalArray& depth,
                  std::optional<std::pair<float, float> > focal_length)
{
    namespace gws = cv::ximgproc::gws;
    const Pixels map = takePixels(labels, "labels");
    const Pixels pixels = takePixels(image, "image"), depths = takeDepth(depth);
    gws::Statistics tables;
    {
        py::gil_scoped_release released;
        CV_CheckTypeEQ(map.matrix.type(), CV_32SC1, "labels must be of the type int32");
        const cv::Size size = map.matrix.size();
        gws::Parameters camera;
        if (focal_length)
            camera.setFocalLength(focal_length->first, focal_length->second);
        gws::StatisticsInput input;
        input.image = gws::checkValues(pixels.matrix, size);
        input.depth = gws::checkDepth(depths.matrix, size);
        input.with_positions = input.with_normals = focal_length.has_value();
        input.focal = camera.focalLength(size);
        gws::measureSuperpixels(map.matrix, num_labels, input, tables);
    }
    return py::make_tuple(giveArray(tables.stats), giveArray(tables.centroids), giveArray(tables.mean_colors),
                          giveArray(tables.mean_depths), giveArray(tables.positions), giveArray(tables.normals));
}

void bindResults(SessionClass& to)
{
    const py::object none = py::none();
    to.def("getNumberOfSuperpixels", [](Session& session) {
        return session.call([](SuperpixelGWatershed& superpixels) { return superpixels.getNumberOfSuperpixels(); });
    }, "Number of superpixels N, 0 before the first iterate().");
    to.def("getLabels", getLabels, py::arg("labels_out") = none,
           "The label map, int32: values in [0, N), -1 outside of a mask.");
    to.def("getLabelContourMask", getLabelContourMask, py::arg("image") = none, py::arg("thick_line") = true,
           "A mask, uint8: 255 on the contours.");
    to.def("getWatershedLineMask", getWatershedLineMask, py::arg("image") = none,
           "A mask, uint8: 255 on the watershed lines of GWATERSHED.");
    to.def("getStatistics", getStatistics, py::arg("image"), py::arg("depth"), py::arg("stats") = none,
           py::arg("centroids") = none, py::arg("mean_colors") = none, py::arg("mean_depths") = none,
           py::arg("positions") = none, py::arg("normals") = none,
           "Area and bounding box, centroid, mean colour, mean depth, and of the surface mean point and normal, of each"
           " superpixel.");
    to.def("getAdjacency", getAdjacency, py::arg("image"), py::arg("depth"), py::arg("pairs") = none,
           py::arg("lengths") = none, py::arg("contrasts") = none,
           "Pairs of superpixels that touch, the lengths of their boundaries, and the contrasts across them.");
}

void bindSteps(SessionClass& to)
{
    to.def("iterate", iterateDepth, py::arg("image"), py::arg("depth"), integer("num_iterations") = py::none(),
           "Segments an image with its depth; None is no depth.");
    to.def("iterate", iterateImage, py::arg("image"), integer("num_iterations") = py::none(), "Segments an image.");
    to.def("iterate", iterateAgain, integer("num_iterations") = 1,
           "Segments the image that was given to the factory.");
    to.def("enforceLabelConnectivity", [](Session& session, OptionalInt min_element_size) {
        session.call([&](SuperpixelGWatershed& superpixels) {
            superpixels.enforceLabelConnectivity(min_element_size.value_or(25));
        });
    }, integer("min_element_size") = py::none(), "Merges superpixels smaller than so many percent of the mean.");
    to.def("mergeSimilar", [](Session& session, int num_superpixels) {
        session.call([&](SuperpixelGWatershed& superpixels) { superpixels.mergeSimilar(num_superpixels); });
    }, integer("num_superpixels"), "Merges neighbours, the most similar first, until a number is left.");
    to.def("mergeSmall", [](Session& session, int min_area) {
        session.call([&](SuperpixelGWatershed& superpixels) { superpixels.mergeSmall(min_area); });
    }, integer("min_area"), "Merges superpixels of fewer pixels into a neighbour.");
    to.def("setMask", setMask, py::arg("mask"), "Restricts the segmentation; bool or uint8. None: no mask.");
    to.def("setMarkers", setMarkers, py::arg("markers"),
           "Sets the markers that superpixels grow from; integers of 32 bits. None: no markers.");
}

//! What the class has from cv::Algorithm, and what pickle and copy need: a copy has the parameters, and nothing else.
void bindParametersAsAWhole(SessionClass& to)
{
    to.def("clear", [](Session& session) {
        session.call([](SuperpixelGWatershed& superpixels) { superpixels.clear(); });
    }, "Drops all but the parameters.");
    to.def("empty", [](Session& session) {
        return session.call([](SuperpixelGWatershed& superpixels) { return superpixels.empty(); });
    }, "Whether there is no segmentation.");
    to.def("getDefaultName", [](Session& session) {
        return session.call([](SuperpixelGWatershed& superpixels) {
            return std::string(superpixels.getDefaultName());
        });
    }, "The name of the class in files of parameters.");
    to.def("save", [](Session& session, const std::string& filename) {
        if (!std::ofstream(filename, std::ios::app))
            throw py::value_error("filename must name a file that can be written, not " + filename);
        session.call([&](SuperpixelGWatershed& superpixels) { superpixels.save(filename); });
    }, py::arg("filename"), "Writes the parameters to a file.");
    to.def("write", &Session::write, "The parameters as text.");
    to.def("read", &Session::read, py::arg("parameters"),
           "Takes the parameters from what write() gave, or from the text of a file of save().");
    to.def("__reduce__", [](const py::object& session) {
        const py::object restore = py::module_::import("gwatershed.parameters").attr("restore");
        const std::string parameters = session.cast<Session&>().write();
        return py::make_tuple(restore, py::make_tuple(py::type::of(session), parameters),
                              py::getattr(session, "__dict__", py::none()));
    });
}

void bindFactories(py::module_& to)
{
    const py::object none = py::none();
    const char* name = "createSuperpixelGWatershed";
    to.def(name, createForImage, py::arg("image"), integer("algorithm"), integer("region_size") = none,
           py::arg("ruler") = none, "Makes an object for an image.");
    to.def(name, createForDepth, py::arg("image"), py::arg("depth") = none, integer("algorithm") = none,
           integer("region_size") = none, py::arg("ruler") = none, py::arg("alpha") = none,
           "Makes an object for an image, with depth where that is not None.");
    to.def(name, createForSize, integer("image_width"), integer("image_height"), integer("image_channels"),
           integer("num_superpixels"), integer("algorithm") = none, py::arg("ruler") = none,
           "Makes an object for images of a size.");
}

} // namespace

PYBIND11_MODULE(_native, module)
{
    translateErrors();
    module.doc() = "The class of gwatershed, as cv2.ximgproc has it where OpenCV was built with the module.";
    module.attr("GWATERSHED") = int(cv::ximgproc::GWATERSHED);
    module.attr("RGWATERSHED") = int(cv::ximgproc::RGWATERSHED);
    module.attr("__version__") = GWATERSHED_VERSION;
    module.attr("__opencv_version__") = cv::getVersionString();

    SessionClass session_class(module, "SuperpixelGWatershed",
                               "Superpixels by a marker-controlled watershed on a gradient map.");
    session_class.def(py::init(&construct), "Takes parameters by keyword; waits for iterate(image).");
    bindSteps(session_class);
    bindResults(session_class);
    bindParameters(session_class);
    bindParametersAsAWhole(session_class);
    bindFactories(module);

    module.def("setNumThreads", &cv::setNumThreads, integer("nthreads"), "Number of threads; 1: no others.");
    module.def("getNumThreads", &cv::getNumThreads, "Number of threads.");
    module.def("_measure", measure, py::arg("labels"), py::arg("num_labels"), py::arg("image"), py::arg("depth"),
               py::arg("focal_length") = py::none(), "Statistics of any label map; see gwatershed.superpixels.");
}

} // namespace gwatershed
