#!/usr/bin/env bash
# Synthesizes every unit of the register-transfer core with Yosys, for UltraScale+, and writes what it takes:
#   scripts/synthesize.sh            into rtl/resources.csv
#   scripts/synthesize.sh FILE.csv   into another file
# A unit has its numbers as constants here, as in a design: those of the default configuration.
set -euo pipefail
cd "$(dirname "$0")/../rtl"

table="$(realpath "${1:-resources.csv}")"
command -v yosys >/dev/null || {
    echo "synthesize: no yosys; scripts/setup.sh --dev installs it" >&2
    exit 2
}
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

shared="faster_pkg.sv shift_register.sv delay_line.sv pipelined_loop.sv block_ram.sv in_window.sv window_origin.sv"

# unit NAME CONFIGURATION TOP FILES PARAMETERS CONSTANTS: parameters as NAME=VALUE, constant inputs as PORT=WIDTH'VALUE.
unit() {
    local name="$1" configuration="$2" top="$3" files="$4" parameters="$5" constants="$6" script="$work/unit.ys" item
    {
        echo "read_verilog -sv $shared $files"
        for item in $parameters; do echo "chparam -set ${item%%=*} ${item#*=} $top"; done
        echo "hierarchy -check -top $top"
        echo "rename -top unit"
        echo "proc"
        for item in $constants; do
            echo "cd unit"
            echo "delete -input w:${item%%=*}"
            echo "connect -nounset -set ${item%%=*} ${item#*=}"
            echo "cd .."
        done
        echo "synth_xilinx -family xcup -flatten -top unit"
        echo "tee -q -o $work/unit.json stat -json"
    } >"$script"
    timeout 900 yosys -q "$script" >"$work/unit.log" 2>&1 || {
        echo "synthesize: $name failed:" >&2
        tail -3 "$work/unit.log" >&2
        exit 1
    }
    python3 - "$name,$configuration" "$work/unit.json" >>"$work/table" <<'PYTHON'
import json, sys
cells = json.load(open(sys.argv[2]))["design"]["num_cells_by_type"]
# LUTs of a primitive that is no plain LUT: shift registers and distributed RAM.
luts_of = {"SRL16E": 1, "SRLC32E": 1, "RAM32X1S": 1, "RAM64X1S": 1, "RAM32X1D": 2, "RAM64X1D": 2, "RAM128X1S": 2,
           "RAM128X1D": 4, "RAM256X1S": 4, "RAM256X1D": 8, "RAM32M": 4, "RAM64M": 4, "RAM32M16": 8, "RAM64M8": 8,
           "RAM512X1S": 8, "INV": 0}
def total(of):
    return sum(count * of(kind) for kind, count in cells.items())
lut = total(lambda kind: 1 if kind.startswith("LUT") else luts_of.get(kind, 0))
ff = total(lambda kind: kind in ("FDRE", "FDSE", "FDCE", "FDPE"))
dsp = total(lambda kind: kind == "DSP48E2")
ramb = total(lambda kind: {"RAMB36E2": 1.0, "RAMB18E2": 0.5}.get(kind, 0))
print(f"{sys.argv[1]},{lut},{ff},{dsp},{ramb:g}")
PYTHON
    tail -1 "$work/table"
}

window="window=9'd200"
latencies="command_latency=6'd7 fragment_depth_latency=6'd7 fragment_index_latency=6'd7 edge_token_latency=6'd7"
fraction="fraction=24'b010001110011110100101001" # 4, 14, 30, 18, 9

unit sample_dispatcher default sample_dispatcher sample_dispatcher.sv "" ""
unit vertex_transform default vertex_transform vertex_transform.sv "" "vertex_loop=16'h0129 write_latency=6'd40"
unit rasterizer default rasterizer "triangle_setup.sv zigzag_scan.sv rasterizer.sv" "EDGE_BITS=29" \
    "scan_loop=16'h0108 setup_cycles=8'd12 $latencies sends_edges=1'b1 width=16'd640 height=16'd480 $window vertex_xy=4'd4"
unit area_reciprocal default area_reciprocal_unit "divider.sv area_reciprocal_unit.sv" \
    "AREA_BITS=29 RECIPROCAL_BITS=39 DIVIDER_STAGES=36" "stages=6'd36 squeezes=1'b0 capacity=12'd2 one=6'd38"
# CONFIGURATION IS_INNER_BORDER CLEARS_ON_READ_OUT
edge_map_builder() {
    unit edge_map_builder "$1" edge_map_builder "inner_border.sv edge_map_builder.sv" "WORDS=40000" \
        "clear_loop=16'h0102 token_loop=16'h0104 output_loop=16'h0103 edge_map_latency=6'd2 is_inner_border=$2 clears_on_read_out=$3 flushes_last=1'b0 forwards=1'b0 $window"
}
edge_map_builder default "1'b0" "1'b0"
edge_map_builder clearing=on_read_out "1'b0" "1'b1"
edge_map_builder algorithm=inner_border "1'b1" "1'b0"
unit observation_reader default observation_reader observation_reader.sv "" \
    "read_loop=16'h0105 observed_depth_latency=6'd4 observed_edge_latency=6'd4 width=16'd640 height=16'd480 $window"
# CONFIGURATION SWEEP_LOOP IS_INNER_BORDER HAS_LINE_BUFFERS CLEARS_ON_READ_OUT IS_FLATTENED, with hazards forwarded
inlier_unit() {
    unit inlier_unit "$1" inlier_unit "depth_unit.sv pixel_comparison.sv line_buffers.sv inlier_sweep.sv inlier_unit.sv" \
        "WORDS=40000 PORTS=2 RECIPROCAL_BITS=39 DEPTH_BITS=20" \
        "clear_loop=16'h0102 fragment_loop=16'h010A sweep_loop=$2 ports=3'd2 is_inner_border=$3 has_line_buffers=$4 clears_on_read_out=$5 is_flattened=$6 forwards=$6 $window $fraction"
}
inlier_unit default "16'h0308" "1'b0" "1'b0" "1'b0" "1'b0"
inlier_unit neighbour_access=window "16'h0108" "1'b0" "1'b1" "1'b0" "1'b0"
inlier_unit clearing=on_read_out "16'h0308" "1'b0" "1'b0" "1'b1" "1'b0"
inlier_unit algorithm=inner_border "16'h0108" "1'b1" "1'b0" "1'b0" "1'b0"
inlier_unit fragment_loop=flattened "16'h0308" "1'b0" "1'b0" "1'b0" "1'b1"
unit result_collector default result_collector result_collector.sv "" ""
for fifo in sample_vertex:128 sample_raster:128 sample_observation:128 vertex:48 area:29 area_reciprocal:39 command:2 \
    fragment_depth:48 fragment_index:32 edge_token:34 edge_map:1 observed_depth:11 observed_edge:1 result:160; do
    unit "fifos.${fifo%%:*}" default fifo "fifo_shift_register.sv fifo_memory.sv fifo.sv" \
        "BITS=${fifo#*:} SHIFT_REGISTER_PLACES=2" "shape=13'h0002"
done

{
    echo "unit,configuration,lut,ff,dsp,ramb36"
    cat "$work/table"
} >"$work/resources.csv"
mv "$work/resources.csv" "$table"
echo "written: $table"
