#!/usr/bin/env bash
# Checks the format of all C++ files of src, tests and bench; --fix rewrites them instead.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mode=(--dry-run -Werror)
if [[ "${1:-}" == --fix ]]; then
    mode=(-i)
fi

# A checkout owned by another user (a container) is fine for reading names.
list=$(git -c safe.directory="$PWD" ls-files -- \
    'src/*.hpp' 'src/*.cpp' 'tests/*.hpp' 'tests/*.cpp' 'bench/*.hpp' 'bench/*.cpp')
files=()
while IFS= read -r file; do
    if [[ -f "$file" ]]; then
        files+=("$file")
    fi
done <<<"$list"

if ((${#files[@]} == 0)); then
    echo "check-format: no files found" >&2
    exit 1
fi
clang-format "${mode[@]}" "${files[@]}"
echo "check-format: ${#files[@]} files are fine"
