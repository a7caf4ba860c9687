// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_GWATERSHED_BLOCK_TEXTURE_HPP
#define OPENCV_GWATERSHED_BLOCK_TEXTURE_HPP

#include "rgwatershed/feature_pyramid.hpp"
#include "shared/region_measure.hpp"

namespace cv { namespace ximgproc { namespace gws {

//! The texture of each region of blocks of the top level: the mean steps across and down inside of each block, and
//! those of each channel with signs, between those of its elements that lie at its corners, as for half of its side.
//! They count half, as those of pixels do, of which every second row counts. Pixels that are merged as they are have no
//! textures.
//! `steps` is a buffer.
void measureBlockTextures(const PyramidLevel* pyramid, const BlockLevels& levels, const RegionDistance& distance,
                          const Padded<int>& labels, int num_regions, Mat& steps,
                          std::vector<RegionTexture>& textures);

}}} // namespace

#endif
