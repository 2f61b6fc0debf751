#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy on the C++ files of src, tests and bench, on all cores; any finding is an error.
# Files of a folder of src are joined by 24, as a unity build joins them: their headers are then read once, which takes
# most of the time.
#   scripts/check-tidy.sh [folder]    a folder, or a pattern of grep, checks only what is in it
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=build/tidy
cmake --preset tidy >/dev/null

mapfile -t files < <(bash scripts/list-cpp-files.sh cpp | { grep "^${1:-}" || true; })  # headers are checked where they are included
if ((${#files[@]} == 0)); then
    echo "check-tidy: no files found" >&2
    exit 1
fi

joined=$build/joined
rm -rf "$joined"
units=()
declare -A members  # of a folder so far
for file in "${files[@]}"; do
    # Tests have helpers of the same names, a verilated core wants its clock where SystemC has one, and the version is a
    # flag of few files.
    if [[ "$file" != src/* ]] || grep -qE '^#include <V|FASTER_VERSION' "$file"; then
        units+=("$file")
        continue
    fi
    folder=$(dirname "$file")
    for library in src/modules src/dataflow/core; do # of many folders, which a unity build joins
        [[ "$folder" != "$library"/* ]] || folder=$library
    done
    number=${members[$folder]:-0}
    members[$folder]=$((number + 1))
    # Flags are those of the file whose path is nearest.
    unit=$joined/$folder/joined_$((number / 24)).cpp
    if ((number % 24 == 0)); then
        mkdir -p "$(dirname "$unit")"
        units+=("$unit")
    fi
    echo "#include \"$PWD/$file\"  // NOLINT(bugprone-suspicious-include)" >>"$unit"
done

# A clang-tidy that crashes (it does, once in some thousand files) has found nothing yet: it gets a second chance.
tidy_one() {
    clang-tidy -p "$1" -quiet -warnings-as-errors='*' "$2" && return 0
    (($? < 128)) && return 1
    echo "check-tidy: clang-tidy crashed on $2; once more" >&2
    clang-tidy -p "$1" -quiet -warnings-as-errors='*' "$2"
}
export -f tidy_one

# clang-tidy counts the warnings it suppresses, most of them in system headers; nobody wants to read that.
if ! printf '%s\0' "${units[@]}" |
    xargs -0 -n 1 -P "$(nproc)" bash -c 'tidy_one "$0" "$1"' "$build" 2>&1 |
    { grep -vE '^[0-9]+ warnings? (generated|treated as error)' || true; }; then
    echo "check-tidy: there are findings" >&2
    exit 1
fi
echo "check-tidy: ${#files[@]} files are fine"
