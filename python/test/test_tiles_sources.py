#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""gwatershed.tiles: what files have, and what is made of it.

It is skipped where dask or zarr are not installed; parts where rasterio is not.
"""
import errno
import json
import os
import subprocess
import sys
import unittest
import warnings
from unittest import mock

import numpy as np
import zarr
from test_command import call
from test_tiles import TilesCase, has

from gwatershed.tiles import command, segment_file
from gwatershed.tiles.sources import to_8_bits


class ValuesTest(TilesCase):

    def test_large_values_of_16_bits_are_valid(self):
        large = (self.image.astype(np.float32) * 200).astype(np.float16)  # the sum of three bands would be infinite
        large[:9, :9, 1] = np.inf
        large[50:60, 50:60, 2] = np.nan
        self.write_zarr("large.zarr", large)
        number, labels = self.run_tiles(image="large.zarr")
        self.assert_partition(number, labels, np.isfinite(large).all(axis=2))

    def test_levels_survive_a_large_offset(self):
        levels = np.arange(256).reshape(16, 16)
        for dtype, offset in ((np.float64, 1e9), (np.int32, 10**9), (np.uint32, 4 * 10**9), (np.int64, -10**12),
                              (np.uint64, 10**12), (">i4", -10**9), (np.uint16, 65000), (np.float32, 10**4)):
            values = (levels + offset).astype(dtype)
            np.testing.assert_array_equal(to_8_bits(values, (offset, offset + 255)), levels, str(dtype))

    def test_refuses_depth_of_int8_at_once(self):
        self.write_zarr("depth.zarr", np.ones(self.image.shape[:2], np.int8))
        with self.assertRaisesRegex(ValueError, "depth must not be of the type int8"):
            self.run_tiles(depth=self.path("depth.zarr"))
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["depth.zarr", "image.zarr"])

    def test_names_what_is_not_installed(self):
        for package, image, output, scheduler in (
                ("rasterio", "image.tif", "labels.zarr", "threads"),
                ("rasterio", "image.zarr", "labels.tif", "threads"),
                ("dask", "image.zarr", "labels.zarr", "threads"), ("zarr", "image.zarr", "labels.zarr", "threads"),
                ("distributed", "image.zarr", "labels.zarr", "tcp://127.0.0.1:1")):
            with mock.patch.dict(sys.modules, {package: None}):
                code, _, errors = call(command.main, self.path(image), self.path(output), "--scheduler", scheduler)
            self.assertEqual(code, 1)
            self.assertEqual(errors, "gwatershed-tiles: this needs %s: python3-%s, or pip install '.[tiles]' in the folder "
                             "of gwatershed\n" % (package, package))
            self.assertEqual(os.listdir(self.folder.name), ["image.zarr"])

    def test_folders_that_are_no_array(self):
        zarr.open(self.path("group.zarr"), mode="w")
        os.mkdir(self.path("folder"))
        for name in ("group.zarr", "folder"):
            code, _, errors = call(command.main, self.path(name), self.path("labels.zarr"))
            self.assertEqual(code, 1)
            self.assertRegex(errors, r"^gwatershed-tiles: .*%s must be an array.*\n$" % name)


class StoreTest(TilesCase):

    def test_full_disk_leaves_no_part_of_a_description(self):
        _, expected = self.run_tiles()
        full = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        with mock.patch.object(json, "dump", side_effect=full), self.assertRaisesRegex(OSError, "No space"):
            self.run_tiles()
        self.assertFalse(os.path.exists(self.path("labels.zarr.part/job.json")))
        np.testing.assert_array_equal(self.run_tiles()[1], expected)

    def test_starts_anew_after_a_description_that_ends_early(self):
        _, expected = self.run_tiles()
        for text in ("", '{"image": {"na'):
            os.mkdir(self.path("labels.zarr.part"))
            with open(self.path("labels.zarr.part/job.json"), "w") as file:
                file.write(text)
            np.testing.assert_array_equal(self.run_tiles()[1], expected)


@unittest.skipUnless(has("rasterio"), "needs rasterio")
class RasterTest(TilesCase):

    def write_tiff(self, name, bands, **profile):
        import rasterio
        with rasterio.open(self.path(name), "w", driver="GTiff", height=bands.shape[1], width=bands.shape[2],
                           count=bands.shape[0], dtype=bands.dtype, **profile) as file:
            file.write(bands)

    def test_no_data_is_no_label(self):
        import rasterio
        bands = self.image.transpose(2, 0, 1).clip(1)
        bands[:, :300, :300] = 0  # of labels, a block and more
        self.write_tiff("image.tif", bands, nodata=0)
        for start in (2**52 + 1, 2**52, 1 - 2**52, 0, 1000):
            self.run_tiles("labels.tif", "image.tif", start_label=start, tile_size=640)
            with rasterio.open(self.path("labels.tif")) as file:
                np.testing.assert_array_equal(file.dataset_mask() != 0, bands[0] > 0)
                np.testing.assert_array_equal(file.read(1) >= start, bands[0] > 0)
        for start in (2**52 + 2, -2**52, 2**62):
            with self.assertRaisesRegex(ValueError, "start_label must be from .* for a GeoTIFF"):
                self.run_tiles("labels.tif", "image.tif", start_label=start)

    def test_rational_polynomials_survive(self):
        import rasterio
        from rasterio.rpc import RPC
        one = [1.0] + [0.0] * 19
        numbers = dict(height_off=100, height_scale=500, lat_off=45, lat_scale=0.1, line_off=480, line_scale=480,
                       long_off=9, long_scale=0.1, samp_off=640, samp_scale=640, line_den_coeff=one,
                       samp_den_coeff=one, line_num_coeff=[0.0, 0.0, -1.0] + one[3:],
                       samp_num_coeff=[0.0, 1.0] + one[2:])
        self.write_tiff("image.tif", self.image.transpose(2, 0, 1), rpcs=RPC(**numbers, err_bias=None, err_rand=None))
        self.run_tiles("labels.tif", "image.tif", tile_size=640)
        with rasterio.open(self.path("labels.tif")) as file:
            kept = file.rpcs.to_dict()
        self.assertEqual({name: kept[name] for name in numbers}, numbers)

    def test_plain_pictures_need_no_warning(self):
        self.write_tiff("plain.tif", self.image.transpose(2, 0, 1))
        for scheduler in ("threads", "processes"):
            run = subprocess.run([sys.executable, "-m", "gwatershed.tiles", self.path("plain.tif"),
                                  self.path("labels.tif"), "--region-size", "10", "--tile-size", "320", "--quiet",
                                  "--scheduler", scheduler, "--workers", "2"], stderr=subprocess.PIPE, check=True,
                                 env={**os.environ, "PYTHONWARNINGS": ""})
            self.assertEqual(run.stderr, b"", scheduler)
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            segment_file(self.path("plain.tif"), self.path("labels.tif"), **self.SIZE)
        self.assertFalse([of for of in said if "geotransform" in str(of.message)])


if __name__ == "__main__":
    unittest.main()
