#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Superpixels of an image by cv2.ximgproc.SuperpixelGWatershed.

Writes OUTPUT_contours.png, OUTPUT_mean.png and OUTPUT_labels.png (16-bit; .tiff with 32 bits
for more than 65536 superpixels).
"""
import argparse
import sys
import time

import cv2 as cv
import numpy as np


def mean_colors(image, gws):
    """Each pixel gets the mean colour of its superpixel."""
    means = gws.getStatistics(image, None)[2]
    return means.round().astype(np.uint8)[gws.getLabels()]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("image", help="image file")
    parser.add_argument("-d", "--depth", help="depth of the image: 8- or 16-bit; 0 is missing")
    parser.add_argument("-o", "--output", default="gwatershed", help="beginning of the names of the pictures")
    parser.add_argument("-s", "--region_size", type=int, default=20, help="side of a superpixel in pixels")
    parser.add_argument("-k", "--superpixels", type=int, help="number of superpixels, instead of region_size")
    parser.add_argument("-r", "--ruler", type=float, default=10, help="compactness")
    parser.add_argument("-e", "--effort", type=int, default=1, help="from 0, the fastest, to 3, the best")
    parser.add_argument("-a", "--alpha", type=float, default=0.5, help="weight of colour against depth")
    parser.add_argument("-n", "--iterations", type=int, default=1, help="number of iterations")
    return parser.parse_args()


def reason(error):
    """What an exception of OpenCV says is wrong, without the expression that says so."""
    return error.err.splitlines()[0].lstrip("> ").split(" (expected")[0].rstrip(":")


def run(arguments):
    image = cv.imread(arguments.image, cv.IMREAD_COLOR)
    depth = cv.imread(arguments.depth, cv.IMREAD_UNCHANGED) if arguments.depth else None
    if image is None or (arguments.depth and depth is None):
        sys.exit("Cannot read the image " + arguments.image + " " + (arguments.depth or ""))

    gws = cv.ximgproc.createSuperpixelGWatershed(
        image, region_size=arguments.region_size, ruler=arguments.ruler)
    gws.setEffort(arguments.effort)
    gws.setAlpha(arguments.alpha)
    if arguments.superpixels is not None:
        gws.setDesiredSuperpixels(arguments.superpixels)
    start = time.perf_counter()
    if depth is None:
        gws.iterate(image, num_iterations=arguments.iterations)
    else:
        gws.iterate(image, depth, num_iterations=arguments.iterations)
    milliseconds = 1000 * (time.perf_counter() - start)

    labels = gws.getLabels()
    number = gws.getNumberOfSuperpixels()
    contours = image.copy()
    contours[gws.getLabelContourMask(thick_line=False) > 0] = (0, 0, 255)
    few = number <= 65536
    pictures = {
        "_contours.png": contours,
        "_mean.png": mean_colors(image, gws),
        "_labels.png" if few else "_labels.tiff": labels.astype(np.uint16) if few else labels,
    }
    for name, picture in pictures.items():
        if not (cv.haveImageWriter(name) and cv.imwrite(arguments.output + name, picture)):
            sys.exit("Cannot write " + arguments.output + name)
    print("%dx%d: %d superpixels in %.2f ms" % (image.shape[1], image.shape[0], number, milliseconds))


def main():
    arguments = parse_arguments()
    if not hasattr(cv, "ximgproc") or not hasattr(cv.ximgproc, "createSuperpixelGWatershed"):
        sys.exit("This cv2 has no ximgproc.createSuperpixelGWatershed: OpenCV was built without the module")
    try:
        run(arguments)
    except cv.error as error:
        sys.exit(reason(error))


if __name__ == "__main__":
    main()
