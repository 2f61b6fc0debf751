#!/usr/bin/env bash
# Lists the C++ files of src, tests, fuzz, bench and examples that git knows, with the given endings.
#   scripts/list-cpp-files.sh cpp hpp
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

patterns=()
for ending in "$@"; do
    patterns+=("src/*.$ending" "tests/*.$ending" "fuzz/*.$ending" "bench/*.$ending" "examples/*.$ending")
done
# A checkout owned by another user (a container) is fine for reading names.
git -c safe.directory="$PWD" ls-files -- "${patterns[@]}" | while IFS= read -r file; do
    if [[ -f "$file" ]]; then
        echo "$file"
    fi
done
