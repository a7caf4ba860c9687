// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef GWATERSHED_PYTHON_PARAMETERS_HPP
#define GWATERSHED_PYTHON_PARAMETERS_HPP

#include "session.hpp"

namespace gwatershed
{

using SessionClass = pybind11::class_<Session, std::shared_ptr<Session> >;

//! An argument that takes integers of any type, and no other number, which would be cut off.
inline pybind11::arg integer(const char* name) { return pybind11::arg(name).noconvert(); }

//! Gives the class of Python the setters and getters of all parameters.
void bindParameters(SessionClass& session_class);

//! Sets parameters by their names, as the constructor takes them. Throws TypeError where there is no such name.
void setParameters(Session& session, const pybind11::dict& parameters);

} // namespace gwatershed

#endif
