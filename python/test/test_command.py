#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""The commands, but what gwatershed-tiles does by tiles, and a sample. What needs Pillow, Zarr or Matplotlib is skipped
where that is not installed."""
import contextlib
import io
import os
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import warnings
import zlib

import numpy as np
from test_package import make_image, needs

import gwatershed
from gwatershed import command


def write_png_of_words(name, image):
    """Colours of 16 bits, which Pillow does not write."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + row.astype(">u2").tobytes() for row in image)
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", *image.shape[1::-1], 16, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def call(main, *arguments):
    """The exit code of a command, and what it prints."""
    output, errors = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
        try:
            code = main(list(arguments))
        except SystemExit as ended:
            code = ended.code
    return code, output.getvalue(), errors.getvalue()


class FolderCase(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)


@needs("PIL")
class CommandTest(FolderCase):

    def setUp(self):
        from PIL import Image
        super().setUp()
        self.image = make_image()
        Image.fromarray(self.image).save(self.path("image.png"))
        Image.fromarray(self.image[::-1]).save(self.path("other.png"))
        self.depth = np.where(np.arange(128) < 50, 1000, 3000).astype(np.uint16) * np.ones((96, 1), np.uint16)
        Image.fromarray(self.depth).save(self.path("depth.png"))

    def read(self, name):
        from PIL import Image
        return np.asarray(Image.open(self.path(name)))

    def run_command(self, *arguments):
        return call(command.main, *arguments)

    def test_pictures(self):
        code, output, _ = self.run_command(self.path("image.png"), "-o", self.path("out.png"), "--number", "40")
        self.assertEqual(code, 0)
        self.assertRegex(output, r"^1/1 .*image.png: 40 superpixels, \d+ ms\n$")
        self.assertTrue((self.read("out.png") == (255, 0, 0)).all(axis=2).any())
        for name in ("labels.png", "labels.tiff", "labels.npy"):
            self.run_command(self.path("image.png"), "-o", self.path(name), "--show", "labels", "-s", "12",
                             "-d", self.path("depth.png"))
            labels = np.load(self.path(name)) if name.endswith("npy") else self.read(name)
            expected = gwatershed.segment(self.image, 12, depth=self.depth)
            np.testing.assert_array_equal(labels, expected)
        self.run_command(self.path("image.png"), "-o", self.path("mean.png"), "--show", "mean")
        np.testing.assert_allclose(self.read("mean.png").mean(axis=(0, 1)), self.image.mean(axis=(0, 1)), atol=1)

    def test_many_files(self):
        code, output, errors = self.run_command(self.path("image.png"), self.path("none.png"), self.path("other.png"),
                                                "-o", self.path("results"))
        self.assertEqual(code, 1)
        self.assertEqual(sorted(os.listdir(self.path("results"))), ["image.png", "other.png"])
        self.assertEqual(output.count("\n"), 2)
        self.assertIn("none.png", errors)
        code, output, _ = self.run_command(self.path("image.png"), self.path("other.png"), "-q", "-o",
                                           self.path("results"))
        self.assertEqual((code, output), (0, ""))

    def test_more_than_8_bits(self):
        from PIL import Image
        gray = self.image.mean(axis=2).round().astype(np.uint8)
        expected = gwatershed.segment(gray, 12)
        for name, values in (("word.png", gray.astype(np.uint16) * 257), ("float.tiff", gray.astype(np.float32) / 255)):
            Image.fromarray(values).save(self.path(name))
            self.assertEqual(self.run_command(self.path(name), "-o", self.path("out.npy"), "--show", "labels", "-s",
                                              "12")[0], 0)
            np.testing.assert_array_equal(np.load(self.path("out.npy")), expected)
            self.run_command(self.path(name), "-o", self.path("mean.png"), "--show", "mean")
            self.assertEqual(self.read("mean.png").shape, self.image.shape)

    def test_refuses_colours_of_16_bits(self):
        head = b"P6 %d %d 65535\n" % self.image.shape[1::-1]
        with open(self.path("words.ppm"), "wb") as file:
            file.write(head + (self.image.astype(">u2") * 257).tobytes())
        write_png_of_words(self.path("words.png"), self.image.astype(np.uint16) * 16)
        for name in ("words.ppm", "words.png"):
            code, _, errors = self.run_command(self.path(name), "-o", self.path("out.npy"))
            self.assertEqual(code, 1, name)
            self.assertRegex(errors, "16 bits for each channel|Too many colors")  # the latter by Pillow before 9.1
        self.assertFalse(command.has_16_bits("raw", ("BGR;16", 0, 1)))  # for a pixel
        for decoder, details in (("SGI16", ("RGB", 0, -1)), ("ppm_plain", ("RGB", 65535)), ("raw", ("RGB;16L", 0, 1))):
            self.assertTrue(command.has_16_bits(decoder, details))

    def test_says_that_there_are_more_pages(self):
        from PIL import Image
        page, other = Image.fromarray(self.image), Image.fromarray(self.image[::-1])
        for name in ("pages.tiff", "pages.gif"):
            page.save(self.path(name), save_all=True, append_images=[other, page])
            code, _, errors = self.run_command(self.path(name), "-q", "-o", self.path("out.png"))
            self.assertEqual(code, 0)
            self.assertIn("the first of 3 pages", errors)
        self.assertEqual(self.run_command(self.path("image.png"), "-q", "-o", self.path("out.png")), (0, "", ""))

    def test_refuses_colours_and_bits_as_depth(self):
        from PIL import Image
        gray = Image.fromarray(self.image[:, :, 0])
        gray.convert("1").save(self.path("bits.png"))
        gray.quantize(30).save(self.path("palette.png"))
        for name in ("bits.png", "palette.png", "other.png"):
            code, _, errors = self.run_command(self.path("image.png"), "-d", self.path(name), "-o", self.path("x.png"))
            self.assertEqual(code, 1)
            self.assertIn("depth must be grey", errors)

    def test_icons(self):
        from PIL import Image
        for name in ("image.ico", "image.icns"):
            Image.fromarray(self.image[:64, :64]).save(self.path(name))
            self.assertEqual(self.run_command(self.path(name), "-q", "-o", self.path("out.png")), (0, "", ""))

    def test_flat_images_need_no_warning(self):
        from PIL import Image
        Image.fromarray(np.full((40, 50), 3000, np.uint16)).save(self.path("flat.png"))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertEqual(self.run_command(self.path("flat.png"), "-q", "-o", self.path("out.png")), (0, "", ""))

    def test_outlier_does_not_darken_the_picture(self):
        from PIL import Image
        gray = self.image.mean(axis=2).round().astype(np.uint16)
        gray[5, 5] = 60000
        Image.fromarray(gray).save(self.path("hot.png"))
        self.run_command(self.path("hot.png"), "-o", self.path("mean.png"), "--show", "mean")
        self.assertGreater(np.median(self.read("mean.png")), 100)

    def test_names_of_outputs(self):
        for name in ("labels.NPY", "new/"):
            code = self.run_command(self.path("image.png"), "--show", "labels", "-o", self.path(name))[0]
            self.assertEqual(code, 0, name)
        self.assertEqual(np.load(self.path("labels.NPY")).shape, (96, 128))
        self.assertEqual(os.listdir(self.path("new")), ["image.tiff"])

    def test_version(self):
        self.assertEqual(self.run_command("--version")[:2], (0, "gwatershed %s\n" % gwatershed.__version__))

    def test_photographs_of_a_turned_camera(self):
        from PIL import Image
        turned = Image.Exif()
        turned[0x0112] = 6  # the camera says: turn it to the right
        Image.fromarray(np.rot90(self.image)).save(self.path("turned.png"), exif=turned)
        Image.fromarray(np.rot90(self.image)).save(self.path("turned.tiff"), exif=turned)
        Image.fromarray(np.rot90(self.depth)).save(self.path("turned_depth.png"), exif=turned)
        Image.fromarray(np.rot90(self.depth)).save(self.path("turned_depth.tiff"), exif=turned)
        Image.fromarray(self.image).save(self.path("damaged.png"), exif=turned.tobytes()[:-9])
        gray = self.image[..., 0]
        Image.fromarray(np.rot90(gray)).save(self.path("turned_gray.tiff"), exif=turned)
        for name, depth in (("turned.png", None), ("turned.png", "turned_depth.png"), ("damaged.png", None),
                            ("turned.tiff", None), ("turned.png", "turned_depth.tiff"), ("turned_gray.tiff", None)):
            arguments = ["-d", self.path(depth)] if depth else []
            self.run_command(self.path(name), "-o", self.path("out.npy"), "--show", "labels", "-s", "12", *arguments)
            expected = gwatershed.segment(gray if "gray" in name else self.image, 12,
                                          depth=self.depth if depth else None)
            np.testing.assert_array_equal(np.load(self.path("out.npy")), expected)
            os.remove(self.path("out.npy"))

    def test_inputs_and_labels_are_kept(self):
        before = self.read("image.png")
        for output in (self.path("image.png"), self.folder.name):
            code, _, errors = self.run_command(self.path("image.png"), "-o", output)
            self.assertEqual(code, 1)
            self.assertIn("another file", errors)
        np.testing.assert_array_equal(self.read("image.png"), before)
        for name in ("labels.gif", "labels.webp"):
            self.assertEqual(self.run_command(self.path("image.png"), "-o", self.path(name), "--show", "labels")[0], 1)

    @needs("resource")
    def test_full_disk(self):
        import resource
        with open(self.path("there.bmp"), "wb") as file:
            file.write(b"kept")
        before = sorted(os.listdir(self.folder.name))
        for name in ("out.bmp", "out.jpg", "out.ppm", "out.png", "out.npy", "there.bmp"):
            run = subprocess.run([sys.executable, "-m", "gwatershed", self.path("image.png"), "-o", self.path(name)],
                                 stderr=subprocess.PIPE, stdout=subprocess.PIPE, check=False,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (99, 99)))
            self.assertEqual(run.returncode, 1, name)
            self.assertRegex(run.stderr.decode(), r"^gwatershed: .*: '.*%s'\n$" % name)
            self.assertEqual(sorted(os.listdir(self.folder.name)), before, name)
        with open(self.path("there.bmp"), "rb") as file:
            self.assertEqual(file.read(), b"kept")

    def test_folders_that_are_none(self):
        for name in ("none/x.png", "image.png/x.png"):
            code, _, errors = self.run_command(self.path("image.png"), "-o", self.path(name))
            self.assertEqual(code, 1)
            self.assertRegex(errors, r"^gwatershed: .*: '.*%s'\n$" % name)

    def test_replaces_what_a_link_names(self):
        with open(self.path("there.png"), "w"):
            pass
        os.chmod(self.path("there.png"), 0o640)
        os.symlink("there.png", self.path("link.png"))
        self.assertEqual(self.run_command(self.path("image.png"), "-o", self.path("link.png"))[0], 0)
        self.assertTrue(os.path.islink(self.path("link.png")))
        self.assertEqual(self.read("there.png").shape, self.image.shape)
        self.assertEqual(os.stat(self.path("there.png")).st_mode & 0o777, 0o640)
        if os.path.exists("/dev/full"):
            os.symlink("/dev/full", self.path("full.png"))
            code, _, errors = self.run_command(self.path("image.png"), "-o", self.path("full.png"))
            self.assertEqual(code, 1)
            self.assertIn("No space left", errors)
            self.assertFalse(os.path.isfile("/dev/full"))

    def test_labels_of_more_than_16_bits(self):
        from PIL import Image
        Image.fromarray(np.zeros((260, 260, 3), np.uint8)).save(self.path("large.png"))
        many = (self.path("large.png"), "--show", "labels", "-s", "1", "-o")
        for name in ("many.tiff", "many.npy"):
            self.assertEqual(self.run_command(*many, self.path(name))[0], 0)
            labels = np.load(self.path(name)) if name.endswith("npy") else self.read(name)
            self.assertEqual(len(np.unique(labels)), 260 * 260)
        code, _, errors = self.run_command(*many, self.path("many.png"))
        self.assertEqual(code, 1)
        self.assertIn(".tiff", errors)
        self.assertFalse(os.path.exists(self.path("many.png")))
        os.mkdir(self.path("folder"))
        self.assertEqual(self.run_command(*many, self.path("folder"))[0], 0)
        self.assertEqual(len(np.unique(self.read(os.path.join("folder", "large.tiff")))), 260 * 260)

    def test_wrong_arguments(self):
        image = self.path("image.png")
        for wrong in ([], [image], [image, "-o", "x.png", "-k", "many"], [image, "-o", "x.png", "-k", "3", "-s", "3"],
                      [image, image, "-o", "x"], [image, self.path("other.png"), "-o", "x", "-d", image]):
            self.assertEqual(self.run_command(*wrong)[0], 2, wrong)
        for wrong in (["-k", "0"], ["-r", "-1"], ["-n", "0"], ["-d", self.path("other.png")]):
            code, _, errors = self.run_command(image, "-o", self.path("x.png"), *wrong)
            self.assertEqual(code, 1, wrong)
            self.assertIn("must be", errors)
        self.assertEqual(self.run_command("--help")[0], 0)

    def test_outputs_that_are_none(self):
        image, other, before = self.path("image.png"), self.path("other.png"), sorted(os.listdir(self.folder.name))
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder.name)
        for output, images, text in (("", [image], "must be the name of a file or a folder"),
                                     (self.path("depth.png"), [image, other], "must be a folder for several")):
            code, _, errors = self.run_command(*images, "-o", output)
            self.assertEqual(code, 2)
            self.assertIn(text, errors)
            self.assertEqual(sorted(os.listdir(self.folder.name)), before)

    def test_names_the_file_that_is_no_image(self):
        with open(self.path("text.png"), "w") as file:
            file.write("text")
        for images in ([self.path("text.png")], [self.path("image.png"), "-d", self.path("text.png")]):
            code, _, errors = self.run_command(*images, "-o", self.path("x.png"))
            self.assertEqual(code, 1)
            self.assertRegex(errors, r"^gwatershed: .*text\.png is no image that Pillow reads\n$")

    def test_says_in_a_line_that_depth_is_not_valid(self):
        from PIL import Image
        Image.fromarray(self.depth * 0).save(self.path("zero.png"))
        for _ in range(2):
            code, _, errors = self.run_command(self.path("image.png"), "-o", self.path("x.png"), "-d",
                                               self.path("zero.png"))
            self.assertEqual(code, 0)
            self.assertRegex(errors, r"^gwatershed: .*image\.png: depth has no valid value.*\n$")

    def start(self, *arguments, **streams):
        return subprocess.Popen([sys.executable, "-m", "gwatershed", *arguments], stderr=subprocess.PIPE, **streams,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))

    def test_goes_on_where_nothing_can_be_printed(self):
        images = self.path("image.png"), self.path("other.png"), "-o"
        reading, writing = os.pipe()
        os.close(reading)
        with os.fdopen(writing, "w") as closed, open("/dev/full", "w") as full:
            for name, stdout in (("closed", closed), ("full", full)):
                process = self.start(*images, self.path(name), stdout=stdout)
                self.assertRegex(process.communicate()[1], rb"^gwatershed: standard output: .*\n$")
                self.assertEqual(process.returncode, 1)
                self.assertEqual(sorted(os.listdir(self.path(name))), ["image.png", "other.png"])

    def test_stopped(self):
        images = [self.path("%d.png" % i) for i in range(400)]
        for name in images:
            os.symlink("image.png", name)
        process = self.start(*images, "-o", self.path("stopped"), stdout=subprocess.PIPE)
        process.stdout.readline()
        process.send_signal(signal.SIGINT)
        self.assertEqual((process.communicate()[1], process.returncode), (b"gwatershed: stopped\n", 130))
        self.assertFalse([name for name in os.listdir(self.path("stopped")) if name.startswith(".")])

    def test_as_a_module(self):
        call = [sys.executable, "-m", "gwatershed", self.path("none.png"), "-o", self.path("x.png")]
        self.assertEqual(subprocess.run(call, stderr=subprocess.DEVNULL, check=False).returncode, 1)


