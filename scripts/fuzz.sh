#!/usr/bin/env bash
# Fuzzes every reader and the engine for MINUTES in all, an equal share each, and prints a line per target: inputs tried,
# inputs that reach new code. Inputs that do harm (a crash, a sanitizer's report, more than 10 s or 2 GiB) are left in
# build/fuzz/found; the exit code is 1 if there are any. The target `designs` needs no fuzzer: it compares random designs
# (tests/chance) of seeds that were never tried, and its log names those that do not agree.
#   scripts/fuzz.sh MINUTES [-j JOBS] [TARGET...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [[ $# -lt 1 || ! "$1" =~ ^[0-9]+$ ]]; then
    echo "usage: scripts/fuzz.sh MINUTES [-j JOBS] [TARGET...]" >&2
    exit 2
fi
minutes=$1
shift
jobs=$(nproc)
if [[ "${1:-}" == -j ]]; then
    jobs=$2
    shift 2
fi

program=$PWD/build/fuzz/bin/faster_fuzz
targets=("$@")
if [[ "${targets[*]}" != designs ]]; then
    cmake --preset fuzz > /dev/null
    cmake --build --preset fuzz -- -j "$jobs"
fi
if [[ ${#targets[@]} -eq 0 ]]; then
    mapfile -t targets < <("$program" --list)
    targets+=(designs)
fi
if [[ " ${targets[*]} " == *" designs "* ]]; then
    cmake --preset release > /dev/null
    cmake --build --preset release --target faster_random_design_tests -- -j "$jobs"
fi
rounds=$(((${#targets[@]} + jobs - 1) / jobs))
seconds=$((minutes * 60 / rounds))

mkdir -p build/fuzz/found build/fuzz/logs
fuzz_one() { # TARGET: new inputs are kept in build/fuzz/corpus, beside the ones of the tree
    local work=build/fuzz/corpus/$1
    mkdir -p "$work"
    local log=build/fuzz/logs/$1.log status=0 files
    files=$(mktemp -d -p "$in_memory") # what readers get; the fuzzer ends without removing anything
    # The readers of meshes and the engine fork; what a killed child leaks is not theirs.
    TMPDIR=$files ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
        "$program" --target="$1" "$work" "fuzz/corpus/$1" -max_total_time="$seconds" -timeout=10 \
        -rss_limit_mb=2048 -max_len=65536 -artifact_prefix="build/fuzz/found/$1-" -print_final_stats=1 \
        > "$log" 2>&1 || status=$?
    rm -rf "$files"
    local tried new
    tried=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log" | tail -n 1)
    new=$(sed -n 's/^stat::new_units_added: *//p' "$log" | tail -n 1)
    if [[ $status -eq 0 ]]; then # what is left then comes from children that may crash: they read meshes
        rm -f build/fuzz/found/"$1"-*
    fi
    echo "$1: ${tried:-0} inputs, ${new:-0} new, $([[ $status -eq 0 ]] && echo fine || echo "HARM, see $log")"
    return "$status"
}
try_designs() { # a hundred at a time, from seeds of this second on
    local log=build/fuzz/logs/designs.log status=0 tried=0 end=$((SECONDS + seconds)) first
    first=$(date +%s)000
    : > "$log"
    while [[ $status -eq 0 && $SECONDS -lt $end ]]; do
        CHANCE_SEED=$((first + tried)) CHANCE_DESIGNS=100 build/release/bin/faster_random_design_tests \
            'random designs do the same*' >> "$log" 2>&1 || status=$?
        tried=$((tried + 100))
    done
    echo "designs: $tried designs from seed $first on, $([[ $status -eq 0 ]] && echo fine || echo "HARM, see $log")"
    return "$status"
}
export -f fuzz_one try_designs
in_memory=$(test -d /dev/shm && echo /dev/shm || echo "${TMPDIR:-/tmp}")
export program seconds in_memory
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c 'if [[ {} == designs ]]; then try_designs; else fuzz_one {}; fi' || exit 1
