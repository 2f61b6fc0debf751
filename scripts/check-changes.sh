#!/usr/bin/env bash
# Tries the changes of docs/changing-the-design.md: that each patch has the size which the page states, applies, builds with
# the kernel as it is, and shows in the results. Works in build/changes, on a copy of the model; a second run compiles only
# what differs.
#   scripts/check-changes.sh [PRESET]    default ci: whose build has the kernel
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset="${1:-ci}"
page=docs/changing-the-design.md
patches=(new_fifo new_loop new_key new_figure new_algorithm new_module)
root="$PWD/build/changes"
copy="$root/src"
out="$root/out"
mkdir -p "$root" "$copy"
log="$root/log"

complain() {
    echo "check-changes: $1" >&2
    exit 1
}
quietly() {
    "$@" >"$log" 2>&1 || {
        cat "$log" >&2
        complain "'$*' failed"
    }
}

# Each alone has the size that the page states: | [`NAME`](changes/NAME.patch) | ... | FILES | + LINES | - LINES |
for name in "${patches[@]}"; do
    patch="docs/changes/$name.patch"
    git apply --check "$patch" || complain "$patch does not apply; git apply --3way, then git diff HEAD makes it again"
    size="$(git apply --numstat "$patch" | awk '{ added += $1; removed += $2 } END { print NR, added, removed }')"
    stated="$(awk -F'|' -v link="(changes/$name.patch)" \
        'index($2, link) { gsub(/ /, ""); print $4, substr($5, 2), substr($6, 2), $7 }' "$page")"
    read -r files added removed limit <<<"$stated" || true
    [[ "$size" == "$files $added $removed" ]] ||
        complain "$patch has $size (files, lines added, removed), $page says '$stated'"
    ((files <= limit)) || complain "$patch touches $files files, expected at most $limit"
done

# The model with all of them: each finds its place with a line around it, as others may have changed the next. What has
# not changed since the last time keeps its time, and is not compiled again. Git must not take the copy for a part of
# this repository, whose files it would look for.
stage="$root/stage"
rm -rf "$stage"
mkdir "$stage"
cp -r CMakeLists.txt CMakePresets.json cmake configs rtl src "$stage"
for name in "${patches[@]}"; do
    patch="$PWD/docs/changes/$name.patch"
    quietly env GIT_CEILING_DIRECTORIES="$root" git -C "$stage" apply -C1 "$patch"
done
for folder in cmake configs rtl src; do
    [[ ! -d "$copy/$folder" ]] || (cd "$copy" && find "$folder" -type f)
done | while IFS= read -r file; do
    [[ -e "$stage/$file" ]] || rm "$copy/$file"
done
(cd "$stage" && find . -type f) | while IFS= read -r file; do
    cmp -s "$stage/$file" "$copy/$file" && continue
    mkdir -p "$(dirname "$copy/$file")"
    cp "$stage/$file" "$copy/$file"
done

# The kernel is not compiled again, nor are commands around poses compiled: no change touches them. The rest is not
# optimized: it compiles for longer than it runs.
[[ -e "build/$preset/build.ninja" ]] || quietly cmake --preset "$preset"
quietly cmake --build --preset "$preset" --target faster-sim
quietly cmake --install "build/$preset" --prefix "$root/kernel"
(
    cd "$copy"
    quietly cmake --preset "$preset" -DFASTER_KERNEL="$root/kernel" -DFASTER_BUILD_POSES=OFF -DFASTER_BUILD_EXAMPLES=OFF \
        -DFASTER_BUILD_PYTHON=OFF -DCMAKE_DISABLE_FIND_PACKAGE_verilator=ON \
        -DCMAKE_BUILD_TYPE=None -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
    quietly cmake --build --preset "$preset" --target faster-sim
)
before="$PWD/build/$preset/bin/faster-sim"
after="$copy/build/$preset/bin/faster-sim"

samples=20
rm -rf "$out"
mkdir "$out"
# A trace: to draw the observation would take most of the time of what is not optimized.
quietly "$before" record configs/banana.yaml --set "workload.samples.count=$samples" --out "$out/trace"
job=(configs/banana.yaml --set "workload.trace=$out/trace" --set accelerator.raster_cores=2)
# run PROGRAM FOLDER [OPTION...]
run() {
    quietly "$1" run "${job[@]}" --out "$out/$2" "${@:3}"
}
# sum FOLDER/TABLE.csv COLUMN [COLUMN=VALUE...]: of the column in all rows that have the values
sum() {
    awk -F, -v column="$2" -v wanted="${*:3}" '
        NR == 1 {
            for (i = 1; i <= NF; ++i) at[$i] = i
            if (!(column in at)) { exit 1 }
            n = split(wanted, pairs, " ")
            next
        }
        {
            for (i = 1; i <= n; ++i) { split(pairs[i], pair, "="); if ($at[pair[1]] != pair[2]) next }
            sum += $at[column]; ++rows
        }
        END { if (!rows) { print "none" } else print sum }' "$out/$1"
}
expect() {
    [[ "$2" == "$3" ]] || complain "$1: expected $3, got $2"
}
expect_same() {
    cmp -s "$out/$2" "$out/$3" || complain "$1: $2 and $3 differ"
}
# scores FOLDER: what the samples score, without the cycles
scores() {
    local names=valid_raster,valid_depth,inlier,valid_edge,edge_inlier
    awk -F, -v names="$names" '
        NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; n = split(names, name, ",") }
        { for (i = 1; i <= n; ++i) printf "%s,", $at[name[i]]; print "" }' "$out/$1/samples.csv"
}
has_key() {
    "$after" keys >"$out/keys"
    grep -qF "| \`$1\` |" "$out/keys" || complain "faster-sim keys does not list $1"
}

