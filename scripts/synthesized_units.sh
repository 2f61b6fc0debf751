# The units and configurations that synthesize.sh goes through; sourced by it.

bits_of() { # of a number, in base 2, padded: bits_of WIDTH VALUE
    local bits="" i
    for ((i = $1 - 1; i >= 0; --i)); do bits+=$((($2 >> i) & 1)); done
    echo "$1'b$bits"
}
hex_loop() { printf "16'h%02X%02X" "$1" "$2"; } # II, depth
log2() { # bits of a count
    local n=$(($1 - 1)) b=0
    while ((n > 0)); do
        n=$((n >> 1))
        b=$((b + 1))
    done
    echo "$b"
}

reset_keys() {
    window=200 vertex_xy=4 area_reciprocal=30 fragment_depth=18 vertex_z=14 depth_buffer=9 width=640 height=480
    write_latency= ports=2 algorithm=dual_map clearing=loop neighbour_access=direct fragment_loop=per_triangle
    flush_last=false when_full=freeze interval=1 edge_tokens=all depth= lanes=1 buffers=1 region=window setups=12
}
# with KEYS COMMAND...: `default` or keys with their values, for a unit; a configuration's name may begin with `check.`
apply() {
    local item
    reset_keys
    [[ "$1" == default ]] && return
    for item in $1; do declare -g "$item"; done
}
truth() { [[ "$1" == "$2" ]] && echo "1'b1" || echo "1'b0"; }
# An edge value: two differences of coordinates inside the image, their product and a sign.
edge_bits() { echo $((2 * ($(log2 $((width > height ? width : height))) + vertex_xy) + 1)); }
reciprocal_bits() { echo $((area_reciprocal + 2 * vertex_xy + 1)); }
fractions() {
    local all
    all="$(bits_of 4 $vertex_xy)$(bits_of 5 $vertex_z)$(bits_of 6 $area_reciprocal)$(bits_of 5 $fragment_depth)$(bits_of 4 $depth_buffer)"
    echo "24'b$(sed "s/[0-9]*'b//g" <<<"$all")"
}

