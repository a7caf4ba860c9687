// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_SURFACE_NORMALS_HPP
#define OPENCV_GWATERSHED_SURFACE_NORMALS_HPP

#include "shared/camera.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Inverse depths of the blocks of 2x2 pixels of an image, in CV_16SC1, 0 where it is not known. Around them is a frame
//! of zeros, as wide as normals are taken over, and each row ends with some more, up to a whole stride.
struct InverseDepths
{
    enum { REACH = 4 };    //!< blocks over which differences are taken; less is noise, more misses small things
    enum { STRIDE = 8 };   //!< blocks that become normals at once
    enum { MOST = SHRT_MAX };

    void create(Size image)
    {
        blocks = Size((image.width + 1) / 2, (image.height + 1) / 2);
        buffer.create(blocks.height + 2 * REACH, int(alignSize(blocks.width, STRIDE)) + 2 * REACH, CV_16SC1);
        buffer.setTo(Scalar(0));
    }

    short* row(int y) { return buffer.ptr<short>(y + REACH) + REACH; }
    const short* row(int y) const { return buffer.ptr<short>(y + REACH) + REACH; }
    int step() const { return int(buffer.step1()); }
    //! Blocks in a row of whole strides.
    int paddedWidth() const { return buffer.cols - 2 * REACH; }

    Size blocks;
    Mat buffer;
};

//! Finds the normals of the blocks, as findSurface() gives them. Returns false if few blocks have one, as where depth
//! is sparse: a few normals beside many depths are worse than none.
bool findNormals(const Camera& camera, const InverseDepths& inverses, Mat& raw_normals, Mat& normals);

}}} // namespace

#endif
