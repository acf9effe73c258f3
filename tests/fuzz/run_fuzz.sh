#!/bin/sh
# tests/fuzz/run_fuzz.sh [SECONDS] [BUILD_FOLDER]
# Builds the fuzz targets with clang and sanitizers and runs each for SECONDS (20). Any crash, leak, hang or memory above
# 1 GiB fails; the input that caused it stays in BUILD_FOLDER (build/fuzz) as crash-*, leak-*, timeout-* or oom-*.
set -eu
seconds=${1:-20}
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${2:-$root/build/fuzz}
clang=$(command -v clang++-14 || command -v clang++) || {
    echo "run_fuzz.sh: no clang++ found; apt-get install clang libclang-rt-14-dev" >&2
    exit 2
}
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$clang" -DTUMBLE_FUZZ=ON >"$build.log" 2>&1 || {
    cat "$build.log" >&2
    exit 2
}
ninja -C "$build" fuzz_stl fuzz_clump fuzz_scene
cd "$build"
for target in stl clump scene; do
    mkdir -p "found/$target"
    seeds="$root/tests/fuzz/corpus/$target"
    dictionary=
    [ "$target" = scene ] && dictionary="-dict=$root/tests/fuzz/scene.dict"
    echo "fuzz_$target: $seconds s"
    "$(find . -name "fuzz_$target" -type f)" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -max_len=65536 \
        -print_final_stats=1 -verbosity=0 $dictionary "found/$target" "$seeds"
done
echo "fuzzing found nothing"
