#!/usr/bin/env bash
# Builds the module alone against Debian's OpenCV and segments images:
#   scripts/demo.sh                     photographs that Debian carries, one of them with depth
#   scripts/demo.sh IMAGE [DEPTH]       your own
# The pictures go to the folder gwatershed-demo where you are.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

photographs=$cache/photographs

# Unpacks three pictures of the package opencv-doc, once.
fetch_photographs() {
    [ -f "$photographs/fruits.jpg" ] && return
    say "fetching three photographs out of Debian's package opencv-doc (96 MB, once)"
    local download
    download=$(mktemp -d)
    if ! (cd "$download" && apt-get -qq -o APT::Sandbox::User=root download opencv-doc); then
        rm -rf "$download"
        fail "no photographs without a network; name an image: scripts/demo.sh IMAGE [DEPTH]"
    fi
    local data=./usr/share/doc/opencv-doc/examples/data
    mkdir -p "$photographs.part"
    dpkg-deb --fsys-tarfile "$download"/opencv-doc_*.deb |
        tar x -C "$photographs.part" --strip-components=7 "$data/aloeL.jpg" "$data/aloeGT.png" "$data/fruits.jpg"
    rm -rf "$download" "$photographs"
    mv "$photographs.part" "$photographs"
}

need_packages cmake g++ make libopencv-dev
say "building against OpenCV $(pkg-config --modversion opencv4 2>/dev/null || true)"
build_alone

mkdir -p gwatershed-demo
if [ $# -gt 0 ]; then
    name=$(basename "${1%.*}")
    "$alone/gwatershed_demo" -i="$1" ${2:+-d="$2"} -o="gwatershed-demo/$name"
else
    fetch_photographs
    "$alone/gwatershed_demo" -i="$photographs/fruits.jpg" -o=gwatershed-demo/fruits
    "$alone/gwatershed_demo" -i="$photographs/aloeL.jpg" -o=gwatershed-demo/aloe
    "$alone/gwatershed_demo" -i="$photographs/aloeL.jpg" -d="$photographs/aloeGT.png" -o=gwatershed-demo/aloe_depth
fi