vertex_transform() {
    apply "$1"
    local latency=${write_latency:-40}
    unit "${2:-}vertex_transform" "$1" vertex_transform vertex_transform.sv "" \
        "vertex_loop=$(hex_loop 1 $((latency + 1))) write_latency=6'd$latency"
}
rasterizer() {
    apply "$1"
    local latency=${write_latency:-7} item lines=""
    for item in command fragment_depth fragment_index edge_token; do lines+=" ${item}_latency=6'd$latency"; done
    unit "${2:-}rasterizer" "$1" rasterizer "triangle_setup.sv zigzag_scan.sv rasterizer.sv" "EDGE_BITS=$(edge_bits)" \
        "scan_loop=$(hex_loop 1 $((latency + 1))) setup_cycles=8'd12 $lines sends_edges=$(truth $edge_tokens all) width=16'd$width height=16'd$height window=9'd$window vertex_xy=4'd$vertex_xy"
}
area_reciprocal_unit() {
    apply "$1"
    local latency=${write_latency:-36} bits
    bits=$(reciprocal_bits)
    unit "${2:-}area_reciprocal" "$1" area_reciprocal_unit "divider.sv iterative_divider.sv area_reciprocal_unit.sv" \
        "AREA_BITS=$(edge_bits) RECIPROCAL_BITS=$bits DIVIDER_STAGES=$latency DIVIDER_INTERVAL=$interval" \
        "interval=8'd$interval stages=6'd$latency squeezes=$(truth $when_full squeeze) capacity=12'd$((2 + latency)) one=6'd$((bits - 1))"
}
edge_map_builder() {
    apply "$1"
    unit "${2:-}edge_map_builder" "$1" edge_map_builder "inner_border.sv edge_map_builder.sv" "WORDS=$((window * window))" \
        "clear_loop=$(hex_loop 1 2) token_loop=$(hex_loop 1 4) output_loop=$(hex_loop 1 3) edge_map_latency=6'd${write_latency:-2} is_inner_border=$(truth $algorithm inner_border) clears_on_read_out=$(truth $clearing on_read_out) flushes_last=$(truth $flush_last true) forwards=1'b0 window=9'd$window"
}
observation_reader() {
    apply "$1"
    local latency=${write_latency:-4}
    unit "${2:-}observation_reader" "$1" observation_reader observation_reader.sv "" \
        "read_loop=$(hex_loop 1 $((latency + 1))) observed_depth_latency=6'd$latency observed_edge_latency=6'd$latency width=16'd$width height=16'd$height window=9'd$window"
}
inlier_unit() {
    apply "$1"
    local words=5 interval flattened
    [[ $algorithm == inner_border || $neighbour_access == window ]] && words=1
    [[ $clearing == on_read_out ]] && words=$((words + 1))
    interval=$(((words + ports - 1) / ports))
    flattened=$(truth $fragment_loop flattened)
    unit "${2:-}inlier_unit" "$1" inlier_unit \
        "depth_unit.sv pixel_comparison.sv line_buffers.sv hidden_pixel.sv hidden_pixels.sv inlier_sweep.sv inlier_unit.sv" \
        "WORDS=$((window * window)) PORTS=$((ports < 2 ? 2 : ports)) RECIPROCAL_BITS=$(reciprocal_bits) DEPTH_BITS=$((fragment_depth + 2))" \
        "clear_loop=$(hex_loop 1 2) fragment_loop=$(hex_loop 1 ${depth:-10}) sweep_loop=$(hex_loop $interval 8) ports=3'd$ports is_inner_border=$(truth $algorithm inner_border) has_line_buffers=$(truth $neighbour_access window) clears_on_read_out=$(truth $clearing on_read_out) counts_hidden=1'b0 is_flattened=$flattened forwards=$flattened window=9'd$window fraction=$(fractions)"
}
# The core with lanes, rtl/lanes
lane_unit() { # NAME CONFIGURATION FILES PARAMETERS CONSTANTS
    unit "$1" "$2" "$1" "lanes/lane_pkg.sv $3 lanes/$1.sv" "$4" "$5"
}
lane_rasterizer() {
    apply "$1"
    local item lines="" difference
    difference=$(($(log2 $((width > height ? width : height))) + vertex_xy + 1))
    for item in command fragment_depth fragment_index edge_token; do lines+=" ${item}_latency=6'd7"; done
    lane_unit lane_rasterizer "$1" "triangle_setup.sv fifo_shift_register.sv $span_setup lanes/span_rows.sv lanes/span_scan.sv" \
        "EDGE_BITS=$(edge_bits) Z_SUM_BITS=48 CROSSING_BITS=$(($(edge_bits) - vertex_xy)) DIFFERENCE_BITS=$difference SETUPS=$setups" \
        "lanes=4'd$lanes scan_loop=$(hex_loop 1 8) setup_cycles=6'd30 setups_ahead=5'd$setups $lines sends_region=$(truth $region touched) width=16'd$width height=16'd$height window=9'd$window vertex_xy=4'd$vertex_xy"
}
span_setup="lanes/settled_register.sv lanes/span_divider.sv lanes/span_division.sv lanes/setup_ahead.sv"
# Parts of it, for other designs with spans
span_units() {
    apply "$1"
    lane_unit span_rows "$1" fifo_shift_register.sv "CROSSING_BITS=25 DIFFERENCE_BITS=15" "lanes=4'd$lanes"
    lane_unit span_scan "$1" "" "Z_SUM_BITS=48" "lanes=4'd$lanes"
}
lane_inlier_unit() {
    apply "$1"
    lane_unit lane_inlier_unit "$1" "depth_unit.sv lanes/lane_depth_unit.sv" \
        "Z_SUM_BITS=48 RECIPROCAL_BITS=$(reciprocal_bits) DEPTH_BITS=$((fragment_depth + 2)) LANES_BUILT=$lanes" \
        "lanes=4'd$lanes fragment_loop=$(hex_loop 1 10) receives_region=$(truth $region touched) has_two_buffers=$(truth $buffers 2) forwards=1'b1 window=9'd$window fraction=$(fractions)"
}
lane_sweep() {
    apply "$1"
    lane_unit lane_sweep "$1" "pixel_comparison.sv hidden_pixel.sv lanes/lane_hidden_pixels.sv lanes/region_walk.sv" "LANES_BUILT=$lanes" \
        "lanes=4'd$lanes sweep_loop=$(hex_loop 1 8) sweeps_touched=$(truth $region touched) has_two_buffers=$(truth $buffers 2) counts_hidden=1'b0 fraction=4'd9 window=9'd$window"
}
lane_hidden_pixels() {
    apply "$1"
    lane_unit lane_hidden_pixels "$1" hidden_pixel.sv "LANES_BUILT=$lanes" "fraction=4'd9"
}
lane_map_output() {
    apply "$1"
    local places=128
    while ((places < 2 * ((window + lanes - 1) / lanes))); do places=$((2 * places)); done
    lane_unit lane_map_output "$1" "lanes/region_walk.sv lanes/lane_border.sv" "PLACES=$places" \
        "lanes=4'd$lanes output_loop=$(hex_loop 1 3) edge_map_latency=6'd2 has_two_maps=$(truth $buffers 2) window=9'd$window"
}
lane_map_builder() {
    apply "$1"
    lane_unit lane_map_builder "$1" "" "" \
        "lanes=4'd$lanes token_loop=$(hex_loop 1 4) receives_region=$(truth $region touched) has_two_maps=$(truth $buffers 2) window=9'd$window"
}
lane_observation_reader() {
    apply "$1"
    lane_unit lane_observation_reader "$1" lanes/region_walk.sv "" \
        "lanes=4'd$lanes read_loop=$(hex_loop 1 5) observed_depth_latency=6'd4 observed_edge_latency=6'd4 receives_region=$(truth $region touched) width=16'd$width height=16'd$height window=9'd$window"
}
# The window in as many banks as lanes; with their block RAMs
banked() { # NAME BITS BANKS BUFFERS
    reset_keys
    local banks=$3 buffers=$4
    unit "$1" "banks=$3 buffers=$4" banked_buffers "lanes/lane_pkg.sv lanes/banked_buffers.sv" \
        "BITS=$2 BANKS=$banks BUFFERS=$buffers WORDS=$((window * ((window + banks - 1) / banks)))" \
        "banks=4'd$banks lanes=8'b$(bits_of 4 "$banks" | cut -d b -f 2)$(bits_of 4 "$banks" | cut -d b -f 2) window=9'd$window"
}
fifo() { # KIND DEPTH BITS
    local places=$(($2 < 2 ? 2 : $2)) words=2 shape
    while ((words < $2)); do words=$((2 * words)); done
    ((words < 4)) && words=4
    shape="13'b0$(bits_of 12 "$2" | cut -d b -f 2)"
    [[ $1 == memory ]] && shape="13'b1$(bits_of 12 $(($2 + 1)) | cut -d b -f 2)"
    unit "${4:-}fifo.$1" "depth=$2 bits=$3" fifo "fifo_shift_register.sv fifo_memory.sv fifo.sv" \
        "BITS=$3 SHIFT_REGISTER_PLACES=$places MEMORY_WORDS=$words" "shape=$shape"
}
delays() { # STAGES BITS
    unit "${3:-}delay_line" "stages=$1 bits=$2" delay_line "" "BITS=$2" "stages=6'd$1"
}

