#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""What the package gwatershed has beside the interface of cv2.ximgproc, which misc/python/test tests.

Parts that need scikit-image or mypy are skipped where these are not installed.
"""
import copy
import importlib.util
import os
import pickle
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import gwatershed


def needs(name):
    return unittest.skipUnless(importlib.util.find_spec(name), "needs " + name)


def make_image(height=96, width=128):
    y, x = np.mgrid[0:height, 0:width]
    image = np.stack([x * 255 // width, y * 255 // height, 128 + 60 * np.sin(x / 5.0 + y / 7.0)], axis=-1)
    return image.astype(np.uint8)


class Named(gwatershed.SuperpixelGWatershed):

    def __init__(self, name):
        super().__init__()
        self.name = name


def class_labels(image, *arguments, **parameters):
    gws = gwatershed.SuperpixelGWatershed(**parameters)
    gws.iterate(image, *arguments)
    return gws.getLabels()


class ArraysTest(unittest.TestCase):

    def assert_same_labels(self, one, other, **parameters):
        np.testing.assert_array_equal(class_labels(one, **parameters), class_labels(other, **parameters))

    def test_strides(self):
        image = make_image()
        wide = np.repeat(image, 2, axis=1)
        fortran = np.asfortranarray(image)
        four = np.dstack([image, image[:, :, 0]])
        for view in (image[::-1], image[:, ::-1], image[:, :, ::-1], wide[:, ::2], image.transpose(1, 0, 2), fortran,
                     image[3:50, 5:70], four[:, :, :3], image[:1], image[:, :1], image[::2],
                     np.broadcast_to(image[5], image.shape)):
            self.assert_same_labels(view, np.ascontiguousarray(view))

    def test_byte_order_and_alignment(self):
        image = make_image().astype(np.uint16) * 257
        self.assert_same_labels(image.astype(">u2"), image)
        raw = np.zeros(image.nbytes + 1, np.uint8)
        odd = raw[1:].view(np.uint16).reshape(image.shape)
        odd[:] = image
        self.assert_same_labels(odd, image)

    def test_copies_only_what_it_must(self):
        """Peak memory, each in a program of its own: a picture of 48 MB counts once more where it is copied."""
        program = ("import sys, numpy as np, gwatershed\n"
                   "wide = np.zeros((4000, 4000, 4), np.uint8)\n"
                   "image = np.lib.stride_tricks.as_strided(wide, (4000, 4000, 3), (12016, 3, 1))\n"
                   "gws = gwatershed.SuperpixelGWatershed(region_size=40)\n"
                   "gwatershed.setNumThreads(1)\n"
                   "gws.iterate(image[:, :, ::int(sys.argv[1])])\n"
                   "print(next(line.split()[1] for line in open('/proc/self/status') if 'VmHWM' in line))\n")
        peak = [int(subprocess.run([sys.executable, "-c", program, step], stdout=subprocess.PIPE, check=True).stdout)
                for step in ("1", "-1")]
        self.assertGreater(peak[1] - peak[0], 40000)

    def test_images_are_not_written_to(self):
        image = make_image()
        image.flags.writeable = False
        kept = image.copy()
        class_labels(image)
        np.testing.assert_array_equal(image, kept)

    def test_things_with_an_array(self):
        class Picture:
            def __array__(self, dtype=None):
                return make_image()
        self.assert_same_labels(Picture(), make_image())

    def test_refuses_what_is_no_image(self):
        gws = gwatershed.SuperpixelGWatershed()
        image = make_image()
        for wrong in (image.astype(bool), image.astype(str), image.astype(complex), image[None], image[:, :, :0],
                      image[0, 0], image[:0], np.dstack([image, image]), np.zeros((4, 4, 2000), np.uint8)):
            with self.assertRaises(ValueError):
                gws.iterate(wrong)
        for wrong in ("image.png", [[1, 2], [3, 4]], 2.5, object()):
            with self.assertRaises(TypeError):
                gws.iterate(wrong)

    def test_bool_masks(self):
        image = make_image()
        inside = np.zeros(image.shape[:2], bool)
        inside[10:60, 20:90] = True
        gws = gwatershed.SuperpixelGWatershed()
        for mask in (inside, inside.astype(np.uint8), np.asfortranarray(inside)):
            gws.setMask(mask)
            gws.iterate(image)
            np.testing.assert_array_equal(gws.getLabels() >= 0, inside)

    def test_integers_of_64_bits(self):
        image = make_image()
        gws = gwatershed.createSuperpixelGWatershed(image)
        markers = np.zeros(image.shape[:2], np.int64)
        markers[3, 4], markers[40, 60] = 5, 2**31 - 1
        gws.setMarkers(markers)
        gws.iterate()
        self.assertEqual(gws.getNumberOfSuperpixels(), 2)
        self.assertRaisesRegex(ValueError, "must be CV_32SC1", gws.setMarkers, markers / 2)
        markers[3, 4] = 2**31
        self.assertRaisesRegex(ValueError, "markers must have integers", gws.setMarkers, markers)
        for dtype, most in ((np.int64, 2**53 - 1), (np.uint64, 2**53 - 1), (np.uint32, 2**32 - 1)):
            values = np.full(image.shape[:2], most, dtype)
            np.testing.assert_array_equal(gws.getStatistics(values, None)[2], np.full((2, 1), most, np.float32))
        for dtype in (np.int64, np.uint64):
            values = np.full(image.shape[:2], 2**53, dtype)
            self.assertRaisesRegex(ValueError, "image must have integers", gws.getStatistics, values, None)

    def test_outputs_into_arrays(self):
        image = make_image()
        gws = gwatershed.createSuperpixelGWatershed(image)
        gws.iterate()
        labels = np.zeros(image.shape[:2], np.int32)
        self.assertIs(gws.getLabels(labels), labels)
        np.testing.assert_array_equal(labels, gws.getLabels())
        wide = np.zeros((image.shape[0], 2 * image.shape[1]), np.int32)
        part = wide[:, :image.shape[1]]
        self.assertIs(gws.getLabels(labels_out=part), part)
        np.testing.assert_array_equal(part, labels)
        self.assertIsNot(gws.getLabels(np.zeros((3, 3), np.int32)), labels)
        with self.assertRaises(ValueError):
            gws.getLabels(wide[:, ::2])
        gws.getLabels()[:] = 7  # a copy
        np.testing.assert_array_equal(gws.getLabels(), labels)

    def test_labels_outlive_the_object(self):
        labels = class_labels(make_image())
        other = class_labels(make_image()[::-1])
        self.assertEqual(len(np.unique(labels)), labels.max() + 1)
        self.assertEqual(other.shape, labels.shape)


class ObjectTest(unittest.TestCase):

    PARAMETERS = dict(algorithm=gwatershed.GWATERSHED, num_superpixels=77, ruler=3.7, effort=2, alpha=0.3,
                      lab_input=True, temporal=True, depth_range=(0.4, 4.1), value_range=(-7.5, 9),
                      border_threshold=99.5,
                      focal_length=(525, 520), normal_weight=0.5, depth_adaptive=True)

    def test_constructor(self):
        gws = gwatershed.SuperpixelGWatershed()
        self.assertEqual((gws.getRegionSize(), gws.getAlgorithm()), (10, gwatershed.RGWATERSHED))
        self.assertRaises(RuntimeError, gws.iterate)
        gws = gwatershed.SuperpixelGWatershed(**self.PARAMETERS)
        self.assertEqual(gws.getDesiredSuperpixels(), 77)
        self.assertEqual(np.float32(gws.getRuler()), np.float32(3.7))
        self.assertRaises(TypeError, gwatershed.SuperpixelGWatershed, 20)
        self.assertRaises(TypeError, gwatershed.SuperpixelGWatershed, rule=20)
        self.assertRaises(TypeError, gwatershed.SuperpixelGWatershed, ruler="x")
        self.assertRaises(TypeError, gwatershed.SuperpixelGWatershed, depth_range=3)
        self.assertRaises(ValueError, gwatershed.SuperpixelGWatershed, alpha=2)

    def test_copies_have_the_parameters(self):
        gws = gwatershed.SuperpixelGWatershed(**self.PARAMETERS)
        gws.iterate(make_image())
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            self.assert_copy(gws, pickle.loads(pickle.dumps(gws, protocol)))
        self.assert_copy(gws, copy.copy(gws))
        self.assert_copy(gws, copy.deepcopy(gws))

    def test_copies_of_a_derived_class(self):
        gws = Named("a")
        gws.setRuler(3)
        for twin in (copy.copy(gws), copy.deepcopy(gws), pickle.loads(pickle.dumps(gws))):
            self.assertEqual((type(twin), twin.name, twin.getRuler()), (Named, "a", 3))

    def assert_copy(self, gws, twin):
        self.assertEqual(twin.write(), gws.write())
        self.assertTrue(twin.empty())
        twin.setRuler(1)
        self.assertNotEqual(twin.write(), gws.write())

    def test_refuses_what_it_cannot_write_to(self):
        gws = gwatershed.SuperpixelGWatershed(region_size=8)
        with self.assertRaisesRegex(ValueError, "filename"):
            gws.save("/no/such/folder/parameters.yml")
        gws.iterate(make_image())
        with self.assertRaisesRegex(ValueError, "byte order"):
            gws.getLabels(np.zeros((96, 128), np.dtype(np.int32).newbyteorder()))
        with self.assertRaisesRegex(ValueError, "int64"):
            gws.getLabels(np.zeros((96, 128), np.int64))
        with self.assertRaisesRegex(TypeError, "by name"):
            gws.getLabelContourMask(False)

    def test_saved_parameters(self):
        gws = gwatershed.SuperpixelGWatershed(**self.PARAMETERS)
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "parameters.yml")
            gws.save(name)
            with open(name) as file:
                self.assertIn("num_superpixels: 77", file.read())
        twin = gwatershed.SuperpixelGWatershed()
        before = twin.write()
        self.assertRaises(ValueError, twin.read, "{}")
        self.assertRaisesRegex(ValueError, "parameters must", twin.read, "")
        self.assertRaises(ValueError, twin.read, before.replace('"alpha"', '"beta"'))
        self.assertEqual(twin.write(), before)
        for kind in ("yml", "xml", "json"):
            text = self.text_of_saved(gws, "parameters." + kind)
            twin = gwatershed.SuperpixelGWatershed()
            twin.read(text)
            self.assertEqual(twin.write(), gws.write())

    def text_of_saved(self, gws, name):
        with tempfile.TemporaryDirectory() as folder:
            gws.save(os.path.join(folder, name))
            with open(os.path.join(folder, name)) as file:
                return file.read()

    def test_none_is_no_depth(self):
        image = make_image()
        expected = class_labels(image)
        np.testing.assert_array_equal(class_labels(image, None), expected)
        np.testing.assert_array_equal(class_labels(image, None, 1), expected)
        gws = gwatershed.createSuperpixelGWatershed(image, None, gwatershed.RGWATERSHED, 10)
        gws.iterate()
        np.testing.assert_array_equal(gws.getLabels(), expected)

    def test_none_is_no_image(self):
        gws = gwatershed.createSuperpixelGWatershed(make_image())
        for call in gws.iterate, gwatershed.createSuperpixelGWatershed:
            self.assertRaisesRegex(TypeError, "imread", call, None)
        self.assertEqual(gws.getNumberOfSuperpixels(), 0)
        gws.iterate()
        gws.iterate(num_iterations=2)

    def test_numbers_are_not_cut_off(self):
        image = make_image()
        gws = gwatershed.createSuperpixelGWatershed(image)
        gws.iterate()
        for call in (gws.setRegionSize, gws.setDesiredSuperpixels, gws.setEffort, gws.setAlgorithm, gws.iterate,
                     gws.mergeSimilar, gws.mergeSmall, gws.enforceLabelConnectivity, gwatershed.setNumThreads):
            self.assertRaises(TypeError, call, np.float32(2.7))
        self.assertRaises(TypeError, gws.iterate, image, np.float32(2.7))
        self.assertRaises(TypeError, gwatershed.createSuperpixelGWatershed, image, region_size=np.float32(20.7))
        self.assertRaises(TypeError, gwatershed.SuperpixelGWatershed, region_size=np.float32(20.7))
        gws.setRegionSize(np.int16(20))
        gws.setRuler(7)
        self.assertEqual((gws.getRegionSize(), gws.getRuler()), (20, 7))

    def test_version(self):
        self.assertRegex(gwatershed.__version__, r"^\d+\.\d+\.\d+$")

    def test_errors_have_our_text(self):
        image = make_image()
        gws = gwatershed.createSuperpixelGWatershed(image)
        for kind, text, call in (
                (ValueError, "^ruler must be 0 or more, and finite; 'value' is -1$", lambda: gws.setRuler(-1)),
                (ValueError, "^image must have 1 to 4 channels", lambda: gws.iterate(np.dstack([image, image]))),
                (ValueError, "^image must not be empty$", lambda: gws.iterate(image[:0])),
                (ValueError, "^depth must have the size of image; .*96", lambda: gws.iterate(image, image[:9, :, 0])),
                (RuntimeError, "^There is no segmentation: call iterate", gws.getLabels),
                (RuntimeError, "^There is no image: call iterate", gwatershed.SuperpixelGWatershed().iterate)):
            with self.assertRaisesRegex(kind, text):
                call()

    def test_needs_no_cv2(self):
        program = "import sys, gwatershed; sys.exit('cv2' in sys.modules)"
        self.assertEqual(subprocess.run([sys.executable, "-c", program], check=False).returncode, 0)

    def test_lack_of_memory(self):
        program = ("import resource, numpy, gwatershed\n"
                   "gws = gwatershed.SuperpixelGWatershed(region_size=50)\n"
                   "image = numpy.zeros((5000, 5000), numpy.uint8)\n"
                   "gwatershed.setNumThreads(1)\n"
                   "gws.iterate(image[:100, :100])\n"
                   "used = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()\n"
                   "resource.setrlimit(resource.RLIMIT_AS, (used + 100000000, -1))\n"
                   "try:\n    gws.iterate(image)\nexcept MemoryError as error:\n    print(error)\n"
                   "gws.iterate(image[:100, :100])\n")
        output = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, check=True, env=os.environ)
        self.assertRegex(output.stdout.decode(), "Not enough memory|Failed to allocate")

    def test_the_interpreter_runs_meanwhile(self):
        image = np.tile(make_image(), (16, 16, 1))
        gws = gwatershed.SuperpixelGWatershed(region_size=20)
        thread = threading.Thread(target=gws.iterate, args=(image,))
        thread.start()
        began = time.perf_counter()
        steps = 0
        while thread.is_alive():
            steps += 1
            time.sleep(0.001)
        thread.join()
        self.assertGreater(steps, 0.05 * (time.perf_counter() - began) / 0.001)

    def test_threads_share_an_object(self):
        images = [make_image(), make_image()[::-1].copy()]
        sizes = {image.shape: class_labels(image).max() for image in images}
        gws = gwatershed.SuperpixelGWatershed()

        def work(image):
            for _ in range(20):
                gws.iterate(image)
                self.assertIn(gws.getLabels().max(), sizes.values())
        threads = [threading.Thread(target=work, args=(image,)) for image in images]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(gws.getLabels().max(), sizes[images[0].shape])


class StubsTest(unittest.TestCase):

    @needs("mypy")
    def test_mypy_accepts_a_program(self):
        program = ("import numpy as np\nimport gwatershed\n"
                   "image = np.zeros((60, 80, 3), np.uint8)\n"
                   "gws = gwatershed.createSuperpixelGWatershed(image, region_size=20)\n"
                   "gws.iterate()\ngws.iterate(image)\ngws.iterate(image, image[:, :, 0], num_iterations=2)\n"
                   "labels = gws.getLabels()\nnumber: int = labels.max()\n"
                   "other = gwatershed.SuperpixelGWatershed(ruler=5, depth_range=(1, 4))\n"
                   "table = gwatershed.superpixels(gwatershed.segment(image, region_size=20), image)\n")
        self.assertEqual(self.check(program), "")
        self.assertIn("ruler", self.check("import gwatershed\ngwatershed.SuperpixelGWatershed(ruler='x')\n"))
        self.assertIn("iterated", self.check("import gwatershed\ngwatershed.SuperpixelGWatershed().iterated()\n"))

    def check(self, program):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "program.py")
            with open(name, "w") as file:
                file.write(program)
            place = os.path.dirname(os.path.dirname(gwatershed.__file__))
            installed = os.path.basename(place) in ("site-packages", "dist-packages")  # mypy looks there itself
            run = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--follow-imports=silent",
                                  "--no-error-summary", "--cache-dir", os.path.join(folder, "cache"), name],
                                 stdout=subprocess.PIPE, env=dict(os.environ, MYPYPATH="" if installed else place),
                                 cwd=folder, check=False)
            self.assertIn(run.returncode, (0, 1))  # 2: it could not check
            return run.stdout.decode()

    @needs("mypy")
    def test_stubs_name_what_there_is(self):
        with open(os.path.join(os.path.dirname(gwatershed.__file__), "_native.pyi")) as file:
            stub = file.read()
        for name in dir(gwatershed.SuperpixelGWatershed):
            if not name.startswith("_"):
                self.assertIn("def %s(" % name, stub)


if __name__ == "__main__":
    unittest.main()
