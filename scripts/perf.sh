#!/usr/bin/env bash
# Times RGWATERSHED, GWATERSHED and their peers by opencv_perf_gwatershed and prints how they compare:
#   scripts/perf.sh                     runs it with one thread, kept on one processor, and with two; about six minutes
#   scripts/perf.sh ONE.xml [TWO.xml]   reports of runs of yours, --gtest_output=xml:ONE.xml, with one and two threads
# scripts/test.sh must have been run before the first form; OPENCV_VERSION is as there.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if [ $# -eq 0 ]; then
    place=$cache/${OPENCV_VERSION:-4.6.0}
    program=$place/build/bin/opencv_perf_gwatershed
    [ -x "$program" ] || fail "there is no $program yet: run scripts/test.sh"
    export OPENCV_SAMPLES_DATA_PATH=$place/source/samples/data
    mkdir -p "$place/results"
    for threads in 1 2; do
        say "timing with $threads thread(s)"
        [ $threads = 1 ] && keep=(taskset -c $(($(nproc) - 1))) || keep=()
        "${keep[@]}" "$program" --perf_threads=$threads --perf_min_samples=18 --perf_force_samples=18 \
            '--gtest_filter=*color*:*rgbd*:*watershed/*:*SLIC/*:*SEEDS*:*ScanSegment*:*region_step*' \
            "--gtest_output=xml:$place/results/perf$threads.xml" >"$place/results/perf$threads.log" 2>&1 ||
            fail "$program ended with an error; see $place/results/perf$threads.log"
    done
    set -- "$place/results/perf1.xml" "$place/results/perf2.xml"
fi

python3 - "$@" <<'PYTHON'
import sys
import xml.etree.ElementTree as ElementTree

SIZES = ["640x480", "1280x720", "1920x1080", "3840x2160"]


def read(file):
    """Median milliseconds by class, test and parameters."""
    times = {}
    for case in ElementTree.parse(file).iter("testcase"):
        values = {p.get("name"): p.get("value") for p in case.iter("property")}
        values.update(case.attrib)
        if "median" in values:
            key = values["classname"], values["name"].split("/")[0], values["value_param"].strip("()")
            times[key] = 1000 * float(values["median"]) / float(values["frequency"])
    return times


def ours(times, algorithm, size, test="color"):
    return times.get(("Perf_GWatershed_" + test, test, "%s, %s" % (algorithm, size)))


def iterations(times, count, size):
    return times.get(("Perf_GWatershed_iterations_color", "color", "%d, %s" % (count, size)))


def peer(times, name, size):
    return times.get(("Perf_GWatershed_peer_" + name, name, size))


def step(times, name, size):
    return times.get(("Perf_GWatershed_region_step_region_step", "region_step", "%s, %s" % (name, size)))


def print_row(name, values, form="%.2f"):
    print("%-52s" % name + "".join("%12s" % (form % v if v is not None else "-") for v in values))


def ratio(a, b):
    return a / b if a and b else None


def pixels(size):
    width, height = size.split("x")
    return int(width) * int(height)


one = read(sys.argv[1])
two = read(sys.argv[2]) if len(sys.argv) > 2 else {}
region_guided = [ours(one, "RGWATERSHED", s) for s in SIZES]
plain = [ours(one, "GWATERSHED", s) for s in SIZES]
print("%-52s" % "" + "".join("%12s" % s for s in SIZES))
print_row("RGWATERSHED, ms, one thread", region_guided)
print_row("RGWATERSHED, ns per pixel", [t and 1e6 * t / pixels(s) for t, s in zip(region_guided, SIZES)], "%.1f")
for name in ("FEATURES", "MARKERS", "FLOOD", "SWEEP_OF_BLOCKS", "MERGING", "LABELS_OF_PIXELS",
             "SWEEP_OF_PIXELS"):
    print_row("  one of its steps: %s, ms" % name.lower(), [step(one, name, s) for s in SIZES])
for name in "SLIC", "SEEDS", "ScanSegment", "watershed":
    print_row("%s over RGWATERSHED" % name, [ratio(peer(one, name, s), t) for t, s in zip(region_guided, SIZES)])
print_row("GWATERSHED, ms, one thread", plain)
print_row("watershed over GWATERSHED", [ratio(peer(one, "watershed", s), t) for t, s in zip(plain, SIZES)])
print_row("RGWATERSHED, two threads: times as fast",
          [ratio(t, ours(two, "RGWATERSHED", s)) for t, s in zip(region_guided, SIZES)])
print_row("GWATERSHED, two threads: times as fast",
          [ratio(t, ours(two, "GWATERSHED", s)) for t, s in zip(plain, SIZES)])
second = [iterations(one, 2, s) for s in SIZES]
fourth = [iterations(one, 4, s) for s in SIZES]
print_row("a second iteration, of the first",
          [ratio(b and t and b - t, t) for t, b in zip(region_guided, second)])
print_row("each of the next two, of the first",
          [ratio(d and b and (d - b) / 2, t) for t, b, d in zip(region_guided, second, fourth)])
print_row("RGB-D over colour", [ratio(ours(one, "RGWATERSHED", s, "rgbd"), t) for t, s in zip(region_guided, SIZES)])
PYTHON
