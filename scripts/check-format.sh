#!/usr/bin/env bash
# Checks the format of all C++ files of src, tests, bench and examples; --fix rewrites them instead.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(--dry-run -Werror)
if [[ "${1:-}" == --fix ]]; then
    mode=(-i)
fi

mapfile -t files < <(bash scripts/list-cpp-files.sh cpp hpp)
if ((${#files[@]} == 0)); then
    echo "check-format: no files found" >&2
    exit 1
fi
clang-format "${mode[@]}" "${files[@]}"
echo "check-format: ${#files[@]} files are fine"
