#!/usr/bin/env bash
# Installs what is missing, builds and runs all tests but the long ones and those that want a cluster, and checks the format.
#   scripts/test.sh            preset release
#   scripts/test.sh --tidy     also clang-tidy, which takes minutes
#   CI=true scripts/test.sh    preset ci (warnings are errors), clang-tidy, instructions counted, engine tests without
#                              dataflow/lookup, the changes of docs/changing-the-design.md, the .deb in a bare Debian, 10
#                              seconds of fuzzing; a missing clang-format is an error
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
tidy=false
for argument in "$@"; do
    case "$argument" in
        --tidy) tidy=true ;;
        -h | --help)
            echo "usage: test.sh [--tidy]"
            exit 0
            ;;
        *)
            echo "test: unknown argument '$argument'; expected --tidy" >&2
            exit 2
            ;;
    esac
done
if [[ "${CI:-}" == true ]]; then
    preset=ci
    tidy=true
    export FASTER_FUZZ_SECONDS=10 # of mutation of the kept inputs, on one core
fi

setup_options=()
if [[ "$tidy" == true ]]; then
    setup_options=(--dev)
fi

bash scripts/setup.sh "${setup_options[@]}"

# What takes seconds comes first.
bash scripts/check-layers.sh
python3 scripts/check-comments.py
if command -v clang-format >/dev/null; then
    bash scripts/check-format.sh
elif [[ "${CI:-}" == true ]]; then
    echo "test: clang-format is missing" >&2
    exit 1
else
    echo "test: no clang-format, format not checked (scripts/setup.sh --dev installs it)"
fi

cmake --preset "$preset"
cmake --build --preset "$preset"
# One more than there are cores: some wait for browsers and servers.
ctest --test-dir "build/$preset" --output-on-failure --no-tests=error -j "$(($(nproc) + 1))" -LE '^(long|cluster)$'

if [[ "${CI:-}" == true ]]; then
    # They mostly wait for the disk and for apt, or keep one core busy, so others go on beside them; but not what builds in
    # their folder.
    beside_log="build/$preset/beside.log"
    (bash scripts/count-instructions.sh "$preset" && bash scripts/check-package.sh "$preset") >"$beside_log" 2>&1 &
    beside=$!
    trap 'wait "$beside" 2>/dev/null || true' EXIT
    bash scripts/check-changes.sh "$preset"
fi

if [[ "$tidy" == true ]]; then
    if ! command -v clang-tidy >/dev/null; then
        echo "test: clang-tidy is missing" >&2
        exit 1
    fi
    # What decides cycles; all of src and tests takes a quarter of an hour on 2 cores: scripts/check-tidy.sh, by hand.
    bash scripts/check-tidy.sh 'src/\(channels\|modules\|dataflow/core\)/'
fi

if [[ "${CI:-}" == true ]]; then
    trap - EXIT
    wait "$beside" || {
        cat "$beside_log" >&2
        exit 1
    }
    cat "$beside_log"
    bash scripts/check-without-lookup.sh "$preset"
fi
