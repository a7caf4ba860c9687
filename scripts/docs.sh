#!/usr/bin/env bash
# Builds OpenCV's documentation with the module in it. It fails if a warning names a file of ours, as for a reference
# or a citation that is not found, or if a page or a picture of ours is missing.
# scripts/test.sh must have been run before, for the source; OPENCV_VERSION is as there.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

place=$cache/${OPENCV_VERSION:-4.6.0}
build=$place/docs
log=$place/docs.log
html=$build/doc/doxygen/html
[ -d "$place/source" ] || fail "there is no $place/source yet: run scripts/test.sh"
need_packages cmake ninja-build g++ doxygen texlive-base python3-bs4

say "building the documentation"
cmake -G Ninja -S "$place/source" -B "$build" "-DOPENCV_EXTRA_MODULES_PATH=$root" -DBUILD_DOCS=ON -DBUILD_JAVA=OFF \
    -DBUILD_LIST=gwatershed,python3,python_bindings_generator -DPYTHON3_EXECUTABLE=/usr/bin/python3 \
    "${lean[@]}" >"$log" 2>&1 || { tail -n 40 "$log"; fail "cmake failed"; }
rm -rf "$html"
ninja -C "$build" doxygen >"$log" 2>&1 || { tail -n 40 "$log"; fail "the build failed; see $log"; }
! grep "$root/.*warning:" "$log" || fail "warnings from our files"
for name in tutorial_gwatershed group__gwatershed classcv_1_1ximgproc_1_1SuperpixelGWatershed; do
    page=$(find "$html" -name "$name.html")
    [ -n "$page" ] || fail "there is no page $name"
    for picture in $(grep -o '<img src="[^"]*' "$page" | cut -d'"' -f2); do
        [ -f "$(dirname "$page")/$picture" ] || fail "$page: there is no $picture"
    done
    echo "  $page"
done
