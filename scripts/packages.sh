#!/usr/bin/env bash
# Makes the Debian packages of the library, for building programs, and of Python, and checks them in a clean Debian 12:
#   scripts/packages.sh [--cached]    with --cached only where that Debian is in the cache
# There, in a folder of the cache, they are installed, a program is built by CMake and by pkg-config, the Python package
# and the command run, another OpenCV is refused, and after apt-get purge nothing is left. It needs root; the first time
# it fetches 0.5 GB. The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$(dirname "${BASH_SOURCE[0]}")/chroot.sh"

release=packages
if [ "${1:-}" = --cached ] && [ ! -s "$chroots/$release/.complete" ]; then
    say "the Debian for the packages is not in the cache: they are left out"
    finish
    exit
fi
# What the packages depend on is there before, so that what they themselves leave can be seen.
make_chroot $release bookworm "" g++ cmake make pkgconf dpkg-dev file pybind11-dev python3-dev python3-numpy \
    python3-pil libopencv-dev
clean=$chroots/$release
logs=$cache/package-logs
mkdir -p "$logs"

# Runs one of the ways of README's block of installing, as it stands there, in the folder of the repository.
run_readme() { # NUMBER
    inside $release mkdir -p /build # kept from the last time
    inside $release ln -sfn /build /gwatershed/build
    inside $release sh -ec "cd /gwatershed
        sudo() { \"\$@\"; }
        export CMAKE_BUILD_PARALLEL_LEVEL=$(nproc)
        $(grep "  *# $1\. " "$root/README.md")"
}

make_packages() {
    inside $release sh -c 'rm -f /build/*.deb' && run_readme 2 && inside $release sh -c 'ls -l /build/*.deb'
}

# All files but the notes of dpkg, apt and ldconfig.
list_files() {
    inside $release find / -xdev \( -path /proc -o -path /sys -o -path /build -o -path /gwatershed \
        -o -path /var/lib/dpkg -o -path /var/lib/apt -o -path /var/cache -o -path /var/log -o -path /tmp \
        -o -path /user \) -prune -o -print | sort
}

# A program of five lines in a folder of its own.
make_program() {
    as_root rm -rf "$clean/user"
    as_root mkdir -p "$clean/user/other"
    as_root tee "$clean/user/superpixels.cpp" >/dev/null <<'CPP'
#include <opencv2/gwatershed.hpp>
int main()
{
    cv::Ptr<cv::ximgproc::SuperpixelGWatershed> gws = cv::ximgproc::createSuperpixelGWatershed(64, 48, 3, 20);
    gws->iterate(cv::Mat(48, 64, CV_8UC3, cv::Scalar(1, 2, 3)));
    return gws->getNumberOfSuperpixels() == 20 ? 0 : 1;
}
CPP
    as_root tee "$clean/user/CMakeLists.txt" >/dev/null <<'CMAKE'
cmake_minimum_required(VERSION 3.12)
project(superpixels CXX)
find_package(gwatershed 0.1 REQUIRED)
add_executable(superpixels superpixels.cpp)
target_link_libraries(superpixels gwatershed::gwatershed)
add_executable(by_old_name superpixels.cpp)
target_link_libraries(by_old_name opencv_gwatershed)
CMAKE
    as_root tee "$clean/user/other/OpenCVConfig.cmake" >/dev/null <<'CMAKE'
set(OpenCV_FOUND TRUE)
set(OpenCV_VERSION 4.99.1)
set(OpenCV_VERSION_MAJOR 4)
set(OpenCV_VERSION_MINOR 99)
CMAKE
}

builds_by_cmake() {
    inside $release sh -c 'cd /user && cmake -S . -B build && cmake --build build &&
        build/superpixels && build/by_old_name'
}

builds_by_pkg_config() {
    inside $release sh -c 'cd /user && pkg-config --modversion gwatershed &&
        g++ superpixels.cpp -o by-pkg-config $(pkg-config --cflags --libs gwatershed) && ./by-pkg-config'
}

refuses_another_opencv() {
    ! inside $release cmake -S /user -B /user/refused -DOpenCV_DIR=/user/other >"$logs/refused" 2>&1 || return 1
    tr -s '\n ' ' ' <"$logs/refused" | grep -o 'It was built with OpenCV 4.6, and here is OpenCV 4.99.1'
}

refuses_another_version() {
    inside $release sed -i 's/gwatershed 0.1/gwatershed 99.0/' /user/CMakeLists.txt
    ! inside $release cmake -S /user -B /user/version >"$logs/version" 2>&1 || return 1
    grep 'requested version "99.0"' "$logs/version"
}

runs_python() {
    inside $release /usr/bin/python3 /gwatershed/python/test/test_package.py &&
    inside $release /usr/bin/python3 /gwatershed/python/test/test_functions.py &&
    inside $release /usr/bin/python3 /gwatershed/python/test/test_command.py &&
    inside $release env GWATERSHED_TEST=package /usr/bin/python3 /gwatershed/misc/python/test/test_gwatershed.py
}

runs_command() {
    inside $release sh -c 'cd /user && python3 -c "
from PIL import Image
Image.linear_gradient(\"L\").save(\"ramp.png\")" && gwatershed ramp.png -o contours.png --number 30 &&
        [ -s contours.png ] && gwatershed-tiles --help'
}

copy_inside $release /gwatershed
inside $release sh -c 'dpkg --purge $(dpkg-query -W -f "\${Package} " "*gwatershed*") 2>/dev/null' || true
say "making the packages"
check "packages" make_packages
make_program
list_files >"$logs/before"
check "install" inside $release sh -c 'apt-get install -y --no-install-recommends /build/*.deb'
check "a program, by CMake" builds_by_cmake
check "a program, by pkg-config" builds_by_pkg_config
check "another OpenCV is refused" refuses_another_opencv
check "another version is refused" refuses_another_version
check "Python" runs_python
check "the command" runs_command
check "purge" inside $release sh -c 'apt-get purge -y $(dpkg-query -W -f "\${Package} " "*gwatershed*")'
list_files >"$logs/after"
check "nothing is left" diff "$logs/before" "$logs/after"

# The library by CMake, without packages.
inside $release sed -i 's/gwatershed 99.0/gwatershed 0.1/' /user/CMakeLists.txt
inside $release rm -rf /user/build
check "installed by CMake" run_readme 3
inside $release ldconfig
check "a program, by CMake, of what CMake installed" builds_by_cmake
check "a program, by pkg-config, of what CMake installed" builds_by_pkg_config
check "uninstalled" inside $release cmake --build /build --target uninstall
inside $release ldconfig
list_files >"$logs/after"
check "nothing is left of what CMake installed" diff "$logs/before" "$logs/after"
finish