unit sample_dispatcher default sample_dispatcher sample_dispatcher.sv "" ""
for keys in default write_latency=20; do vertex_transform "$keys"; done
for keys in default edge_tokens=object vertex_xy=2 vertex_xy=6 window=50 window=100 window=255; do
    rasterizer "$keys"
done
for keys in default write_latency=12 write_latency=18 write_latency=24 write_latency=39 write_latency=48 \
    write_latency=63 area_reciprocal=22 area_reciprocal=34 vertex_xy=2 vertex_xy=6 when_full=squeeze interval=3 interval=5 interval=6 \
    interval=12 interval=20 interval=36; do
    area_reciprocal_unit "$keys"
done
for keys in default clearing=on_read_out algorithm=inner_border flush_last=true \
    "algorithm=inner_border clearing=on_read_out" window=100 window=150 window=255; do
    edge_map_builder "$keys"
done
for keys in default window=50 window=100 window=255; do observation_reader "$keys"; done
for keys in default neighbour_access=window clearing=on_read_out algorithm=inner_border fragment_loop=flattened \
    "algorithm=inner_border clearing=on_read_out" "neighbour_access=window clearing=on_read_out" \
    window=50 window=100 window=150 window=255 ports=1 ports=3 ports=5 \
    vertex_xy=2 vertex_xy=6 area_reciprocal=22 area_reciprocal=34 fragment_depth=14 fragment_depth=22; do
    inlier_unit "$keys"
