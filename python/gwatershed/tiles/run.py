# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""A run over all tiles: by Dask, resumable after it was stopped."""
import json
import os
import shutil
import sys
from contextlib import contextmanager, nullcontext, redirect_stdout, suppress
from typing import Any, Iterator, List, Optional, Sequence, Tuple

import numpy as np

import gwatershed
from gwatershed.segmentation import count_of, integer

from .arguments import (
    SCHEDULERS,
    bands_of,
    check_output,
    check_packages,
    check_parameters,
    check_scheduler,
    check_start_label,
    range_of,
    workers_of,
)
from .lock import alone
from .sources import Source, is_zarr, open_raster, write_window
from .tiling import Tiling, Window
from .work import Job, do_tile, final_labels, number_tile

USUAL_FOCAL_LENGTH = 0.8  # of the longer side of the image
# Scaled already, or a disparity: not metric, unless the user gives a focal length.
OTHER_DEPTH = ("bool", "uint8", "int16")


def segment_file(image: str, output: str, region_size: int = 20, *, depth: Optional[str] = None,
                 bands: Optional[Sequence[int]] = None, value_range: Optional[Tuple[float, float]] = None,
                 depth_range: Optional[Tuple[float, float]] = None, num_iterations: int = 1, start_label: int = 1,
                 tile_size: int = 2048, scheduler: Any = "threads", workers: Optional[int] = None,
                 progress: bool = False, **parameters: Any) -> int:
    """Segments an image file of any size into a file of labels, int64, and returns the number of superpixels N.

    image: GeoTIFF, or what else rasterio reads, or an array of Zarr, height x width or height x width x bands. Complex
        numbers and palettes are refused.
    output: .zarr, or .tif or .tiff, a GeoTIFF with the georeference of the image; no address as s3://. Labels are
        start_label .. start_label + N - 1, and start_label - 1 where the image has no data; a GeoTIFF takes a
        start_label up to 2**52.
    region_size: side of a superpixel in pixels.
    depth: file of the depth, of the same size. By default the focal length is that of segment() for the whole image.
        The optical axis is in the middle of each tile.
    bands: one or three of the image, from 1 on; the first three by default. Three are red, green and blue.
    value_range: values that become black and white; by default, and for (0, 0), 8 bits are taken as they are, and
        others from the 1st to the 99th percentile of the image.
    depth_range: depths that are told apart; by default, and for (0, 0), from the 1st to the 99th percentile. 8 bits
        have none.
    tile_size: side of a tile in pixels. It changes the labels, and the memory: about 100 bytes for each of its pixels
        and worker.
    scheduler: "threads", "processes", "single-threaded", the address of a scheduler of dask.distributed, or a Client.
        Workers of a cluster must see the files under the same names. It changes nothing in the labels. Processes
        import the script that calls this, which must do so below if __name__ == "__main__".
    workers: number of threads or processes.
    progress: whether to show Dask's progress bar, on standard error.
    parameters: others of SuperpixelGWatershed, as ruler=10, but num_superpixels and temporal.

    What is done is kept beside the output, in the folder output + ".part", until all is done: the same call goes on
    from there. It takes 8 bytes for each pixel, compressed. While one call writes an output, others with the same one
    are refused, by a lock on the file output + ".part.lock".
    """
    image, output = os.fspath(image), os.fspath(output)
    region_size, tile_size = integer(region_size, "region_size"), integer(tile_size, "tile_size")
    num_iterations, start_label = count_of(num_iterations, "num_iterations"), integer(start_label, "start_label")
    value_range, depth_range, workers = range_of(value_range), range_of(depth_range), workers_of(workers)
    ranges = {"value_range": value_range, "depth_range": depth_range}
    check_parameters({"region_size": region_size, **parameters,
                      **{name: of for name, of in ranges.items() if of is not None}})
    check_scheduler(scheduler)
    check_output(output)
    check_packages([image, output] if depth is None else [image, output, os.fspath(depth)], scheduler)
    source = Source.open(image, bands_of(bands))
    depths = None if depth is None else Source.open(os.fspath(depth), single=True)
    if depths is not None and (depths.height, depths.width) != (source.height, source.width):
        raise ValueError("depth must have the size of image, %d x %d" % (source.width, source.height))
    if depths is not None and depths.dtype == "int8":
        raise ValueError("depth must not be of the type int8")
    if os.path.abspath(output) in (source.name, depths and depths.name):
        raise ValueError("output must be another file than image and depth")
    check_start_label(start_label, source.height * source.width, output)
    if depths is not None and depth_range is None:
        depth_range = depths.range(of_depth=True)
    if depth_range is not None:
        parameters["depth_range"] = depth_range
    is_metric = depths is not None and depths.dtype not in OTHER_DEPTH
    if is_metric and not any(parameters.get("focal_length", ())):
        parameters["focal_length"] = (USUAL_FOCAL_LENGTH * max(source.height, source.width),) * 2
    parameters.update(region_size=region_size, num_iterations=num_iterations)
    tiling = Tiling.of(source.height, source.width, tile_size, region_size)
    if value_range is None:
        value_range = source.range()
    job = Job(source, depths, value_range, tiling, parameters, os.path.abspath(output) + ".part")
    with alone(output, job.store), _scheduler(scheduler, workers, progress) as compute:
        _begin(job)
        counts = _do_tiles(job, compute)
        _number(job, counts, start_label)
        _write(job, output, start_label, progress, compute)
        shutil.rmtree(job.store)
    return sum(counts)


