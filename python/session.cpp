// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "session.hpp"

namespace gwatershed
{

std::string Session::write()
{
    return call([](SuperpixelGWatershed& superpixels) {
        cv::FileStorage storage("parameters.json", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
        superpixels.write(storage);
        return std::string(storage.releaseAndGetString());
    });
}

void Session::read(const std::string& parameters)
{
    call([&](SuperpixelGWatershed& superpixels) {
        if (parameters.empty())
            CV_Error(cv::Error::StsBadArg, "parameters must not be empty");
        const cv::FileStorage storage(parameters, cv::FileStorage::READ | cv::FileStorage::MEMORY);
        const cv::FileNode saved = storage[superpixels.getDefaultName()];
        superpixels.read(saved.empty() ? storage.root() : saved);
    });
}

} // namespace gwatershed