run "$before" before
run "$after" after --events "$out/events"
run "$after" lockstep --set simulation.engine=lockstep
[[ "$(scores before)" == "$(scores after)" ]] || complain "the changes change what samples score"

# new_fifo
has_key accelerator.fifos.sample_result.depth
expect "tokens written" "$(sum after/fifos.csv writes fifo=sample_result)" "$samples"
expect "tokens read" "$(sum after/fifos.csv reads fifo=sample_result)" "$samples"
quietly "$after" whatif "$out/events" --set accelerator.fifos.sample_result.depth=1 --out "$out/whatif_depth"
run "$after" depth --set accelerator.fifos.sample_result.depth=1
expect_same "depth 1, what-if and run" whatif_depth/samples.csv depth/samples.csv
cmp -s "$out/after/samples.csv" "$out/depth/samples.csv" && complain "depth 1 changes no cycle"
echo "new_fifo: $samples tokens; what-if with depth 1 as a run"

# new_loop
has_key accelerator.loops.inlier_unit.add_up.depth
expect "entries" "$(sum after/loops.csv entries module=inlier_unit loop=add_up)" "$samples"
expect "iterations" "$(sum after/loops.csv iterations module=inlier_unit loop=add_up)" "$((4 * samples))"
quietly "$after" whatif "$out/events" --set accelerator.loops.inlier_unit.add_up.depth=9 --out "$out/whatif_loop"
run "$after" loop --set accelerator.loops.inlier_unit.add_up.depth=9
expect_same "pipeline depth 9, what-if and run" whatif_loop/samples.csv loop/samples.csv
cmp -s "$out/after/samples.csv" "$out/loop/samples.csv" && complain "pipeline depth 9 changes no cycle"
echo "new_loop: $((4 * samples)) iterations; what-if with depth 9 as a run"

# new_key
key=accelerator.modules.inlier_unit.triangle_cycles
has_key "$key"
run "$after" key --set "$key=64"
run "$after" key_lockstep --set "$key=64" --set simulation.engine=lockstep
[[ "$(sum after/samples.csv latency_cycles)" != "$(sum key/samples.csv latency_cycles)" ]] ||
    complain "$key changes no latency"
expect_same "both engines, 64 cycles" key/samples.csv key_lockstep/samples.csv
[[ "$(scores after)" == "$(scores key)" ]] || complain "$key changes what samples score"
"$after" whatif "$out/events" --set "$key=64" >"$log" 2>&1 && complain "what-if accepts $key, which it cannot work out"
grep -q "decides which operations there are" "$log" || complain "what-if does not say why it refuses $key"
echo "new_key: latencies change from $(sum after/samples.csv latency_cycles) to $(sum key/samples.csv latency_cycles) cycles; both engines agree"

# new_figure
matches="$(sum after/samples.csv edge_match)"
((matches > 0 && matches <= $(sum after/samples.csv inlier))) || complain "edge_match is $matches"
expect_same "both engines" after/samples.csv lockstep/samples.csv
echo "new_figure: edge_match counts $matches px; both engines agree"

# new_algorithm
algorithm=(--set accelerator.edge_map.algorithm=outer_border)
"$before" run "${job[@]}" "${algorithm[@]}" --out "$out/unknown" >"$log" 2>&1 && complain "outer_border is there without its patch"
run "$after" outer "${algorithm[@]}"
run "$after" outer_lockstep "${algorithm[@]}" --set simulation.engine=lockstep
expect_same "both engines, outer_border" outer/samples.csv outer_lockstep/samples.csv
expect "depths drawn" "$(sum outer/samples.csv valid_raster)" "$(sum after/samples.csv valid_raster)"
dual="$(sum after/samples.csv valid_edge)"
outer="$(sum outer/samples.csv valid_edge)"
((10 * outer > 9 * dual && 9 * outer < 10 * dual)) || complain "outer_border finds $outer edge pixels, dual_map $dual"
token=(iterations module=edge_map_builder loop=token)
(($(sum outer/loops.csv "${token[@]}") < $(sum after/loops.csv "${token[@]}"))) ||
    complain "outer_border takes as many iterations of the token loop as dual_map"
echo "new_algorithm: $outer edge pixels, dual_map $dual; both engines agree"

# new_module
key=accelerator.modules.score_unit.division
has_key "$key"
has_key accelerator.fifos.scored.depth
expect "tokens written" "$(sum after/fifos.csv writes fifo=scored)" "$samples"
expect "tokens read" "$(sum after/fifos.csv reads fifo=result)" "$samples"
run "$after" slow --set "$key=500"
run "$after" slow_lockstep --set "$key=500" --set simulation.engine=lockstep
expect_same "both engines, a division of 500 cycles" slow/samples.csv slow_lockstep/samples.csv
expect "later ends" "$(($(sum slow/samples.csv latency_cycles) - $(sum after/samples.csv latency_cycles)))" "$((464 * samples))"
[[ "$(scores after)" == "$(scores slow)" ]] || complain "$key changes what samples score"
echo "new_module: $samples samples pass; a longer division ends each later by what it is longer"

echo "check-changes: six changes have the sizes that $page states, and show in the results"
