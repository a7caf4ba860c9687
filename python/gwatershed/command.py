# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The command gwatershed: superpixels of images in files."""
import argparse
import contextlib
import io
import os
import re
import shutil
import struct
import sys
import time
import warnings
from pathlib import Path
from typing import Any, Iterator, List, Optional, Tuple

import numpy as np

from ._native import __version__
from .segmentation import depth_array, segment, superpixels

DESCRIPTION = "Divides images into superpixels and writes a picture of each."
EXAMPLES = """examples:
  gwatershed image.jpg -o contours.png
  gwatershed image.jpg -o labels.tiff --show labels --depth depth.png --number 400
  gwatershed photographs/*.jpg -o folder

The exit code is 0, 1 if a file could not be read, segmented or written, or a line not printed, 2 if an argument is
unknown, no number or no output, or 130 if it was stopped by Ctrl-C."""
RED = (255, 0, 0)


def displayed(image: Any) -> Any:
    """An image in three channels of 8 bits. Others lose one value in 1000 at each end."""
    if image.dtype == np.uint8:
        return image
    finite = image[np.isfinite(image)].astype(np.float64)
    low, high = np.percentile(finite, (0.1, 99.9)) if finite.size else (0, 1)
    scaled = (image.astype(np.float64) - low) * (255 / ((high - low) or 1))
    gray = np.nan_to_num(scaled.clip(0, 255)).round().astype(np.uint8)
    return np.repeat(gray[:, :, np.newaxis], 3, axis=2)


def contours(image: Any, labels: Any) -> Any:
    """The image with a red line of one pixel where the label changes."""
    line = np.zeros(labels.shape, bool)
    line[:, :-1] |= labels[:, :-1] != labels[:, 1:]
    line[:-1] |= labels[:-1] != labels[1:]
    picture = displayed(image).copy()
    picture[line] = RED
    return picture


def mean_colors(image: Any, labels: Any) -> Any:
    """Each pixel with the mean colour of its superpixel."""
    return superpixels(labels, displayed(image))["mean_color"].round().astype(np.uint8)[labels]


def smallest_labels(_: Any, labels: Any) -> Any:
    """Labels as 16 bits where they fit, else 32."""
    return labels.astype(np.uint16) if labels.max() < 65536 else labels


PICTURES = {"contours": contours, "mean": mean_colors, "labels": smallest_labels}


def parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="gwatershed", description=DESCRIPTION, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("images", nargs="+", metavar="IMAGE", help="image file, of a kind that Pillow reads")
    parser.add_argument("-o", "--output", required=True, metavar="FILE",
                        help="picture to write; a folder for several images; .npy is an array of NumPy")
    parser.add_argument("-d", "--depth", metavar="FILE",
                        help="depth of the image: 8 or 16 bits, or float; 0 is missing")
    size = parser.add_mutually_exclusive_group()
    size.add_argument("-k", "--number", type=int, metavar="N", help="number of superpixels, met exactly")
    size.add_argument("-s", "--region-size", type=int, metavar="N", help="side of a superpixel in pixels; default 20")
    parser.add_argument("-r", "--ruler", type=float, default=10, help="compactness; default %(default)s")
    parser.add_argument("-e", "--effort", type=int, default=1,
                        help="from 0, the fastest, to 3, the best; default %(default)s")
    parser.add_argument("-a", "--alpha", type=float, default=0.5,
                        help="weight of colour against depth; default %(default)s")
    parser.add_argument("-n", "--iterations", type=int, default=1, metavar="N",
                        help="more of them follow the image better; default %(default)s")
    parser.add_argument("--show", choices=sorted(PICTURES), default="contours",
                        help="what to write: the image with contours (the default), mean colours, or labels as numbers")
    parser.add_argument("--version", action="version", version="%(prog)s " + __version__)
    parser.add_argument("-q", "--quiet", action="store_true",
                        help="say nothing but errors, and what of a file is left out")
    parsed = parser.parse_args(arguments)
    if not parsed.output:
        parser.error("--output must be the name of a file or a folder")
    if len(parsed.images) > 1 and os.path.exists(parsed.output) and not os.path.isdir(parsed.output):
        parser.error("--output must be a folder for several images, not the file %s" % parsed.output)
    if parsed.depth and len(parsed.images) > 1:
        parser.error("--depth goes with one image")
    if len(parsed.images) > 1 and len({Path(image).stem for image in parsed.images}) < len(parsed.images):
        parser.error("two images would be written to the same file")
    return parsed


