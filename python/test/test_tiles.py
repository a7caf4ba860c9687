#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gwatershed.tiles: every pixel once, connected superpixels, the same for all workers, and after all that can happen.

It is skipped where dask or zarr are not installed; parts where rasterio, distributed or scikit-image are not.
"""
import contextlib
import importlib.util
import io
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
from unittest import mock

import numpy as np

import gwatershed


SLOW = 20  # iterations, where a run is to be stopped half way


def has(*names):
    return all(importlib.util.find_spec(name) for name in names)


if not has("dask", "zarr"):
    raise unittest.SkipTest("needs dask and zarr")

import zarr  # noqa: E402

from gwatershed.tiles import command, run, segment_file, work  # noqa: E402
from gwatershed.tiles.tiling import Tiling  # noqa: E402

warnings.filterwarnings("ignore", category=ResourceWarning)


def make_picture(height, width, seed=1):
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    picture = np.stack([127 + 100 * np.sin(x / 37 + y / 91) * np.cos(y / 53),
                        127 + 90 * np.sin(x / 71) * np.cos(y / 29 + x / 101), 127 + 80 * np.sin((x + y) / 47)], -1)
    picture += (np.hypot(x % 150 - 75, y % 130 - 65) < 45)[..., None] * 40
    picture += np.random.RandomState(seed).normal(0, 4, picture.shape)
    return picture.clip(0, 255).astype(np.uint8)


def explained_variation(labels, image):
    table = gwatershed.superpixels(labels, image, start_label=1)
    mean = image.reshape(-1, image.shape[2]).mean(axis=0)
    return (table["area"][:, None] * (table["mean_color"] - mean) ** 2).sum() / ((image - mean) ** 2).sum()


class TilesCase(unittest.TestCase):

    SIZE = dict(region_size=10, tile_size=160)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.image = make_picture(500, 610)
        self.write_zarr("image.zarr", self.image)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write_zarr(self, name, values):
        zarr.open(self.path(name), mode="w", shape=values.shape, chunks=(100, 100) + values.shape[2:],
                  dtype=values.dtype)[:] = values

    def run_tiles(self, output="labels.zarr", image="image.zarr", **arguments):
        arguments = {**self.SIZE, "scheduler": "single-threaded", **arguments}
        number = segment_file(self.path(image), self.path(output), **arguments)
        self.assertFalse(os.path.exists(self.path(output) + ".part"))
        if output.endswith(".zarr"):
            return number, zarr.open(self.path(output), mode="r")[:]
        import rasterio
        with rasterio.open(self.path(output)) as file:
            return number, file.read(1)

    def assert_partition(self, number, labels, valid=None):
        self.assertEqual(labels.dtype, np.int64)
        valid = np.ones(labels.shape, bool) if valid is None else valid
        np.testing.assert_array_equal(labels > 0, valid)
        self.assertEqual(np.unique(labels[valid]).tolist(), list(range(1, number + 1)))
        if has("skimage"):
            from skimage.measure import label
            self.assertEqual(label(labels, connectivity=1).max(), number)


class TilingTest(unittest.TestCase):

    def test_windows_of_a_phase_share_no_chunk(self):
        for shape in ((500, 610), (160, 160), (1, 1), (161, 479), (321, 159)):
            tiling = Tiling.of(*shape, 160, 10)
            seen = np.zeros(shape, int)
            chunks = {}
            for tile in tiling.in_order():
                seen[tiling.core(tile).slices] += 1
                window = tiling.window(tile)
                for y in range(window.top // tiling.chunk, (window.bottom - 1) // tiling.chunk + 1):
                    for x in range(window.left // tiling.chunk, (window.right - 1) // tiling.chunk + 1):
                        chunks.setdefault((tiling.phase(tile), y, x), []).append(tile)
            self.assertTrue((seen == 1).all())
            self.assertTrue(all(len(tiles) == 1 for tiles in chunks.values()))

    def test_refuses_small_tiles(self):
        self.assertRaises(ValueError, Tiling.of, 100, 100, 150, 10)
        self.assertRaises(ValueError, Tiling.of, 100, 100, 162, 10)


class ResultTest(TilesCase):

    def test_is_the_same_for_all_schedulers(self):
        number, labels = self.run_tiles()
        self.assert_partition(number, labels)
        for arguments in (dict(scheduler="threads", workers=1), dict(scheduler="threads", workers=3),
                          dict(scheduler="processes", workers=2)):
            other, same = self.run_tiles(**arguments)
            self.assertEqual(other, number)
            np.testing.assert_array_equal(same, labels)

    def test_processes_of_the_script_of_debian(self):
        script = pathlib.Path(__file__).resolve().parents[1] / "debian" / "gwatershed-tiles"
        subprocess.run([sys.executable, str(script), self.path("image.zarr"), self.path("script.zarr"), "--quiet",
                        "--region-size", "10", "--tile-size", "160", "--scheduler", "processes", "--workers", "1"],
                       stderr=subprocess.DEVNULL, check=True)
        np.testing.assert_array_equal(zarr.open(self.path("script.zarr"), mode="r")[:], self.run_tiles()[1])

    def test_is_as_good_as_the_plain_call(self):
        number, labels = self.run_tiles()
        plain = gwatershed.segment(self.image, 10, start_label=1)
        self.assertLess(abs(number / plain.max() - 1), 0.03)
        self.assertGreater(explained_variation(labels, self.image), explained_variation(plain, self.image) - 0.005)

    def test_one_tile_is_the_plain_call(self):
        for start in (0, 1):
            _, labels = self.run_tiles(tile_size=640, start_label=start, num_iterations=2, ruler=5)
            plain = gwatershed.segment(self.image, 10, start_label=start, num_iterations=2, ruler=5)
            np.testing.assert_array_equal(labels, plain)

    def test_depth_that_is_missing_or_infinite(self):
        depth = np.where(np.arange(610) // 20 % 2, 800, 830) * np.ones((500, 1), int)
        for dtype, missing in ((np.uint16, 65535), (np.uint16, 0), (np.int16, -16), (np.float32, -1)):
            holes = depth.astype(dtype)
            holes[:, ::25] = missing
            _, labels = self.run_with_depth(holes)
            edges = (depth[:, 1:] != depth[:, :-1]) & (holes[:, 1:] != missing) & (holes[:, :-1] != missing)
            found = (labels[:, 1:] != labels[:, :-1])[edges].mean()
            self.assertGreater(found, 0.9, (dtype, missing))
        far = np.where(np.arange(610) < 333, 2, np.inf).astype(np.float32) * np.ones((500, 1), np.float32)
        far[:, :100] += 0.02
        _, labels = self.run_with_depth(far)
        self.assertGreater((labels[:, 332] != labels[:, 333]).mean(), 0.95)

    def run_with_depth(self, depth):
        self.write_zarr("depth.zarr", depth)
        self.write_zarr("flat.zarr", np.full(depth.shape, 90, np.uint8))
        return self.run_tiles(image="flat.zarr", depth=self.path("depth.zarr"))

    def test_wrong_arguments_leave_nothing(self):
        self.write_zarr("complex.zarr", self.image[:, :, 0] * 1j)
        for wrong in ({"effort": 9}, {"ruler": -1}, {"rulr": 5}, {"region_size": 0}, {"num_iterations": 0},
                      {"value_range": (5, 5)}, {"depth_range": (5, 1)}, {"workers": 0}, {"start_label": 1.5},
                      {"image": "complex.zarr", "value_range": (0, 1)}, {"tile_size": 160.0}, {"num_iterations": 1.0},
                      {"num_iterations": 2**40}, {"workers": 1.5}, {"scheduler": None}, {"scheduler": "bogus"},
                      {"start_label": 2**63 - 9}, {"start_label": -2**63}, {"bands": [1.5]}, {"bands": 2},
                      {"num_superpixels": 50}, {"temporal": True}, {"output": "s3://place/labels.zarr"}):
            name = list(wrong)[0]
            text = {"image": "complex", "value_range": "high_value", "depth_range": "far_depth"}.get(name, name)
            with self.assertRaisesRegex((ValueError, TypeError), text, msg=wrong):
                segment_file(**{"image": self.path("image.zarr"), "output": self.path("labels.zarr"), **self.SIZE,
                                **{key: self.path(of) if key == "image" else of for key, of in wrong.items()}})
            self.assertEqual(sorted(os.listdir(self.folder.name)), ["complex.zarr", "image.zarr"], wrong)

    def test_labels_up_to_the_largest(self):
        _, expected = self.run_tiles()
        _, labels = self.run_tiles(start_label=2**63 - 500 * 610)
        np.testing.assert_array_equal(labels - (2**63 - 500 * 610 - 1), expected)

    def test_refuses_names_and_shapes_that_say_something_else(self):
        for output in ("labels.png", "labels.npy", "labels"):
            with self.assertRaisesRegex(ValueError, "output must be .zarr, .tif or .tiff"):
                self.run_tiles(output)
        self.write_zarr("bands_first.zarr", np.ascontiguousarray(self.image.transpose(2, 0, 1)))
        with self.assertRaisesRegex(ValueError, "height x width x bands"):
            self.run_tiles(image="bands_first.zarr")

    def test_focal_length_is_that_of_the_whole_image(self):
        y, x = np.mgrid[0:500, 0:610]
        depth = (1000 + 2 * np.abs(x % 240 - 120) + y // 3).astype(np.uint16)
        self.write_zarr("depth.zarr", depth)
        self.write_zarr("flat.zarr", np.full(depth.shape, 90, np.uint8))
        self.write_zarr("disparity.zarr", depth.astype("<i2"))
        self.write_zarr("swapped.zarr", depth.astype(">i2"))
        labels = {}
        for name, arguments in (("usual", {}), ("set", {"focal_length": (488, 488)}),
                                ("other", {"focal_length": (99, 99)}),
                                ("disparity", {"depth": self.path("disparity.zarr")}),
                                ("swapped", {"depth": self.path("swapped.zarr")})):
            labels[name] = self.run_tiles(image="flat.zarr", **{"depth": self.path("depth.zarr"), **arguments})[1]
        np.testing.assert_array_equal(labels["usual"], labels["set"])
        self.assertFalse((labels["usual"] == labels["other"]).all())
        self.assertFalse((labels["usual"] == labels["disparity"]).all())
        np.testing.assert_array_equal(labels["disparity"], labels["swapped"])

    def test_numbers_of_numpy_and_paths(self):
        number, expected = self.run_tiles(ruler=5, bands=(1, 2, 3), value_range=(0, 255))
        shutil.rmtree(self.path("labels.zarr"))
        self.assertEqual(number, segment_file(
            pathlib.Path(self.path("image.zarr")), pathlib.Path(self.path("labels.zarr")), np.int64(10),
            tile_size=np.int64(160), ruler=np.float32(5), bands=np.array([1, 2, 3]), value_range=np.array([0, 255])))
        np.testing.assert_array_equal(zarr.open(self.path("labels.zarr"), mode="r")[:], expected)

    def test_depth_with_a_range_of_the_whole_image(self):
        depth = np.where(np.arange(610) < 333, 1000, 3000).astype(np.uint16) * np.ones((500, 1), np.uint16)
        self.write_zarr("depth.zarr", depth)
        self.write_zarr("flat.zarr", np.full((500, 610), 90, np.uint8))
        number, labels = self.run_tiles(image="flat.zarr", depth=self.path("depth.zarr"), depth_range=(0, 0))
        np.testing.assert_array_equal(labels, self.run_tiles(image="flat.zarr", depth=self.path("depth.zarr"))[1])
        self.assert_partition(number, labels)
        across = set(labels[:, :333].ravel()) & set(labels[:, 333:].ravel())
        self.assertLess(len(across), 0.002 * number)
        self.write_zarr("small.zarr", depth[1:])
        with self.assertRaisesRegex(ValueError, "size of image"):
            self.run_tiles(depth=self.path("small.zarr"))

    def test_values_of_any_range(self):
        _, expected = self.run_tiles(value_range=(0, 255))
        self.write_zarr("large.zarr", self.image.astype(np.float32) * 7 + 100)
        _, labels = self.run_tiles(image="large.zarr", value_range=(100, 100 + 7 * 255))
        np.testing.assert_array_equal(labels, expected)
        number, labels = self.run_tiles(image="large.zarr", value_range=(0, 0))
        np.testing.assert_array_equal(labels, self.run_tiles(image="large.zarr")[1])
        self.assert_partition(number, labels)
        self.assertGreater(explained_variation(labels, self.image), explained_variation(expected, self.image) - 0.01)


    def test_leaves_alone_what_is_not_its_own(self):
        kept = self.path("folder")
        os.mkdir(kept)
        plain = self.path("file.zarr")
        with open(plain, "w"):
            pass
        for output in (kept, self.path("image.zarr"), plain):
            with self.assertRaisesRegex(ValueError, "output must"):
                self.run_tiles(output)
            self.assertTrue(os.path.isfile(output) if output == plain else os.path.isdir(output))
            self.assertFalse(os.path.exists(output + ".part"))
        gwatershed.setNumThreads(2)
        for scheduler in ("threads", "single-threaded"):
            self.run_tiles(scheduler=scheduler, tile_size=640)
            self.assertEqual(gwatershed.getNumThreads(), 2)


class StoppedTest(TilesCase):

    def stop_after(self, tiles, also_forget):
        """Runs until so many tiles are done; the last of them may not be noted as done."""
        done = []

        def do_and_stop(job, tile, *waited_for):
            count = work.do_tile(job, tile, *waited_for)
            done.append(tile)
            if len(done) == tiles:
                if also_forget:
                    job.open("counts")[job.tiling.place(tile)] = -1
                raise InterruptedError
            return count
        with mock.patch.object(run, "do_tile", do_and_stop), self.assertRaises(InterruptedError):
            self.run_tiles()
        return done

    def test_goes_on_where_it_was(self):
        _, expected = self.run_tiles()
        for forget in (False, True):
            self.stop_after(7, forget)
            with mock.patch.object(work, "_segment", wraps=work._segment) as calls:
                _, labels = self.run_tiles()
            self.assertEqual(calls.call_count, 16 - 7 + forget)
            np.testing.assert_array_equal(labels, expected)

    def test_one_run_at_a_time(self):
        _, expected = self.run_tiles()

        def do_beside_another(job, tile, *waited_for):
            with self.assertRaisesRegex(ValueError, "output must not be what another run writes"):
                self.run_tiles()
            return work.do_tile(job, tile, *waited_for)
        with mock.patch.object(run, "do_tile", do_beside_another):
            np.testing.assert_array_equal(self.run_tiles()[1], expected)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["image.zarr", "labels.zarr"])

    def test_refuses_to_go_on_with_other_parameters(self):
        self.stop_after(3, False)
        with self.assertRaisesRegex(ValueError, "other parameters"):
            self.run_tiles(ruler=3)

    def test_refuses_to_go_on_with_another_image(self):
        self.stop_after(3, False)
        time.sleep(0.01)
        shutil.rmtree(self.path("image.zarr"))
        self.write_zarr("image.zarr", self.image[::-1])
        with self.assertRaisesRegex(ValueError, "another image"):
            self.run_tiles()

    def test_refuses_to_go_on_with_an_image_that_was_changed_below(self):
        self.stop_after(3, False)
        folder = os.stat(self.path("image.zarr"))
        time.sleep(0.01)
        zarr.open(self.path("image.zarr"), mode="r+")[:50, :60] = 7
        os.utime(self.path("image.zarr"), ns=(folder.st_atime_ns, folder.st_mtime_ns))  # as of folders deeper
        with self.assertRaisesRegex(ValueError, "another image"):
            self.run_tiles()

    def test_a_killed_command_goes_on(self):
        _, expected = self.run_tiles(num_iterations=SLOW)
        for number, code in ((signal.SIGKILL, -signal.SIGKILL), (signal.SIGINT, 130)):
            call = [sys.executable, "-m", "gwatershed.tiles", "image.zarr", "killed.zarr", "--workers", "1",
                    "--region-size", "10", "--tile-size", "160", "--iterations", str(SLOW)]
            process = subprocess.Popen(
                call, cwd=self.folder.name, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))  # jobs in the background ignore it
            self.assertTrue(when_half_way(self.path("killed.zarr.part"), lambda: process.send_signal(number)))
            _, errors = process.communicate()
            self.assertEqual(process.returncode, code)
            self.assertEqual(b"the same command goes on" in errors, code == 130)
            with mock.patch.object(work, "_segment", wraps=work._segment) as calls:
                _, labels = self.run_tiles("killed.zarr", num_iterations=SLOW, ruler=10, effort=1, alpha=0.5)
            self.assertLess(calls.call_count, 16)
            np.testing.assert_array_equal(labels, expected)


def when_half_way(store, act):
    """Acts once when some tiles are done and others are not; says whether that was seen."""
    for _ in range(20000):
        with contextlib.suppress(Exception):
            done = zarr.open(os.path.join(store, "counts"), mode="r")[:] >= 0
            if done.any():
                if not done.all():
                    act()
                return not done.all()
        time.sleep(0.001)
    return False


@unittest.skipUnless(has("distributed"), "needs distributed")
class ClusterTest(TilesCase):
    """A scheduler and two workers, each a process of its own that starts in another folder."""

    def start(self, program, *arguments):
        process = subprocess.Popen([sys.executable, "-m", "distributed.cli." + program, *arguments, "--no-dashboard"],
                                   cwd=self.path("elsewhere"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def setUp(self):
        super().setUp()
        from dask.distributed import Client
        os.mkdir(self.path("elsewhere"))
        file = self.path("scheduler.json")
        self.start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", file)
        self.workers = [self.start("dask_worker", "--scheduler-file", file, "--nthreads", "1", "--no-nanny")
                        for _ in range(2)]
        with Client(scheduler_file=file, timeout=60) as client:
            client.wait_for_workers(2, timeout=60)
            self.address = client.scheduler.address

    def run_command(self, *more):
        output, errors = io.StringIO(), io.StringIO()
        here = os.getcwd()
        os.chdir(self.folder.name)
        try:
            with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
                code = command.main(["image.zarr", "labels.zarr", "--region-size", "10", "--tile-size", "160",
                                     "--scheduler", self.address, *more])
        finally:
            os.chdir(here)
        self.assertEqual(code, 0)
        self.assertRegex(output.getvalue(), r"^\d+ superpixels\n$" if "--quiet" not in more else "^$")
        return errors.getvalue(), zarr.open(self.path("labels.zarr"), mode="r")[:]

    def test_gives_the_same_also_after_a_worker_was_killed(self):
        _, expected = self.run_tiles()
        errors, labels = self.run_command()
        np.testing.assert_array_equal(labels, expected)
        self.assertIn("100% Completed", errors)
        shutil.rmtree(self.path("labels.zarr"))
        killed = []
        thread = threading.Thread(target=lambda: killed.append(
            when_half_way(self.path("labels.zarr.part"), self.workers[0].kill)))
        thread.start()
        _, labels = self.run_command("--quiet", "--iterations", str(SLOW))
        thread.join()
        self.assertEqual(killed, [True])
        self.assertIsNone(self.workers[1].poll())
        np.testing.assert_array_equal(labels, self.run_tiles(num_iterations=SLOW)[1])


@unittest.skipUnless(has("rasterio"), "needs rasterio")
class GeoTiffTest(TilesCase):

    def write_tiff(self, name, bands, **profile):
        import rasterio
        from rasterio.transform import from_origin
        with rasterio.open(self.path(name), "w", driver="GTiff", height=bands.shape[1], width=bands.shape[2],
                           count=bands.shape[0], dtype=bands.dtype, crs="EPSG:32632",
                           transform=from_origin(500000, 5400000, 0.5, 0.5), **profile) as file:
            file.write(bands)

    def test_georeference_nodata_and_bands(self):
        import rasterio
        _, expected = self.run_tiles()
        bands = self.image.transpose(2, 0, 1)
        self.write_tiff("image.tif", bands)
        _, labels = self.run_tiles("labels.tif", "image.tif")
        np.testing.assert_array_equal(labels, expected)
        with rasterio.open(self.path("labels.tif")) as file:
            self.assertEqual((file.crs.to_epsg(), file.transform.c, file.nodata), (32632, 500000, 0))
            self.assertEqual(file.dtypes, ("int64",))

        five = np.concatenate([bands[:1] * 0, bands[1:2], bands[:1], bands[2:], bands[:1] * 0])
        self.write_tiff("five.tif", five)
        _, labels = self.run_tiles("labels.tif", "five.tif", bands=(3, 2, 4))
        np.testing.assert_array_equal(labels, expected)
        with self.assertRaisesRegex(ValueError, "bands must be one or three"):
            self.run_tiles("labels.tif", "five.tif", bands=(3, 9, 4))

        valid = np.hypot(*np.mgrid[-200:300, -400:210]) < 310
        self.write_tiff("disc.tif", np.where(valid, np.maximum(bands, 1), 0).astype(np.uint8), nodata=0)
        number, labels = self.run_tiles("labels.tif", "disc.tif")
        self.assert_partition(number, labels, valid)

    def test_control_points_survive(self):
        import rasterio
        from rasterio.control import GroundControlPoint
        points = [GroundControlPoint(row=r, col=c, x=7 + c / 1e4, y=50 - r / 1e4)
                  for r, c in ((0, 0), (0, 600), (490, 0))]
        with rasterio.open(self.path("points.tif"), "w", driver="GTiff", height=500, width=610, count=3, dtype="uint8",
                           gcps=points, crs="EPSG:4326") as file:
            file.write(self.image.transpose(2, 0, 1))
        self.run_tiles("labels.tif", "points.tif", tile_size=640)
        with rasterio.open(self.path("labels.tif")) as file:
            kept, crs = file.gcps
        self.assertEqual([(p.row, p.col, p.x, p.y) for p in kept], [(p.row, p.col, p.x, p.y) for p in points])
        self.assertEqual(crs.to_epsg(), 4326)

    def test_refuses_colours_by_number(self):
        import rasterio
        with rasterio.open(self.path("palette.tif"), "w", driver="GTiff", height=500, width=610, count=1, dtype="uint8",
                           photometric="palette") as file:
            file.write_colormap(1, {0: (255, 0, 0), 1: (0, 0, 255)})
            file.write(self.image[:, :, :1].transpose(2, 0, 1))
        for arguments in ({"image": "palette.tif"}, {"depth": self.path("palette.tif")}):
            with self.assertRaisesRegex(ValueError, "image and depth must not have .* as .*palette.tif has"):
                self.run_tiles("labels.tif", **arguments)

    def test_command(self):
        self.write_tiff("image.tif", self.image.transpose(2, 0, 1))
        output, errors = io.StringIO(), io.StringIO()
        call = [self.path("image.tif"), self.path("labels.tif"), "--region-size", "10", "--tile-size", "160"]
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            self.assertEqual(command.main(call + ["--workers", "2"]), 0)
            self.assertEqual(command.main(call + ["--tile-size", "10"]), 1)
            self.assertEqual(command.main([self.path("none.tif"), self.path("labels.tif")]), 1)
            self.assertEqual(command.main([self.path("none.zarr"), self.path("labels.tif")]), 1)
        self.assertRegex(output.getvalue(), r"^\d+ superpixels\n$")
        for text in ("Completed", "tile_size must be", "none.tif", "none.zarr"):
            self.assertIn(text, errors.getvalue())
        for image, labels in (("image.zarr", "plain.tif"), ("plain.tif", "again.tif")):  # without a georeference
            run = subprocess.run([sys.executable, "-m", "gwatershed.tiles", self.path(image), self.path(labels),
                                  "--quiet"], stderr=subprocess.PIPE, check=True)
            self.assertEqual(run.stderr, b"")


if __name__ == "__main__":
    unittest.main()
