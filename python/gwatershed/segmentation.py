# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Functions in the manner of scikit-image: an image in, labels out."""
import operator
import warnings
from typing import Any, Optional, Tuple

import numpy as np

from ._native import SuperpixelGWatershed, _measure

NAMES_OF_SLIC = {"n_segments": "num_superpixels", "compactness": "ruler", "max_num_iter": "num_iterations"}


def segment(image: Any, region_size: Optional[int] = None, *, num_superpixels: Optional[int] = None,
            depth: Any = None, mask: Any = None, markers: Any = None, num_iterations: int = 1,
            start_label: int = 0, bgr: bool = False, **parameters: Any) -> Any:
    """Divides an image into superpixels and returns their labels, int32.

    image: height x width, or with 1 to 4 channels as third dimension; bool, integers or floats. Three channels are RGB,
        as scikit-image, Pillow and imageio read them; see bgr. A fourth one, as alpha, is ignored. Unsigned integers of
        8 bits are taken as they are, others have a range that is found; value_range sets it. Images of Pillow that are
        neither grey nor RGB, as those with a palette, CMYK or alpha, become RGB.
    region_size: side of a superpixel in pixels, 10 if neither this nor num_superpixels is given; as many as fit.
    num_superpixels: number of superpixels, met exactly, instead of region_size.
    depth: depth map of the same size, floats or integers but int8. 0, what is below, NaN and 65535 of uint16 are
        missing; infinity is far. A UserWarning says if none is valid, or none lies in depth_range. Images of Pillow
        must be grey.
    mask: bool, or not 0 inside; pixels outside get the label start_label - 1.
    markers: integers, positive ones are markers that superpixels grow from, instead of region_size and num_superpixels.
    num_iterations: more of them follow the image better.
    start_label: label of the first superpixel. regionprops() of scikit-image needs 1.
    bgr: whether three channels are BGR, as cv2.imread() gives them.
    parameters: others of SuperpixelGWatershed, as ruler=10, alpha=0.5, lab_input=False, value_range=(0, 4095),
        depth_range=(0.4, 4), focal_length=(525, 525).
    """
    if region_size is not None and num_superpixels is not None:
        raise ValueError("give region_size or num_superpixels, not both")
    if region_size is not None:
        parameters["region_size"] = region_size
    if num_superpixels is not None:
        parameters["num_superpixels"] = num_superpixels
    start_label, num_iterations = integer(start_label, "start_label"), count_of(num_iterations, "num_iterations")
    for name, own in NAMES_OF_SLIC.items():
        if name in parameters:
            raise TypeError("there is no parameter %s; here it is %s" % (name, own))
    labels = labels_of(image, depth, mask, markers, num_iterations, bgr, parameters)
    if depth is not None:
        _warn_of_depth(np.asarray(depth), *parameters.get("depth_range", (0, 0)))
    if start_label:
        if not -2**31 - min(labels.min(), 0) <= start_label <= 2**31 - 1 - labels.max():
            raise ValueError("start_label must be a number from which all labels fit 32 bits, not %d" % start_label)
        labels += np.int32(start_label)
    return labels


def labels_of(image: Any, depth: Any, mask: Any, markers: Any, num_iterations: int, bgr: bool, parameters: Any) -> Any:
    """What segment() returns, from 0 on."""
    gws = SuperpixelGWatershed(**parameters)
    gws.setMask(_inside(mask))
    gws.setMarkers(_optional(markers, "markers"))
    gws.iterate(_colors(image, bgr or gws.getLabInput()), depth_array(depth), num_iterations)
    return gws.getLabels()


def superpixels(labels: Any, image: Any = None, depth: Any = None, *, start_label: int = 0,
                focal_length: Optional[Tuple[float, float]] = None) -> Any:
    """Measures the superpixels of a label map in one pass, into a structured array: a row for each label that occurs.

    labels: integers; pixels below start_label are outside.
    image: image of that size, of 1 to 128 channels (512 with OpenCV 4), for mean_color; those of Pillow as in
        segment().
    depth: depth of that size, for mean_depth; metric, for position and normal.
    focal_length: (fx, fy) of the depth camera in pixels, for position and normal. fy 0 is fx; both 0 are 0.8 of the
        longer side of the image, which is near to that of usual sensors.

    Fields: label, area, bbox (min_row, min_col, max_row, max_col; half open, as of regionprops()), centroid (row, col),
    mean_color, in the order of the channels of image, and mean_depth, NaN where no depth is valid. With depth and
    focal_length also position, the mean point in space (x to the right, y down, z forward from the camera, in the unit
    of depth), and normal (x, y, z, of length 1, towards the camera), NaN where there is nothing to take them from.
    """
    labels, start_label = _plain(labels, "labels"), integer(start_label, "start_label")
    if focal_length is not None:
        SuperpixelGWatershed(focal_length=focal_length)  # which says what is wrong as it does for segment()
    if labels.ndim != 2 or labels.dtype.kind not in "iu" or labels.size == 0:
        raise ValueError("labels must be integers in two dimensions, not %s of shape %s" % (labels.dtype, labels.shape))
    names, numbers = _compact(labels, start_label)
    image, depth = _optional(_image(image), "image"), depth_array(depth)
    stats, centroids, mean_colors, mean_depths, positions, normals = _measure(
        numbers, len(names), image, depth, focal_length)
    channels = 0 if image is None else image.shape[2] if image.ndim == 3 else 1
    with_surface = depth is not None and focal_length is not None
    table = np.zeros(len(names), _fields(labels.dtype, channels, depth is not None, with_surface))
    if len(names) == 0:
        return table
    table["label"] = names
    table["area"] = stats[:, 4]
    left, top, width, height = stats[:, :4].T
    table["bbox"] = np.stack([top, left, top + height, left + width], axis=1)
    table["centroid"] = centroids[:, ::-1]
    if image is not None:
        table["mean_color"] = mean_colors
    if depth is not None:
        table["mean_depth"] = mean_depths[:, 0]
    if with_surface:
        table["position"] = positions
        table["normal"] = normals
    return table[table["area"] > 0]


