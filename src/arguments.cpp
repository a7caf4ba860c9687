// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
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
    const double side = double(std::max(width, height)); // an int holds four times as much
    CV_Check(side, side < (1 << 29) - 16, "image must have fewer than 2^29 - 16 columns and rows");
}

//! In Python an array of the shape (H, W, 0) becomes a matrix of many channels that has no memory.
static void checkMemory(const Mat& matrix, const char* name)
{
    const size_t row = matrix.cols * matrix.elemSize();
    if ((matrix.rows > 1 && matrix.step[0] < row) || (matrix.u && matrix.u->size < row))
        CV_Error_(Error::StsBadArg, ("%s must have a channel", name));
}

//! The header of a matrix.
static Mat takeMatrix(InputArray input, const char* name)
{
    const int kind = input.kind();
    if (input.isMatVector() || input.isUMatVector() || kind == _InputArray::STD_ARRAY_MAT ||
        kind == _InputArray::STD_VECTOR_VECTOR || input.isMatx()) // Matx and Vec; C++ passes a number as one
        CV_Error_(Error::StsBadArg, ("%s must be one Mat or UMat", name));
    const Mat matrix = input.getMat();
    if (matrix.dims != 2)
        CV_Error_(Error::StsBadArg, ("%s must have two dimensions, and at most %d channels; it has %d dimensions", name,
                                     CV_CN_MAX, matrix.dims));
    checkMemory(matrix, name);
    return matrix;
}

Mat checkImage(InputArray input)
{
    if (input.empty())
        CV_Error(Error::StsBadArg, "image must not be empty");
    const Mat image = takeMatrix(input, "image");
    CV_CheckDepth(image.depth(), image.depth() <= CV_16F, "image must be CV_8U, 8S, 16U, 16S, 32S, 32F, 64F or 16F");
    CV_CheckLE(image.channels(), MAX_CHANNELS,
               "image must have 1 to 4 channels; choose some by extractChannel() or merge(), or reduce them by PCA");
    checkSize(image.cols, image.rows);
    return image;
}

Mat checkDepth(InputArray input, Size size)
{
    if (input.empty())
        return Mat();
    const Mat depth = takeMatrix(input, "depth");
    const int type = depth.type();
    CV_CheckType(type, type == CV_8UC1 || type == CV_16UC1 || type == CV_16SC1 || type == CV_32FC1 || type == CV_64FC1,
                 "depth must be CV_8UC1, CV_16UC1, CV_16SC1, CV_32FC1 or CV_64FC1");
    CV_CheckEQ(depth.size(), size, "depth must have the size of image");
    return depth;
}

Mat checkValues(InputArray input, Size size)
{
    if (input.empty())
        return Mat();
    const Mat image = takeMatrix(input, "image");
    CV_CheckEQ(image.size(), size, "image must have the size of the label map");
    const double in_row = double(image.cols) * image.channels();
    CV_Check(in_row, in_row < INT_MAX, "image must have fewer than 2^31 - 1 values in a row");
#ifdef CV_64S // since OpenCV 5
    const int depth = image.depth();
    CV_CheckDepth(depth, depth != CV_64S && depth != CV_64U,
                  "image must not be of 64-bit integers, of which double has only 53 bits; convert it to CV_64F");
#endif
    return image;
}

Mat checkMask(InputArray input)
{
    if (input.empty())
        return Mat();
    const Mat mask = takeMatrix(input, "mask");
#ifdef CV_Bool // since OpenCV 5, of which NumPy's are
    if (mask.type() == CV_BoolC1)
        return Mat(mask.size(), CV_8UC1, mask.data, mask.step).clone();
#endif
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
