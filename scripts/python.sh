#!/usr/bin/env bash
# Builds the extension of the Python package beside the OpenCV that is installed, and runs the package's tests in place,
# without pip: the fast loop. scripts/releases.sh bookworm installs it by pip in a clean Debian 12.
# The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

need_packages cmake g++ make libopencv-dev pybind11-dev python3-dev python3-numpy python3-pil python3-skimage mypy \
    python3-dask python3-distributed python3-zarr python3-rasterio
build="$cache/python alone"
package="$build/package"
say "building the extension"
build_alone "$build" -DBUILD_PYTHON=ON -DBUILD_SAMPLES=OFF -DPython_EXECUTABLE=/usr/bin/python3
rm -rf "$package"
mkdir -p "$package"
cp -r "$root/python/gwatershed" "$build"/python/_native*.so "$package"
mv "$package"/_native*.so "$package/gwatershed"

# Runs a file of unittest and counts its tests.
run_unittest() { # NAME FILE [VARIABLE=VALUE...]
    local log=$build/$1.log tests failures
    say "$1"
    env "PYTHONPATH=$package" "${@:3}" /usr/bin/python3 "$2" >"$log" 2>&1 || true
    tests=$(sed -n 's/^Ran \([0-9]*\) test.*/\1/p' "$log")
    failures=$(grep -cE '^(FAIL|ERROR): ' "$log" || true)
    if [ -z "$tests" ] || ! grep -q '^OK' "$log"; then
        cat "$log"
        [ "$failures" -gt 0 ] || failures=1
        [ -n "$tests" ] || tests=$failures
    fi
    echo "  $tests tests, $failures failed; $(tail -n 1 "$log")"
    count $((tests - failures)) "$failures"
}

run_unittest interface "$root/misc/python/test/test_gwatershed.py" GWATERSHED_TEST=package
run_unittest package "$root/python/test/test_package.py"
run_unittest functions "$root/python/test/test_functions.py"
run_unittest command "$root/python/test/test_command.py"
run_unittest tiles "$root/python/test/test_tiles.py" PYTHONWARNINGS=ignore
run_unittest "sources of tiles" "$root/python/test/test_tiles_sources.py" PYTHONWARNINGS=ignore

# The library is installed by cmake, the package by pip or by apt.
installs_no_python() {
    rm -rf "$build/installed"
    cmake --install "$build" --prefix "$build/installed" >/dev/null &&
        find "$build/installed" -name 'libopencv_gwatershed*.so*' | grep . &&
        (cd "$build/installed" && ! find . -name '*python*' -o -path './bin/*' | grep .)
}
logs=$build
check "cmake --install leaves the package out" installs_no_python
finish
