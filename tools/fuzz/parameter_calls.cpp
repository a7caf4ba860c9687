// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "attempts.hpp"

#include <functional>

// Calls that set, write and read parameters.

namespace fuzz
{

using cv::FileStorage;
using cv::ximgproc::GWATERSHED;
using cv::ximgproc::RGWATERSHED;

void Session::setParameter()
{
    Settings s = settingsOf(*gws_);
    std::function<void()> set;
    switch (bytes_.ConsumeIntegralInRange(0, 13))
    {
    case 0:
        s.algorithm = bytes_.PickValueInArray({ int(GWATERSHED), int(RGWATERSHED), 199, 202, 0, INT_MIN });
        set = [&]() { gws_->setAlgorithm(s.algorithm); };
        break;
    case 1:
        s.region_size = takeInt(30, bytes_);
        s.num_superpixels = 0;
        set = [&]() { gws_->setRegionSize(s.region_size); };
        break;
    case 2:
        s.region_size = 0;
        s.num_superpixels = takeInt(max_pixels_ / 8, bytes_);
        set = [&]() { gws_->setDesiredSuperpixels(s.num_superpixels); };
        break;
    case 3:
        s.ruler = takeFloat(60, bytes_);
        set = [&]() { gws_->setRuler(s.ruler); };
        break;
    case 4:
        s.alpha = takeFloat(1, bytes_);
        set = [&]() { gws_->setAlpha(s.alpha); };
        break;
    case 5:
        s.lab_input = !s.lab_input;
        set = [&]() { gws_->setLabInput(s.lab_input); };
        break;
    case 6:
        s.temporal = !s.temporal;
        set = [&]() { gws_->setTemporal(s.temporal); };
        break;
    case 7:
        s.low_value = takeFloat(300, bytes_);
        s.high_value = takeFloat(4000, bytes_);
        set = [&]() { gws_->setValueRange(s.low_value, s.high_value); };
        break;
    case 8:
        s.near_depth = takeFloat(3000, bytes_);
        s.far_depth = oneIn(2, bytes_) ? s.near_depth + takeFloat(4000, bytes_) : takeFloat(7000, bytes_);
        set = [&]() { gws_->setDepthRange(s.near_depth, s.far_depth); };
        break;
    case 9:
        s.effort = takeInt(4, bytes_);
        set = [&]() { gws_->setEffort(s.effort); };
        break;
    case 10:
        s.focal_x = takeFloat(600, bytes_);
        s.focal_y = oneIn(2, bytes_) ? 0 : takeFloat(600, bytes_);
        set = [&]() { gws_->setFocalLength(s.focal_x, s.focal_y); };
        break;
    case 11:
        s.normal_weight = takeFloat(1, bytes_);
        set = [&]() { gws_->setNormalWeight(s.normal_weight); };
        break;
    case 12:
        s.depth_adaptive = !s.depth_adaptive;
        set = [&]() { gws_->setDepthAdaptive(s.depth_adaptive); };
        break;
    default:
        s.border_threshold = takeFloat(1500, bytes_);
        set = [&]() { gws_->setBorderThreshold(s.border_threshold); };
    }
    attempt(inRange(s), "setters take what is in range", set);
    require(settingsOf(*gws_) == s || !inRange(s), "getters return what was set");
}

void Session::writeAndRead()
{
    const State before = state();
    FileStorage written(".json", FileStorage::WRITE | FileStorage::MEMORY);
    gws_->write(written);
    FileStorage kept(written.releaseAndGetString(), FileStorage::READ | FileStorage::MEMORY);
    gws_->read(kept.root());
    require(state() == before, "write() and read() keep all");
}

//! Parameters from a file that somebody else has written.
void Session::readNumbers()
{
    const char* const names[] = { "algorithm", "region_size", "num_superpixels", "ruler", "effort", "alpha",
                                  "lab_input", "temporal", "low_value", "high_value", "near_depth", "far_depth",
                                  "focal_x", "focal_y", "normal_weight", "depth_adaptive", "border_threshold" };
    FileStorage written(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    FileStorage own(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    gws_->write(own);
    FileStorage kept(own.releaseAndGetString(), FileStorage::READ | FileStorage::MEMORY);
    bool is_complete = true;
    for (const char* name : names)
        switch (bytes_.ConsumeIntegralInRange(0, 15))
        {
        case 0: is_complete = false; break;
        case 1: written << name << takeInt(200, bytes_); break;
        case 2: written << name << takeFloat(200, bytes_); break;
        case 3: written << name << "word"; is_complete = false; break;
        default: written << name << double(kept[name]);
        }
    FileStorage changed(written.releaseAndGetString(), FileStorage::READ | FileStorage::MEMORY);
    const State before = state();
    const bool accepted = succeeds([&]() { gws_->read(changed.root()); });
    require(!accepted || is_complete, "read() misses no parameter");
    require(accepted || state() == before, "read() changes nothing if it throws");
    require(inRange(settingsOf(*gws_)), "read() takes what is in range");
}

} // namespace
