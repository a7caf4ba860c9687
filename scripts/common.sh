# Shared by the scripts beside it; sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cache=${XDG_CACHE_HOME:-$HOME/.cache}/gwatershed

say() { printf '== %s\n' "$*"; }
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

# For scripts whose last line is "N passed, N failed".
passed=0
failed=0
count() { # PASSED FAILED
    passed=$((passed + $1))
    failed=$((failed + $2))
}
finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
}

# Runs a command as one check. Its output becomes the file $log in the folder $logs; the end is shown if it fails.
check() { # NAME COMMAND...
    local name=$1
    log=$logs/${1//[ \/]/-}.log
    shift
    if "$@" >"$log" 2>&1; then
        echo "  ok      $name"
        count 1 0
    else
        tail -n 40 "$log"
        echo "  FAILED  $name; log: $log"
        count 0 1
    fi
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        DEBIAN_FRONTEND=noninteractive "$@"
    elif command -v sudo >/dev/null; then
        sudo DEBIAN_FRONTEND=noninteractive "$@"
    else
        fail "not root and no sudo; please run as root: $*"
    fi
}

# Installs those of the named Debian packages that are missing.
need_packages() {
    local package missing=()
    if ! command -v apt-get >/dev/null; then
        say "no apt-get here; this needs what Debian calls: $*"
        return
    fi
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
    done
    [ ${#missing[@]} = 0 ] && return
    say "installing through apt: ${missing[*]}"
    as_root apt-get -qq update
    as_root apt-get -qq install -y --no-install-recommends "${missing[@]}" >/dev/null
}

# What a build of OpenCV can do without here. Debian's source does not have all of it.
lean=(-DENABLE_PRECOMPILED_HEADERS=OFF)
for name in IPP ITT FFMPEG GSTREAMER OPENCL ADE QUIRC OPENEXR WEBP TIFF JASPER OPENJPEG GTK V4L 1394 \
            PROTOBUF EIGEN LAPACK; do
    lean+=("-DWITH_$name=OFF")
done

# Builds the module alone, against Debian's OpenCV, in a folder; $alone is the one that the scripts share.
alone="$cache/module alone" # paths with a space must do
build_alone() { # [FOLDER] [OPTIONS OF CMAKE...]
    local folder=${1:-$alone}
    grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt" ||
        rm -f "$folder/CMakeCache.txt" # of a clone elsewhere
    cmake -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release "${@:2}" >/dev/null &&
        cmake --build "$folder" --parallel "$(nproc)" >/dev/null
}

# Runs a program of GoogleTest and counts what its report says; no report is a failure. Its files go to $results.
run_gtest() { # NAME PROGRAM ARGUMENTS...
    local name=$1 xml=$results/$1.xml tests failures
    shift
    say "$name"
    "$@" "--gtest_output=xml:$xml" >"$results/$name.log" 2>&1 || true
    if [ ! -s "$xml" ]; then
        tail -n 40 "$results/$name.log"
        echo "  $name ended without a report"
        count 0 1
        return
    fi
    tests=$(sed -n 's/.*<testsuites tests="\([0-9]*\)".*/\1/p' "$xml")
    failures=$(sed -n 's/.*<testsuites tests="[0-9]*" failures="\([0-9]*\)".*/\1/p' "$xml")
    if [ "${tests:-0}" -eq 0 ]; then
        echo "  $name ran no test"
        count 0 1
        return
    fi
    grep -E -B 20 '^\[  FAILED  \]' "$results/$name.log" || true
    echo "  $tests tests, $failures failed; log: $results/$name.log"
    count $((tests - failures)) "$failures"
}
