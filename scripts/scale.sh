#!/usr/bin/env bash
# Builds the module alone against Debian's OpenCV, measures its memory, and tries it on the largest images, without
# enough memory, and on a stream of changing frames (tools/checks/scale.cpp):
#   scripts/scale.sh [SIDE [FRAMES]]   side of the largest image, 20000, and length of the stream, 6000: a minute
# It takes 11 GB of memory.
# The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

need_packages cmake g++ make libopencv-dev pkg-config
place=$cache/scale
mkdir -p "$place"
build_alone
read -ra flags < <(pkg-config --cflags opencv4)
g++ -std=c++11 -O2 -I"$root/include" "${flags[@]}" "$root"/tools/checks/{scale,images}.cpp -o "$place/scale" \
    -L"$alone" -lopencv_gwatershed -lopencv_core
LD_LIBRARY_PATH=$alone "$place/scale" --side="${1:-20000}" --soak="${2:-6000}" 2>"$place/errors.log"
