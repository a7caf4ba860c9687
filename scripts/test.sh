#!/usr/bin/env bash
# Builds OpenCV with this module, and ximgproc beside it, and runs all tests:
#   scripts/test.sh                     with the OpenCV of Debian 12, 4.6.0
#   OPENCV_VERSION=4.10.0 scripts/test.sh      with that of Debian 13
#   OPENCV_SOURCE=DIR scripts/test.sh          with a source tree of your own; contrib in DIR/contrib
#   scripts/test.sh --alone [ARGUMENTS]        only the tests in C++, with the OpenCV that is installed: a minute
# The source and the build stay in the cache; only the first build takes long. ARGUMENTS are those of GoogleTest, as
# --gtest_filter='*mask*'.
# The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

version=${OPENCV_VERSION:-4.6.0}
place=$cache/$version
if [ -n "${OPENCV_SOURCE:-}" ]; then
    OPENCV_SOURCE=$(cd "$OPENCV_SOURCE" && pwd)
    place=$cache/own-$(printf %s "$OPENCV_SOURCE" | cksum | cut -d' ' -f1)
fi
source_dir=${OPENCV_SOURCE:-$place/source}
build=$place/build

# Debian's source package of OpenCV, contrib in its folder contrib/. The lines for apt are derived
# from those that are there, and apt keeps nothing of it outside of the cache. The parts are unpacked
# by hand, because not every mirror has the .dsc of another release; apt checks their sums.
fetch_source() {
    local suite apt_dir=$place/apt uri
    case $version in
    4.6.0) suite=bookworm ;;
    4.10.0) suite=trixie ;;
    *) fail "OPENCV_VERSION must be 4.6.0 or 4.10.0; for another one give OPENCV_SOURCE" ;;
    esac
    say "fetching the source of OpenCV $version (127 MB, once)"
    rm -rf "$apt_dir" "$source_dir.part"
    mkdir -p "$apt_dir/lists/partial" "$apt_dir/cache"
    list_uris() {
        apt-get indextargets --format '$(LABEL)|$(COMPONENT)|$(REPO_URI)' 'Created-By: Packages' |
            sed -n 's/^Debian|main|//p' | sort -u
    }
    [ -n "$(list_uris)" ] || as_root apt-get -qq update
    for uri in $(list_uris); do
        echo "deb-src $uri $suite main" >>"$apt_dir/sources.list"
    done
    local options=(-qq -o "Dir::Etc::sourcelist=$apt_dir/sources.list" -o Dir::Etc::sourceparts=-
                   -o "Dir::State::lists=$apt_dir/lists" -o "Dir::Cache=$apt_dir/cache" -o APT::Sandbox::User=root)
    apt-get "${options[@]}" update
    (cd "$apt_dir" && apt-get "${options[@]}" source --download-only opencv) || true
    set -- "$apt_dir/opencv_$version"*.orig.tar.* "$apt_dir/opencv_$version"*.orig-contrib.tar.* \
           "$apt_dir/opencv_$version"*.debian.tar.*
    [ -f "$1" ] && [ -f "$2" ] && [ -f "$3" ] || fail "cannot fetch the source of OpenCV $version"

    mkdir -p "$source_dir.part/contrib"
    tar xf "$1" -C "$source_dir.part" --strip-components=1
    tar xf "$2" -C "$source_dir.part/contrib" --strip-components=1
    tar xf "$3" -C "$source_dir.part"
    local patch
    for patch in $(grep -v '^#' "$source_dir.part/debian/patches/series"); do
        patch -s -d "$source_dir.part" -p1 <"$source_dir.part/debian/patches/$patch"
    done
    mv "$source_dir.part" "$source_dir"
    rm -rf "$apt_dir"
}

configure() { # FOLDER [OPTIONS OF CMAKE...]
    local modules=$root
    [ -d "$source_dir/contrib/modules/ximgproc" ] && modules="$source_dir/contrib/modules/ximgproc;$root"
    cmake -G Ninja -S "$source_dir" -B "$1" -DCMAKE_BUILD_TYPE=Release \
        "-DOPENCV_EXTRA_MODULES_PATH=$modules" \
        -DBUILD_LIST=gwatershed,ximgproc,ts,python3,python_bindings_generator \
        -DPYTHON3_EXECUTABLE=/usr/bin/python3 -DBUILD_EXAMPLES=ON -DBUILD_TESTS=ON -DBUILD_PERF_TESTS=ON \
        -DBUILD_JAVA=OFF "${lean[@]}" "${@:2}"
}

