# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The work on one tile. Done twice, or by another worker, it gives the same.

While tiles are being done, a pixel has the number of the tile that labelled it and its label there, so tiles need not
know how many superpixels the others have. At the end a table of the first label of each tile makes them 1..N.
"""
import os
from dataclasses import dataclass
from typing import Any, Dict, Optional, Tuple

import numpy as np

import gwatershed
from gwatershed.segmentation import labels_of

from .sources import Source, to_8_bits
from .tiling import Tiling

LABEL_BITS = 32
LABEL_MASK = (1 << LABEL_BITS) - 1


@dataclass(frozen=True)
class Job:
    """All that a worker needs to know."""
    image: Source
    depth: Optional[Source]
    value_range: Optional[Tuple[float, float]]
    tiling: Tiling
    parameters: Dict[str, Any]  # of SuperpixelGWatershed, and num_iterations
    store: str                  # a folder that all workers see

    def open(self, name: str) -> Any:
        import zarr
        return zarr.open(os.path.join(self.store, name), mode="r+")


def do_tile(job: Job, tile: int, *waited_for: Any) -> int:
    """Labels the tile and what lies whole in its margin; returns the number of superpixels."""
    counts = job.open("counts")
    row, column = job.tiling.place(tile)
    if counts[row, column] >= 0:  # by an earlier run
        return int(counts[row, column])
    window = job.tiling.window(tile)
    labelled = job.open("labels")[window.slices]
    own = labelled >> LABEL_BITS == tile + 1  # by a worker that was stopped while it wrote
    labelled[own] = 0
    pixels, valid = job.image.read(window)
    free = valid & (labelled == 0)
    labels = _segment(job, window, pixels, free)
    kept = _kept(job.tiling, tile, labels)
    count = int(kept.sum())
    numbers = np.zeros(len(kept) + 1, np.int64)  # the last for -1, outside of the mask
    numbers[:-1][kept] = (tile + 1 << LABEL_BITS) + np.arange(count)
    labelled |= numbers[labels]
    if count or own.any():
        job.open("labels")[window.slices] = labelled
    counts[row, column] = count
    return count


def _segment(job: Job, window: Any, pixels: Any, free: Any) -> Any:
    if not free.any():
        return np.full(free.shape, -1, np.int32)
    depth = None if job.depth is None else job.depth.read_depth(window)
    gwatershed.setNumThreads(1)  # the workers share the processors
    parameters = dict(job.parameters)
    num_iterations = parameters.pop("num_iterations")
    return labels_of(to_8_bits(pixels, job.value_range), depth, free, None, num_iterations, False, parameters)


def _kept(tiling: Tiling, tile: int, labels: Any) -> Any:
    """Which superpixels this tile keeps: those that reach into it, and those that do not touch the edge of the window.
    The others are left to their own tile."""
    window = tiling.window(tile)
    kept = np.ones(labels.max() + 1, bool)
    edges = [(window.top > 0, labels[0]), (window.bottom < tiling.height, labels[-1]),
             (window.left > 0, labels[:, 0]), (window.right < tiling.width, labels[:, -1])]
    for is_cut, edge in edges:
        if is_cut:
            kept[edge[edge >= 0]] = False
    core = labels[tiling.core(tile).within(window)]
    kept[core[core >= 0]] = True
    return kept


def number_tile(job: Job, tile: int) -> None:
    """Writes the final labels of a tile."""
    window = job.tiling.core(tile)
    job.open("final")[window.slices] = final_labels(job, window)


def final_labels(job: Job, window: Any) -> Any:
    labelled = job.open("labels")[window.slices]
    owners = labelled >> LABEL_BITS
    labelled &= LABEL_MASK
    labelled += job.open("firsts")[:][owners]
    return labelled