done
unit result_collector default result_collector result_collector.sv "" ""
# Parts of units, for what is there several times
reset_keys
unit depth_unit default depth_unit depth_unit.sv "RECIPROCAL_BITS=39 DEPTH_BITS=20" "fraction=$(fractions)"
unit zigzag_scan default zigzag_scan zigzag_scan.sv "EDGE_BITS=$(edge_bits) Z_SUM_BITS=48" "sends_edges=1'b0"
for keys in default lanes=5 lanes=10 region=touched buffers=2 "lanes=10 region=touched" "region=touched buffers=2" \
    "lanes=5 region=touched buffers=2" "lanes=6 region=touched buffers=2"; do
    lane_sweep "$keys"
done
for keys in default lanes=5 lanes=10 region=touched buffers=2 "lanes=5 region=touched" "region=touched buffers=2" \
    "lanes=5 region=touched buffers=2" "lanes=6 region=touched buffers=2"; do
    lane_map_builder "$keys"
done
for keys in default lanes=5 lanes=10 buffers=2 "lanes=5 buffers=2" "lanes=6 buffers=2"; do lane_map_output "$keys"; done
for keys in default lanes=5 lanes=10 region=touched "lanes=5 region=touched" "lanes=6 region=touched" "lanes=10 region=touched"; do
    lane_observation_reader "$keys"
done
for keys in default lanes=5 lanes=10 region=touched "lanes=5 region=touched" "lanes=6 region=touched"; do
    lane_rasterizer "$keys"
done
for keys in default lanes=5 region=touched buffers=2 "lanes=5 region=touched" "region=touched buffers=2" \
    "lanes=5 region=touched buffers=2" "lanes=6 region=touched buffers=2"; do
    lane_inlier_unit "$keys"
done
for shape in "1 1" "1 2" "5 1" "5 2" "6 2" "10 1"; do # banks, buffers
    banked banked_map 1 ${shape% *} ${shape#* }
    banked banked_depths 11 ${shape% *} ${shape#* }
done
for keys in default lanes=5 lanes=10; do span_units "$keys"; done
# What counting hidden pixels adds to inlier_unit or lane_sweep
unit hidden_pixels default hidden_pixels "hidden_pixel.sv hidden_pixels.sv" "" "window=9'd200 fraction=4'd9"
for keys in default lanes=5 lanes=6 lanes=10; do lane_hidden_pixels "$keys"; done
unit lane_depth_unit default lane_depth_unit "depth_unit.sv lanes/lane_depth_unit.sv" "RECIPROCAL_BITS=39 DEPTH_BITS=20" \
    "forwards=1'b1 read_stage=6'd7 fraction=$(fractions)"
for keys in default interval=18; do # a triangle every third cycle, or one after the other
    [[ $keys == default ]] && interval=3 || interval=18
    unit span_division "$keys" span_division "lanes/span_divider.sv lanes/span_division.sv" \
        "CROSSING_BITS=25 DIFFERENCE_BITS=15 INTERVAL=$interval" ""
done
for depth in 1 2 3 4 8 16 17 32 33 64; do
    for bits in 1 128; do fifo shift_register $depth $bits; done
done
for bits in 2 11 29 32 33 34 39 48 96 160; do fifo shift_register 2 $bits; done
for depth in 4 16 64 256 1024; do
    for bits in 1 32 128; do fifo memory $depth $bits; done
done
for stages in 1 2 3 16 17 33 63; do
    for bits in 1 49; do delays $stages $bits; done
done

# What interpolation is checked against
vertex_transform write_latency=10 check.
for keys in "vertex_xy=3 window=120" "edge_tokens=object vertex_xy=5 window=80"; do rasterizer "$keys" check.; done
for keys in write_latency=30 "area_reciprocal=28 vertex_xy=3" "vertex_xy=5 write_latency=45" interval=4 interval=9; do
    area_reciprocal_unit "$keys" check.
done
for keys in window=80 "clearing=on_read_out window=128" "algorithm=inner_border clearing=on_read_out window=120"; do
    edge_map_builder "$keys" check.
done
observation_reader window=120 check.
for keys in window=120 "clearing=on_read_out window=80" "algorithm=inner_border clearing=on_read_out fragment_loop=flattened window=160" \
    "fragment_depth=16 vertex_xy=3" "neighbour_access=window window=100" "clearing=on_read_out fragment_loop=flattened ports=3"; do
    inlier_unit "$keys" check.
done
for shape in "3 11" "6 34" "12 48" "24 39" "48 2"; do fifo shift_register ${shape% *} ${shape#* } check.; done
for shape in "4 39" "24 34" "64 81" "512 34"; do fifo memory ${shape% *} ${shape#* } check.; done
