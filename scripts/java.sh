#!/usr/bin/env bash
# Builds OpenCV's Java binding with the module in it, and runs the Java tests of the module. Only the module is
# optimized.
# scripts/test.sh must have been run before, for the source; OPENCV_VERSION is as there.
# The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

place=$cache/${OPENCV_VERSION:-4.6.0}
build=$place/java
log=$place/java.log
[ -d "$place/source" ] || fail "there is no $place/source yet: run scripts/test.sh"
need_packages cmake ninja-build g++ libjpeg-dev libpng-dev zlib1g-dev default-jdk ant ant-optional
export JAVA_HOME=${JAVA_HOME:-/usr/lib/jvm/default-java}

# OpenCV 4 builds the tests of its Java binding only where calib3d is built; OpenCV 5 has 3d and calib in its place.
modules=gwatershed,java,imgcodecs
for module in calib3d 3d calib; do
    [ ! -d "$place/source/modules/$module" ] || modules+=,$module
done
# What OpenCV includes when it has made the target of the module.
hooks=$place/java-hooks
mkdir -p "$hooks"
echo 'target_compile_options(opencv_gwatershed PRIVATE -O3)' \
    >"$hooks/POST_CREATE_MODULE_LIBRARY_opencv_gwatershed.cmake"
say "building OpenCV for Java in $build (the first time takes seven minutes of a core)"
cmake -G Ninja -S "$place/source" -B "$build" -DCMAKE_BUILD_TYPE=Release "-DOPENCV_EXTRA_MODULES_PATH=$root" \
    "-DBUILD_LIST=$modules" -DBUILD_PERF_TESTS=OFF -DCPU_DISPATCH= \
    -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DCMAKE_C_FLAGS_RELEASE=-O0 "-DOPENCV_CMAKE_HOOKS_DIR=$hooks" \
    "${lean[@]}" >"$log" 2>&1 ||
    { tail -n 40 "$log"; fail "cmake failed"; }
ninja -C "$build" opencv_test_java >"$log" 2>&1 || { tail -n 60 "$log"; fail "the build failed; see $log"; }

cd "$build/java_test"
rm -rf testResults
ant -Dopencv.build.type=Release -Dopencv.test.package=gwatershed buildAndTest >"$log" 2>&1 || true
read -r tests failures < <(grep -o 'Tests run: .*' "$log" | tr -dc '0-9 \n' |
    awk '{ tests += $1; failures += $2 + $3 } END { print tests + 0, failures + 0 }')
[ "$tests" -gt 0 ] || { tail -n 40 "$log"; failures=1 tests=1; }
grep -E 'FAILED|Caused an ERROR' "$log" || true
count $((tests - failures)) "$failures"
finish