@contextlib.contextmanager
def opened(name: str) -> Iterator[Any]:
    """A file as Pillow has it. It is given the stream alone, see upright(), so it cannot say whose it is."""
    from PIL import Image, UnidentifiedImageError
    Image.MAX_IMAGE_PIXELS = None  # files of the user may be large
    with open(name, "rb") as stream:
        try:
            file = Image.open(stream)
        except UnidentifiedImageError:
            raise ValueError("%s is no image that Pillow reads" % name) from None
        with file:
            look_for_more(file, name)
            yield file


def read_image(name: str) -> Any:
    """Colours, or grey values of more than 8 bits as they are, which Pillow would cut off."""
    with opened(name) as file:
        image = upright(file)
        return fit_16_bits(np.asarray(image), "image") if image.mode[0] in "IF" else np.asarray(image.convert("RGB"))


def read_depth(name: str) -> Any:
    with opened(name) as file:
        return fit_16_bits(depth_array(upright(file)), "depth")


def has_16_bits(decoder: str, details: Any) -> bool:
    """Whether what Pillow decodes has more than 8 bits: by the name of the layout, which ends with the order of bytes,
    of the decoder, or by the highest value. JPEG 2000 does not say it."""
    if decoder in ("ppm", "ppm_plain"):
        return isinstance(details, tuple) and details[-1] > 255
    layout = details[0] if isinstance(details, tuple) else details
    return decoder == "SGI16" or re.search(";16[BLN]", str(layout)) is not None


def say(line: str, stream: Any) -> bool:
    """Prints a line. Where that fails, as in a pipe that was closed or on a full disk, what else is printed there is
    lost, so that the work goes on; says whether it was printed."""
    try:
        print(line, file=stream, flush=True)
        return True
    except OSError as error:
        nothing = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nothing, stream.fileno())  # Python writes what is left at its end
        os.close(nothing)
        if stream is sys.stdout:
            say("gwatershed: standard output: %s" % error, sys.stderr)
        return False


def look_for_more(file: Any, name: str) -> None:
    """Says that a file has more pages than the one that is read, and refuses what Pillow would cut bits off."""
    BITS_PER_SAMPLE = 258
    in_tags = file.format == "TIFF" and max(file.tag_v2.get(BITS_PER_SAMPLE, (8,))) > 8
    if file.mode[0] not in "IF" and (in_tags or any(has_16_bits(tile[0], tile[3]) for tile in file.tile or ())):
        raise ValueError("%s has 16 bits for each channel, of which Pillow reads 8: call segment() with what"
                         " cv2.imread() gives with IMREAD_UNCHANGED, or gwatershed-tiles" % name)
    pages = getattr(file, "n_frames", 1)
    if pages > 1:
        say("gwatershed: %s: the first of %d pages" % (name, pages), sys.stderr)


def upright(image: Any) -> Any:
    """Turned as the camera says, as cv2.imread() does it, unless what it says is damaged. TIFF is turned by load(), but
    wrongly by Pillow 11 to 13 where it maps the file into memory, as it does with files that it opened by name."""
    from PIL import ImageOps
    if image.format == "TIFF":
        image.load()
        return image
    try:
        return ImageOps.exif_transpose(image)
    except (SyntaxError, struct.error):
        return image


def fit_16_bits(values: Any, name: str) -> Any:
    """Pillow has 16 bits of some files as 32."""
    if values.dtype.kind in "iu" and values.dtype.itemsize > 2:
        if values.min() < 0 or values.max() > 65535:
            raise ValueError(name + " must fit 16 bits")
        return values.astype(np.uint16)
    return values


