#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The functions segment() and superpixels(). What needs scikit-image is skipped where that is not installed."""
import pathlib
import unittest
import warnings

import numpy as np
from test_package import class_labels, make_image, needs

import gwatershed


class FunctionsTest(unittest.TestCase):

    def test_segment_is_the_class(self):
        image = make_image()
        bgr = np.ascontiguousarray(image[:, :, ::-1])
        labels = gwatershed.segment(image, region_size=12)
        self.assertEqual(labels.dtype, np.int32)
        np.testing.assert_array_equal(labels, class_labels(bgr, region_size=12))
        np.testing.assert_array_equal(labels, gwatershed.segment(bgr, 12, bgr=True))
        np.testing.assert_array_equal(labels, gwatershed.segment(image / 255, 12))
        np.testing.assert_array_equal(labels + 1, gwatershed.segment(image, 12, start_label=1))
        self.assertEqual(gwatershed.segment(image, num_superpixels=33, ruler=4).max(), 32)
        np.testing.assert_array_equal(gwatershed.segment(image, lab_input=True), class_labels(image, lab_input=True))
        self.assertEqual(gwatershed.segment(image[:, :, 0]).shape, image.shape[:2])
        self.assertRaises(ValueError, gwatershed.segment, image, 12, num_superpixels=33)
        self.assertRaises(ValueError, gwatershed.segment, None)
        self.assertRaises(TypeError, gwatershed.segment, image, regionsize=12)

    def test_bool_images_are_black_and_white(self):
        disc = np.hypot(*np.mgrid[-30:30, -40:40]) < 17
        np.testing.assert_array_equal(gwatershed.segment(disc, 12), gwatershed.segment(disc * np.uint8(255), 12))

    def test_8_bits_of_any_range(self):
        image = make_image()
        expected = gwatershed.segment(image, 12)
        np.testing.assert_array_equal(gwatershed.segment(image // 25, 12, value_range=(0, 10.2)),
                                      gwatershed.segment(image // 25 * 25, 12))
        np.testing.assert_array_equal(gwatershed.segment(image, 12, value_range=(0, 255)), expected)

    def test_refuses_what_it_would_take_for_something_else(self):
        image = make_image()
        for name, own in (("n_segments", "num_superpixels"), ("compactness", "ruler")):
            with self.assertRaisesRegex(TypeError, own):
                gwatershed.segment(image, **{name: 20})
        with self.assertRaisesRegex(ValueError, "last dimension"):
            gwatershed.segment(image.transpose(2, 0, 1))
        for name in ("region_size", "num_superpixels", "effort"):
            for value in (20.7, np.float32(20.7), None, "20"):
                if value is not None or name == "effort":
                    with self.assertRaisesRegex(TypeError, name):
                        gwatershed.segment(image, **{name: value})
        for value in (2.5, np.float32(2.5), None):
            with self.assertRaisesRegex(TypeError, "num_iterations must be an integer"):
                gwatershed.segment(image, num_iterations=value)
        for value in (0, 2**31, 2**64):
            with self.assertRaisesRegex(ValueError, "num_iterations must be from 1"):
                gwatershed.segment(image, num_iterations=value)
        np.testing.assert_array_equal(gwatershed.segment(image, np.uint8(12), num_iterations=np.int64(2)),
                                      gwatershed.segment(image, 12, num_iterations=2))
        gray = image[:, :, 0].astype(np.float32)
        masked = np.ma.masked_less(gray, 100)
        calls = [lambda: gwatershed.segment(masked), lambda: gwatershed.segment(image, depth=masked),
                 lambda: gwatershed.segment(image, mask=masked), lambda: gwatershed.superpixels(masked.astype(int)),
                 lambda: gwatershed.superpixels(gray.astype(int), masked)]
        for call in calls:
            self.assertRaisesRegex(TypeError, "masked array", call)
        np.testing.assert_array_equal(gwatershed.segment(np.ma.asarray(gray)), gwatershed.segment(gray))

    def test_says_when_depth_says_nothing(self):
        image, depth = make_image(), np.linspace(500, 3000, 96 * 128).reshape(96, 128)
        for wrong, depth_range in ((depth * 0, (0, 0)), (-depth, (0, 0)), (depth * np.nan, (0, 0)),
                                   (np.full(depth.shape, 65535, np.uint16), (0, 0)), (depth, (0.5, 4)),
                                   (np.full(depth.shape, 65535, ">u2"), (0, 0)),
                                   (np.where(depth > 900, 100, 0.1), (0.5, 4))):
            with self.assertWarnsRegex(UserWarning, "depth"):
                gwatershed.segment(image, 12, depth=wrong, depth_range=depth_range)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for right, depth_range in ((depth, (0, 0)), (depth, (500, 4000)), (depth / 1000, (0.5, 4)),
                                       (depth.astype(np.uint16), (0, 600)), (np.where(depth > 2000, 0, depth), (0, 0)),
                                       (np.where(depth > 900, 4, 100), (0.5, 4))):
                gwatershed.segment(image, 12, depth=right, depth_range=depth_range)

    def test_depth_of_any_numbers(self):
        image = make_image()
        depth = np.where(np.arange(128) < 50, 1000, 2000) * np.ones((96, 1), int)
        depth[:, ::7] = 0
        expected = gwatershed.segment(image, 12, depth=depth.astype(np.float64))
        for dtype in (np.int32, np.int64, np.uint32, np.float16, np.float32, np.uint16):
            np.testing.assert_array_equal(gwatershed.segment(image, 12, depth=depth.astype(dtype)), expected)
        self.assertRaisesRegex(ValueError, "depth must", gwatershed.segment, image, depth=depth.astype(np.int8))

    def test_segment_with_depth_mask_and_markers(self):
        image = np.full((60, 80, 3), 90, np.uint8)
        depth = np.where(np.arange(80) < 33, 1.0, 3.0) * np.ones((60, 1))
        labels = gwatershed.segment(image, 10, depth=depth)
        self.assertFalse(set(labels[:, :33].ravel()) & set(labels[:, 33:].ravel()))
        mask = np.zeros((60, 80))
        mask[5:50, 7:70] = 0.5
        labels = gwatershed.segment(image, 10, mask=mask, start_label=1)
        np.testing.assert_array_equal(labels > 0, mask > 0)
        self.assertEqual(labels.min(), 0)
        markers = np.zeros((60, 80), np.int64)
        markers[3, 4], markers[40, 60] = 5, 9
        self.assertEqual(np.unique(gwatershed.segment(image, markers=markers)).tolist(), [0, 1])
        markers[3, 4] = 2**40
        self.assertRaises(ValueError, gwatershed.segment, image, markers=markers)
        self.assertRaises(ValueError, gwatershed.segment, image, markers=markers / 2)

    def test_superpixels(self):
        image = make_image()
        depth = np.full(image.shape[:2], 1.5)
        depth[:, :40] = np.nan
        labels = gwatershed.segment(image, 12)
        table = gwatershed.superpixels(labels, image, depth)
        self.assertEqual(table.dtype.names, ("label", "area", "bbox", "centroid", "mean_color", "mean_depth"))
        self.assertEqual(table["label"].tolist(), list(range(labels.max() + 1)))
        for row in table:
            y, x = np.nonzero(labels == row["label"])
            self.assertEqual(row["area"], len(y))
            self.assertEqual(row["bbox"].tolist(), [y.min(), x.min(), y.max() + 1, x.max() + 1])
            np.testing.assert_allclose(row["centroid"], [y.mean(), x.mean()])
            np.testing.assert_allclose(row["mean_color"], image[y, x].mean(axis=0), rtol=1e-5)
            valid = depth[y, x][np.isfinite(depth[y, x])]
            np.testing.assert_allclose(row["mean_depth"], valid.mean() if len(valid) else np.nan, rtol=1e-6)

    def test_superpixels_on_a_slanted_plane(self):
        y, x = np.mgrid[0:60, 0:80]
        focal_length = (70, 50)
        ray_x, ray_y = (x - 39.5) / 70, (y - 29.5) / 50
        depth = 2 / (1 - 0.4 * ray_x + 0.3 * ray_y)  # z = 2 + 0.4 x - 0.3 y
        points = np.stack([ray_x * depth, ray_y * depth, depth], axis=-1)
        depth[:20, :20] = np.nan
        labels = gwatershed.segment(np.zeros((60, 80), np.uint8), 10, depth=depth, focal_length=focal_length)
        labels[0, 0] = labels.max() + 1
        table = gwatershed.superpixels(labels, None, depth, focal_length=focal_length)
        self.assertEqual(table.dtype.names[-3:], ("mean_depth", "position", "normal"))
        for row in table[:-1]:
            inside = (labels == row["label"]) & np.isfinite(depth)
            if inside.any(axis=0).sum() > 1 and inside.any(axis=1).sum() > 1:
                np.testing.assert_allclose(row["position"], points[inside].mean(axis=0), rtol=1e-5, atol=1e-6)
                np.testing.assert_allclose(row["normal"], np.array([0.4, -0.3, -1]) / np.sqrt(1.25), atol=1e-4)
        self.assertTrue(np.isnan(table[-1]["position"]).all() and np.isnan(table[-1]["normal"]).all())
        gws = gwatershed.SuperpixelGWatershed(focal_length=focal_length, region_size=10)
        gws.iterate(np.zeros((60, 80), np.uint8), depth)
        of_class = gwatershed.superpixels(gws.getLabels(), None, depth, focal_length=focal_length)
        for field, expected in zip(("position", "normal"), gws.getStatistics(None, depth)[4:]):
            np.testing.assert_array_equal(of_class[field], expected)

    def test_superpixels_and_focal_length(self):
        labels, depth = np.arange(6, dtype=np.int32).reshape(2, 3), np.ones((2, 3), np.float32)
        self.assertEqual(gwatershed.superpixels(labels, focal_length=(5, 5)).dtype.names[-1], "centroid")
        usual = gwatershed.superpixels(labels, None, depth, focal_length=(0, 0))
        np.testing.assert_allclose(usual["position"][0], [-1 / 2.4, -0.5 / 2.4, 1], rtol=1e-6)
        nothing = gwatershed.superpixels(labels, None, depth, focal_length=(5, 0), start_label=6)
        self.assertEqual((len(nothing), nothing.dtype.names[-1]), (0, "normal"))
        self.assertRaises(ValueError, gwatershed.superpixels, labels, None, depth, focal_length=(-1, 0))

    def test_superpixels_of_any_labels(self):
        labels = np.array([[0, 0, 7, 7], [-1, 5, 5, 7]])
        for kind in (np.int8, np.int64, np.int32):
            table = gwatershed.superpixels(labels.astype(kind))
            self.assertEqual(table["label"].tolist(), [0, 5, 7])
            self.assertEqual(table["label"].dtype, kind)
            self.assertEqual(table["area"].tolist(), [2, 2, 3])
        self.assertEqual(gwatershed.superpixels(labels, start_label=1)["label"].tolist(), [5, 7])
        labels[labels == 7] = 2**50
        self.assertEqual(gwatershed.superpixels(labels)["label"].tolist(), [0, 5, 2**50])
        self.assertEqual(len(gwatershed.superpixels(labels, start_label=2**51)), 0)
        colors = gwatershed.superpixels(labels, np.arange(8).reshape(2, 4))["mean_color"]
        np.testing.assert_allclose(colors[:, 0], [0.5, 5.5, 4])
        for wrong in (labels / 2, labels[None], labels[:0]):
            self.assertRaises(ValueError, gwatershed.superpixels, wrong)
        self.assertRaises(ValueError, gwatershed.superpixels, labels, np.zeros((3, 3)))
        self.assertRaises(ValueError, gwatershed.superpixels, labels, None, np.zeros((3, 3)))
        for kind in (np.int16, np.float64):
            depth = np.array([[2, 4, -3, 6], [1, 1, 0, 6]], kind)
            np.testing.assert_array_equal(gwatershed.superpixels(labels, None, depth)["mean_depth"], [3, 1, 6])
        colors = gwatershed.superpixels(labels, labels == 5)["mean_color"]
        np.testing.assert_array_equal(colors[:, 0], [0, 1, 0])

    def test_nothing_to_measure(self):
        labels = np.full((4, 6), -1)
        for shape, channels in (((4, 6), 1), ((4, 6, 1), 1), ((4, 6, 3), 3)):
            table = gwatershed.superpixels(labels, np.zeros(shape))
            self.assertEqual((len(table), table["mean_color"].shape), (0, (0, channels)))
            self.assertEqual(table.dtype, gwatershed.superpixels(labels + 1, np.zeros(shape)).dtype)
        self.assertEqual(gwatershed.superpixels(labels + 1, np.ones((4, 6, 128)))["mean_color"].shape, (1, 128))

    @needs("PIL")
    def test_images_of_pillow(self):
        from PIL import Image
        image = Image.fromarray(make_image())
        for mode in ("P", "CMYK", "HSV", "YCbCr", "RGBA", "LA", "PA"):
            other = image.convert(mode) if mode in ("P", "CMYK", "HSV", "YCbCr", "RGBA") else (
                image.convert("L").convert(mode))
            colors = np.asarray(other.convert("RGB"))
            labels = gwatershed.segment(other, 12)
            np.testing.assert_array_equal(labels, gwatershed.segment(colors, 12), mode)
            np.testing.assert_array_equal(gwatershed.superpixels(labels, other), gwatershed.superpixels(labels, colors))
        for mode in ("1", "L", "I", "F"):
            np.testing.assert_array_equal(gwatershed.segment(image.convert(mode), 12),
                                          gwatershed.segment(np.asarray(image.convert(mode)), 12), mode)
        gray = image.convert("L")
        np.testing.assert_array_equal(gwatershed.segment(image, 12, depth=gray),
                                      gwatershed.segment(image, 12, depth=np.asarray(gray)))
        for mode in ("1", "P", "RGB", "LA"):
            depth = gray.convert(mode)
            for work in gwatershed.segment, lambda _, depth: gwatershed.superpixels(np.ones(depth.size[::-1], int),
                                                                                    None, depth):
                with self.assertRaisesRegex(ValueError, "depth must be grey .* mode " + mode):
                    work(image, depth=depth)

    @needs("skimage")
    def test_with_scikit_image(self):
        from skimage.measure import regionprops
        from skimage.segmentation import mark_boundaries
        image = make_image()
        mask = np.ones(image.shape[:2], bool)
        mask[:20, :30] = False
        labels = gwatershed.segment(image, 12, mask=mask, start_label=1)
        marked = mark_boundaries(image, labels)
        self.assertEqual(marked.shape, image.shape)
        table = gwatershed.superpixels(labels, image, start_label=1)
        properties = regionprops(labels, image)
        self.assertEqual([p.label for p in properties], table["label"].tolist())
        self.assertEqual([p.area for p in properties], table["area"].tolist())
        self.assertEqual([list(p.bbox) for p in properties], table["bbox"].tolist())
        np.testing.assert_allclose([p.centroid for p in properties], table["centroid"])
        np.testing.assert_allclose([p.mean_intensity for p in properties], table["mean_color"], rtol=1e-5)


class RefusalsTest(unittest.TestCase):

    def test_names_and_numbers_are_no_arrays(self):
        image = make_image()
        labels = gwatershed.segment(image)
        for wrong in ("photo.jpg", pathlib.Path("photo.jpg"), 5, np.float32(5), np.array(5), object()):
            for name, call in (("image", lambda of: gwatershed.segment(of)),
                               ("depth", lambda of: gwatershed.segment(image, depth=of)),
                               ("mask", lambda of: gwatershed.segment(image, mask=of)),
                               ("markers", lambda of: gwatershed.segment(image, markers=of)),
                               ("labels", lambda of: gwatershed.superpixels(of)),
                               ("image", lambda of: gwatershed.superpixels(labels, of)),
                               ("depth", lambda of: gwatershed.superpixels(labels, None, of))):
                with self.assertRaisesRegex(TypeError, "^%s must be an array, not " % name):
                    call(wrong)

    def test_focal_length_is_named(self):
        image = make_image()
        depth = np.ones(image.shape[:2], np.float32)
        labels = gwatershed.segment(image)
        for wrong in (500, (500,), (1, 2, 3), "ab", (None, 1)):
            for call in (lambda of: gwatershed.segment(image, depth=depth, focal_length=of),
                         lambda of: gwatershed.superpixels(labels, None, depth, focal_length=of)):
                with self.assertRaisesRegex(TypeError, "^focal_length cannot be "):
                    call(wrong)


class NarrowLabelsTest(unittest.TestCase):

    def test_labels_of_few_bits_that_begin_below_0(self):
        for dtype, first in ((np.int8, -100), (np.int16, -32768), (np.uint8, -1), (np.uint64, 2 ** 63)):
            last = min(first + 200, np.iinfo(dtype).max)
            start = max(first, 0) if np.dtype(dtype).kind == "u" else first
            labels = np.arange(start, last + 1, dtype=dtype).reshape(1, -1).repeat(3, axis=0)
            table = gwatershed.superpixels(labels, start_label=first)
            np.testing.assert_array_equal(table["label"], labels[0])
            self.assertTrue((table["area"] == 3).all())

    def test_labels_fit_32_bits(self):
        for n, m in (2 ** 31 - 1, None), (-2 ** 31, make_image()[:, :, 0] > 99):
            self.assertRaisesRegex(ValueError, "start_label", gwatershed.segment, make_image(), mask=m, start_label=n)

    def test_labels_begin_with_an_integer(self):
        for begin in (1.5, 1.0, "1"):
            for work in gwatershed.segment, gwatershed.superpixels:
                with self.assertRaisesRegex(TypeError, "start_label"):
                    work(np.ones((4, 5), np.uint8), start_label=begin)
        labels = gwatershed.segment(make_image(), start_label=np.int64(1))
        self.assertEqual((labels.dtype, labels.min()), (np.int32, 1))


if __name__ == "__main__":
    unittest.main()
