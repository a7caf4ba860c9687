#!/usr/bin/env bash
# Calls the module as libFuzzer makes it up, under the sanitizers of addresses and undefined behaviour:
#   scripts/fuzz.sh [SECONDS]           starts from tools/fuzz/corpus; 60 seconds by default
#   scripts/fuzz.sh FILE                repeats what an earlier run found
# What it finds, and a corpus that grows from run to run, are in the cache.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

need_packages cmake make clang-14 libclang-rt-14-dev libopencv-dev
place=$cache/fuzz
mkdir -p "$place/corpus" "$place/found"
say "building the fuzz target"
rm -f "$place/build/CMakeCache.txt" # of a clone elsewhere
cmake -S "$root/tools/fuzz" -B "$place/build" -DCMAKE_CXX_COMPILER=clang++-14 \
    -DCMAKE_CXX_FLAGS="-O1 -g -fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=all" >/dev/null
cmake --build "$place/build" --target fuzz --parallel "$(nproc)" >"$place/build.log" 2>&1 ||
    { tail -n 40 "$place/build.log"; fail "the build failed"; }

export OPENCV_ENABLE_MEMALIGN=1 # else images have room at their end, which hides what is read there
if [ -f "${1:-}" ]; then
    "$place/build/fuzz" "$1"
    exit
fi
say "fuzzing for ${1:-60} seconds"
options=(-max_len=1000 -len_control=0 -timeout=120 -report_slow_units=120 -rss_limit_mb=4096
         "-artifact_prefix=$place/found/")
if ! "$place/build/fuzz" "-max_total_time=${1:-60}" "${options[@]}" "$place/corpus" "$root/tools/fuzz/corpus" \
        >"$place/fuzz.log" 2>&1; then
    tail -n 40 "$place/fuzz.log"
    fail "a defect; repeat it with scripts/fuzz.sh $(ls -t "$place"/found/* | head -n 1)"
fi
sed -n 's/^Done \([0-9]*\) runs.*/\1 runs without a defect/p' "$place/fuzz.log"