# One of our files, where OpenCV is one library (BUILD_opencv_world); all of that would take too long.
build_beside_world() {
    configure "$place/world" -DBUILD_opencv_world=ON &&
    ninja -C "$place/world" modules/gwatershed/CMakeFiles/opencv_gwatershed.dir/src/gwatershed/gwatershed.cpp.o
}

# What is wrong is compiled again the next time.
has_no_warning() { # LOG
    local files
    files=$(sed -n "s|^\($root/[^:]*\):.*warning:.*|\1|p" "$1" | sort -u)
    [ -z "$files" ] || { grep -A 5 "^$root/.*warning:" "$1"; xargs -d '\n' touch <<<"$files"; false; }
}

run_python_test() {
    local log=$results/python.log tests failures
    say "Python"
    PYTHONPATH=$build/lib/python3:$source_dir/modules/python/test \
        /usr/bin/python3 "$root/misc/python/test/test_gwatershed.py" >"$log" 2>&1 || true
    tests=$(sed -n 's/^Ran \([0-9]*\) test.*/\1/p' "$log")
    failures=$(grep -cE '^(FAIL|ERROR): ' "$log" || true)
    if [ -z "$tests" ] || ! tail -n 1 "$log" | grep -q '^OK'; then
        cat "$log"
        [ "$failures" -gt 0 ] || failures=1
        [ -n "$tests" ] || tests=$failures
    fi
    echo "  $tests tests, $failures failed"
    count $((tests - failures)) "$failures"
}

prints() { # WORDS COMMAND...
    "${@:2}" | grep "$1"
}

# The pictures that a sample wrote exist and load; the labels are 0..N-1 for the N that it printed.
pictures_load() { # PREFIX
    PYTHONPATH=$build/lib/python3 /usr/bin/python3 - "$1" "$results/sample.log" <<'PYTHON'
import re, sys
import cv2, numpy
prefix, log = sys.argv[1:]
number = int(re.search(r"(\d+) superpixels", open(log).read()).group(1))
labels = cv2.imread(prefix + "_labels.png", cv2.IMREAD_UNCHANGED)
assert numpy.unique(labels).tolist() == list(range(number)), "labels"
for name in "_contours.png", "_mean.png":
    assert cv2.imread(prefix + name).shape[:2] == labels.shape, name
PYTHON
}

run_sample() { # NAME PREFIX COMMAND...
    local name=$1 prefix=$2
    shift 2
    rm -f "$prefix"_*
    if "$@" >"$results/sample.log" 2>&1; then
        check "$name" pictures_load "$prefix"
    else
        check "$name" sh -c 'cat "$1"; false' sh "$results/sample.log"
    fi
}

run_samples() {
    local data=$source_dir/samples/data
    local demo=$build/bin/example_gwatershed_gwatershed_demo python_demo=(env "PYTHONPATH=$build/lib/python3"
        /usr/bin/python3 "$root/samples/gwatershed_demo.py")
    say "samples"
    run_sample "gwatershed_demo, colour" "$results/fruits" "$demo" -i="$data/fruits.jpg" -o="$results/fruits"
    run_sample "gwatershed_demo, RGB-D" "$results/aloe" \
        "$demo" -i="$data/aloeL.jpg" -d="$data/aloeGT.png" -o="$results/aloe"
    run_sample "gwatershed_demo.py, colour" "$results/home" \
        "${python_demo[@]}" "$data/home.jpg" -o "$results/home" -k 300
    run_sample "gwatershed_demo.py, RGB-D" "$results/aloe_py" \
        "${python_demo[@]}" "$data/aloeL.jpg" -d "$data/aloeGT.png" -o "$results/aloe_py"
    check "saliency_filters" finds_saliency "$data"
    check "gwatershed_polygons" finds_polygons "$data/fruits.jpg"
    check "gwatershed_steps" sh -c '"$1" -i="$2" -o="$3" | grep -q "^300 superpixels" && [ -s "$3" ]' \
        sh "$build/bin/example_gwatershed_gwatershed_steps" "$data/fruits.jpg" "$results/steps.png"
    # Labels of the demo serve as a ground truth.
    mkdir -p "$results/truth"
    cp "$results/fruits_labels.png" "$results/truth/fruits-0.png"
    check "gwatershed_benchmark" benchmark_finds_itself "$data/fruits.jpg"
    check "gwatershed_benchmark refuses numbers" refuses_numbers
    check "samples say what is wrong" samples_refuse "$data"
    check "gwatershed_plot.py" sh -c '/usr/bin/python3 "$1" "$2.csv" -o "$2.png" | grep -q RGWATERSHED && [ -s "$2.png" ]' \
        sh "$root/samples/gwatershed_plot.py" "$results/benchmark"
}

