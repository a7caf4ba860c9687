#!/usr/bin/env bash
# Times RGWATERSHED, GWATERSHED and their peers by opencv_perf_gwatershed, where they take turns on mosaics of
# photographs, and prints how they compare; less than ten minutes:
#   scripts/perf.sh                  one thread on one processor, then two threads on two
#   scripts/perf.sh ONE.xml TWO.xml  prints the table of reports of yours, --gtest_output=xml:ONE.xml
# scripts/test.sh must have been run before the first form; OPENCV_VERSION is as there.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if [ $# -eq 0 ]; then
    place=$cache/${OPENCV_VERSION:-4.6.0}
    program=$place/build/bin/opencv_perf_gwatershed
    [ -x "$program" ] || fail "there is no $program yet: run scripts/test.sh"
    export OPENCV_SAMPLES_DATA_PATH=$place/source/samples/data
    mkdir -p "$place/results"
    # Memory that a method gives back to the system costs the next ones time on a virtual machine, page by page.
    export MALLOC_MMAP_MAX_=0 MALLOC_TRIM_THRESHOLD_=$((1 << 40))
    last=$(($(nproc) - 1))
    for threads in 1 2; do
        say "timing with $threads thread(s)"
        report=$place/results/perf$threads
        taskset -c $((last - threads + 1))-$last "$program" "--perf_threads=$threads" --perf_max_deviation=0.1 \
            '--gtest_filter=Perf_Superpixels*' "--gtest_output=xml:$report.xml" >"$report.log" 2>&1 ||
            fail "$program ended with an error; see $report.log"
        set -- "$@" "$report.xml"
    done
fi
python3 "$root/scripts/perf_table.py" "$@"
