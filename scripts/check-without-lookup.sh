#!/usr/bin/env bash
# Builds without the room dataflow/lookup and runs the engine tests that compare both engines with a twin: cycles do not depend
# on what is remembered. Works in the build folder of a preset, where little is compiled again, and leaves it as it was.
#   scripts/check-without-lookup.sh [--all] [PRESET]    preset ci by default; --all: every engine test, twice as long
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tests='^faster_engine_tests\.Engines (and twin )?agree'
if [[ "${1:-}" == --all ]]; then
    tests='^faster_engine_tests\.'
    shift
fi
folder="build/${1:-ci}"
configure() {
    cmake -S . -B "$folder" -DFASTER_LOOKUP="$1" >/dev/null
}
trap 'configure ON' EXIT
configure OFF
cmake --build "$folder" --target faster_engine_tests
ctest --test-dir "$folder" --output-on-failure --no-tests=error -j "$(nproc)" -R "$tests"
