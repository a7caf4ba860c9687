// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arguments.hpp"

namespace cv { namespace ximgproc { namespace gws {

void checkIterations(int num_iterations)
{
    CV_CheckGE(num_iterations, 1, "num_iterations must be 1 or more");
}

void checkSize(int64 width, int64 height)
{
    const double nodes = double(width + 2) * double(height + 2);
    CV_Check(nodes, nodes < INT_MAX - 2, "image, with a frame of one pixel, must have fewer than 2^31 - 3 pixels");
}

//! The matrix of an input; the data is not copied.
static Mat takeMatrix(InputArray input, const char* name)
{
    const int kind = input.kind();
    if (input.isMatVector() || input.isUMatVector() || kind == _InputArray::STD_ARRAY_MAT ||
        kind == _InputArray::STD_VECTOR_VECTOR)
        CV_Error_(Error::StsBadArg, ("%s must be one Mat or UMat", name));
    const Mat matrix = input.getMat();
    if (matrix.dims != 2)
        CV_Error_(Error::StsBadArg, ("%s must have two dimensions, not %d", name, matrix.dims));
    return matrix;
}

Mat checkImage(InputArray input)
{
    if (input.empty())
        CV_Error(Error::StsBadArg, "image must not be empty");
    const Mat image = takeMatrix(input, "image");
    CV_Check(image.depth(), image.depth() == CV_8U || image.depth() == CV_16U || image.depth() == CV_32F,
             "image must be CV_8U, CV_16U or CV_32F");
    CV_Check(image.channels(), image.channels() == 1 || image.channels() == 3 || image.channels() == 4,
             "image must have 1, 3 or 4 channels");
    checkSize(image.cols, image.rows);
    return image;
}

Mat checkDepth(InputArray input, Size size)
{
    if (input.empty())
        CV_Error(Error::StsBadArg, "depth must not be empty; call iterate(image) where there is none");
    const Mat depth = takeMatrix(input, "depth");
    CV_CheckType(depth.type(), depth.type() == CV_8UC1 || depth.type() == CV_16UC1 || depth.type() == CV_32FC1,
                 "depth must be CV_8UC1, CV_16UC1 or CV_32FC1");
    CV_CheckEQ(depth.size(), size, "depth must have the size of image");
    return depth;
}

Mat checkValues(InputArray input, Size size)
{
    if (input.empty())
        return Mat();
    const Mat image = takeMatrix(input, "image");
    CV_CheckEQ(image.size(), size, "image must have the size of the label map");
    return image;
}

Mat checkMask(InputArray input)
{
    if (input.empty())
        return Mat();
    const Mat mask = takeMatrix(input, "mask");
    CV_CheckTypeEQ(mask.type(), CV_8UC1, "mask must be CV_8UC1");
    return mask;
}

Mat checkMarkers(InputArray input)
{
    if (input.empty())
        return Mat();
    const Mat markers = takeMatrix(input, "markers");
    CV_CheckTypeEQ(markers.type(), CV_32SC1, "markers must be CV_32SC1");
    return markers;
}

void checkOutput(const _OutputArray& output, int type, bool is_line, const char* name)
{
    const bool is_matrix = output.isMat() || output.isUMat() || output.isMatx();
    if (!is_matrix && !(is_line && output.isVector()))
        CV_Error_(Error::StsBadArg, ("%s must be a Mat or UMat", name));
    if (output.fixedType() && output.type() != type)
        CV_Error_(Error::StsUnmatchedFormats, ("%s must be %s", name, typeToString(type).c_str()));
}

Mat createOutput(const _OutputArray& output, Size size, int type)
{
    output.create(size, type);
    return output.getMat().reshape(0, size.height);
}

}}} // namespace
