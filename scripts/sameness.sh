#!/usr/bin/env bash
# Checks that results do not depend on threads, parallel back ends, processors, compilers, their options and
# versions of OpenCV: prints a hash for each of 200 cases (tools/checks/sameness.cpp) in all these ways and compares.
#   scripts/sameness.sh
# The pthreads of OpenCV 4.6.0, and 4.10.0, take part where scripts/test.sh has built them.
# The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

place=$cache/sameness

# Builds the module alone, with the option that its CMake files give, because results depend on it. It is not called as
# the one of scripts/test.sh, which is on the path, too.
build_module() { # NAME COMPILER FLAGS INCLUDES...
    say "building the module, $1"
    mkdir -p "$place/$1"
    (cd "$place/$1" && find "$root/src" -name '*.cpp' -print0 |
        xargs -0 -n 1 -P "$(nproc)" "$2" -std=c++11 -fPIC -ffp-contract=off $3 -I"$root/include" -I"$root/src" \
            "${@:4}" -c &&
        "$2" -shared *.o -o libgwatershed.so) || fail "the build failed"
}

# Builds the program, once for each OpenCV: all modules for that are loaded by the same one.
build_program() { # NAME MODULE FLAGS...
    g++ -std=c++11 -O2 -fopenmp -I"$root/include" "$root"/tools/checks/{sameness,images}.cpp -o "$place/$1" \
        "${@:3}" -L"$place/$2" -Wl,--no-as-needed -lgwatershed -lopencv_imgproc -lopencv_core
}

# Compares the table of one way with that of the first. A case that was not reached differs.
compare() { # NAME LIBRARIES PROGRAM ARGUMENTS...
    local name=$1 libraries=$2 program=$place/$3 table=$place/tables/$1 differ
    shift 3
    LD_LIBRARY_PATH=$libraries "$program" "$@" >"$table" 2>"$place/tables/errors" || cat "$place/tables/errors"
    differ=$(diff "$place/tables/first" "$table" | grep -c '^<' || true)
    if [ "$differ" = 0 ]; then
        echo "  ok      $name"
        count 1 0
    else
        echo "  FAILED  $name: $differ of $cases cases differ; see $table"
        count 0 1
    fi
}

need_packages g++ clang libopencv-dev pkg-config
rm -rf "$place"
mkdir -p "$place/tables"
read -ra debian < <(pkg-config --cflags opencv4)

build_module g++-O3 g++ -O3 "${debian[@]}"
build_program sameness g++-O3 "${debian[@]}"
LD_LIBRARY_PATH=$place/g++-O3 "$place/sameness" >"$place/tables/first"
cases=$(wc -l <"$place/tables/first")
say "$cases cases; the first table is of g++ -O3, Debian's OpenCV, one thread"

say "threads and back ends"
export OMP_WAIT_POLICY=passive # there may be more threads than processors
pthreads=$cache/4.6.0/build/lib
[ -d "$pthreads" ] || say "OpenCV 4.6.0 is not in the cache: pthreads are left out"
for threads in 1 2 3 8; do
    compare "TBB, $threads threads" "$place/g++-O3" sameness --threads=$threads
    compare "OpenMP, $threads threads" "$place/g++-O3" sameness --threads=$threads --openmp
    [ ! -d "$pthreads" ] || compare "pthreads, $threads threads" "$place/g++-O3:$pthreads" sameness --threads=$threads
done

say "processors"
compare "setUseOptimized(false)" "$place/g++-O3" sameness --plain
OPENCV_CPU_DISABLE=SSE4.1,SSE4.2,AVX,FP16,AVX2,AVX512-SKX \
    compare "OpenCV without the code for newer processors" "$place/g++-O3" sameness

build_module emulated g++ "-O3 -DCV_FORCE_SIMD128_CPP" "${debian[@]}"
compare "intrinsics as plain C++" "$place/emulated" sameness --threads=3

for compiler in g++ clang++; do
    for flags in -O0 -O3 "-O3 -march=x86-64-v3"; do
        name=${compiler}${flags// -march=/-}
        [ "$name" != g++-O3 ] || continue
        if [[ $flags == *v3 ]] && ! grep -qw fma /proc/cpuinfo; then
            say "$flags is left out: this processor does not have all of it"
            continue
        fi
        build_module "$name" "$compiler" "$flags" "${debian[@]}"
        compare "$compiler $flags, 3 threads" "$place/$name" sameness --threads=3
    done
done

newer=$cache/4.10.0
if [ -d "$newer/build/lib" ]; then
    includes=("-I$newer"/{build,source/modules/{core,imgproc}/include})
    build_module 4.10.0 g++ -O3 "${includes[@]}"
    build_program sameness-4.10.0 4.10.0 "${includes[@]}" "-L$newer/build/lib"
    for threads in 1 8; do
        compare "OpenCV 4.10.0, $threads threads" "$place/4.10.0:$newer/build/lib" sameness-4.10.0 --threads=$threads
    done
else
    say "OpenCV 4.10.0 is not in the cache: it is left out"
fi

finish