@needs("dask")
@needs("zarr")
class TilesCommandTest(FolderCase):
    """What of gwatershed-tiles needs no tiles."""

    def setUp(self):
        import zarr
        super().setUp()
        zarr.open(self.path("image.zarr"), mode="w", shape=(40, 50), chunks=(20, 20), dtype=np.uint8)[:] = 90

    def run_command(self, *arguments):
        from gwatershed.tiles.command import main
        return call(main, *arguments)

    def test_help_says_what_all_arguments_are(self):
        code, output, _ = self.run_command("--help")
        self.assertEqual(code, 0)
        for option in ("region-size", "ruler", "effort", "alpha", "iterations", "bands", "value-range", "depth-range",
                       "focal-length", "tile-size", "scheduler", "workers"):
            self.assertRegex(output, r"\n  --%s (?:(?!\n  -)[\s\S])*default" % option)
        self.assertRegex(output, r"\n  --depth FILE +depth of")

    def test_outputs_that_cannot_be_written(self):
        with open(self.path("file"), "w"):
            pass
        for output in ("/proc/file.zarr", self.path("file/labels.zarr")):
            code, _, errors = self.run_command(self.path("image.zarr"), output, "--tile-size", "320")
            self.assertEqual(code, 1)
            self.assertRegex(errors, r"^gwatershed-tiles: .*file.*\n$")


