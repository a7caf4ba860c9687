// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_HPP
#define OPENCV_GWATERSHED_HPP

#include "opencv2/gwatershed/superpixel_gwatershed.hpp"

#include <algorithm>
#include <climits>
#include <type_traits>

/**
@defgroup gwatershed Superpixels by a marker-controlled watershed on a gradient map

The module has one class, cv::ximgproc::SuperpixelGWatershed. It divides a colour image, or a colour image
with its depth map, into superpixels after @cite Jiang2015 . Its interface is that of SuperpixelSLIC and
SuperpixelSEEDS in the module ximgproc, which it does not need. @ref tutorial_gwatershed starts from code
for SuperpixelSLIC.
*/

namespace cv
{
namespace ximgproc
{

//! @addtogroup gwatershed
//! @{

/** @brief Makes an object for images of a given size, as createSuperpixelSEEDS() does.

Buffers are allocated for that size. Images of another size or number of channels are accepted as well.

@param image_width Width of the images to come in pixels, 1 or more.
@param image_height Height in pixels, 1 or more.
@param image_channels Number of channels, 1 to 4. It is checked, and nothing else.
@param num_superpixels Number of superpixels, met exactly. See SuperpixelGWatershed::setDesiredSuperpixels.
@param algorithm One of #GWatershedType.
@param ruler Compactness. See SuperpixelGWatershed::setRuler.
*/
CV_EXPORTS_W Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        int image_width, int image_height, int image_channels, int num_superpixels,
        int algorithm = RGWATERSHED, float ruler = 10.0f);

//! For numbers of other types, such as size_t. Fractions, and what is beyond the range of int, are cut off.
template <typename Width, typename Height, typename Channels, typename Number>
inline typename std::enable_if<std::is_arithmetic<Width>::value && std::is_arithmetic<Height>::value &&
                               std::is_arithmetic<Channels>::value && std::is_arithmetic<Number>::value,
                               Ptr<SuperpixelGWatershed> >::type
createSuperpixelGWatershed(Width image_width, Height image_height, Channels image_channels, Number num_superpixels,
                           int algorithm = RGWATERSHED, float ruler = 10.0f)
{
    const auto cut = [](double value) { return int(std::min(std::max(double(INT_MIN), value), double(INT_MAX))); };
    return createSuperpixelGWatershed(cut(double(image_width)), cut(double(image_height)),
                                      cut(double(image_channels)), cut(double(num_superpixels)), algorithm, ruler);
}

/** @overload
@brief Makes an object for an image, as createSuperpixelSLIC() does.

@param image Image to segment; a copy is kept for SuperpixelGWatershed::iterate(int).
@param algorithm One of #GWatershedType. 0 is taken for None of Python, which is depth that is not there.
@param region_size Mean side of a superpixel in pixels. See SuperpixelGWatershed::setRegionSize.
@param ruler Compactness. See SuperpixelGWatershed::setRuler.
*/
CV_EXPORTS_W Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        InputArray image, int algorithm, int region_size = 10, float ruler = 10.0f);

//! Accepts a ruler of another type, such as the integer 10, without a conversion by hand.
template <typename Ruler>
inline typename std::enable_if<std::is_arithmetic<Ruler>::value, Ptr<SuperpixelGWatershed> >::type
createSuperpixelGWatershed(InputArray image, int algorithm, int region_size, Ruler ruler)
{
    return createSuperpixelGWatershed(image, algorithm, region_size, static_cast<float>(ruler));
}

/** @overload
@brief Makes an object for an image with depth.

@param image Image to segment; a copy is kept for SuperpixelGWatershed::iterate(int).
@param depth Depth map of the size of the image, or empty if there is none; a copy is kept, too.
@param algorithm One of #GWatershedType.
@param region_size Mean side of a superpixel in pixels. See SuperpixelGWatershed::setRegionSize.
@param ruler Compactness. See SuperpixelGWatershed::setRuler.
@param alpha Weight of colour against depth. See SuperpixelGWatershed::setAlpha.
*/
CV_EXPORTS_W Ptr<SuperpixelGWatershed> createSuperpixelGWatershed(
        InputArray image, InputArray depth = noArray(), int algorithm = RGWATERSHED, int region_size = 10,
        float ruler = 10.0f, float alpha = 0.5f);

//! @}

} // namespace ximgproc
} // namespace cv

#endif // OPENCV_GWATERSHED_HPP
