// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "output.hpp"

namespace cv { namespace ximgproc { namespace gws {

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
