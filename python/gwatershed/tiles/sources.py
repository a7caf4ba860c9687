# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Images and depth maps in files, read window by window."""
import errno
import os
import threading
import warnings
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any, Dict, Iterator, Optional, Tuple

import numpy as np

from gwatershed.segmentation import valid_depth

from .tiling import Window

SAMPLED_ROWS = 64  # for the range of an image; each may need a row of chunks
SAMPLES_IN_A_ROW = 4096
FILES_OF_ZARR = (".zarray", ".zgroup", "zarr.json")
_opening = threading.Lock()  # what warns is a setting of the process


def is_zarr(name: str) -> bool:
    return name.rstrip("/").endswith(".zarr") or os.path.isdir(name)


def may_be_replaced(name: str) -> bool:
    """Whether nothing is there, or what would be written: an array of Zarr, or a file whose name does not say so."""
    return (not (is_zarr(name) and os.path.exists(name)) or
            any(os.path.exists(os.path.join(name, part)) for part in (".zarray", "zarr.json")))


@dataclass(frozen=True)
class Source:
    """Bands of a file. Workers open it themselves: only the name travels."""
    name: str               # absolute, as workers of a cluster start in other folders
    bands: Tuple[int, ...]  # from 1 on, as GDAL counts
    height: int
    width: int
    state: Tuple[int, int, int]  # so that a run is not taken up with another image of the same name
    dtype: str = ""         # of the values, as NumPy names it

    @staticmethod
    def open(name: str, bands: Optional[Tuple[int, ...]] = None, single: bool = False) -> "Source":
        """The bands that are named, or the first three, or the first one where there are fewer or `single` is set."""
        height, width, count = _zarr_shape(name) if is_zarr(name) else _raster_shape(name)
        if bands is None:
            bands = (1, 2, 3) if count >= 3 and not single else (1,)
        if len(bands) not in (1, 3) or not all(1 <= band <= count for band in bands):
            raise ValueError("bands must be one or three of the %d of %s, not %s" % (count, name, list(bands)))
        name = name if "://" in name else os.path.abspath(name)
        source = Source(name, tuple(bands), height, width, _state_of(name))
        return replace(source, dtype=source._type_of_values())

    def _type_of_values(self) -> str:
        """What is read must be numbers whose order says something."""
        dtype = self._read(Window(0, 0, 1, 1))[0].dtype
        if dtype.kind not in "biuf":
            raise ValueError("%s must have numbers that are not %s" % (self.name, dtype))
        if not is_zarr(self.name) and _has_palette(self.name, self.bands):
            raise ValueError("image and depth must not have colours by number, as %s has: turn them to red, green and"
                             " blue, or to depth" % self.name)
        return str(dtype.newbyteorder("=").name)

    def read(self, window: Window) -> Any:
        """height x width, or height x width x 3; and whether a pixel is valid."""
        pixels, valid = self._read(window)
        if pixels.dtype.kind == "f":
            finite = np.isfinite(pixels)
            valid = valid & (finite if pixels.ndim == 2 else finite.all(axis=2))
        return pixels, valid

    def read_depth(self, window: Window) -> Any:
        """Depth, 0 where the file has none. What is infinite stays so: it is far."""
        depth, known = self._read(window)
        return np.where(known, depth, 0).astype(depth.dtype)

    def _read(self, window: Window) -> Any:
        return (self._read_zarr if is_zarr(self.name) else self._read_raster)(window)

    def _read_zarr(self, window: Window) -> Any:
        import zarr
        array = zarr.open(self.name, mode="r")
        if array.ndim == 2:
            pixels = array[window.slices]
        else:
            pixels = array[window.slices + (slice(None),)][:, :, [band - 1 for band in self.bands]]
            pixels = pixels[:, :, 0] if len(self.bands) == 1 else pixels
        return pixels, np.ones(window.shape, bool)

    def _read_raster(self, window: Window) -> Any:
        from rasterio.windows import Window as RasterWindow
        place = RasterWindow(window.left, window.top, *window.shape[::-1])
        with open_raster(self.name) as file:
            pixels = file.read(list(self.bands), window=place)
            valid = file.dataset_mask(window=place) != 0
        return (pixels[0] if len(self.bands) == 1 else np.ascontiguousarray(pixels.transpose(1, 2, 0))), valid

    def georeference(self) -> Dict[str, Any]:
        """What a GeoTIFF of the labels takes over."""
        if is_zarr(self.name):
            return {}
        with open_raster(self.name) as file:
            rpcs = {"rpcs": file.rpcs} if file.rpcs else {}
            points, crs = file.gcps
            if points:
                return {"crs": crs, "gcps": points, **rpcs}
            transform = {} if file.transform.is_identity else {"transform": file.transform}
            return {"crs": file.crs, **transform, **rpcs}

    def range(self, of_depth: bool = False) -> Optional[Tuple[float, float]]:
        """From the 1st to the 99th percentile of a regular sample; None for 8 bits, which are taken as they are. Of
        depth, what is missing does not count: 0 and below, and 65535 in 16 bits."""
        if self.dtype == "uint8":
            return None
        step = -(-self.height // SAMPLED_ROWS)
        samples = np.concatenate([self._sample_row(y) for y in range(step // 2, self.height, step)])
        if of_depth:
            samples = samples[valid_depth(samples)]
        if samples.size == 0:
            return None
        low, high = (float(p) for p in np.percentile(samples.astype(np.float64), (1, 99)))
        return (low, high) if high > low else (low, low + 1)

    def _sample_row(self, y: int) -> Any:
        pixels, valid = self.read(Window(y, 0, y + 1, self.width))
        step = max(self.width // SAMPLES_IN_A_ROW, 1)
        return pixels[0, ::step][valid[0, ::step]].ravel()


@contextmanager
def open_raster(*arguments: Any, **profile: Any) -> Iterator[Any]:
    """What rasterio.open() gives, without a warning for a plain picture, which has no georeference."""
    import rasterio
    from rasterio.errors import NotGeoreferencedWarning
    with _opening, warnings.catch_warnings():
        warnings.simplefilter("ignore", NotGeoreferencedWarning)
        file = rasterio.open(*arguments, **profile)
    with file:
        yield file


def write_window(file: Any, window: Window, values: Any) -> None:
    """Into the first band of an open raster."""
    from rasterio.windows import Window as RasterWindow
    file.write(values, 1, window=RasterWindow(window.left, window.top, *window.shape[::-1]))


def _raster_shape(name: str) -> Tuple[int, int, int]:
    with open_raster(name) as file:
        return file.height, file.width, file.count


def _has_palette(name: str, bands: Tuple[int, ...]) -> bool:
    from rasterio.enums import ColorInterp
    with open_raster(name) as file:
        return any(file.colorinterp[band - 1] == ColorInterp.palette for band in bands)


def _state_of(name: str) -> Tuple[int, int, int]:
    """The last change of a file, or of those in a folder, whose own time says nothing of what lies deeper; their
    number; and their size. Nothing is known of an address."""
    if not os.path.isdir(name):
        return (os.stat(name).st_mtime_ns, 1, os.stat(name).st_size) if os.path.exists(name) else (0, 0, 0)
    last, number, size = 0, 0, 0
    for folder, _, files in os.walk(name):
        for file in files:
            found = os.stat(os.path.join(folder, file))
            last, number, size = max(last, found.st_mtime_ns), number + 1, size + found.st_size
    return last, number, size


def _zarr_shape(name: str) -> Tuple[int, int, int]:
    import zarr
    if "://" not in name and not os.path.exists(name):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), name)
    if os.path.isdir(name) and not any(os.path.exists(os.path.join(name, part)) for part in FILES_OF_ZARR):
        raise ValueError("%s must be an array of Zarr, not another folder" % name)
    shape = getattr(zarr.open(name, mode="r"), "shape", ())
    bands_first = len(shape) == 3 and shape[0] <= 4 < shape[2]
    if len(shape) not in (2, 3) or bands_first:
        raise ValueError("%s must be an array, height x width or height x width x bands, not %s" %
                         (name, shape or "a group"))
    return shape[0], shape[1], shape[2] if len(shape) == 3 else 1


def to_8_bits(pixels: Any, value_range: Optional[Tuple[float, float]]) -> Any:
    """The range of the whole image as 0..255, so that all tiles see the same values."""
    if value_range is None:
        return pixels
    low, high = value_range
    kind = np.result_type(pixels.dtype, np.float32)  # more bits where those of 32 would lose levels
    scaled = (pixels.astype(kind) - kind.type(low)) * kind.type(255 / (high - low))
    return np.nan_to_num(scaled.clip(0, 255)).round().astype(np.uint8)
