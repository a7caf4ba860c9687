# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Superpixels by a marker-controlled watershed, for colour images and for colour with depth.

    labels = gwatershed.segment(image, region_size=20)
    table = gwatershed.superpixels(labels, image)

SuperpixelGWatershed and createSuperpixelGWatershed() have the names and keywords that cv2.ximgproc has in an OpenCV
that was built with the module. Wrong arguments are refused where OpenCV's binding guesses, and read() takes the text
that write() gives. Errors are a ValueError for wrong values, a TypeError for wrong types and most
integers beyond 32 bits, a MemoryError, or a RuntimeError where another call must come first. One object can be used by
several threads, which wait for each other; different objects run at the same time.
"""
from ._native import (
    GWATERSHED,
    RGWATERSHED,
    SuperpixelGWatershed,
    __version__,
    createSuperpixelGWatershed,
    getNumThreads,
    setNumThreads,
)
from .segmentation import segment, superpixels

__all__ = [
    "GWATERSHED",
    "RGWATERSHED",
    "SuperpixelGWatershed",
    "__version__",
    "createSuperpixelGWatershed",
    "getNumThreads",
    "segment",
    "setNumThreads",
    "superpixels",
]
