# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Checks of arguments, before anything is read or made."""
import importlib.util
from typing import Any, Optional, Sequence, Tuple

import numpy as np

import gwatershed
from gwatershed.segmentation import count_of, integer

from .sources import is_zarr, may_be_replaced

SCHEDULERS = ("threads", "processes", "single-threaded")


def check_parameters(parameters: Any) -> None:
    """Refuses what would be refused at the first tile, and what would mean nothing there."""
    if "num_superpixels" in parameters:
        raise ValueError("num_superpixels must not be given for tiles: give region_size")
    if parameters.get("temporal"):
        raise ValueError("temporal must not be set for tiles: they are no frames of a video")
    gwatershed.SuperpixelGWatershed(**parameters)


def workers_of(workers: Any) -> Optional[int]:
    return None if workers is None else count_of(workers, "workers")


def bands_of(bands: Any) -> Optional[Tuple[int, ...]]:
    if bands is None:
        return None
    if not np.iterable(bands):
        raise TypeError("bands must be one or three numbers in a list, not %.60r" % (bands,))
    return tuple(integer(band, "each of bands") for band in bands)


def range_of(values: Any) -> Any:
    """A range, or None where it is to be found: 0 and 0, too, as the class has it."""
    if values is None or not np.iterable(values):
        return values
    values = tuple(values)
    return None if values == (0, 0) else values


def check_packages(names: Sequence[str], scheduler: Any) -> None:
    """Says what is not installed before anything is read or made."""
    needed = {"dask": True, "zarr": True, "rasterio": not all(map(is_zarr, names)),
              "distributed": isinstance(scheduler, str) and scheduler not in SCHEDULERS}
    for package, is_needed in needed.items():
        if is_needed and importlib.util.find_spec(package) is None:
            raise ModuleNotFoundError("this needs %s: python3-%s, or pip install '.[tiles]' in the folder of gwatershed"
                                      % (package, package))


def check_output(output: str) -> None:
    if "://" in output:
        raise ValueError("output must be a file or a folder, not an address as %s" % output)
    if not is_zarr(output) and not output.lower().endswith((".tif", ".tiff")):
        raise ValueError("output must be .zarr, .tif or .tiff, not %s" % output)
    if not may_be_replaced(output):
        raise ValueError("output must not be a folder, or a file named .zarr, that is there and no array of Zarr, as %s"
                         " is" % output)


def check_scheduler(scheduler: Any) -> None:
    is_known = scheduler in SCHEDULERS or ":" in scheduler if isinstance(scheduler, str) else all(
        hasattr(scheduler, name) for name in ("compute", "gather"))
    if not is_known:
        raise ValueError("scheduler must be %s, an address as tcp://head:8786, or a Client, not %.60r"
                         % (", ".join(SCHEDULERS), scheduler))


def check_start_label(start_label: int, pixels: int, output: str) -> None:
    """All labels must fit, however many there will be. A GeoTIFF has the value of no data as a floating-point number,
    which GDAL rounds."""
    if not -2**63 < start_label <= 2**63 - pixels:
        raise ValueError("start_label must be from %d to %d for this image, so that labels fit 64 bits, not %d"
                         % (1 - 2**63, 2**63 - pixels, start_label))
    if not is_zarr(output) and abs(start_label - 1) > 2**52:
        raise ValueError("start_label must be from %d to %d for a GeoTIFF, so that no data has an exact value, not %d;"
                         " .zarr takes others" % (1 - 2**52, 1 + 2**52, start_label))