def integer(value: Any, name: str) -> int:
    """An integer of any type."""
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError("%s must be an integer, not %.60r" % (name, value)) from None


def count_of(value: Any, name: str) -> int:
    """A number of things, of any type of integers."""
    value = integer(value, name)
    if not 1 <= value < 2**31:
        raise ValueError("%s must be from 1 to %d, not %d" % (name, 2**31 - 1, value))
    return value


def valid_depth(depth: Any) -> Any:
    """Where depth is not missing."""
    is_word = depth.dtype.newbyteorder("=") == np.uint16
    return (depth > 0) & (depth != 65535) if is_word else depth > 0


def _warn_of_depth(depth: Any, near: float, far: float) -> None:
    """Depth that says nothing is no error: a camera may see nothing. But it is a mistake of units more often."""
    valid = valid_depth(depth)
    if not valid.any():
        warnings.warn("depth has no valid value: the superpixels follow colour alone", stacklevel=3)
    elif far > 0 and not (valid & (depth >= near) & (depth <= far)).any():
        warnings.warn("no depth lies in depth_range, %g to %g: have both the same unit?" % (near, far), stacklevel=3)


def _fields(label_type: Any, channels: int, with_depth: bool, with_surface: bool) -> Any:
    fields: Any = [("label", label_type), ("area", np.int32), ("bbox", np.int32, (4,)), ("centroid", np.float64, (2,))]
    if channels:
        fields.append(("mean_color", np.float32, (channels,)))
    if with_depth:
        fields.append(("mean_depth", np.float32))
    if with_surface:
        fields += [("position", np.float32, (3,)), ("normal", np.float32, (3,))]
    return fields


def _compact(labels: Any, start_label: int) -> Any:
    """The labels that there may be, and the map with their numbers, 0 .. N-1, as int32; -1 outside."""
    last = int(labels.max())
    if last < start_label:
        return np.zeros(0, labels.dtype), np.full(labels.shape, -1, np.int32)
    number = last - start_label + 1
    if number <= labels.size:  # nearly all occur
        outside = labels < start_label
        wide = labels if labels.dtype.itemsize == 8 else labels.astype(np.int64)
        numbers = (wide - wide.dtype.type(start_label)).astype(np.int32)
        numbers[outside] = -1
        names = np.arange(number, dtype=wide.dtype) + wide.dtype.type(start_label)
        return names.astype(labels.dtype), numbers
    names, inverse = np.unique(labels, return_inverse=True)
    first = int(np.searchsorted(names, start_label))
    numbers = np.maximum(inverse.reshape(labels.shape) - first, -1).astype(np.int32)
    return names[first:], numbers


def _colors(image: Any, as_they_are: bool) -> Any:
    """The image in the order of the channels that the class takes. bool becomes black and white."""
    if image is None:
        raise ValueError("image must not be None")
    image = _image(image)
    if image.ndim == 3 and image.shape[2] > 4:
        raise ValueError("image must have 1 to 4 channels, as its last dimension, not the shape %s" % (image.shape,))
    if image.dtype == bool:
        image = image * np.uint8(255)
    if image.ndim == 3 and image.shape[2] in (3, 4) and not as_they_are:
        return image[:, :, 2::-1]
    return image


def _image(image: Any) -> Any:
    """An array, or None. Images of Pillow that are neither grey nor RGB become RGB: their numbers are of a palette, or
    of other colours."""
    mode = _mode_of_pillow(image)
    if mode not in ("", "1", "L", "RGB") and mode[0] not in "IF":
        image = image.convert("RGB")
    return None if image is None else _plain(image, "image")


def _mode_of_pillow(image: Any) -> str:
    mode = getattr(image, "mode", "")
    return mode if isinstance(mode, str) and hasattr(image, "convert") else ""


def depth_array(depth: Any) -> Any:
    """An array, or None. What Pillow has as numbers of a palette, as colours or as black and white is no depth."""
    mode = _mode_of_pillow(depth)
    if mode not in ("", "L") and mode[0] not in "IF":
        raise ValueError("depth must be grey values of 8 or 16 bits, or float, not an image of the mode " + mode)
    return _optional(depth, "depth")


def _plain(values: Any, name: str) -> Any:
    """An array. What has a mask of its own, which would be lost, is refused, and what is a name or a number."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise TypeError(name + " must not be a masked array: fill it, floats with NaN, or give segment() its mask")
    array = np.asarray(values)
    if array.ndim == 0:
        raise TypeError("%s must be an array, not %.60r" % (name, values))
    return array


def _optional(values: Any, name: str) -> Any:
    """An array, or None. bool becomes 0 and 1."""
    if values is None:
        return None
    values = _plain(values, name)
    return values.view(np.uint8) if values.dtype == bool else values


def _inside(mask: Any) -> Any:
    """A mask as bool."""
    return None if mask is None else _plain(mask, "mask") != 0