def _plain(value: Any) -> Any:
    """What JSON does not know: numbers and arrays of NumPy, and parts of a job."""
    return value.tolist() if isinstance(value, (np.generic, np.ndarray)) else value.__dict__


def _begin(job: Job) -> None:
    """Makes the store, or takes up one of the same job."""
    import zarr
    kept = os.path.join(job.store, "job.json")
    description = json.loads(json.dumps(job.__dict__, default=_plain))
    earlier = _read_json(kept)
    if earlier is not None:
        if earlier != description:
            raise ValueError("%s is left from a run with another image or other parameters: remove it" % job.store)
        return
    shutil.rmtree(job.store, ignore_errors=True)
    tiling = job.tiling
    chunks = (tiling.chunk, tiling.chunk)
    zarr.open(os.path.join(job.store, "labels"), mode="w", shape=(tiling.height, tiling.width), chunks=chunks,
              dtype=np.int64, fill_value=0)
    zarr.open(os.path.join(job.store, "counts"), mode="w", shape=(tiling.rows, tiling.columns), chunks=(1, 1),
              dtype=np.int64, fill_value=-1)
    with open(kept + ".new", "w") as file:
        json.dump(description, file)
    os.replace(kept + ".new", kept)  # all of it or none, also on a full disk


def _read_json(name: str) -> Any:
    """None where there is no file, or one that was not written to its end."""
    with suppress(FileNotFoundError, json.JSONDecodeError), open(name) as file:
        return json.load(file)


def _do_tiles(job: Job, compute: Any) -> List[int]:
    """The number of superpixels of each tile."""
    from dask import delayed
    do = delayed(do_tile, pure=False)
    tasks: Any = {}
    for tile in job.tiling.in_order():
        tasks[tile] = do(job, tile, *(tasks[other] for other in job.tiling.earlier_neighbours(tile)))
    return list(compute([tasks[tile] for tile in range(len(job.tiling))]))


def _number(job: Job, counts: List[int], start_label: int) -> None:
    """Stores the first label of each tile, after that of pixels without a tile. It is one chunk, read for each tile."""
    import zarr
    firsts = np.cumsum([start_label - 1, 1] + counts[:-1])
    zarr.open(os.path.join(job.store, "firsts"), mode="w", shape=firsts.shape, chunks=firsts.shape,
              dtype=np.int64)[:] = firsts


@contextmanager
def _scheduler(scheduler: Any, workers: Optional[int], progress: bool) -> Iterator[Any]:
    """A function that computes a list of tasks."""
    if isinstance(scheduler, str) and scheduler in SCHEDULERS:
        threads = gwatershed.getNumThreads()  # the tasks change it
        try:
            options = {"chunksize": 1} if scheduler == "processes" else {}  # a process would take six tiles at once
            yield lambda tasks: _compute_here(tasks, progress, scheduler=scheduler, num_workers=workers, **options)
        finally:
            gwatershed.setNumThreads(threads)
        return
    from dask.distributed import Client
    with Client(scheduler) if isinstance(scheduler, str) else nullcontext(scheduler) as client:
        yield lambda tasks: _compute_there(tasks, progress, client)


def _compute_here(tasks: Any, progress: bool, **options: Any) -> Any:
    import dask
    from dask.diagnostics import ProgressBar
    with ProgressBar(out=sys.stderr) if progress else nullcontext():
        return dask.compute(*tasks, **options)


def _compute_there(tasks: Any, progress: bool, client: Any) -> Any:
    futures = client.compute(tasks)
    if progress:
        from dask.distributed import progress as show
        with redirect_stdout(sys.stderr):
            show(futures)
    return client.gather(futures)


def _write(job: Job, output: str, start_label: int, progress: bool, compute: Any) -> None:
    if is_zarr(output):
        _write_zarr(job, output, start_label, compute)
    else:
        _write_raster(job, output, start_label, progress)


def _write_zarr(job: Job, output: str, start_label: int, compute: Any) -> None:
    import zarr
    from dask import delayed
    tiling = job.tiling
    final = os.path.join(job.store, "final")
    zarr.open(final, mode="w", shape=(tiling.height, tiling.width), chunks=(tiling.chunk, tiling.chunk),
              dtype=np.int64, fill_value=start_label - 1)
    do = delayed(number_tile, pure=False)
    compute([do(job, tile) for tile in range(len(tiling))])
    shutil.rmtree(output, ignore_errors=True)
    os.replace(final, output)


def _write_raster(job: Job, output: str, start_label: int, progress: bool) -> None:
    """One file has one writer, which goes by rows of the store's chunks."""
    from dask import delayed
    tiling = job.tiling
    part = os.path.join(job.store, "final.tif")
    with open_raster(part, "w", driver="GTiff", height=tiling.height, width=tiling.width, count=1, dtype="int64",
                     nodata=start_label - 1, tiled=True, blockxsize=256, blockysize=256, compress="deflate",
                     bigtiff="if_safer", **job.image.georeference()) as file:
        side = -(-tiling.chunk // 256) * 256
        windows = [Window(top, left, min(top + side, tiling.height), min(left + 4 * side, tiling.width))
                   for top in range(0, tiling.height, side) for left in range(0, tiling.width, 4 * side)]
        write = delayed(lambda window: write_window(file, window, final_labels(job, window)), pure=False)
        _compute_here([write(window) for window in windows], progress, scheduler="single-threaded")
    os.replace(part, output)