# A picture of four rows, and a line for each image.
finds_saliency() { # DATA
    "$build/bin/example_gwatershed_saliency_filters" -i="$1/fruits.jpg,$1/aloeL.jpg" -d=",$1/aloeGT.png" \
        -o="$results/saliency.png" >"$results/saliency.log" &&
    grep -q 'fruits.jpg, 512x480: 400 superpixels' "$results/saliency.log" &&
    grep -q 'aloeL.jpg, 1282x1110 with depth: 400 superpixels' "$results/saliency.log" &&
    PYTHONPATH=$build/lib/python3 /usr/bin/python3 - "$results/saliency.png" <<'PYTHON'
import sys
import cv2
picture = cv2.imread(sys.argv[1])
assert picture.shape[0] == 4 * 244, picture.shape
saliency = picture[-240:, :256, 0]
assert saliency[60:180, 60:140].mean() > 1.5 * saliency[:, :20].mean(), "the orange does not stand out"
PYTHON
}

# The polygons of a superpixel, filled, are the superpixel: together they fill the image without overlap.
finds_polygons() { # IMAGE
    "$build/bin/example_gwatershed_gwatershed_polygons" -i="$1" -k=1600 -o="$results/polygons.json" |
        grep -q '^1600 superpixels, [0-9]* polygons$' &&
    PYTHONPATH=$build/lib/python3 /usr/bin/python3 - "$results/polygons.json" <<'PYTHON'
import json, sys
import cv2, numpy
polygons = json.load(open(sys.argv[1]))
filled = numpy.zeros((polygons["height"], polygons["width"]), numpy.uint8)
for superpixel in polygons["superpixels"]:
    one = numpy.zeros_like(filled)
    cv2.fillPoly(one, [numpy.array(p["points"]).reshape(-1, 2) for p in superpixel["polygons"]], 1)
    assert one.sum() == superpixel["area"]
    filled += one
assert (filled == 1).all()
PYTHON
}

# The superpixels of the demo, measured against themselves, have no error.
benchmark_finds_itself() { # IMAGE
    mkdir -p "$results/images"
    cp "$1" "$results/images"
    "$build/bin/example_gwatershed_gwatershed_benchmark" -i="$results/images" -g="$results/truth" \
        -k=300,624 -m=RGWATERSHED,grid -o="$results/benchmark.csv"
    grep -q '^RGWATERSHED,624,mean,1,0,1,' "$results/benchmark.csv"
}

# Wrong numbers of superpixels, methods and folders end it with a message and the exit code 1.
refuses_numbers() {
    local wrong benchmark=$build/bin/example_gwatershed_gwatershed_benchmark
    for wrong in "-k=0" "-k=3x" "-k=400,999999" "-k=300 -m=none" "-k=300 -i=$results/no-such-folder" "-k=300 -l=-1"; do
        "$benchmark" -i="$results/images" -g="$results/truth" -o="$results/refused.csv" $wrong
        [ $? = 1 ] || return 1
    done
}

# A command ends with the exit code 1 and a message that has some words, and measures or draws nothing.
refuses() { # WORDS COMMAND...
    "${@:2}" >"$results/refused.out" 2>"$results/refused.err"
    [ $? = 1 ] && [ ! -s "$results/refused.out" ] && grep "$1" "$results/refused.err" &&
        ! grep Traceback "$results/refused.err"
}

samples_refuse() { # DATA
    local image=$1/fruits.jpg sample=$build/bin/example_gwatershed_gwatershed wrong output=$results/refused
    local python_demo=(env "PYTHONPATH=$build/lib/python3" /usr/bin/python3 "$root/samples/gwatershed_demo.py")
    rm -rf "$results/frames"
    mkdir -p "$results/frames" "$results/no-frames"
    cp "$image" "$results/frames"
    ln -sf /dev/full "$results/full.json"
    for wrong in "-s 0" "-k 0" "-k -3" "-n 0" "-e 9" "-d $image"; do
        refuses "must be" "${python_demo[@]}" "$image" -o "$output" $wrong || return 1
    done
    for wrong in no-frames no-such-folder; do
        refuses "no depth in the folder" "${sample}_demo" -c="$results/frames" -d="$results/$wrong" || return 1
    done
    refuses "cannot write" "${sample}_polygons" -i="$image" -o="$results/full.json" &&
    refuses "cannot write" "${sample}_benchmark" -i="$results/images" -g="$results/truth" -k=300 -o=/dev/full &&
    PYTHONPATH=$build/lib/python3 /usr/bin/python3 -c 'import sys, cv2, numpy
cv2.imwrite(sys.argv[1], numpy.zeros((11, 20, 3), numpy.uint8))' "$output.png" &&
    refuses "12x12 pixels" "${sample}_steps" -i="$output.png" -o="$output.steps.png"
}

