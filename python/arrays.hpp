// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef GWATERSHED_PYTHON_ARRAYS_HPP
#define GWATERSHED_PYTHON_ARRAYS_HPP

#include <opencv2/core.hpp>
#include <pybind11/numpy.h>

namespace gwatershed
{

namespace py = pybind11;

//! An argument that must be an array: of NumPy, or what NumPy can make one of without looking into a list.
struct Array
{
    py::array values;
};

//! The same, or None.
struct OptionalArray
{
    py::object values = py::none();
};

//! A matrix, and the array that its pixels are in.
struct Pixels
{
    py::object owner;
    cv::Mat matrix;
};

//! The matrix of an array: without a copy where the pixels of a row follow each other. Throws ValueError where there is
//! no matrix of its type or shape.
Pixels takePixels(const Array& array, const char* name);
//! The same; None is an empty matrix.
Pixels takePixels(const OptionalArray& array, const char* name);
//! The same; int32 and float16, which no matrix of depth has, become double.
Pixels takeDepth(const OptionalArray& array);
//! The same; bool is taken, too.
Pixels takeMask(const OptionalArray& array);
//! The same; integers of any type become int32. Throws ValueError where they do not fit.
Pixels takeMarkers(const OptionalArray& array);

//! The header of an array of the caller that an output is to be written to; empty where there is none.
cv::Mat takeOutput(const py::object& array, const char* name);

//! The array for a matrix of one channel: `given` where the matrix is that of takeOutput(), or else a new one that
//! shares the memory. None for a matrix without rows, as cv2 has it.
py::object giveArray(const cv::Mat& matrix, const py::object& given = py::none());

} // namespace gwatershed

namespace pybind11 { namespace detail {

template <> struct type_caster<gwatershed::Array>
{
    PYBIND11_TYPE_CASTER(gwatershed::Array, const_name("numpy.ndarray"));

    //! Numbers and lists are no arrays: another overload may take them. None no overload takes.
    bool load(handle source, bool)
    {
        if (source && source.is_none())
            throw type_error("an array is needed, not None, which imread() returns for an image that it cannot read");
        if (!source || !(isinstance<array>(source) || hasattr(source, "__array__")))
            return false;
        value.values = array::ensure(source);
        if (!value.values)
            throw error_already_set();
        return value.values.ndim() > 0;
    }
};

template <> struct type_caster<gwatershed::OptionalArray>
{
    PYBIND11_TYPE_CASTER(gwatershed::OptionalArray, const_name("Optional[numpy.ndarray]"));

    bool load(handle source, bool convert)
    {
        if (source && source.is_none())
            return true;
        type_caster<gwatershed::Array> inner;
        if (!inner.load(source, convert))
            return false;
        value.values = static_cast<gwatershed::Array&>(inner).values;
        return true;
    }
};

}} // namespace pybind11::detail

#endif
