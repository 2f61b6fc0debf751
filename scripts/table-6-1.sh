#!/usr/bin/env bash
# The tables of docs/validation.md, "Table 6.1 of the thesis": the five classes in both flows on the FPGA, with the built-in
# models and with scanned meshes, and what decides the figures. Prints Markdown; takes some minutes.
#   scripts/table-6-1.sh [FASTER_SIM]
# FASTER_SHARED_DATA: a folder with meshes/*_CLASS.obj; without it the scans are left out.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
sim=${1:-build/release/bin/faster-sim}
scans=$(mktemp -d)
trap 'rm -r "$scans"' EXIT
source scripts/class-table.sh

# The window is centred on the origin, which the scans have beside them: moves it to the middle of the box around them.
centred() { # OBJ
    awk '$1 != "v" { if (NR != FNR) print; next }
         NR == FNR { for (i = 2; i <= 4; i++) { if (!n || $i < lo[i]) lo[i] = $i; if (!n || $i > hi[i]) hi[i] = $i } n = 1; next }
         { printf "v %.9g %.9g %.9g\n", $2 - (lo[2] + hi[2]) / 2, $3 - (lo[3] + hi[3]) / 2, $4 - (lo[4] + hi[4]) / 2 }' \
        "$1" "$1"
}

extraction=accelerator.edge_extraction
fpga_grip=accelerator.flow=fpga_grip
printf 'Built-in models, configs/CLASS.yaml\n\n'
header
row "faster"
row "fpga_grip" $fpga_grip
row "fpga_grip, n = 3, direct" $fpga_grip $extraction.neighbourhood=3 $extraction.neighbour_access=direct
row "fpga_grip, n = 5, direct" $fpga_grip $extraction.neighbour_access=direct
for ii in 2 3 4; do
    row "fpga_grip, extract.ii = $ii" $fpga_grip accelerator.loops.inlier_unit.extract.ii=$ii
done
recurrence=accelerator.loops.inlier_unit.fragment.recurrence_ii
for ii in 2 3 4; do
    row "faster, fragment.recurrence_ii = $ii" $recurrence=$ii
    row "fpga_grip, fragment.recurrence_ii = $ii" $fpga_grip $recurrence=$ii
done
memory=accelerator.memory.model=axi
row "faster, external memory" $memory
row "fpga_grip, external memory" $fpga_grip $memory
row "fpga_grip, n = 3, direct, external memory" \
    $fpga_grip $extraction.neighbourhood=3 $extraction.neighbour_access=direct $memory

if [[ -z "${FASTER_SHARED_DATA:-}" ]]; then
    printf '\nNo scans: FASTER_SHARED_DATA is not set.\n'
    exit 0
fi
for class in "${classes[@]}"; do
    centred "$FASTER_SHARED_DATA"/meshes/*_"$class".obj > "$scans/$class.obj"
done
meshes=$scans
always=(workload.camera.fx=570 workload.camera.fy=570)
turned=workload.samples.rotation_sigma_deg=1000 # any rotation
at() { echo "workload.pose.translation_m=[0, 0, $1]"; }
fifos() { printf "accelerator.fifos.%s.depth=$1\n" command fragment_depth fragment_index edge_token; }

printf '\nScanned meshes, 1,200 triangles at 0.67 m, 570 px, rotations of all kinds\n\n'
header
row "faster" "$(at 0.67)" $turned
row "fpga_grip" "$(at 0.67)" $turned $fpga_grip
row "faster, rotations around that of configs/CLASS.yaml" "$(at 0.67)"
row "faster, around rotation_deg [90, 0, 0]" "$(at 0.67)" 'workload.pose.rotation_deg=[90, 0, 0]'
for distance in 0.55 0.60 0.75 0.80; do
    row "faster, $distance m" "$(at $distance)" $turned
done
for triangles in 600 2400 4800; do
    row "faster, $triangles triangles" "$(at 0.67)" $turned workload.max_triangles=$triangles
done
for depth in 4 16; do
    mapfile -t depths < <(fifos $depth)
    row "faster, FIFOs behind the scan $depth deep" "$(at 0.67)" $turned "${depths[@]}"
done
row "faster, setup 24 deep" "$(at 0.67)" $turned accelerator.loops.rasterizer.setup.depth=24
