#!/usr/bin/env python3
"""Prints how the methods compare in two reports of opencv_perf_gwatershed, for scripts/perf.sh:

  perf_table.py ONE_THREAD.xml TWO_THREADS.xml
"""
import sys
import xml.etree.ElementTree as ElementTree

NAME = "%-36s"
REGION_SIZES = [3, 5, 10, 20, 40]
SIZES = [(640, 480), (1920, 1080), (3840, 2160)]
SUPERPIXELS_MERGED = 1600
PEERS = ["ScanSegment", "SLIC", "SEEDS", "watershed"]


def read(file):
    """Median milliseconds by method, width and region_size, or number of superpixels in the case of merging; also the
    numbers of superpixels, by the method with "_superpixels" behind it."""
    times = {}
    for case in ElementTree.parse(file).iter("testcase"):
        if not case.get("classname").startswith("Perf_Superpixels"):
            continue
        size, number = case.get("value_param").strip("()").split(", ")
        for item in case.iter("property"):
            key = item.get("name"), int(size.split("x")[0]), int(number)
            try:
                times[key] = float(item.get("value"))
            except ValueError:  # of the framework
                pass
    return times


def ratio(a, b):
    return a / b if a is not None and b else None


def print_row(name, values, width=8, digits=2):
    if any(value is not None for value in values):
        print(NAME % name + "".join("%*s" % (width, "-" if value is None else "%.*f" % (digits, value))
                                    for value in values))


def print_size(size, one, two):
    def row(times, method):
        return [times.get((method, size[0], region_size)) for region_size in REGION_SIZES]

    def print_ratios(name, dividend, divisor):
        print_row(name, list(map(ratio, dividend, divisor)))

    print("\n" + NAME % ("%dx%d, region_size" % size) + "".join("%8d" % region_size for region_size in REGION_SIZES))
    print_row("RGWATERSHED, ms", row(one, "RGWATERSHED"))
    print_row("RGWATERSHED, ns per pixel", [t and 1e6 * t / (size[0] * size[1]) for t in row(one, "RGWATERSHED")], 8, 1)
    print_row("GWATERSHED, ms", row(one, "GWATERSHED"))
    for peer in PEERS:
        print_ratios("%s / RGWATERSHED" % peer, row(one, peer), row(one, "RGWATERSHED"))
    for peer in PEERS:
        print_ratios("the same, two threads: %s" % peer, row(two, peer), row(two, "RGWATERSHED"))
    for peer in PEERS:
        print_ratios("superpixels of %s / asked for" % peer, row(one, peer + "_superpixels"),
                     row(one, "RGWATERSHED_superpixels"))
    print_ratios("watershed / GWATERSHED", row(one, "watershed"), row(one, "GWATERSHED"))
    for method in "RGWATERSHED", "GWATERSHED":
        print_ratios("one thread / two: %s" % method, row(one, method), row(two, method))
    for more in "depth", "2_iterations", "4_iterations":
        method = "RGWATERSHED_" + more
        print_ratios("%s / RGWATERSHED" % more.replace("_", " "), row(one, method), row(one, "RGWATERSHED"))


def print_growth(times):
    """How time grows as superpixels get smaller and images larger."""
    def ours(size, region_size):
        return times.get(("RGWATERSHED", size[0], region_size))

    def per_pixel(size, region_size):
        time = ours(size, region_size)
        return time and time / (size[0] * size[1])

    print("\n" + NAME % "RGWATERSHED, one thread" + "".join("%11s" % ("%dx%d" % size) for size in SIZES))
    for small in 10, 5, 3:
        print_row("region_size %d / 20" % small, [ratio(ours(size, small), ours(size, 20)) for size in SIZES], 11)
    for region_size in 10, 20:
        print_row("ns per pixel, region_size %d" % region_size,
                  [ratio(per_pixel(size, region_size), per_pixel(SIZES[0], region_size)) for size in SIZES], 11)
    first = times.get(("RGWATERSHED", 640, SUPERPIXELS_MERGED))
    print_row("mergeSimilar / iterate", [ratio(times.get(("mergeSimilar", 640, SUPERPIXELS_MERGED)), first)], 11)


def main():
    one, two = map(read, sys.argv[1:])
    for size in SIZES:
        print_size(size, one, two)
    print_growth(one)


if __name__ == "__main__":
    main()
