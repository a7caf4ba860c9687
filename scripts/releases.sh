#!/usr/bin/env bash
# Builds and runs the module beside the OpenCV of other releases of Debian, each in a folder of the cache:
#   scripts/releases.sh [bookworm] [trixie] [sid]    4.6.0 of Debian 12, 4.10.0 of Debian 13, and 5.0.0 of experimental
#                                                    on sid; all three by default
#   scripts/releases.sh --cached                     those that are in the cache
# There: the tests in C++, the 200 labels of tools/checks/sameness.cpp against those with the OpenCV here, the samples,
# the code of the documents, the Python package by pip. It needs root; the first time it fetches 0.8 GB for each.
# The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$(dirname "${BASH_SOURCE[0]}")/chroot.sh"

packages=(g++ cmake make pkgconf libgtest-dev libopencv-dev python3-opencv
          python3-venv python3-dev pybind11-dev python3-pybind11 python3-numpy python3-pil)
build_core=python3-scikit-build-core
# What the tests of the Python package take part with where it is there.
optional=(python3-skimage python3-dask python3-distributed python3-zarr python3-rasterio mypy)
place=$cache/releases

make_release() { # RELEASE
    case $1 in
    bookworm) make_chroot bookworm bookworm bookworm-backports "${packages[@]}" "${optional[@]}" \
        $build_core/bookworm-backports python3-packaging/bookworm-backports ;;
    trixie) make_chroot trixie trixie "" "${packages[@]}" $build_core ;;
    sid) make_chroot sid sid experimental -t experimental "${packages[@]}" $build_core ;;
    *) fail "there is no $1 here; bookworm, trixie or sid" ;;
    esac
}

# The labels with the OpenCV that is installed here, as a table of hashes.
make_table() {
    need_packages cmake g++ make libopencv-dev
    say "the labels with OpenCV $(pkg-config --modversion opencv4) here"
    build_alone "$place/here" -DBUILD_SAMPLES=OFF || fail "the build failed"
    g++ -std=c++11 -O2 -fopenmp -I"$root/include" -I/usr/include/opencv4 "$root"/tools/checks/{sameness,images}.cpp \
        -o "$place/sameness" -L"$place/here" -lopencv_gwatershed -lopencv_imgproc -lopencv_core
    LD_LIBRARY_PATH=$place/here "$place/sameness" >"$place/table"
}

# The same there, compared.
has_same_labels() { # RELEASE THREADS
    inside "$1" env LD_LIBRARY_PATH=/build /build/sameness "--threads=$2" >"$place/table.$1" || return 1
    diff "$place/table" "$place/table.$1" && echo "$(wc -l <"$place/table.$1") lines are equal"
}

build_there() { # RELEASE
    inside "$1" cmake -S /gwatershed -B /build -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTS=ON &&
    inside "$1" cmake --build /build --parallel "$(nproc)" &&
    inside "$1" sh -c 'cd /gwatershed/tools/checks &&
        g++ -std=c++17 -O2 -fopenmp -I/gwatershed/include $(pkg-config --cflags opencv5 2>/dev/null ||
        pkg-config --cflags opencv4) sameness.cpp images.cpp -o /build/sameness -L/build -lopencv_gwatershed \
        -lopencv_imgproc -lopencv_core'
}

# The tests in C++: as many as GoogleTest counts.
run_tests() { # RELEASE
    inside "$1" rm -f /build/tests.xml
    inside "$1" /build/opencv_test_gwatershed --gtest_output=xml:/build/tests.xml >"$logs/tests.log" 2>&1 || true
    local report=$chroots/$1/build/tests.xml tests=0 failures=1
    if [ -s "$report" ]; then
        read -r tests failures < <(sed -n \
            's/.*<testsuites tests="\([0-9]*\)" failures="\([0-9]*\)".*/\1 \2/p' "$report")
    fi
    grep -E -B 20 '^\[  FAILED  \]' "$logs/tests.log" || true
    echo "  $tests tests, $failures failed; log: $logs/tests.log"
    count $((tests - failures)) "$failures"
}

# An image that needs no photograph: a disc on a ramp.
make_picture() { # FILE
    awk 'BEGIN { print "P3 320 240 255"; for (y = 0; y < 240; y++) for (x = 0; x < 320; x++)
        print (x % 256), y, ((x - 160) ^ 2 + (y - 120) ^ 2 < 6400 ? 220 : 60) }' >"$1"
}

runs_demo() { # RELEASE
    make_picture "$place/picture.ppm"
    as_root cp "$place/picture.ppm" "$chroots/$1/build/picture.ppm"
    inside "$1" /build/gwatershed_demo -i=/build/picture.ppm -o=/build/demo | tee "$place/demo.$1" &&
    [ -s "$chroots/$1/build/demo_labels.png" ] && [ -s "$chroots/$1/build/demo_contours.png" ] &&
    inside "$1" /build/gwatershed_polygons -i=/build/picture.ppm -k=300 -o=/build/polygons.json
}

# The pictures that the documents name, of the source of OpenCV that scripts/test.sh has fetched.
copy_samples() { # RELEASE
    local data=$cache/4.6.0/source/samples/data
    [ -d "$data" ] || fail "there is no $data yet: run scripts/test.sh"
    [ -d "$chroots/$1/data" ] || as_root cp -r "$data" "$chroots/$1/data"
}

# All presets, as far as CMake itself can say.
takes_presets() { # RELEASE
    local preset
    for preset in $(sed -n '/configurePresets/,/buildPresets/s/.*"name": "\(.*\)".*/\1/p' "$root/CMakePresets.json"); do
        inside "$1" sh -c 'cd /gwatershed && cmake --preset "$1" -B "/tmp/$1"' sh "$preset" || return 1
    done
}