def encode(name: Path, picture: Any) -> Any:
    """The bytes of the file. Labels go to what keeps them: Pillow would cut them off without a word elsewhere."""
    from PIL import Image
    suffix = name.suffix.lower()
    kept_by = {2: (".npy", ".tif", ".tiff", ".png"), 4: (".npy", ".tif", ".tiff")}.get(picture.dtype.itemsize)
    if kept_by and suffix not in kept_by:
        raise ValueError("labels up to %d need a file of one of the kinds %s" % (picture.max(), " ".join(kept_by)))
    encoded: Any = io.BytesIO()
    if suffix == ".npy":
        np.save(encoded, picture)
    else:
        encoded.name = str(name)  # where Pillow finds the format
        Image.fromarray(picture).save(encoded)
    return encoded.getbuffer()


def write(name: Path, data: Any) -> None:
    """All of it, or an error and what was there before. Pillow, which writes some kinds of files itself, does not see
    that a disk is full."""
    target = Path(os.path.realpath(name))
    if target.exists() and not target.is_file():  # a device or a pipe
        target.write_bytes(data)
        return
    part = target.with_name(".gwatershed-%d" % os.getpid())
    try:
        part.write_bytes(data)
        if target.exists():
            shutil.copymode(target, part)
        os.replace(part, target)
    except OSError as error:
        error.filename = str(name)  # which the user knows
        raise
    finally:
        with contextlib.suppress(OSError):
            part.unlink()


def output_of(name: str, arguments: argparse.Namespace) -> Path:
    """A file, or for several images one in the folder. A name that ends with a slash is one, too."""
    output = Path(arguments.output)
    if len(arguments.images) == 1 and not output.is_dir() and not arguments.output.endswith(("/", os.sep)):
        return output
    output.mkdir(parents=True, exist_ok=True)
    return output / (Path(name).stem + (".tiff" if arguments.show == "labels" else ".png"))


def process(name: str, arguments: argparse.Namespace) -> Tuple[int, float]:
    """Segments one file; returns the number of superpixels and the milliseconds that it took."""
    output = output_of(name, arguments)
    inputs = [Path(file) for file in (name, arguments.depth) if file and os.path.exists(file)]
    if output.exists() and any(output.samefile(file) for file in inputs):
        raise ValueError("output must be another file than the image and its depth")
    image = read_image(name)
    depth = read_depth(arguments.depth) if arguments.depth else None
    size = {"num_superpixels": arguments.number} if arguments.number is not None else {
        "region_size": 20 if arguments.region_size is None else arguments.region_size}
    start = time.perf_counter()
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always", UserWarning)
        labels = segment(image, depth=depth, num_iterations=arguments.iterations, ruler=arguments.ruler,
                         effort=arguments.effort, alpha=arguments.alpha, **size)
    milliseconds = 1000 * (time.perf_counter() - start)
    for warning in said:
        say("gwatershed: %s: %s" % (name, warning.message), sys.stderr)
    write(output, encode(output, PICTURES[arguments.show](image, labels)))
    return int(labels.max()) + 1, milliseconds


def process_all(arguments: argparse.Namespace) -> int:
    code = 0
    for number, name in enumerate(arguments.images, 1):
        try:
            count, milliseconds = process(name, arguments)
        except (OSError, ValueError, TypeError, SyntaxError, MemoryError) as error:
            say("gwatershed: %s: %s" % (name, error), sys.stderr)
            code = 1
            continue
        line = "%d/%d %s: %d superpixels, %.0f ms" % (number, len(arguments.images), name, count, milliseconds)
        if not arguments.quiet and not say(line, sys.stdout):
            code = 1
    return code


def main(arguments: Optional[List[str]] = None) -> int:
    parsed = parse(arguments)
    try:
        import PIL  # noqa: F401
    except ImportError:
        print("gwatershed: the command needs Pillow: python3-pil, or pip install '.[command]' in the folder of gwatershed",
              file=sys.stderr)
        return 1
    try:
        return process_all(parsed)
    except KeyboardInterrupt:
        say("gwatershed: stopped", sys.stderr)
        return 130
