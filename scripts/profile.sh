#!/usr/bin/env bash
# Prints where the time of iterate() goes, as a tree of its functions. OpenCV traces these (CV_TRACE_FUNCTION) while
# opencv_perf_gwatershed segments mosaics of photographs:
#   scripts/profile.sh [ALGORITHM [SIZE [REGION_SIZE [THREADS]]]]    RGWATERSHED 640x480 20 1
# SIZE is 640x480, 1280x720, 1920x1080 or 3840x2160, REGION_SIZE is 5, 10 or 20.
# scripts/test.sh must have been run before; OPENCV_VERSION is as there.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

place=$cache/${OPENCV_VERSION:-4.6.0}
program=$place/build/bin/opencv_perf_gwatershed
[ -x "$program" ] || fail "there is no $program yet: run scripts/test.sh"
export OPENCV_SAMPLES_DATA_PATH=$place/source/samples/data
threads=${4:-1}
parameters="(${1:-RGWATERSHED}, ${2:-640x480}, ${3:-20})"
number=$("$program" --gtest_list_tests 2>/dev/null | sed -n "s|.*iterate/\([0-9]*\) .*= $parameters\$|\1|p")
[ -n "$number" ] || fail "there is no case $parameters"
traces=$place/results/traces
rm -rf "$traces"
mkdir -p "$traces"
export OPENCV_TRACE=1 OPENCV_TRACE_LOCATION="$traces/trace" OPENCV_TRACE_DEPTH_OPENCV=6
export OPENCV_TRACE_MAX_CHILDREN=0 OPENCV_TRACE_MAX_CHILDREN_OPENCV=0
taskset -c $(($(nproc) - threads))-$(($(nproc) - 1)) "$program" "--perf_threads=$threads" --perf_min_samples=30 \
    --perf_force_samples=30 --perf_max_outliers=0 --perf_max_deviation=0.1 "--gtest_filter=*iterate/$number" \
    "--gtest_output=xml:$traces/report.xml" >"$traces/log" 2>&1 || fail "$program ended with an error; see $traces/log"
python3 "$root/scripts/profile_tree.py" "$traces"/{trace.txt,trace-000.txt,report.xml}
