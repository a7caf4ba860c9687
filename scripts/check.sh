#!/usr/bin/env bash
# Reads the sources for rules that they must keep (rooms.py), and builds the module, with the program
# tools/fuzz/stress.cpp, under sanitizers and checkers; a line for each.
# The logs stay in the cache. The last line is "N passed, N failed".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

place=$cache/check
logs=$place/logs

build() { # FOLDER TARGET COMPILER FLAGS
    cmake -S "$root/tools/fuzz" -B "$place/$1" "-DCMAKE_CXX_COMPILER=$3" "-DCMAKE_CXX_FLAGS=$4" >/dev/null &&
        cmake --build "$place/$1" --target "$2" --parallel "$(nproc)"
}

# A program that a sanitizer is built into.
sanitize() { # FOLDER FLAGS ARGUMENTS...
    build "$1" stress clang++-14 "-O1 -g $2" && "$place/$1/stress" "${@:3}"
}

# Valgrind of Debian 12 does not read what clang writes about the source by default.
run_valgrind() { # FOLDER ARGUMENTS...
    build "$1" stress clang++-14 "-O1 -gdwarf-4" &&
        valgrind --quiet --error-exitcode=1 --leak-check=full --errors-for-leak-kinds=definite \
            "$place/$1/stress" "${@:2}"
}

no_warning_in() { # LOG
    grep -q 'Built target gwatershed' "$1" && ! grep -E "^$root/(src|include)/.*warning:" "$1" | sort -u | grep .
}

warn() { # FOLDER COMPILER FLAGS
    build "$1" gwatershed "$2" "$3" >"$place/$1.build" 2>&1 && no_warning_in "$place/$1.build"
}

tidy() { # FOLDER OF A BUILD
    find "$root/src" -name '*.cpp' -print0 |
        xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 -p "$place/$1" --quiet "--header-filter=^$root/(src|include)/"
}

need_packages cmake make g++ python3 clang-14 clang-tidy-14 libclang-rt-14-dev valgrind libopencv-dev
rm -rf "$place"
mkdir -p "$logs"
# Without this option the search for leaks of clang 14 breaks down where threads have ended.
export ASAN_OPTIONS=intercept_tls_get_addr=0
export OPENCV_ENABLE_MEMALIGN=1 # else images have room at their end, which hides what is read there

say "building and running under sanitizers and checkers; it takes some minutes"
check "rooms" "$root/scripts/rooms.py"
check "addresses and undefined behaviour" \
    sanitize addresses "-fsanitize=address,undefined -fno-sanitize-recover=all" 200
check "threads" sanitize threads -fsanitize=thread 100
check "valgrind" run_valgrind memory 40 400
check "no warning of clang" no_warning_in "$logs/addresses-and-undefined-behaviour.log"
check "no warning of g++" warn g++ g++ -O2
check "clang-tidy" tidy addresses

finish
