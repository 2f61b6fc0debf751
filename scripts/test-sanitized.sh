#!/usr/bin/env bash
# Builds with sanitizers and runs tests under them: unit, engine and cli with address and undefined behaviour; those that
# start threads, in the engine and in the commands, with the thread sanitizer. What the sanitizers say is in
# build/PRESET/reports.
#   scripts/test-sanitized.sh [JOBS]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs=${1:-$(nproc)}
status=0

# Into files: commands have to be silent on stderr.
reports_of() { # PRESET
    mkdir -p "build/$1/reports"
    rm -f "build/$1/reports/"*
    echo "log_path=$PWD/build/$1/reports/report"
}
show_reports() { # PRESET
    local report
    while read -r report; do
        cat "$report"
        status=1
    done < <(grep -lrE 'ERROR: |runtime error|WARNING: ThreadSanitizer' "build/$1/reports" || true)
}

cmake --preset asan-ubsan > /dev/null
cmake --build --preset asan-ubsan --target faster-sim faster_kernel_tests faster_unit_tests faster_image_tests \
    faster_pose_tests faster_fuzz_tests faster_engine_tests faster_cli_tests -- -j "$jobs"
# The leak sanitizer sometimes fails on the stacks of SystemC's processes. Tests that let calls of the system fail would
# hit the sanitizer's own, as do those without descriptors: whether an object may be looked at, it asks by a pipe.
asan=detect_stack_use_after_return=0:$(reports_of asan-ubsan)
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
# Instead of 20: each is three runs of a command, which takes ten times as long here.
export FASTER_INTERRUPTIONS=8
ASAN_OPTIONS=$asan ctest --test-dir build/asan-ubsan -j "$jobs" -L '^unit$' --output-on-failure || status=1
ASAN_OPTIONS=$asan:detect_leaks=0 ctest --test-dir build/asan-ubsan -j "$jobs" -L '^(engine|cli)$' \
    -E 'A call of the system that fails|A folder is replaced in two|A signal that comes when|Whatever the number of desc' --output-on-failure || status=1
show_reports asan-ubsan

cmake --preset tsan > /dev/null
cmake --build --preset tsan --target faster-sim faster_engine_tests faster_cli_tests -- -j "$jobs"
TSAN_OPTIONS=halt_on_error=1:die_after_fork=0:$(reports_of tsan)
export TSAN_OPTIONS
ctest --test-dir build/tsan -j "$jobs" \
    -R 'faster_(engine|cli)_tests\..*([Tt]hreads|jobs|in the background|sensitivities of an event file)' \
    --no-tests=error --output-on-failure || status=1
for architecture in faster setup_overlap spans; do
    build/tsan/bin/faster-sim run configs/banana.yaml -j 2 --set "accelerator.architecture=$architecture" \
        --events build/tsan/run.events >/dev/null || status=1
done
show_reports tsan
exit "$status"
