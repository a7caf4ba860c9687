// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "parameters.hpp"

#include <pybind11/stl.h>

#include <functional>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>

namespace gwatershed
{

namespace py = pybind11;

namespace
{

//! Sets the parameter that a keyword of the constructor names.
using Setter = std::function<void(Session&, const py::handle&)>;

std::map<std::string, Setter>& setters()
{
    static std::map<std::string, Setter> all;
    return all;
}

//! Integers are not cut off other numbers.
template <typename T> constexpr bool convert = !std::is_same<T, int>::value;

template <typename T> T castTo(const py::handle& value)
{
    py::detail::make_caster<T> caster;
    if (!caster.load(value, convert<T>))
        throw py::cast_error();
    return py::detail::cast_op<T>(caster);
}

//! getName(), and the keyword of the constructor.
template <typename T, typename Set>
void bindRest(SessionClass& to, const char* keyword, const std::string& name, Set setter,
              T (SuperpixelGWatershed::*get)() const, const char* description)
{
    to.def(("get" + name).c_str(), [get](Session& session) {
        return session.call([&](SuperpixelGWatershed& superpixels) { return (superpixels.*get)(); });
    }, description);
    setters()[keyword] = [setter](Session& session, const py::handle& value) { setter(session, castTo<T>(value)); };
}

//! A parameter of one value: setName(keyword), getName(), and the keyword of the constructor.
template <typename T>
void bindValue(SessionClass& to, const char* keyword, const std::string& name, void (SuperpixelGWatershed::*set)(T),
               T (SuperpixelGWatershed::*get)() const, const char* description)
{
    const auto setter = [set](Session& session, T value) {
        session.call([&](SuperpixelGWatershed& superpixels) { (superpixels.*set)(value); });
    };
    to.def(("set" + name).c_str(), setter, py::arg(keyword).noconvert(!convert<T>), description);
    bindRest(to, keyword, name, setter, get, description);
}

//! The same where the setter has a default, which None stands for, too.
template <typename T>
void bindDefaulted(SessionClass& to, const char* keyword, const std::string& name,
                   void (SuperpixelGWatershed::*set)(T), T (SuperpixelGWatershed::*get)() const, T default_value,
                   const char* description)
{
    const auto setter = [set, default_value](Session& session, std::optional<T> value) {
        session.call([&](SuperpixelGWatershed& superpixels) { (superpixels.*set)(value.value_or(default_value)); });
    };
    to.def(("set" + name).c_str(), setter, py::arg(keyword).noconvert(!convert<T>) = py::none(), description);
    bindRest(to, keyword, name, setter, get, description);
}

//! A parameter of two values: setName(near, far), and the keyword of the constructor, which takes a pair.
template <typename Second>
void bindRange(SessionClass& to, const char* keyword, const std::string& name,
               void (SuperpixelGWatershed::*set)(float, float), const char* first_name, const Second& second_argument,
               const char* description)
{
    using End = std::optional<float>;
    const auto setter = [set](Session& session, End first, End last) { // None is 0, as in cv2
        session.call([&](SuperpixelGWatershed& superpixels) {
            (superpixels.*set)(first.value_or(0), last.value_or(0));
        });
    };
    to.def(("set" + name).c_str(), setter, py::arg(first_name), second_argument, description);
    setters()[keyword] = [setter](Session& session, const py::handle& value) {
        const auto range = value.cast<std::pair<float, float> >();
        setter(session, range.first, range.second);
    };
}

//! One end of a range.
void bindEnd(SessionClass& to, const char* name, float (SuperpixelGWatershed::*get)() const, const char* description)
{
    to.def(name, [get](Session& session) {
        return session.call([&](SuperpixelGWatershed& superpixels) { return (superpixels.*get)(); });
    }, description);
}

} // namespace

// A new parameter needs a line here, and its names in gwatershed/_native.pyi. Pickle and copy follow write() and
// read().
void bindParameters(SessionClass& to)
{
    using S = SuperpixelGWatershed;
    bindDefaulted(to, "algorithm", "Algorithm", &S::setAlgorithm, &S::getAlgorithm, int(cv::ximgproc::RGWATERSHED),
                  "RGWATERSHED or GWATERSHED.");
    bindDefaulted(to, "region_size", "RegionSize", &S::setRegionSize, &S::getRegionSize, 10,
                  "Side of a superpixel in pixels; 0 where a number of superpixels is asked for.");
    bindValue(to, "num_superpixels", "DesiredSuperpixels", &S::setDesiredSuperpixels, &S::getDesiredSuperpixels,
              "Number of superpixels asked for; 0 where a region size is asked for.");
    bindDefaulted(to, "ruler", "Ruler", &S::setRuler, &S::getRuler, 10.f, "Compactness; 0 follows the image alone.");
    bindDefaulted(to, "effort", "Effort", &S::setEffort, &S::getEffort, 1,
                  "Time for better superpixels, from 0 to 3; for RGWATERSHED.");
    bindDefaulted(to, "alpha", "Alpha", &S::setAlpha, &S::getAlpha, 0.5f,
                  "Weight of colour against depth, in [0, 1].");
    bindValue(to, "lab_input", "LabInput", &S::setLabInput, &S::getLabInput,
              "Whether images come as lightness and two colour differences.");
    bindValue(to, "temporal", "Temporal", &S::setTemporal, &S::getTemporal,
              "Whether superpixels keep their labels from frame to frame.");
    bindDefaulted(to, "normal_weight", "NormalWeight", &S::setNormalWeight, &S::getNormalWeight, 0.2f,
                  "Weight of normals against depth, in [0, 1]; 0: depth as it is.");
    bindValue(to, "depth_adaptive", "DepthAdaptive", &S::setDepthAdaptive, &S::getDepthAdaptive,
              "Whether superpixels have about the same area on the surface.");
    bindRange(to, "focal_length", "FocalLength", &S::setFocalLength, "fx", py::arg("fy") = 0.f,
              "The focal length in pixels; both 0: a usual one.");
    bindEnd(to, "getFocalLengthX", &S::getFocalLengthX, "The focal length along x.");
    bindEnd(to, "getFocalLengthY", &S::getFocalLengthY, "The focal length along y; 0: as along x.");
    bindDefaulted(to, "border_threshold", "BorderThreshold", &S::setBorderThreshold, &S::getBorderThreshold, 150.f,
                  "Gradient from which a pixel is a border; for GWATERSHED.");
    bindRange(to, "depth_range", "DepthRange", &S::setDepthRange, "near_depth", py::arg("far_depth"),
              "The depths that become 1 and 255; both 0: the range of the frame.");
    bindEnd(to, "getNearDepth", &S::getNearDepth, "The depth that becomes 1.");
    bindEnd(to, "getFarDepth", &S::getFarDepth, "The depth that becomes 255.");
    bindRange(to, "value_range", "ValueRange", &S::setValueRange, "low_value", py::arg("high_value"),
              "The values that become 0 and 255; both 0: the usual range of the type, or that of the image.");
    bindEnd(to, "getLowValue", &S::getLowValue, "The value that becomes 0.");
    bindEnd(to, "getHighValue", &S::getHighValue, "The value that becomes 255.");
}

void setParameters(Session& session, const py::dict& parameters)
{
    for (const auto& parameter : parameters)
    {
        const std::string name = py::str(parameter.first);
        const auto setter = setters().find(name);
        if (setter == setters().end())
            throw py::type_error("there is no parameter " + name);
        try
        {
            setter->second(session, parameter.second);
        }
        catch (const py::cast_error&)
        {
            throw py::type_error(name + " cannot be " + std::string(py::repr(parameter.second)));
        }
    }
}

} // namespace gwatershed
