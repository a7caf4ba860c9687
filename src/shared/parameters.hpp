// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_PARAMETERS_HPP
#define OPENCV_GWATERSHED_PARAMETERS_HPP

#include "shared/sample.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The parameters of SuperpixelGWatershed. Setters throw, and change nothing, on a wrong value.
struct Parameters
{
    int algorithm = RGWATERSHED;
    int region_size = 10;   //!< 0: num_superpixels rules
    int num_superpixels = 0;
    float ruler = 10.f;
    int effort = 1;
    float alpha = 0.5f;
    bool lab_input = false;
    bool temporal = false;
    float low_value = 0;    //!< both 0: the range of values comes from the image
    float high_value = 0;
    float near_depth = 0;   //!< both 0: the range comes from the frame
    float far_depth = 0;
    float focal_x = 0;      //!< in pixels; 0: a usual one
    float focal_y = 0;      //!< 0: as focal_x
    float normal_weight = 0.2f;
    bool depth_adaptive = false;
    float border_threshold = 150; //!< measured, see doc/log.md; 0: none

    void setAlgorithm(int value);
    void setRegionSize(int value);
    void setDesiredSuperpixels(int value);
    void setRuler(float value);
    void setEffort(int value);
    void setAlpha(float value);
    void setValueRange(float low, float high);
    void setDepthRange(float first, float last);
    void setFocalLength(float x, float y);
    void setNormalWeight(float value);
    void setBorderThreshold(float value);

    void write(FileStorage& fs) const;
    //! Throws if a value is missing or wrong.
    static Parameters read(const FileNode& fn);

    //! Number of superpixels for a number of pixels in an image of a size, at most one for each.
    int countSuperpixels(Size size, double pixels) const;
    //! The focal length in pixels, for images of a size.
    Point2f focalLength(Size size) const;
    //! The ranges that are set. Both ends are 0 where there is none.
    FloatRange valueRange() const { return { low_value, high_value }; }
    FloatRange depthRange() const { return { near_depth, far_depth }; }
    //! alpha in 1/256.
    int alphaWeight() const { return cvRound(alpha * 256); }
};

}}} // namespace

#endif
