// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_FEATURES_HPP
#define OPENCV_GWATERSHED_FEATURES_HPP

#include "shared/camera.hpp"
#include "shared/padded.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! Fixed-point units of means, distances and weights.
static const int STEPS_PER_LEVEL = 16; //!< of the 8-bit grey levels of a feature: means and distances are in these
static const int FULL_WEIGHT = 256;    //!< a weight of 1

//! A pixel, or a block of pixels, as RGWATERSHED compares it: lightness and two colour differences
//! of an opponent space, and scaled depth, 0 if missing.
struct Feature
{
    uchar color[3];
    uchar depth;
};

//! Direction of the surface at a pixel, or of a block: x and y of its unit normal in the axes of the camera, 1..255 for
//! -1..1; both 0 if it is not known.
struct Normal
{
    uchar x, y;

    enum { ZERO = 128, ONE = 127 };
    bool known() const { return x != 0; }
};

//! Normals with their number, in the parts of a word: up to 16 of them are added up at once.
//! @note Halves of a level are exact in the quotients, so they are rounded as they are in integers.
struct NormalSum
{
    enum { Y_SHIFT = 12, COUNT_SHIFT = 24, PART = (1 << 12) - 1 };

    static int of(const Normal& n) { return n.x + (n.y << Y_SHIFT) + (n.known() << COUNT_SHIFT); }

    //! The mean of those that are known.
    static Normal mean(int sum)
    {
        const float count = float(std::max(sum >> COUNT_SHIFT, 1));
        const Normal mean = { uchar(int(0.5f + float(sum & PART) / count)),
                              uchar(int(0.5f + float(sum >> Y_SHIFT & PART) / count)) };
        return mean;
    }
};

//! Features of the pixels of an image, or of the blocks of a level, and beside them their normals, if there are any.
//! Normals change slowly, so pixels have those of blocks of 2x2.
struct FeatureMap : Padded<Feature>
{
    Mat normals;          //!< CV_8UC2, as Normal; empty if there are none
    int normal_shift = 0; //!< an element of normals is that of 2^normal_shift elements, along both axes
    Camera camera;        //!< of the normals, in elements of this map

    bool withNormals() const { return !normals.empty(); }
    const Normal* normalsOfRow(int y) const { return normals.ptr<Normal>(y >> normal_shift); }
    const Normal& normalAt(Point p) const { return normalsOfRow(p.y)[p.x >> normal_shift]; }
};

//! Features of a row of pixels of 1, 3 or 4 channels; depth may be 0. If lab_input is false, colours are BGR and become
//! those of the opponent space.
void makeFeatureRow(const uchar* color, int channels, bool lab_input, const uchar* depth, int cols, Feature* to);

}}} // namespace

#endif