@needs("matplotlib")
class PlotTest(FolderCase):
    """The sample gwatershed_plot.py."""

    def plot(self, table, picture):
        script = pathlib.Path(__file__).resolve().parents[2] / "samples" / "gwatershed_plot.py"
        return subprocess.run([sys.executable, str(script), self.path(table), "-o", self.path(picture)],
                              stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, check=False)

    def test_errors_in_one_line(self):
        head = "method,image,asked,superpixels,recall,ue,milliseconds\n"
        for name, rows in (("table.csv", "SLIC,mean,100,99,0.5,0.1,3\nSLIC,mean,200,199,0.6,0.09,3\n"),
                           ("text.csv", "SLIC,mean,100,99,x,0.1,3\n"), ("short.csv", "SLIC,mean,100\n")):
            with open(self.path(name), "w") as file:
                file.write(head + rows)
        with open(self.path("columns.csv"), "w") as file:
            file.write("method,image\nSLIC,mean\n")
        for picture in ("out.png", "out.jpg", "out.svg"):
            self.assertEqual(self.plot("table.csv", picture).returncode, 0, picture)
        for table, picture in (("none.csv", "x.png"), ("text.csv", "x.png"), ("short.csv", "x.png"),
                               ("columns.csv", "x.png"), ("table.csv", "x.xyz"), ("table.csv", "none/x.png")):
            run = self.plot(table, picture)
            self.assertEqual((run.returncode, run.stderr.count(b"\n")), (1, 1), (table, picture))


@needs("cv2")
class DemoTest(FolderCase):
    """The sample gwatershed_demo.py beside a cv2 without the module; scripts/test.sh runs it beside one with it."""

    def test_says_that_the_module_is_missing(self):
        import cv2
        if hasattr(cv2, "ximgproc") and hasattr(cv2.ximgproc, "createSuperpixelGWatershed"):
            self.skipTest("cv2 has the module")
        cv2.imwrite(self.path("image.png"), make_image())
        script = pathlib.Path(__file__).resolve().parents[2] / "samples" / "gwatershed_demo.py"
        run = subprocess.run([sys.executable, str(script), self.path("image.png")], cwd=self.folder.name,
                             stderr=subprocess.PIPE, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, rb"^This cv2 has no ximgproc.createSuperpixelGWatershed: .*\n$")


if __name__ == "__main__":
    unittest.main()
