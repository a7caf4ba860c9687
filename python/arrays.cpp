// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"

#include <memory>
#include <string>

namespace gwatershed
{

//! The depth of a matrix for a type of NumPy, or -1.
static int depthOf(const py::dtype& type)
{
    const auto size = type.itemsize();
    switch (type.kind())
    {
    case 'u':
        return size == 1 ? CV_8U : size == 2 ? CV_16U : -1;
    case 'i':
        return size == 1 ? CV_8S : size == 2 ? CV_16S : size == 4 ? CV_32S : -1;
    case 'f':
        return size == 2 ? CV_16F : size == 4 ? CV_32F : size == 8 ? CV_64F : -1;
    default:
        return -1;
    }
}

static std::string textOf(const py::handle& value)
{
    return py::str(value);
}

//! Whether a matrix can have the layout: values of a pixel, and pixels of a row, follow each other.
static bool isLayoutOfMatrix(const py::array& values, int channels)
{
    const py::ssize_t height = values.shape(0), width = values.shape(1), size = values.itemsize();
    const bool pixels = channels == 1 || values.strides(2) == size;
    const bool rows = width == 1 || values.strides(1) == channels * size;
    const bool columns = height == 1 || (values.strides(0) >= width * channels * size && values.strides(0) % size == 0);
    const bool aligned = reinterpret_cast<size_t>(values.data()) % size_t(size) == 0;
    return pixels && rows && columns && aligned;
}

static int channelsOf(const py::array& values, const char* name)
{
    if (values.ndim() != 2 && values.ndim() != 3)
        throw py::value_error(std::string(name) + " must have two dimensions, or channels as the third one, not " +
                              std::to_string(values.ndim()));
    const py::ssize_t channels = values.ndim() == 2 ? 1 : values.shape(2);
    if (channels > CV_CN_MAX)
        throw py::value_error(std::string(name) + " must have at most " + std::to_string(CV_CN_MAX) +
                              " channels, not " + std::to_string(channels));
    if (channels == 0)
        throw py::value_error(std::string(name) + " must have at least one channel");
    return int(channels);
}

//! The header of an array whose layout is that of a matrix.
static cv::Mat headerOf(const py::array& values, int depth, int channels)
{
    const int height = int(values.shape(0)), width = int(values.shape(1));
    const size_t step = height == 1 ? size_t(cv::Mat::AUTO_STEP) : size_t(values.strides(0));
    return cv::Mat(height, width, CV_MAKETYPE(depth, channels), const_cast<void*>(values.data()), step);
}

static bool isInteger(const py::array& values)
{
    return values.dtype().kind() == 'i' || values.dtype().kind() == 'u';
}

//! Integers as another type that has those of up to some bits and a sign.
static py::array convertIntegers(const py::array& values, const char* type, int bits, const char* name)
{
    const py::int_ end(int64_t(1) << bits);
    if (values.size() != 0 && (py::int_(values.attr("min")()) < -end || py::int_(values.attr("max")()) >= end))
        throw py::value_error(std::string(name) + " must have integers from -2**" + std::to_string(bits) + " to 2**" +
                              std::to_string(bits) + " - 1");
    return py::array(values.attr("astype")(type));
}

//! As double, which must hold them.
static py::array toDouble(const py::array& values, const char* name)
{
    return isInteger(values) ? convertIntegers(values, "float64", 53, name)
                             : py::array(values.attr("astype")("float64"));
}

static Pixels takeValues(py::array values, const char* name)
{
    if (isInteger(values) && depthOf(values.dtype()) < 0)
        values = toDouble(values, name);
    const int depth = depthOf(values.dtype());
    if (depth < 0)
        throw py::value_error(std::string(name) + " must not be of the type " + textOf(values.dtype()));
    const int channels = channelsOf(values, name);
    if (values.shape(0) > INT_MAX || values.shape(1) > INT_MAX)
        throw py::value_error(std::string(name) + " must not be as large as " + textOf(values.attr("shape")));
    if (values.size() == 0)
        return Pixels();
    const bool native = values.dtype().attr("isnative").cast<bool>();
    if (!native || !isLayoutOfMatrix(values, channels))
        values = py::array(values.attr("astype")(values.dtype().attr("newbyteorder")("="), "C"));
    return {values, headerOf(values, depth, channels)};
}

Pixels takePixels(const Array& array, const char* name)
{
    return takeValues(array.values, name);
}

Pixels takePixels(const OptionalArray& array, const char* name)
{
    return array.values.is_none() ? Pixels() : takeValues(array.values, name);
}

Pixels takeDepth(const OptionalArray& array)
{
    if (array.values.is_none())
        return Pixels();
    const py::array values = array.values;
    const int depth = depthOf(values.dtype());
    const bool is_other = depth == CV_32S || depth == CV_16F;
    return takeValues(is_other ? toDouble(values, "depth") : values, "depth");
}

Pixels takeMask(const OptionalArray& array)
{
    if (array.values.is_none())
        return Pixels();
    const py::array values = array.values;
    return takeValues(values.dtype().kind() == 'b' ? py::array(values.attr("view")("uint8")) : values, "mask");
}

Pixels takeMarkers(const OptionalArray& array)
{
    if (array.values.is_none())
        return Pixels();
    const py::array values = array.values;
    const bool is_other = isInteger(values) && depthOf(values.dtype()) != CV_32S;
    return takeValues(is_other ? convertIntegers(values, "int32", 31, "markers") : values, "markers");
}

cv::Mat takeOutput(const py::object& array, const char* name)
{
    if (array.is_none())
        return cv::Mat();
    if (!py::isinstance<py::array>(array))
        throw py::type_error(std::string(name) + " must be an array, or None; give what follows it by name");
    const py::array values = array;
    const int depth = depthOf(values.dtype()), channels = channelsOf(values, name);
    if (values.size() == 0)
        return cv::Mat();
    if (depth < 0)
        throw py::value_error(std::string(name) + " must not be of the type " + textOf(values.dtype()));
    const bool native = values.dtype().attr("isnative").cast<bool>();
    if (!native || !values.writeable() || !isLayoutOfMatrix(values, channels))
        throw py::value_error(std::string(name) +
                              " must be an array in native byte order that can be written to row by row");
    return headerOf(values, depth, channels);
}

static py::dtype typeOf(const cv::Mat& matrix)
{
    switch (matrix.depth())
    {
    case CV_8U:
        return py::dtype::of<unsigned char>();
    case CV_32S:
        return py::dtype::of<int>();
    case CV_32F:
        return py::dtype::of<float>();
    default:
        CV_Assert(matrix.depth() == CV_64F);
        return py::dtype::of<double>();
    }
}

py::object giveArray(const cv::Mat& matrix, const py::object& given)
{
    if (matrix.empty())
        return py::none();
    if (!given.is_none() && py::array(given).data() == matrix.data)
        return given;
    std::unique_ptr<cv::Mat> kept(new cv::Mat(matrix));
    const py::capsule owner(kept.get(), [](void* it) { delete static_cast<cv::Mat*>(it); });
    const cv::Mat& shared = *kept.release();
    return py::array(typeOf(shared), {py::ssize_t(shared.rows), py::ssize_t(shared.cols)},
                     {py::ssize_t(shared.step), py::ssize_t(shared.elemSize())}, shared.data, owner);
}

} // namespace gwatershed
