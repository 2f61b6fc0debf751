#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy on all C++ files of src, tests and bench, on all cores; any finding is an error.
#   scripts/check-tidy.sh [build folder]    the folder's compile_commands.json says how each file is compiled (build/ci)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build="${1:-build/ci}"
if [[ ! -f "$build/compile_commands.json" ]]; then
    echo "check-tidy: no compile_commands.json in $build; cmake --preset ci writes it to build/ci" >&2
    exit 1
fi

# Headers are checked where they are included. A checkout owned by another user (a container) is fine for reading names.
list=$(git -c safe.directory="$PWD" ls-files -- 'src/*.cpp' 'tests/*.cpp' 'bench/*.cpp')
files=()
while IFS= read -r file; do
    if [[ -f "$file" ]]; then
        files+=("$file")
    fi
done <<<"$list"

if ((${#files[@]} == 0)); then
    echo "check-tidy: no files found" >&2
    exit 1
fi

# clang-tidy counts the warnings it suppresses, most of them in system headers; nobody wants to read that.
if ! printf '%s\0' "${files[@]}" |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$build" -quiet -warnings-as-errors='*' 2>&1 |
    { grep -vE '^[0-9]+ warnings? (generated|treated as error)' || true; }; then
    echo "check-tidy: there are findings" >&2
    exit 1
fi
echo "check-tidy: ${#files[@]} files are fine"
