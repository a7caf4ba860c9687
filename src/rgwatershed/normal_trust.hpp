// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_NORMAL_TRUST_HPP
#define OPENCV_GWATERSHED_NORMAL_TRUST_HPP

#include "shared/features.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! How far the normals of a video can be trusted. Those of a stereo matcher are new in each frame, and boundaries that
//! followed them would be, too; a camera that moves changes those at creases only.
class NormalTrust
{
public:
    //! The first frame. Normals count in full until they are known to change.
    void start(const Mat& normals);

    //! From 0 to 1, for the next frame: by how many normals are as they were in the last frame with other ones.
    float next(const Mat& normals);

private:
    Mat last_;         // normals that were there last; empty: none
    float steady_ = 1; // share of normals that stayed, in the last frame with new ones
    float trust_ = 1;  // in the last frame
};

}}} // namespace

#endif
