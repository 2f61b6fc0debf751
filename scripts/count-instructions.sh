#!/usr/bin/env bash
# Counts the instructions of a few commands (Valgrind's cachegrind) and compares them with bench/instructions.csv: what
# got slower shows on any host, however busy. A run is counted without what its first sample costs, most of which is the
# workload's noise, whose functions the C library chooses by the host.
#   scripts/count-instructions.sh [PRESET]              preset ci by default; fails if one is 5 % above the kept figure
#   scripts/count-instructions.sh --update [PRESET]     keeps the figures found
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

update=false
if [[ "${1:-}" == --update ]]; then
    update=true
    shift
fi
binaries="$PWD/build/${1:-ci}/bin"
program="$binaries/faster-sim"
kept=bench/instructions.csv
most_percent=105
if ! command -v valgrind >/dev/null; then
    echo "count-instructions: valgrind is missing (scripts/setup.sh --dev installs it)" >&2
    exit 1
fi
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

# count NAME PROGRAM WORD...: its instructions, in a file of that name
count() {
    valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null "$binaries/$2" "${@:3}" 2>&1 >/dev/null |
        awk '/I +refs/ { gsub(",", "", $NF); print $NF }' >"$work/$1"
}
run() {
    echo faster-sim run configs/banana.yaml -j 1 --set "accelerator.architecture=$1" --set "workload.samples.count=$2"
}
designs=(faster setup_overlap)
jobs=()
for design in "${designs[@]}"; do
    read -ra words <<<"$(run "$design" 12)"
    "$program" "${words[@]:1}" --events "$work/$design.events" >/dev/null
    jobs+=("run_$design.1 $(run "$design" 1)" "run_$design.12 $(run "$design" 12)"
        "whatif_$design faster-sim whatif $work/$design.events --set accelerator.fifos.edge_token.depth=7")
done
jobs+=("pipeline pipeline run examples/pipeline/pipeline.yaml -j 1 --set workload.numbers=1000000"
    "dot_product dot_product run examples/published/dot_product.yaml -j 1 --set workload.words=100000")
export -f count
export binaries work
printf '%s\n' "${jobs[@]}" | xargs -P "$(nproc)" -I {} bash -c 'count {}'

found="$work/found"
echo "command,instructions" >"$found"
for design in "${designs[@]}"; do
    echo "run $design,$(($(cat "$work/run_$design.12") - $(cat "$work/run_$design.1")))"
    echo "whatif $design,$(cat "$work/whatif_$design")"
done >>"$found"
for example in pipeline published/dot_product; do
    echo "examples/$example,$(cat "$work/${example#*/}")"
done >>"$found"
if [[ "$update" == true ]]; then
    cp "$found" "$kept"
fi
awk -F, -v most="$most_percent" '
    FNR == 1 { next }
    NR == FNR { kept[$1] = $2; next }
    {
        percent = kept[$1] ? 100 * $2 / kept[$1] : 0
        printf "%-32s %8.1f million instructions, %5.1f %% of those kept\n", $1, $2 / 1e6, percent
        if (percent == 0 || percent > most) worse = 1
    }
    END { exit worse }' "$kept" "$found" || {
    echo "count-instructions: more than $most_percent % of $kept; scripts/count-instructions.sh --update keeps what is meant" >&2
    exit 1
}
