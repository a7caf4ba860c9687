#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Every overload of SuperpixelGWatershed from Python, by position and by keyword.

It tests cv2.ximgproc, or, with GWATERSHED_TEST=package in the environment, the package gwatershed.
"""
import inspect
import os
import re
import threading
import unittest

import numpy as np

IS_PACKAGE = os.environ.get("GWATERSHED_TEST") == "package"
if IS_PACKAGE:
    import gwatershed as ximgproc
    TestCase, Error = unittest.TestCase, (ValueError, RuntimeError, TypeError)
    OF_ALGORITHM = {"clear", "empty", "read", "save", "write", "getDefaultName"}
else:
    import cv2
    from cv2 import ximgproc
    from tests_common import NewOpenCVTests as TestCase
    Error, OF_ALGORITHM = cv2.error, set(dir(cv2.Algorithm))

# What help() shows: a line for each overload, the names as in the header.
FACTORY = [
    "(image_width, image_height, image_channels, num_superpixels[, algorithm[, ruler]]) -> retval",
    "(image, algorithm[, region_size[, ruler]]) -> retval",
    "(image[, depth[, algorithm[, region_size[, ruler[, alpha]]]]]) -> retval",
]
METHODS = {
    "iterate": ["([, num_iterations]) -> None", "(image[, num_iterations]) -> None",
                "(image, depth[, num_iterations]) -> None"],
    "getNumberOfSuperpixels": ["() -> retval"],
    "getLabels": ["([, labels_out]) -> labels_out"],
    "getLabelContourMask": ["([, image[, thick_line]]) -> image"],
    "getWatershedLineMask": ["([, image]) -> image"],
    "enforceLabelConnectivity": ["([, min_element_size]) -> None"],
    "mergeSmall": ["(min_area) -> None"],
    "mergeSimilar": ["(num_superpixels) -> None"],
    "getStatistics": ["(image, depth[, stats[, centroids[, mean_colors[, mean_depths[, positions[, normals]]]]]])"
                      " -> stats, centroids, mean_colors, mean_depths, positions, normals"],
    "getAdjacency": ["(image, depth[, pairs[, lengths[, contrasts]]]) -> pairs, lengths, contrasts"],
    "setMask": ["(mask) -> None"],
    "setMarkers": ["(markers) -> None"],
    "setAlgorithm": ["([, algorithm]) -> None"],
    "getAlgorithm": ["() -> retval"],
    "setRegionSize": ["([, region_size]) -> None"],
    "getRegionSize": ["() -> retval"],
    "setDesiredSuperpixels": ["(num_superpixels) -> None"],
    "getDesiredSuperpixels": ["() -> retval"],
    "setRuler": ["([, ruler]) -> None"],
    "getRuler": ["() -> retval"],
    "setEffort": ["([, effort]) -> None"],
    "getEffort": ["() -> retval"],
    "setAlpha": ["([, alpha]) -> None"],
    "getAlpha": ["() -> retval"],
    "setLabInput": ["(lab_input) -> None"],
    "getLabInput": ["() -> retval"],
    "setTemporal": ["(temporal) -> None"],
    "getTemporal": ["() -> retval"],
    "setValueRange": ["(low_value, high_value) -> None"],
    "getLowValue": ["() -> retval"],
    "getHighValue": ["() -> retval"],
    "setDepthRange": ["(near_depth, far_depth) -> None"],
    "getNearDepth": ["() -> retval"],
    "getFarDepth": ["() -> retval"],
    "setFocalLength": ["(fx[, fy]) -> None"],
    "getFocalLengthX": ["() -> retval"],
    "getFocalLengthY": ["() -> retval"],
    "setNormalWeight": ["([, normal_weight]) -> None"],
    "getNormalWeight": ["() -> retval"],
    "setDepthAdaptive": ["(depth_adaptive) -> None"],
    "getDepthAdaptive": ["() -> retval"],
    "setBorderThreshold": ["([, border_threshold]) -> None"],
    "getBorderThreshold": ["() -> retval"],
}


def signatures(function):
    """The lines of the docstring that are signatures; those of the description begin with a dot."""
    lines = function.__doc__.splitlines()
    return [line[len(function.__name__):] for line in lines if line.startswith(function.__name__ + "(")]


def package_signatures(function):
    """Those of the package, as cv2 writes them but for the result."""
    lines = [re.sub(r"^\d+\. ", "", line) for line in function.__doc__.splitlines()]
    found = [line for line in lines if line.startswith(function.__name__ + "(") and " -> " in line]
    return [as_cv2_writes(line) for line in found]


def as_cv2_writes(signature):
    """name(self: T, a: T, b: T = value) -> T  becomes  (a[, b])"""
    parameters = re.findall(r"(\w+): ([^()]*?)(?= = |, \w+: |\)|$)( = )?", signature.split("(", 1)[1])
    names = [(name, bool(default)) for name, _, default in parameters if name != "self"]
    text = ""
    for index, (name, has_default) in enumerate(names):
        text += ("[" if has_default else "") + (", " if index or has_default else "") + name
    if names and names[0][1]:
        text = text.replace("[, ", "[, ", 1)
    return "(" + text + "]" * sum(has_default for _, has_default in names) + ")"


def make_image(height=48, width=64):
    y, x = np.mgrid[0:height, 0:width]
    image = np.stack([x * 3, y * 4, 128 + 60 * np.sin(x / 5.0 + y / 7.0)], axis=-1)
    return image.astype(np.uint8)


def make_depth(height=48, width=64):
    depth = np.full((height, width), 1500, np.uint16)
    depth[:, 37:] = 1700
    return depth


class gwatershed_test(TestCase):

    def labels_of(self, gws):
        labels = gws.getLabels()
        self.assertEqual(labels.dtype, np.int32)
        self.assertEqual(np.unique(labels).tolist(), list(range(gws.getNumberOfSuperpixels())))
        return labels

    def segment(self, *arguments, **keywords):
        gws = ximgproc.createSuperpixelGWatershed(*arguments, **keywords)
        gws.iterate()
        return self.labels_of(gws)

    def test_methods_are_those_of_the_header(self):
        own = dict(inspect.getmembers(ximgproc.SuperpixelGWatershed, callable))
        names = {name for name in own if not name.startswith("_")}
        self.assertEqual(names - OF_ALGORITHM, set(METHODS))
        self.assertLessEqual({"clear", "empty", "read", "save", "write", "getDefaultName"}, names)

    @unittest.skipIf(IS_PACKAGE, "it writes them in another way")
    def test_signatures(self):
        self.assertEqual(signatures(ximgproc.createSuperpixelGWatershed), FACTORY)
        for name, expected in METHODS.items():
            self.assertEqual(signatures(getattr(ximgproc.SuperpixelGWatershed, name)), expected, name)

    @unittest.skipUnless(IS_PACKAGE, "of the package")
    def test_signatures_of_the_package(self):
        functions = [(ximgproc.createSuperpixelGWatershed, FACTORY)]
        functions += [(getattr(ximgproc.SuperpixelGWatershed, name), METHODS[name]) for name in METHODS]
        for function, expected in functions:
            of_cv2 = {line.split(" -> ")[0] for line in expected}
            self.assertEqual(set(package_signatures(function)), of_cv2, function.__name__)

    @unittest.skipIf(IS_PACKAGE, "it has no dots")
    def test_every_method_is_described(self):
        for name in METHODS:
            text = getattr(ximgproc.SuperpixelGWatershed, name).__doc__
            description = [line for line in text.splitlines() if line.startswith(".") and line.strip(". ")]
            self.assertTrue(description, name)

    def test_factory_for_an_image(self):
        image = make_image()
        labels = self.segment(image, ximgproc.GWATERSHED, 8, 10.0)
        self.assertEqual(labels.shape, image.shape[:2])
        self.assertEqual(labels.max() + 1, 48)
        same = self.segment(image=image, algorithm=ximgproc.GWATERSHED, region_size=8, ruler=10)
        np.testing.assert_array_equal(labels, same)
        self.assertEqual(self.segment(image).max() + 1, 30)  # region_size 10: five rows of six

    def test_factory_for_an_image_with_depth(self):
        image, depth = make_image(), make_depth()
        labels = self.segment(image, depth, ximgproc.GWATERSHED, 8, 10.0, 0.25)
        same = self.segment(image=image, depth=depth, algorithm=ximgproc.GWATERSHED, region_size=8,
                            ruler=10, alpha=0.25)
        np.testing.assert_array_equal(labels, same)
        flat = np.full_like(image, 100)
        cut = self.segment(flat, depth, region_size=8)
        self.assertFalse(set(cut[:, :37].ravel()) & set(cut[:, 37:].ravel()))

    def test_factory_for_a_size(self):
        image = make_image()
        by_position = ximgproc.createSuperpixelGWatershed(64, 48, 3, 50)
        by_keyword = ximgproc.createSuperpixelGWatershed(
            image_width=64, image_height=48, image_channels=3, num_superpixels=50,
            algorithm=ximgproc.GWATERSHED, ruler=10)
        for gws in (by_position, by_keyword):
            gws.setAlgorithm(ximgproc.GWATERSHED)
            self.assertRaises(Error, gws.iterate)  # there is no image yet
            gws.iterate(image)
            self.assertEqual(gws.getNumberOfSuperpixels(), 50)
        np.testing.assert_array_equal(self.labels_of(by_position), self.labels_of(by_keyword))

    def test_iterate(self):
        image, depth = make_image(), make_depth()
        gws = ximgproc.createSuperpixelGWatershed(image, region_size=8)
        gws.iterate(3)
        of_factory = self.labels_of(gws)
        gws.iterate(image, 3)
        np.testing.assert_array_equal(self.labels_of(gws), of_factory)
        gws.iterate(image=image, num_iterations=3)
        np.testing.assert_array_equal(self.labels_of(gws), of_factory)
        gws.iterate(num_iterations=3)
        np.testing.assert_array_equal(self.labels_of(gws), of_factory)
        gws.iterate(image, depth)
        with_depth = self.labels_of(gws)
        gws.iterate(image=image, depth=depth, num_iterations=1)
        np.testing.assert_array_equal(self.labels_of(gws), with_depth)

    def test_slices_and_types(self):
        image = make_image()
        part = image[5:40, 7:50]
        np.testing.assert_array_equal(self.segment(part), self.segment(part.copy()))
        labels = self.segment(image)
        np.testing.assert_array_equal(labels, self.segment(image.astype(np.uint16) * 257))
        np.testing.assert_array_equal(labels, self.segment(image.astype(np.float32) / 255))
        gray = image[:, :, 0].copy()
        self.assertEqual(self.segment(gray).shape, gray.shape)

    def test_masks(self):
        gws = ximgproc.createSuperpixelGWatershed(make_image(), region_size=8)
        gws.iterate()
        thick = gws.getLabelContourMask()
        thin = gws.getLabelContourMask(thick_line=False)
        for mask in (thick, thin, gws.getWatershedLineMask()):
            self.assertEqual(mask.dtype, np.uint8)
            self.assertTrue(set(np.unique(mask)) <= {0, 255})
        self.assertTrue((thick[thin > 0] > 0).all())
        gws.enforceLabelConnectivity(min_element_size=50)
        gws.mergeSmall(min_area=90)
        self.assertGreaterEqual(np.bincount(self.labels_of(gws).ravel()).min(), 90)

    def test_mask(self):
        image = make_image()
        mask = np.zeros(image.shape[:2], np.uint8)
        mask[5:30, 10:50] = 1
        mask[20:25, 20:30] = 0
        gws = ximgproc.createSuperpixelGWatershed(image, region_size=8)
        gws.setMask(mask)
        gws.iterate()
        labels = gws.getLabels()
        self.assertEqual(np.unique(labels).tolist(), list(range(-1, gws.getNumberOfSuperpixels())))
        np.testing.assert_array_equal(labels >= 0, mask > 0)
        gws.setMask(mask=np.zeros_like(mask))
        gws.iterate()
        self.assertEqual(gws.getNumberOfSuperpixels(), 0)
        self.assertTrue(all(table is None for table in gws.getStatistics(image, None)))
        gws.setMask(mask=None)
        gws.iterate()
        self.labels_of(gws)

    def test_markers(self):
        image = make_image()
        markers = np.zeros(image.shape[:2], np.int32)
        markers[3, 5:9], markers[40, 50], markers[0, 0] = 70000, 12, -1
        gws = ximgproc.createSuperpixelGWatershed(image)
        gws.setMarkers(markers)
        gws.iterate()
        labels = self.labels_of(gws)
        self.assertEqual(gws.getNumberOfSuperpixels(), 2)
        self.assertEqual((labels[40, 50], labels[3, 5], labels[3, 8]), (0, 1, 1))

    def test_statistics(self):
        image, depth = make_image(), make_depth()
        depth[10:20, 5:40] = 0
        gws = ximgproc.createSuperpixelGWatershed(image, region_size=8)
        gws.iterate()
        labels, number = gws.getLabels(), gws.getNumberOfSuperpixels()
        stats, centroids, colors, depths, positions, normals = gws.getStatistics(image, depth)
        self.assertEqual((stats.shape, stats.dtype), ((number, 5), np.int32))
        self.assertEqual((centroids.shape, centroids.dtype), ((number, 2), np.float64))
        self.assertEqual((colors.shape, colors.dtype), ((number, 3), np.float32))
        self.assertEqual((depths.shape, depths.dtype), ((number, 1), np.float32))
        self.assertEqual((positions.shape, positions.dtype), ((number, 3), np.float32))
        self.assertEqual((normals.shape, normals.dtype), ((number, 3), np.float32))
        np.testing.assert_array_equal(positions[:, 2:], depths)
        for i in range(number):
            y, x = np.nonzero(labels == i)
            self.assertEqual(stats[i].tolist(), [x.min(), y.min(), np.ptp(x) + 1, np.ptp(y) + 1, len(x)])
            np.testing.assert_allclose(centroids[i], [x.mean(), y.mean()])
            np.testing.assert_allclose(colors[i], image[y, x].mean(axis=0), rtol=1e-5)
            valid = depth[y, x][depth[y, x] > 0]
            np.testing.assert_allclose(depths[i, 0], valid.mean() if len(valid) else np.nan, rtol=1e-5)
        only_colors = gws.getStatistics(image=image, depth=None)
        np.testing.assert_array_equal(only_colors[2], colors)
        self.assertEqual(only_colors[3:], (None, None, None))

    def test_surfaces(self):
        y, x = np.mgrid[0:60, 0:80]
        depth = (2 / (1 - 0.4 * (x - 39.5) / 70 + 0.3 * (y - 29.5) / 50)).astype(np.float32)  # z = 2 + 0.4 x - 0.3 y
        gws = ximgproc.createSuperpixelGWatershed(np.zeros((60, 80), np.uint8), depth, region_size=12)
        gws.setFocalLength(70, 50)
        gws.iterate()
        positions, normals = gws.getStatistics(None, depth)[4:]
        np.testing.assert_allclose(2 + positions[:, :2] @ [0.4, -0.3], positions[:, 2], rtol=1e-4)
        np.testing.assert_allclose(normals, np.tile(np.float32([0.4, -0.3, -1]) / np.sqrt(1.25), (len(normals), 1)),
                                   atol=1e-3)

    def test_adjacency(self):
        image = make_image()
        gws = ximgproc.createSuperpixelGWatershed(image, region_size=8)
        gws.iterate()
        labels = gws.getLabels()
        pairs, lengths, contrasts = gws.getAdjacency(image, None)
        self.assertEqual((pairs.dtype, lengths.dtype, contrasts.dtype), (np.int32, np.int32, np.float32))
        edges = np.concatenate([np.stack([labels[:, :-1].ravel(), labels[:, 1:].ravel()], 1),
                                np.stack([labels[:-1].ravel(), labels[1:].ravel()], 1)])
        edges = np.sort(edges[edges[:, 0] != edges[:, 1]], axis=1)
        expected, counts = np.unique(edges, axis=0, return_counts=True)
        np.testing.assert_array_equal(pairs, expected)
        np.testing.assert_array_equal(lengths[:, 0], counts)

    def test_merging(self):
        gws = ximgproc.createSuperpixelGWatershed(make_image(), region_size=6)
        gws.iterate()
        fine = gws.getLabels()
        for number in (40, 10, 20):
            gws.mergeSimilar(num_superpixels=number)
            labels = self.labels_of(gws)
            self.assertEqual(gws.getNumberOfSuperpixels(), number)
            for i in range(fine.max() + 1):
                self.assertEqual(len(np.unique(labels[fine == i])), 1)

    def test_temporal(self):
        image = make_image(120, 160)
        gws = ximgproc.createSuperpixelGWatershed(160, 120, 3, 60)
        gws.setTemporal(temporal=True)
        self.assertTrue(gws.getTemporal())
        gws.iterate(image)
        first = self.labels_of(gws)
        gws.iterate(np.roll(image, 1, axis=1))
        self.assertGreater(np.mean(self.labels_of(gws) == first), 0.7)

    def test_none_for_depth_is_no_depth(self):
        image, create = make_image(), ximgproc.createSuperpixelGWatershed
        for algorithm in (ximgproc.GWATERSHED, ximgproc.RGWATERSHED):
            expected = self.segment(image, algorithm, 8)
            for gws in (create(image, None, algorithm, 8), create(image, None, algorithm, 8, 10.0, 0.5),
                        create(image, None, algorithm=algorithm, region_size=8),
                        create(image=image, depth=None, region_size=8, algorithm=algorithm),
                        create(ruler=10, region_size=8, algorithm=algorithm, image=image)):
                self.assertEqual((gws.getAlgorithm(), gws.getRegionSize()), (algorithm, 8))
                gws.iterate()
                np.testing.assert_array_equal(self.labels_of(gws), expected)
                gws.iterate(image, None)
                np.testing.assert_array_equal(self.labels_of(gws), expected)
                gws.iterate(image, None, 4)
                four = self.labels_of(gws)
                gws.iterate(image, 4)
                np.testing.assert_array_equal(self.labels_of(gws), four)
        gws = create(image, None)
        self.assertEqual((gws.getAlgorithm(), gws.getRegionSize()), (ximgproc.RGWATERSHED, 10))

    def test_none_for_a_number_is_its_default_or_throws(self):
        gws = ximgproc.createSuperpixelGWatershed(make_image())
        for setter, getter, other, default in (
                (gws.setAlpha, gws.getAlpha, 0.25, 0.5), (gws.setRuler, gws.getRuler, 3, 10),
                (gws.setBorderThreshold, gws.getBorderThreshold, 70, 150), (gws.setEffort, gws.getEffort, 3, 1),
                (gws.setRegionSize, gws.getRegionSize, 7, 10),
                (gws.setAlgorithm, gws.getAlgorithm, ximgproc.GWATERSHED, ximgproc.RGWATERSHED)):
            setter(other)
            self.assertEqual(getter(), other)
            setter(None)
            self.assertEqual(getter(), default)
        gws.setDepthRange(None, None)
        gws.setValueRange(None, None)
        self.assertEqual((gws.getFarDepth(), gws.getHighValue()), (0, 0))
        gws.iterate()
        for call in (gws.setDesiredSuperpixels, gws.mergeSimilar):
            self.assertRaises(Error, call, None)

    def test_values_of_every_type(self):
        image = make_image()
        labels = self.segment(image)
        gws = ximgproc.createSuperpixelGWatershed(image)
        gws.setValueRange(0, 255)
        for dtype in (np.int16, np.int32, np.int64, np.float32, np.float64):
            gws.iterate(image.astype(dtype))
            np.testing.assert_array_equal(self.labels_of(gws), labels)
        flat, depth = np.full_like(image, 100), make_depth()
        gws.setRegionSize(8)
        for dtype in (np.int16, np.float32, np.float64):
            gws.iterate(flat, depth.astype(dtype))
            cut = self.labels_of(gws)
            self.assertFalse(set(cut[:, :37].ravel()) & set(cut[:, 37:].ravel()))

    def test_values_in_any_range(self):
        bytes_ = make_image()
        labels = self.segment(bytes_)
        for image in (bytes_.astype(np.uint16) * 257, bytes_.astype(np.float32) / 255, bytes_ / 255.0):
            np.testing.assert_array_equal(self.segment(image), labels)
        flat = np.where(np.arange(64) < 37, 170, 90) * np.ones((48, 1))
        for low, step, dtype in ((0, 1, np.float32), (-1, 1 / 128, np.float32), (-1000, 12, np.int16),
                                 (0, 16, np.uint16), (7000, 4, np.uint16), (1e6, 8, np.float64),
                                 (-70000, 600, np.int32)):
            for channels in (1, 2, 3, 4):
                image = np.dstack([flat * step + low] * channels).astype(dtype)
                cut = self.segment(image, region_size=8)
                self.assertFalse(set(cut[:, :37].ravel()) & set(cut[:, 37:].ravel()), (dtype, channels))
        flat[5:9, 5:9], flat[20, 3], flat[30, 3] = np.nan, np.inf, -np.inf
        cut = self.segment(flat * 3, region_size=8)
        self.assertFalse(set(cut[:, :37].ravel()) & set(cut[:, 37:].ravel()))

    def test_depth_that_is_missing_or_far(self):
        image, depth = np.full((48, 64, 3), 100, np.uint8), make_depth()
        holes, saturated = depth.copy(), depth.copy()
        holes[:, 50:], saturated[:, 50:] = 0, 65535
        np.testing.assert_array_equal(self.segment(image, holes), self.segment(image, saturated))
        sentinel = depth.copy()
        sentinel[10:40, 45:] = 10000
        far = np.where(np.arange(64) < 37, 1.0, np.inf) * np.ones((48, 1))
        for values in (sentinel, far, far.astype(np.float32)):
            cut = self.segment(image, values, region_size=8)
            self.assertFalse(set(cut[:, :37].ravel()) & set(cut[:, 37:].ravel()))
        for missing in (np.nan, 0, -1, -np.inf):
            part = np.where(np.arange(64) < 37, 1.0, missing) * np.ones((48, 1))
            np.testing.assert_array_equal(self.segment(image, part), self.segment(image))

    def test_statistics_skip_what_is_no_number(self):
        gws = ximgproc.createSuperpixelGWatershed(make_image())
        gws.setDesiredSuperpixels(1)
        gws.iterate()
        values = np.full((48, 64, 3), (4, 5, np.nan), np.float32)
        values[2] = np.nan, 5, np.inf
        colors = gws.getStatistics(values, None)[2]
        self.assertEqual(colors[0, :2].tolist(), [4, 5])
        self.assertTrue(np.isnan(colors[0, 2]))

    def test_channels(self):
        many = np.zeros((48, 64, 7), np.float32)
        with self.assertRaisesRegex(Error, "PCA"):
            ximgproc.createSuperpixelGWatershed(many)

    def test_arrays_without_memory(self):
        image = make_image()
        gws = ximgproc.createSuperpixelGWatershed(image)
        gws.iterate()
        for dtype in (np.uint8, np.float32):
            nothing = np.zeros(image.shape[:2] + (0,), dtype)
            self.assertRaises(Error, gws.getStatistics, nothing, None)
            self.assertRaises(Error, gws.iterate, nothing)
        self.assertRaises(Error, gws.getStatistics, np.zeros(image.shape[:2] + (513,), np.uint8), None)

    def test_two_threads(self):
        image = make_image(240, 320)
        gws = ximgproc.createSuperpixelGWatershed(image)
        others = []

        def work():
            for _ in range(20):
                try:
                    gws.iterate(image)
                    gws.getLabels()
                except Error as error:
                    if "in use by another thread" not in str(error):
                        others.append(str(error))

        threads = [threading.Thread(target=work) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(others, [])
        gws.iterate(image)
        self.labels_of(gws)

    def test_parameters(self):
        gws = ximgproc.createSuperpixelGWatershed(make_image())
        gws.setAlgorithm(ximgproc.GWATERSHED)
        gws.setDesiredSuperpixels(77)
        gws.setRuler(3.5)
        gws.setEffort(2)
        gws.setAlpha(0.75)
        gws.setDepthRange(near_depth=400, far_depth=4000)
        gws.setValueRange(low_value=-1000, high_value=3000)
        gws.setBorderThreshold(100)
        self.assertEqual(gws.getAlgorithm(), ximgproc.GWATERSHED)
        self.assertEqual((gws.getDesiredSuperpixels(), gws.getRegionSize()), (77, 0))
        self.assertEqual((gws.getRuler(), gws.getAlpha(), gws.getEffort()), (3.5, 0.75, 2))
        self.assertEqual((gws.getNearDepth(), gws.getFarDepth()), (400, 4000))
        self.assertEqual((gws.getLowValue(), gws.getHighValue()), (-1000, 3000))
        self.assertRaises(Error, gws.setValueRange, 2, 1)
        self.assertEqual((gws.getLowValue(), gws.getHighValue()), (-1000, 3000))
        self.assertEqual(gws.getBorderThreshold(), 100)
        gws.setRegionSize(9)
        self.assertEqual((gws.getDesiredSuperpixels(), gws.getRegionSize()), (0, 9))
        self.assertEqual(gws.getDefaultName(), "SuperpixelGWatershed")

    def test_errors(self):
        image = make_image()
        gws = ximgproc.createSuperpixelGWatershed(image)
        self.assertTrue(gws.empty())
        for call in (gws.getLabels, lambda: gws.setRegionSize(0), lambda: gws.setAlpha(2), lambda: gws.setEffort(4),
                     lambda: gws.iterate(np.dstack([image, image])), lambda: gws.iterate(image, image)):
            self.assertRaises(Error, call)
        gws.iterate()
        self.labels_of(gws)
        gws.clear()
        self.assertTrue(gws.empty())


if __name__ == "__main__":
    unittest.main() if IS_PACKAGE else TestCase.bootstrap()
