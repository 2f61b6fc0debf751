#!/usr/bin/env bash
# Builds with sanitizers and runs the tests under them: unit, engine and cli with address and undefined behaviour; those
# that start threads with the thread sanitizer. Both builds take about 70 minutes of processor time.
#   scripts/test-sanitized.sh [JOBS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=${1:-$(nproc)}

cmake --preset asan-ubsan > /dev/null
cmake --build --preset asan-ubsan -- -j "$jobs"
ASAN_OPTIONS=detect_stack_use_after_return=0 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    ctest --test-dir build/asan-ubsan -j "$jobs" -L '^(unit|engine|cli)$' -LE '^(long|cluster)$' --output-on-failure

cmake --preset tsan > /dev/null
cmake --build --preset tsan -- -j "$jobs" faster_kernel_tests faster_pose_tests faster_engine_tests faster_unit_tests
TSAN_OPTIONS=halt_on_error=1 ctest --test-dir build/tsan -j "$jobs" \
    -R 'faster_(kernel|pose|engine|unit)_tests\..*([Tt]hread|jobs|last that holds|[Ss]izing|[Jj]udge|[Rr]etim|GRIP)' \
    -LE '^(long|cluster)$' --output-on-failure