# The code of the documents is built against the installed module, by projects that ask for C++11 only: where OpenCV
# needs more, the target of the module must ask for it.
run_documents() { # RELEASE
    local document folder
    check "$1: install" inside "$1" cmake --install /build --prefix /installed
    copy_samples "$1"
    for document in doc/installing.markdown doc/gwatershed.markdown README.md; do
        folder=$place/blocks/$document
        check "$1: $document: code blocks" "$root/scripts/code_blocks.py" "$root/$document" "$folder"
        [ -f "$folder/superpixels.cpp" ] || continue
        as_root rm -rf "$chroots/$1/blocks"
        as_root cp -r "$folder" "$chroots/$1/blocks"
        check "$1: $document: C++" inside "$1" env OPENCV_SAMPLES_DATA_PATH=/data sh -c \
            'cd /blocks && cmake -S . -B build -DCMAKE_PREFIX_PATH=/installed -DCMAKE_CXX_STANDARD=11 &&
             cmake --build build && build/superpixels'
    done
    check "$1: pkg-config" inside "$1" sh -c 'cd /blocks &&
        export PKG_CONFIG_PATH=$(dirname "$(find /installed -name gwatershed.pc)") &&
        g++ -std=c++17 superpixels.cpp -o by-pkg-config $(pkg-config --cflags --libs gwatershed) &&
        LD_LIBRARY_PATH=/build ./by-pkg-config'
}

# README's line for pip in a fresh environment, with an index of what is needed: the packages of the release as wheels.
# Of the programs that an index has, ninja is no package of Python here; make does it.
installs_from_index() { # RELEASE
    inside "$1" sh -ec "rm -rf /index /fresh
        /gwatershed/scripts/wheel_index.py /index pybind11 scikit-build-core packaging pathspec numpy
        python3 -m venv /fresh
        cd /gwatershed
        export PATH=/fresh/bin:\$PATH PIP_INDEX_URL=file:///index CMAKE_GENERATOR='Unix Makefiles'
        $(grep '^pip install' "$root/README.md")
        pip check
        cd /
        python -c 'import gwatershed, numpy
print(gwatershed.segment(numpy.zeros((40, 60, 3), numpy.uint8), 20).max(), gwatershed.__file__)' | grep '^5 /fresh'"
}

# The package is installed as doc/installing.markdown says, and the code there runs.
run_python() { # RELEASE
    local blocks=$place/blocks/doc/installing.markdown
    check "$1: pip install with an index" installs_from_index "$1"
    check "$1: pip install" inside "$1" sh -ec "rm -rf /gwatershed/venv; cd /gwatershed
        $(grep venv "$blocks/superpixels.sh" | grep -v 'apt-get\|python3-venv')"
    as_root cp "$blocks/superpixels.py" "$chroots/$1/installing.py"
    check "$1: doc/installing.markdown: Python" inside "$1" /gwatershed/venv/bin/python /installing.py
    check "$1: interface of the package" inside "$1" env GWATERSHED_TEST=package \
        /gwatershed/venv/bin/python /gwatershed/misc/python/test/test_gwatershed.py
    check "$1: the package" inside "$1" /gwatershed/venv/bin/python /gwatershed/python/test/test_package.py
    check "$1: the functions" inside "$1" /gwatershed/venv/bin/python /gwatershed/python/test/test_functions.py
    check "$1: the command" inside "$1" /gwatershed/venv/bin/python /gwatershed/python/test/test_command.py
    check "$1: tiles" inside "$1" sh -c '! /gwatershed/venv/bin/python -c "import zarr, dask" ||
        { /gwatershed/venv/bin/python -W ignore /gwatershed/python/test/test_tiles.py &&
          /gwatershed/venv/bin/python -W ignore /gwatershed/python/test/test_tiles_sources.py; }'
    check "$1: beside cv2" inside "$1" /gwatershed/venv/bin/python -c \
        'import cv2, gwatershed; print(cv2.__version__); import numpy as np
image = np.random.RandomState(1).randint(0, 255, (90, 90, 3), np.uint8)
print(gwatershed.segment(cv2.blur(image, (5, 5)), 10, bgr=True).max())'
}

run_release() { # RELEASE
    make_release "$1"
    say "$1: OpenCV $(inside "$1" dpkg-query -W -f '${Version}' libopencv-dev)," \
        "$(inside "$1" g++ --version | head -n 1)"
    copy_inside "$1" /gwatershed
    logs=$place/logs/$1
    mkdir -p "$logs"
    check "$1: presets" takes_presets "$1"
    check "$1: build" build_there "$1"
    check "$1: no warning" sh -c '! grep "warning:" "$1"' sh "$logs/$1:-build.log"
    run_tests "$1"
    for threads in 1 8; do
        check "$1: the same 200 labels, threads=$threads" has_same_labels "$1" "$threads"
    done
    check "$1: samples" runs_demo "$1"
    run_documents "$1"
    run_python "$1"
}

releases=("$@")
[ $# -gt 0 ] || releases=(bookworm trixie sid)
if [ "${1:-}" = --cached ]; then
    releases=()
    for release in bookworm trixie sid; do
        [ ! -s "$chroots/$release/.complete" ] || releases+=("$release")
    done
fi
mkdir -p "$place"
[ ${#releases[@]} = 0 ] || make_table
for release in "${releases[@]}"; do
    run_release "$release"
done
finish
