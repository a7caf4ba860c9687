#!/usr/bin/env bash
# Builds the module alone against Debian's OpenCV, measures its memory, and tries it on the largest images, without
# enough memory, and on a stream of changing frames (misc/checks/scale.cpp):
#   scripts/scale.sh [SIDE [SECONDS]]   side of the largest image, 20000, which takes 11 GB, and processor time for the
#                                       stream, 60
# The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

need_packages cmake g++ make libopencv-dev pkg-config
build=$cache/scale-build
mkdir -p "$build"
rm -f "$build/CMakeCache.txt" # of a clone elsewhere
{ cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release &&
  cmake --build "$build" --target opencv_gwatershed --parallel "$(nproc)"; } >"$build/build.log" 2>&1 ||
    { tail -n 40 "$build/build.log"; fail "the build failed"; }
read -ra flags < <(pkg-config --cflags opencv4)
g++ -std=c++11 -O2 -I"$root/include" "${flags[@]}" "$root"/misc/checks/{scale,images}.cpp -o "$build/scale" \
    -L"$build" -lopencv_gwatershed -lopencv_core
LD_LIBRARY_PATH=$build "$build/scale" --side="${1:-20000}" --soak="${2:-60}" 2>"$build/errors.log"
