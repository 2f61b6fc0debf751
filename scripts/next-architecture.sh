#!/usr/bin/env bash
# The tables of docs/next-architecture.md behind the first, which configs/sweeps/own_designs.yaml makes: what each step buys,
# how sure the memory's figures have to be. Prints Markdown; takes some minutes.
#   scripts/next-architecture.sh [FASTER_SIM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
sim=${1:-build/release/bin/faster-sim}
source scripts/class-table.sh

accelerator() { printf 'accelerator.%s\n' "$@"; }

axi=accelerator.memory.model=axi
header "Steps, each added to those above, $axi"
always=($axi)
row "faster"
add() { # TITLE KEY=VALUE...
    mapfile -t -O "${#always[@]}" always < <(accelerator "${@:2}")
    row "$1"
}
add "edges on the object" edge_map.algorithm=inner_border
add "no clearing loops" edge_map.clearing=on_read_out inlier_unit.clearing=on_read_out
banks() { printf 'brams.%s.partition.type=cyclic brams.%s.partition.factor=6 brams.%s.partition.dimension=2 ' "$1" "$1" "$1"; }
add "6 pixels per cycle in the sweep" inlier_unit.sweep_lanes=6 $(banks object_map) $(banks depth_buffer)
add "setup beside the scan" rasterizer.setup_overlap=12
add "only covered pixels" rasterizer.scan=spans
add "no tokens beside triangles" rasterizer.edge_tokens=object
add "one loop for all fragments" inlier_unit.fragment_loop=flattened
fifos() {
    printf 'fifos.%s.depth=32 ' command fragment_depth fragment_index
    printf 'fifos.%s.kind=shift_register ' command fragment_depth fragment_index area
    printf 'fifos.area.depth=8'
}
add "FIFOs as deep as the reciprocal's latency" $(fifos)
add "6 pixels per cycle in the scan" rasterizer.lanes=6
add "two buffers" edge_map.buffers=2 inlier_unit.buffers=2
add "only what the sample touched" inlier_unit.sweep_region=touched
add "mesh on the chip" memory.mesh=on_chip memory.mesh_triangles=1200
add "seven cores" raster_cores=7
add "a smaller divider: next_zcu102" modules.area_reciprocal.interval=5

header "When one step is left out of next_zcu102"
always=(accelerator.architecture=next_zcu102)
row "nothing"
without() { # TITLE KEY=VALUE...
    local settings
    mapfile -t settings < <(accelerator "${@:2}")
    row "$1" "${settings[@]}"
}
without "edges on the object (one lane, all tokens)" edge_map.algorithm=dual_map rasterizer.edge_tokens=all rasterizer.lanes=1
without "clearing on read-out" edge_map.clearing=loop inlier_unit.clearing=loop
without "sweep lanes" inlier_unit.sweep_lanes=1
without "setup beside the scan" rasterizer.setup_overlap=0
without "spans" rasterizer.scan=zigzag
without "flattened fragments" inlier_unit.fragment_loop=per_triangle
without "deeper FIFOs" fifos.{area,command,fragment_depth,fragment_index}.depth=2
without "lanes of the scan" rasterizer.lanes=1
without "two buffers" edge_map.buffers=1 inlier_unit.buffers=1
without "the touched region" inlier_unit.sweep_region=window
without "mesh on the chip" memory.mesh=external
without "the smaller divider" modules.area_reciprocal.interval=1
without "forwarding: interlock" loops.inlier_unit.fragment.depth_buffer.hazards=interlock
without "forwarding: interval 2" loops.inlier_unit.fragment.recurrence_ii=2
without "forwarding: interval 3" loops.inlier_unit.fragment.recurrence_ii=3

header "next_zcu102 with other memories and clocks"
row "as it is"
for setting in memory.read_latency_ns={60,240} memory.request_cycles={12,48} memory.dram_efficiency={0.375,1} \
    memory.ports={1,2,4} memory.outstanding={8,32} memory.burst_bytes={128,512} memory.prefetch=true \
    fifo_rules={spec,vitis_hls} clock_mhz={150,250,300} raster_cores={6,8,9,10}; do
    without "\`$setting\`" "$setting"
done
