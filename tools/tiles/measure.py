#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Measures gwatershed.tiles on a mosaic of photographs that annotators have segmented, as those of BSDS500:

  measure.py mosaic FOLDER SIDE         makes FOLDER/image.zarr and FOLDER/edges.zarr
  measure.py run FOLDER WORKERS KIND    segments it by threads or processes; prints seconds and the largest memory
  measure.py speed FOLDER ROUNDS        one and two workers in turns; prints medians of seconds, and their ratios
  measure.py plain FOLDER SIDE          the plain call and the tiles on a corner that fits into memory; prints seconds
  measure.py seams FOLDER               explained variation and boundary recall near the edges of tiles and elsewhere

The environment names two folders: TRUTH has a label map NAME-0.png for PHOTOGRAPHS/NAME.jpg.
"""
import os
import random
import re
import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import zarr

REGION_SIZE = 20
TILE_SIZE = 2048
MARGIN = 4 * REGION_SIZE
HEIGHT, WIDTH = 320, 480  # of a photograph in the mosaic
STRIP = 512
TOLERANCE = 2             # of recall, in pixels


def edges_of(labels):
    edges = np.zeros(labels.shape, bool)
    edges[:, :-1] = labels[:, :-1] != labels[:, 1:]
    edges[:-1] |= labels[:-1] != labels[1:]
    return edges


def read_photograph(name):
    from PIL import Image
    truth = Path(os.environ["TRUTH"]) / (name.stem + "-0.png")
    image, edges = np.asarray(Image.open(name).convert("RGB")), edges_of(np.asarray(Image.open(truth)))
    if image.shape[0] > image.shape[1]:
        image, edges = image.transpose(1, 0, 2), edges.T
    return image[:HEIGHT, :WIDTH], edges[:HEIGHT, :WIDTH]


def make_mosaic(folder, side):
    photographs = [read_photograph(name) for name in sorted(Path(os.environ["PHOTOGRAPHS"]).glob("*.jpg"))]
    image = zarr.open(f"{folder}/image.zarr", mode="w", shape=(side, side, 3), chunks=(640, 1024, 3), dtype=np.uint8)
    edges = zarr.open(f"{folder}/edges.zarr", mode="w", shape=(side, side), chunks=(640, 1024), dtype=bool)
    random.seed(3)
    for top in range(0, side, 2 * HEIGHT):
        rows = [[random.choice(photographs) for _ in range(-(-side // WIDTH))] for _ in range(2)]
        for part, to in ((0, image), (1, edges)):
            strip = np.concatenate([np.concatenate([photograph[part] for photograph in row], 1) for row in rows])
            to[top:top + 2 * HEIGHT] = strip[:side - top, :side]


def run_tiles(folder, workers, kind):
    from gwatershed.tiles import segment_file
    start = time.perf_counter()
    number = segment_file(f"{folder}/image.zarr", f"{folder}/labels.zarr", REGION_SIZE, tile_size=TILE_SIZE,
                          scheduler=kind, workers=int(workers))
    seconds = time.perf_counter() - start
    own, children = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    memory = (own.ru_maxrss + int(workers) * children.ru_maxrss) / 1e6  # as if all had their peak at once
    busy = sum(one.ru_utime + one.ru_stime for one in (own, children))
    print(f"{workers} {kind}: {number} superpixels, {seconds:.1f} s, {busy:.1f} s of processors, {memory:.2f} GB")


def compare_speed(folder, rounds):
    ways = [(workers, kind) for kind in ("threads", "processes") for workers in ("1", "2")]
    seconds = {way: [] for way in ways}
    for _ in range(rounds):
        for way in ways:
            run = subprocess.run([sys.executable, __file__, "run", folder, *way], stdout=subprocess.PIPE, check=True)
            seconds[way].append(float(re.search(r"([0-9.]+) s,", run.stdout.decode()).group(1)))
            print(run.stdout.decode().strip(), flush=True)
    for kind in ("threads", "processes"):
        one, two = (np.median(seconds[workers, kind]) for workers in ("1", "2"))
        print(f"{kind}: {one:.1f} s and {two:.1f} s, {one / two:.2f} times as fast with two")


def compare_with_plain(folder, side):
    import gwatershed
    from gwatershed.tiles import segment_file
    corner = zarr.open(f"{folder}/image.zarr", mode="r")[:side, :side]
    zarr.open(f"{folder}/corner.zarr", mode="w", shape=corner.shape, chunks=(640, 1024, 3), dtype=np.uint8)[:] = corner
    gwatershed.setNumThreads(1)
    clock = time.process_time()
    gwatershed.segment(zarr.open(f"{folder}/corner.zarr", mode="r")[:], REGION_SIZE)
    plain = time.process_time() - clock
    clock = time.process_time()
    segment_file(f"{folder}/corner.zarr", f"{folder}/corner-labels.zarr", REGION_SIZE, tile_size=TILE_SIZE,
                 scheduler="single-threaded")
    tiles = time.process_time() - clock
    print(f"{side} x {side}: plain {plain:.1f} s of a processor, tiles {tiles:.1f} s, {tiles / plain:.2f} times")


def near_seams(top, height, width, side):
    """Whether a pixel is nearer to the edge of a tile than its margin is wide."""
    def near(x):
        return (np.minimum(x % TILE_SIZE, TILE_SIZE - 1 - x % TILE_SIZE) < MARGIN) & (x >= MARGIN) & (x < side - MARGIN)
    return near(np.arange(top, top + height))[:, None] | near(np.arange(width))[None, :]


def strips(folder):
    """Strips of the mosaic: first row, image, labels, and the edges that annotators drew."""
    image, labels, edges = (zarr.open(f"{folder}/{name}.zarr", mode="r") for name in ("image", "labels", "edges"))
    for top in range(0, image.shape[0], STRIP):
        yield top, image[top:top + STRIP], labels[top:top + STRIP], edges[top:top + STRIP]


def measure_seams(folder):
    from scipy.ndimage import maximum_filter
    labels = zarr.open(f"{folder}/labels.zarr", mode="r")
    number = max(int(part.max()) for _, _, part, _ in strips(folder))
    side = labels.shape[0]
    areas, sums = np.zeros(number + 1), np.zeros((3, number + 1))
    for _, image, part, _ in strips(folder):
        areas += np.bincount(part.ravel(), minlength=number + 1)
        for c in range(3):
            sums[c] += np.bincount(part.ravel(), image[:, :, c].ravel(), number + 1)
    means = (sums / np.maximum(areas, 1)).astype(np.float32)
    found, drawn, errors, total = (np.zeros(2) for _ in range(4))
    mean_color = (sums.sum(axis=1) / areas.sum()).astype(np.float32)
    for top, image, part, edges in strips(folder):
        near = near_seams(top, *part.shape, side)
        ours = maximum_filter(edges_of(part), 2 * TOLERANCE + 1)
        for zone, inside in enumerate((near, ~near)):
            drawn[zone] += edges[inside].sum()
            found[zone] += (edges & ours)[inside].sum()
            for c in range(3):
                values = image[:, :, c][inside].astype(np.float32)
                errors[zone] += ((values - means[c][part[inside]]) ** 2).sum(dtype=np.float64)
                total[zone] += ((values - mean_color[c]) ** 2).sum(dtype=np.float64)
    variation, recall = 1 - errors / total, found / drawn
    print(f"near seams: explained variation {variation[0]:.4f}, recall {recall[0]:.4f}")
    print(f"elsewhere:  explained variation {variation[1]:.4f}, recall {recall[1]:.4f}")


if __name__ == "__main__":
    what, folder, *rest = sys.argv[1:]
    if what == "mosaic":
        make_mosaic(folder, int(rest[0]))
    elif what == "run":
        run_tiles(folder, *rest)
    elif what == "speed":
        compare_speed(folder, int(rest[0]))
    elif what == "plain":
        compare_with_plain(folder, int(rest[0]))
    elif what == "seams":
        measure_seams(folder)
    else:
        sys.exit(__doc__)