# The module alone is installed, projects find it, and uninstalling leaves what was there before. The projects are the
# code blocks of the documents: the C++ as a program, built as the CMake block of the document says, Python, shell.
run_installed() {
    local prefix=$results/prefix document folder
    say "the module alone"
    check "build" build_alone
    mkdir -p "$prefix/include/opencv2" "$prefix/lib"
    touch "$prefix/include/opencv2/other.hpp"
    find "$prefix" | sort >"$results/prefix.before"
    check "install" cmake --install "$alone" --prefix "$prefix"
    for document in README.md CONTRIBUTING.md doc/gwatershed.markdown; do
        folder=$results/blocks/$document
        check "$document: code blocks" "$root/scripts/code_blocks.py" "$root/$document" "$folder"
        sed 's/^/          /' "$log"
        [ ! -f "$folder/superpixels.cpp" ] || check "$document: C++ in a project of its own" user_project "$folder"
        [ ! -f "$folder/superpixels.py" ] || check "$document: Python" \
            env "PYTHONPATH=$build/lib/python3" /usr/bin/python3 "$folder/superpixels.py"
        [ ! -f "$folder/superpixels.sh" ] || check "$document: shell" bash -n "$folder/superpixels.sh"
    done
    check "part of another project" part_of_project
    check "uninstall" cmake --build "$alone" --target uninstall
    check "nothing is left of it" sh -c 'find "$1" | sort | diff "$1.before" -' sh "$prefix"
}

# Configures a project that has the module as a part, and a target "uninstall" of its own.
part_of_project() {
    local folder=$results/part
    mkdir -p "$folder"
    printf '%s\n' 'cmake_minimum_required(VERSION 3.12)' 'project(whole CXX)' 'add_custom_target(uninstall)' \
        "add_subdirectory(\"$root\" gwatershed)" 'add_executable(whole whole.cpp)' \
        'target_link_libraries(whole gwatershed::gwatershed)' >"$folder/CMakeLists.txt"
    touch "$folder/whole.cpp"
    cmake -S "$folder" -B "$folder/build"
}

# Builds the project of a folder against the installed module and runs it there.
user_project() { # FOLDER
    cmake -S "$1" -B "$1/build" "-DCMAKE_PREFIX_PATH=$results/prefix" &&
    cmake --build "$1/build" && (cd "$1" && build/superpixels)
}

# The tests without a build of OpenCV.
test_alone() { # ARGUMENTS OF GOOGLETEST...
    local folder="$cache/tests alone"
    results=$folder/results
    rm -rf "$results"
    mkdir -p "$results"
    need_packages cmake g++ make libopencv-dev libgtest-dev
    say "building the module and its tests alone"
    build_alone "$folder" -DBUILD_TESTS=ON -DBUILD_SAMPLES=OFF
    run_gtest accuracy "$folder/opencv_test_gwatershed" "$@"
    finish
}

if [ "${1:-}" = --alone ]; then
    test_alone "${@:2}"
    exit
fi

need_packages cmake ninja-build g++ patch xz-utils libjpeg-dev libpng-dev zlib1g-dev python3-dev python3-numpy \
    python3-matplotlib make libopencv-dev
[ -d "$source_dir" ] || fetch_source
results=$place/results
rm -rf "$results"
logs=$results/checks
mkdir -p "$logs"

say "building OpenCV in $build (the first time takes about ten minutes on two cores)"
configure "$build" >"$results/configure.log" 2>&1 || { tail -n 40 "$results/configure.log"; fail "cmake failed"; }
ninja -C "$build" opencv_test_gwatershed opencv_perf_gwatershed opencv_samples_gwatershed opencv_python3 \
    >"$results/build.log" 2>&1 || { tail -n 60 "$results/build.log"; fail "the build failed"; }
check "no warning from our files" has_no_warning "$results/build.log"
check "beside OpenCV as one library" build_beside_world

export OPENCV_SAMPLES_DATA_PATH=$source_dir/samples/data
run_gtest accuracy "$build/bin/opencv_test_gwatershed"
run_gtest performance "$build/bin/opencv_perf_gwatershed" --perf_min_samples=1 --perf_force_samples=1 \
    '--gtest_filter=*/0'
check "perf.sh" prints "RGWATERSHED, ms" "$root/scripts/perf.sh" "$results"/performance.xml{,}
check "profile.sh" prints "The steps" "$root/scripts/profile.sh"
run_python_test
run_samples
run_installed

finish
