# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Superpixels of images that are larger than memory, on one machine or many.

It needs dask and zarr, and rasterio for GeoTIFF.

    number = gwatershed.tiles.segment_file("orthophoto.tif", "labels.tif", region_size=20)
"""
from .run import segment_file

__all__ = ["segment_file"]
