#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Draws what gwatershed_benchmark measured: the paper's figures 3 and 4 and its Table I.

Boundary recall, undersegmentation error and time against the number of superpixels delivered, as
one picture; the times also as a Markdown table on the standard output.
"""
import argparse
import csv
from collections import OrderedDict

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

PANELS = (("recall", "boundary recall (5)"), ("ue", "undersegmentation error (6)"), ("milliseconds", "time, ms"))


def read_means(name):
    """The rows of means, as dictionaries of numbers, by method in the order of the file."""
    methods = OrderedDict()
    with open(name, newline="") as file:
        for row in csv.DictReader(file):
            if row["image"] == "mean":
                values = {key: float(value) for key, value in row.items() if key not in ("method", "image")}
                methods.setdefault(row["method"], []).append(values)
    return methods


def draw(methods, title, output):
    figure, axes = plt.subplots(1, len(PANELS), figsize=(4.2 * len(PANELS), 3.8))
    for axis, (column, label) in zip(axes, PANELS):
        for method, rows in methods.items():
            ours = "GWATERSHED" in method
            axis.plot([row["superpixels"] for row in rows], [row[column] for row in rows], marker=".",
                      label=method, linewidth=2.2 if ours else 1, linestyle="-" if ours else "--")
        axis.set_xscale("log")
        axis.set_xlabel("number of superpixels")
        axis.set_title(label, fontsize=10)
        axis.grid(alpha=0.3)
    axes[-1].set_yscale("log")
    axes[0].legend(fontsize=7)
    figure.suptitle(title, fontsize=9)
    figure.tight_layout()
    figure.savefig(output, dpi=80, metadata={"Software": None})


def print_times(methods):
    asked = sorted({row["asked"] for rows in methods.values() for row in rows})
    print("| time in ms | " + " | ".join("N = %d" % number for number in asked) + " | mean |")
    print("|---" * (len(asked) + 2) + "|")
    for method, rows in methods.items():
        times = {row["asked"]: row["milliseconds"] for row in rows}
        cells = ["%.1f" % times[number] if number in times else "" for number in asked]
        print("| %s | %s | %.1f |" % (method, " | ".join(cells), sum(times.values()) / len(times)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("table", help="CSV file of gwatershed_benchmark")
    parser.add_argument("-o", "--output", default="benchmark.png", help="picture to write")
    parser.add_argument("-t", "--title", default="", help="line above the figures: data, machine, version")
    arguments = parser.parse_args()
    methods = read_means(arguments.table)
    draw(methods, arguments.title, arguments.output)
    print_times(methods)


if __name__ == "__main__":
    main()
