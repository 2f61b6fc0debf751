#!/usr/bin/env bash
# Installs what is missing, builds and runs all tests but the long ones, and checks the format.
#   scripts/test.sh            preset release
#   CI=true scripts/test.sh    preset ci (warnings are errors), and the format check is not skipped
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
setup_options=()
if [[ "${CI:-}" == true ]]; then
    preset=ci
    setup_options=(--dev)
fi

bash scripts/setup.sh "${setup_options[@]}"
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --test-dir "build/$preset" --output-on-failure --no-tests=error -j2 -LE '^long$'

if command -v clang-format >/dev/null; then
    bash scripts/check-format.sh
elif [[ "${CI:-}" == true ]]; then
    echo "test: clang-format is missing" >&2
    exit 1
else
    echo "test: no clang-format, format not checked (scripts/setup.sh --dev installs it)"
fi
