// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PARAMETERS_HPP
#define OPENCV_GWATERSHED_PARAMETERS_HPP

#include "precomp.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The parameters of SuperpixelGWatershed. A setter throws on a wrong value, and then changes nothing.
struct Parameters
{
    int algorithm = RGWATERSHED;
    int region_size = 10;   //!< 0 if num_superpixels is used
    int num_superpixels = 0; //!< 0 if region_size is used
    float ruler = 10.f;
    float alpha = 0.5f;
    bool lab_input = false;
    bool temporal = false;
    float near_depth = 0;   //!< both are 0 if the range is taken from the frame
    float far_depth = 0;
    float border_threshold = 150; //!< found by measurement, see doc/log.md; 0 means no borders

    void setAlgorithm(int value);
    void setRegionSize(int value);
    void setDesiredSuperpixels(int value);
    void setRuler(float value);
    void setAlpha(float value);
    void setDepthRange(float first, float last);
    void setBorderThreshold(float value);

    void write(FileStorage& fs) const;
    //! Throws if a value is missing or wrong.
    static Parameters read(const FileNode& fn);

    //! Number of superpixels for a number of pixels, at most one for each.
    int countSuperpixels(double pixels) const;
    //! alpha in 1/256.
    int alphaWeight() const { return cvRound(alpha * 256); }
};

}}} // namespace

#endif
