#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Every overload of SuperpixelGWatershed from Python, by position and by keyword."""
import inspect

import cv2 as cv
import numpy as np

from tests_common import NewOpenCVTests

# What help() shows: a line for each overload, the names as in the header.
FACTORY = [
    "(image_width, image_height, image_channels, num_superpixels[, algorithm[, ruler]]) -> retval",
    "(image[, algorithm[, region_size[, ruler]]]) -> retval",
    "(image, depth[, algorithm[, region_size[, ruler[, alpha]]]]) -> retval",
]
METHODS = {
    "iterate": ["([, num_iterations]) -> None", "(image[, num_iterations]) -> None",
                "(image, depth[, num_iterations]) -> None"],
    "getNumberOfSuperpixels": ["() -> retval"],
    "getLabels": ["([, labels_out]) -> labels_out"],
    "getLabelContourMask": ["([, image[, thick_line]]) -> image"],
    "getWatershedLineMask": ["([, image]) -> image"],
    "enforceLabelConnectivity": ["([, min_element_size]) -> None"],
    "mergeSimilar": ["(num_superpixels) -> None"],
    "getStatistics": ["(image, depth[, stats[, centroids[, mean_colors[, mean_depths]]]])"
                      " -> stats, centroids, mean_colors, mean_depths"],
    "getAdjacency": ["(image, depth[, pairs[, lengths[, contrasts]]]) -> pairs, lengths, contrasts"],
    "setMask": ["(mask) -> None"],
    "setMarkers": ["(markers) -> None"],
    "setAlgorithm": ["(algorithm) -> None"],
    "getAlgorithm": ["() -> retval"],
    "setRegionSize": ["(region_size) -> None"],
    "getRegionSize": ["() -> retval"],
    "setDesiredSuperpixels": ["(num_superpixels) -> None"],
    "getDesiredSuperpixels": ["() -> retval"],
    "setRuler": ["(ruler) -> None"],
    "getRuler": ["() -> retval"],
    "setAlpha": ["(alpha) -> None"],
    "getAlpha": ["() -> retval"],
    "setLabInput": ["(lab_input) -> None"],
    "getLabInput": ["() -> retval"],
    "setTemporal": ["(temporal) -> None"],
    "getTemporal": ["() -> retval"],
    "setDepthRange": ["(near_depth, far_depth) -> None"],
    "getNearDepth": ["() -> retval"],
    "getFarDepth": ["() -> retval"],
    "setBorderThreshold": ["(border_threshold) -> None"],
    "getBorderThreshold": ["() -> retval"],
}


def signatures(function):
    """The lines of the docstring that are signatures; those of the description begin with a dot."""
    lines = function.__doc__.splitlines()
    return [line[len(function.__name__):] for line in lines if line.startswith(function.__name__ + "(")]


def make_image(height=48, width=64):
    y, x = np.mgrid[0:height, 0:width]
    image = np.stack([x * 3, y * 4, 128 + 60 * np.sin(x / 5.0 + y / 7.0)], axis=-1)
    return image.astype(np.uint8)


def make_depth(height=48, width=64):
    depth = np.full((height, width), 1500, np.uint16)
    depth[:, 37:] = 1700
    return depth


