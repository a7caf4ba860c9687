// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef GWATERSHED_PYTHON_ERRORS_HPP
#define GWATERSHED_PYTHON_ERRORS_HPP

namespace gwatershed
{

//! From now on a cv::Exception becomes a MemoryError, a RuntimeError where something must be called first, or a
//! ValueError, with the text of the check and without that of its place.
void translateErrors();

} // namespace gwatershed

#endif
