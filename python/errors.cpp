// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "errors.hpp"

#include <opencv2/core.hpp>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace gwatershed
{

//! The lines of a text, without the "> " that OpenCV begins those of its checks with.
static std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line.substr(std::min(line.size(), line.find_first_not_of("> "))));
    return lines;
}

//! Checks that compare values have a line of ours, the expression, "where", and the values.
static bool isCheck(const cv::Exception& error)
{
    return error.err.find('\n') != std::string::npos;
}

//! Our line of a check, and the values.
static std::string shorten(const std::string& check)
{
    const std::vector<std::string> lines = linesOf(check);
    const auto first = std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return !line.empty(); });
    if (first == lines.end())
        return check;
    std::string text = first->substr(0, first->find(" (expected: "));
    text = text.substr(0, text.find_last_not_of(':') + 1);
    const auto is_where = [](const std::string& line) {
        return line.size() >= 5 && line.compare(line.size() - 5, 5, "where") == 0;
    };
    const auto where = std::find_if(first, lines.end(), is_where);
    std::string separator = "; ";
    for (auto line = where; line != lines.end() && ++line != lines.end(); separator = " ")
        text += separator + *line;
    return text;
}

static PyObject* kindOf(const cv::Exception& error)
{
    if (error.code == cv::Error::StsNoMem)
        return PyExc_MemoryError;
    const bool is_state = error.code == cv::Error::StsError && !isCheck(error);
    return is_state ? PyExc_RuntimeError : PyExc_ValueError;
}

void translateErrors()
{
    pybind11::register_exception_translator([](std::exception_ptr thrown) {
        try
        {
            if (thrown)
                std::rethrow_exception(thrown);
        }
        catch (const cv::Exception& error)
        {
            PyErr_SetString(kindOf(error), (isCheck(error) ? shorten(error.err) : error.err).c_str());
        }
    });
}

} // namespace gwatershed
