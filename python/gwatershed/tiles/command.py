# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The command gwatershed-tiles: superpixels of an image file of any size."""
import argparse
import sys
from typing import Any, Dict, List, Optional

import gwatershed
from gwatershed.command import say

from .run import segment_file

DESCRIPTION = "Segments an image that may be larger than memory into superpixels."
EXAMPLES = """examples:
  gwatershed-tiles orthophoto.tif labels.tif --region-size 20
  gwatershed-tiles slide.zarr labels.zarr --region-size 30 --scheduler tcp://head:8786

After it was stopped, the same command goes on where it was. The exit code is 0, 1 for an error, 2 if an
argument is unknown or no number, or 130 if it was stopped by Ctrl-C."""


def parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="gwatershed-tiles", description=DESCRIPTION, epilog=EXAMPLES,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("image", help="GeoTIFF, what else GDAL reads, or an array of Zarr")
    parser.add_argument("output", help="labels to write: .zarr, or .tif or .tiff, a GeoTIFF")
    parser.add_argument("--region-size", type=int, default=20, metavar="N",
                        help="side of a superpixel in pixels; default %(default)s")
    parser.add_argument("--ruler", type=float, default=10, help="compactness; default %(default)s")
    parser.add_argument("--effort", type=int, default=1, metavar="N",
                        help="from 0, the fastest, to 3, the best; default %(default)s")
    parser.add_argument("--alpha", type=float, default=0.5, help="weight of colour against depth; default %(default)s")
    parser.add_argument("--iterations", type=int, default=1, metavar="N",
                        help="more of them follow the image better; default %(default)s")
    parser.add_argument("--bands", type=int, nargs="+", metavar="N",
                        help="one or three of the image, from 1 on; default: the first three, or the first")
    parser.add_argument("--value-range", type=float, nargs=2, metavar=("LOW", "HIGH"),
                        help="values that become black and white; default: 8 bits as they are, others from the 1st to"
                             " the 99th percentile")
    parser.add_argument("--depth", metavar="FILE", help="depth of the image, of the same size; 0 is missing")
    parser.add_argument("--depth-range", type=float, nargs=2, metavar=("NEAR", "FAR"),
                        help="depths that are told apart; default: from the 1st to the 99th percentile")
    parser.add_argument("--focal-length", type=float, metavar="F",
                        help="of the depth camera, in pixels; default: 0.8 of the longer side of the image")
    parser.add_argument("--tile-size", type=int, default=2048, metavar="N",
                        help="side of a tile in pixels; it changes the labels, and the memory; default %(default)s")
    parser.add_argument("--scheduler", default="threads", metavar="ADDRESS",
                        help="of dask.distributed; or threads, processes, single-threaded; default %(default)s")
    parser.add_argument("--workers", type=int, metavar="N", help="threads or processes; default: one a processor")
    parser.add_argument("-q", "--quiet", action="store_true", help="say nothing but errors; no progress bar")
    parser.add_argument("--version", action="version", version="%(prog)s " + gwatershed.__version__)
    return parser.parse_args(arguments)


def main(arguments: Optional[List[str]] = None) -> int:
    parsed = parse(arguments)
    camera: Dict[str, Any] = {} if parsed.focal_length is None else {"focal_length": (parsed.focal_length,) * 2}
    try:
        number = segment_file(
            parsed.image, parsed.output, parsed.region_size, depth=parsed.depth, bands=parsed.bands,
            value_range=parsed.value_range, depth_range=parsed.depth_range, num_iterations=parsed.iterations,
            tile_size=parsed.tile_size, scheduler=parsed.scheduler, workers=parsed.workers,
            progress=not parsed.quiet, ruler=parsed.ruler, effort=parsed.effort, alpha=parsed.alpha, **camera)
    except KeyboardInterrupt:
        say("gwatershed-tiles: stopped; the same command goes on from here", sys.stderr)
        return 130
    except (OSError, ValueError, TypeError, RuntimeError, MemoryError, ImportError) as error:
        say("gwatershed-tiles: %s" % error, sys.stderr)
        return 1
    return 0 if parsed.quiet or say("%d superpixels" % number, sys.stdout) else 1
