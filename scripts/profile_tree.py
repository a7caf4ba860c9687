#!/usr/bin/env python3
"""Prints the time of the module's functions as a tree, for scripts/profile.sh:

  profile_tree.py NAMES.txt CALLS.txt REPORT.xml

The first two are written by OpenCV with OPENCV_TRACE=1: the names of what is traced, and when each call of one thread
began and ended. The third is written by opencv_perf_gwatershed in the same run, with the mean of the whole.
What functions of others take is counted for the one of ours that called them.
"""
import collections
import csv
import re
import sys
import xml.etree.ElementTree as ElementTree

OURS = re.compile(r"cv::ximgproc::(?:gws::|\{anonymous\}::|\(anonymous namespace\)::)*([\w:]+)\(")


def read_names(file):
    """Names of the module's functions by number."""
    with open(file, encoding="utf-8") as lines:
        rows = [row for row in csv.reader(lines) if row[0] == "l"]
    found = {row[1]: OURS.search(row[4]) for row in rows}
    return {number: match.group(1) for number, match in found.items() if match}


def read_calls(file, names):
    """For each call of a function that nothing of ours called: nanoseconds by path, which is a tuple of names."""
    calls, paths = [], [()]
    with open(file, encoding="utf-8") as lines:
        for row in csv.reader(lines):
            if row[0] == "b":
                paths.append(paths[-1] + ((names[row[3]],) if row[3] in names else ()))
                if len(paths[-1]) == 1 and not paths[-2]:
                    calls.append(collections.Counter())
            elif row[0] == "e":
                path = paths.pop()
                if path != paths[-1]:
                    calls[-1][path] += int(row[5].split("=")[-1])
    return calls


def read_mean(file):
    """Nanoseconds of a whole call by the clock of the performance test."""
    values = {item.get("name"): item.get("value") for item in ElementTree.parse(file).iter("property")}
    return 1e9 * float(values["mean"]) / float(values["frequency"])


def print_line(depth, name, time, whole):
    if time > whole / 1000:
        print("%-52s%9.3f ms %5.1f %%" % ("  " * depth + name, time / 1e6, 100 * time / whole))


def print_tree(path, times, children, whole):
    """Returns what the leaves below add up to."""
    print_line(len(path) - 1, path[-1], times[path], whole)
    if not children[path]:
        return times[path]
    steps = sum(print_tree(child, times, children, whole) for child in children[path])
    print_line(len(path), "(the rest of it)", times[path] - sum(times[child] for child in children[path]), whole)
    return steps


def average(calls):
    """Mean by path."""
    return {path: sum(call[path] for call in calls) / len(calls) for call in calls for path in call}


def main():
    whole = read_mean(sys.argv[3])
    times = average(read_calls(sys.argv[2], read_names(sys.argv[1])))
    children = collections.defaultdict(list)
    for path in times:
        children[path[:-1]].append(path)
    steps = sum(print_tree(root, times, children, whole) for root in children[()])
    print("\nThe steps, which call none of the others, add up to %.1f %% of the whole, %.3f ms."
          % (100 * steps / whole, whole / 1e6))


if __name__ == "__main__":
    main()
