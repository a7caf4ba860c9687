#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""Draws what gwatershed_benchmark measured, as figures 3 and 4 and Table I of the paper do.

One picture shows boundary recall, undersegmentation error and time against the number of superpixels delivered. The
times are also printed as a Markdown table.
"""
import argparse
import csv
import sys
from collections import OrderedDict
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import NullLocator

PANELS = (("recall", "boundary recall"), ("ue", "undersegmentation error"), ("milliseconds", "time in ms"))
METHODS = "RGWATERSHED,SLIC,SEEDS,LSC,ScanSegment"
COLORS = ("#d62728", "#1f77b4", "#2ca02c", "#9467bd", "#7f7f7f", "#8c564b", "#e377c2", "#17becf")
LABEL_HEIGHT = 0.1  # of a panel


def read_means(name):
    """The rows of means, as dictionaries of numbers, by method in the order of the file."""
    methods = OrderedDict()
    with open(name, newline="") as file:
        for row in csv.DictReader(file):
            if row["image"] == "mean":
                values = {key: float(value) for key, value in row.items() if key not in ("method", "image")}
                methods.setdefault(row["method"], []).append(values)
    return methods


def spread(positions):
    """Moves positions apart so that labels do not overlap; keeps their order."""
    order = sorted(range(len(positions)), key=lambda i: positions[i])
    result = list(positions)
    for last, i in zip(order, order[1:]):
        result[i] = max(result[i], result[last] + LABEL_HEIGHT)
    overlap = max(0, result[order[-1]] - 1)
    return [position - overlap for position in result]


def label_curves(axis):
    """Writes the names of the curves beside their right ends."""
    lines = axis.get_lines()
    to_panel = axis.transData + axis.transAxes.inverted()
    ends = [to_panel.transform((line.get_xdata()[-1], line.get_ydata()[-1]))[1] for line in lines]
    for line, y in zip(lines, spread(ends)):
        axis.text(1.04, y, line.get_label(), color=line.get_color(), transform=axis.transAxes, va="center")


def draw(methods, title, output):
    plt.rcParams.update({"font.size": 18})
    figure, axes = plt.subplots(1, len(PANELS), figsize=(18, 5.4))
    asked = sorted({int(row["asked"]) for rows in methods.values() for row in rows})
    for axis, (column, label) in zip(axes, PANELS):
        for (method, rows), color in zip(methods.items(), COLORS):
            axis.plot([row["superpixels"] for row in rows], [row[column] for row in rows], marker="o", markersize=5,
                      label=method, color=color, linewidth=4 if "GWATERSHED" in method else 2)
        axis.set_xscale("log")
        axis.set_xticks(asked[::2])
        axis.set_xticklabels(asked[::2])
        axis.xaxis.set_minor_locator(NullLocator())
        axis.set_xlabel("number of superpixels")
        axis.set_title(label)
        axis.grid(alpha=0.4)
    axes[-1].set_yscale("log")
    axes[-1].yaxis.set_major_formatter("{x:g}")
    label_curves(axes[-1])
    figure.suptitle(title, fontsize=16)
    figure.tight_layout()
    is_png = Path(output).suffix.lower() in ("", ".png")
    figure.savefig(output, dpi=72, **({"metadata": {"Software": None}} if is_png else {}))  # others do not know it


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
    parser.add_argument("-m", "--methods", default=METHODS, help="methods to draw, up to %d" % len(COLORS))
    parser.add_argument("-t", "--title", default="", help="line above the figures: data, machine, version")
    arguments = parser.parse_args()
    try:
        methods = read_means(arguments.table)
    except KeyError as error:
        sys.exit("%s has no column %s" % (arguments.table, error))
    except (OSError, ValueError, TypeError, csv.Error) as error:
        sys.exit("Cannot read %s: %s" % (arguments.table, error))
    wanted = [method for method in arguments.methods.split(",") if method in methods][:len(COLORS)]
    if not wanted:
        parser.error("none of these methods is in the table: " + arguments.methods)
    try:
        draw(OrderedDict((method, methods[method]) for method in wanted), arguments.title, arguments.output)
    except KeyError as error:
        sys.exit("%s has no column %s" % (arguments.table, error))
    except (OSError, ValueError) as error:
        sys.exit("Cannot write %s: %s" % (arguments.output, error))
    print_times(methods)


if __name__ == "__main__":
    main()