class gwatershed_test(NewOpenCVTests):

    def labels_of(self, gws):
        labels = gws.getLabels()
        self.assertEqual(labels.dtype, np.int32)
        self.assertEqual(np.unique(labels).tolist(), list(range(gws.getNumberOfSuperpixels())))
        return labels

    def segment(self, *arguments, **keywords):
        gws = cv.ximgproc.createSuperpixelGWatershed(*arguments, **keywords)
        gws.iterate()
        return self.labels_of(gws)

    def test_methods_are_those_of_the_header(self):
        own = dict(inspect.getmembers(cv.ximgproc.SuperpixelGWatershed, callable))
        names = {name for name in own if not name.startswith("_")}
        self.assertEqual(names - set(dir(cv.Algorithm)), set(METHODS))
        self.assertLessEqual({"clear", "empty", "read", "save", "write", "getDefaultName"}, names)

    def test_signatures(self):
        self.assertEqual(signatures(cv.ximgproc.createSuperpixelGWatershed), FACTORY)
        for name, expected in METHODS.items():
            self.assertEqual(signatures(getattr(cv.ximgproc.SuperpixelGWatershed, name)), expected, name)

    def test_every_method_is_described(self):
        for name in METHODS:
            text = getattr(cv.ximgproc.SuperpixelGWatershed, name).__doc__
            description = [line for line in text.splitlines() if line.startswith(".") and line.strip(". ")]
            self.assertTrue(description, name)

    def test_factory_for_an_image(self):
        image = make_image()
        labels = self.segment(image, cv.ximgproc.GWATERSHED, 8, 10.0)
        self.assertEqual(labels.shape, image.shape[:2])
        self.assertEqual(labels.max() + 1, 48)
        same = self.segment(image=image, algorithm=cv.ximgproc.GWATERSHED, region_size=8, ruler=10)
        np.testing.assert_array_equal(labels, same)
        self.assertEqual(self.segment(image).max() + 1, 31)  # region_size 10

    def test_factory_for_an_image_with_depth(self):
        image, depth = make_image(), make_depth()
        labels = self.segment(image, depth, cv.ximgproc.GWATERSHED, 8, 10.0, 0.25)
        same = self.segment(image=image, depth=depth, algorithm=cv.ximgproc.GWATERSHED, region_size=8,
                            ruler=10, alpha=0.25)
        np.testing.assert_array_equal(labels, same)
        flat = np.full_like(image, 100)
        cut = self.segment(flat, depth, region_size=8)
        self.assertFalse(set(cut[:, :37].ravel()) & set(cut[:, 37:].ravel()))

    def test_factory_for_a_size(self):
        image = make_image()
        by_position = cv.ximgproc.createSuperpixelGWatershed(64, 48, 3, 50)
        by_keyword = cv.ximgproc.createSuperpixelGWatershed(
            image_width=64, image_height=48, image_channels=3, num_superpixels=50,
            algorithm=cv.ximgproc.GWATERSHED, ruler=10)
        for gws in (by_position, by_keyword):
            gws.setAlgorithm(cv.ximgproc.GWATERSHED)
            self.assertRaises(cv.error, gws.iterate)  # there is no image yet
            gws.iterate(image)
            self.assertEqual(gws.getNumberOfSuperpixels(), 50)
        np.testing.assert_array_equal(self.labels_of(by_position), self.labels_of(by_keyword))

    def test_iterate(self):
        image, depth = make_image(), make_depth()
        gws = cv.ximgproc.createSuperpixelGWatershed(image, region_size=8)
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
        gws = cv.ximgproc.createSuperpixelGWatershed(make_image(), region_size=8)
        gws.iterate()
        thick = gws.getLabelContourMask()
        thin = gws.getLabelContourMask(thick_line=False)
        for mask in (thick, thin, gws.getWatershedLineMask()):
            self.assertEqual(mask.dtype, np.uint8)
            self.assertTrue(set(np.unique(mask)) <= {0, 255})
        self.assertTrue((thick[thin > 0] > 0).all())
        gws.enforceLabelConnectivity(min_element_size=50)
        self.labels_of(gws)

    def test_mask(self):
        image = make_image()
        mask = np.zeros(image.shape[:2], np.uint8)
        mask[5:30, 10:50] = 1
        mask[20:25, 20:30] = 0
        gws = cv.ximgproc.createSuperpixelGWatershed(image, region_size=8)
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
        gws = cv.ximgproc.createSuperpixelGWatershed(image)
        gws.setMarkers(markers)
        gws.iterate()
        labels = self.labels_of(gws)
        self.assertEqual(gws.getNumberOfSuperpixels(), 2)
        self.assertEqual((labels[40, 50], labels[3, 5], labels[3, 8]), (0, 1, 1))

    def test_statistics(self):
        image, depth = make_image(), make_depth()
        depth[10:20, 5:40] = 0
        gws = cv.ximgproc.createSuperpixelGWatershed(image, region_size=8)
        gws.iterate()
        labels, number = gws.getLabels(), gws.getNumberOfSuperpixels()
        stats, centroids, colors, depths = gws.getStatistics(image, depth)
        self.assertEqual((stats.shape, stats.dtype), ((number, 5), np.int32))
        self.assertEqual((centroids.shape, centroids.dtype), ((number, 2), np.float64))
        self.assertEqual((colors.shape, colors.dtype), ((number, 3), np.float32))
        self.assertEqual((depths.shape, depths.dtype), ((number, 1), np.float32))
        for i in range(number):
            y, x = np.nonzero(labels == i)
            self.assertEqual(stats[i].tolist(), [x.min(), y.min(), np.ptp(x) + 1, np.ptp(y) + 1, len(x)])
            np.testing.assert_allclose(centroids[i], [x.mean(), y.mean()])
            np.testing.assert_allclose(colors[i], image[y, x].mean(axis=0), rtol=1e-5)
            valid = depth[y, x][depth[y, x] > 0]
            np.testing.assert_allclose(depths[i, 0], valid.mean() if len(valid) else np.nan, rtol=1e-5)
        only_colors = gws.getStatistics(image=image, depth=None)
        np.testing.assert_array_equal(only_colors[2], colors)

    def test_adjacency(self):
        image = make_image()
        gws = cv.ximgproc.createSuperpixelGWatershed(image, region_size=8)
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
        gws = cv.ximgproc.createSuperpixelGWatershed(make_image(), region_size=6)
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
        gws = cv.ximgproc.createSuperpixelGWatershed(160, 120, 3, 60)
        gws.setTemporal(temporal=True)
        self.assertTrue(gws.getTemporal())
        gws.iterate(image)
        first = self.labels_of(gws)
        gws.iterate(np.roll(image, 1, axis=1))
        self.assertGreater(np.mean(self.labels_of(gws) == first), 0.7)

    def test_parameters(self):
        gws = cv.ximgproc.createSuperpixelGWatershed(make_image())
        gws.setAlgorithm(cv.ximgproc.GWATERSHED)
        gws.setDesiredSuperpixels(77)
        gws.setRuler(3.5)
        gws.setAlpha(0.75)
        gws.setDepthRange(400, 4000)
        gws.setBorderThreshold(100)
        self.assertEqual(gws.getAlgorithm(), cv.ximgproc.GWATERSHED)
        self.assertEqual((gws.getDesiredSuperpixels(), gws.getRegionSize()), (77, 0))
        self.assertEqual((gws.getRuler(), gws.getAlpha()), (3.5, 0.75))
        self.assertEqual((gws.getNearDepth(), gws.getFarDepth()), (400, 4000))
        self.assertEqual(gws.getBorderThreshold(), 100)
        gws.setRegionSize(9)
        self.assertEqual((gws.getDesiredSuperpixels(), gws.getRegionSize()), (0, 9))
        self.assertEqual(gws.getDefaultName(), "SuperpixelGWatershed")

    def test_errors(self):
        image = make_image()
        gws = cv.ximgproc.createSuperpixelGWatershed(image)
        self.assertTrue(gws.empty())
        for call in (gws.getLabels, lambda: gws.setRegionSize(0), lambda: gws.setAlpha(2),
                     lambda: gws.iterate(image.astype(np.float64)), lambda: gws.iterate(image, image)):
            self.assertRaises(cv.error, call)
        gws.iterate()
        self.labels_of(gws)
        gws.clear()
        self.assertTrue(gws.empty())


if __name__ == "__main__":
    NewOpenCVTests.bootstrap()
