// A raster core that works in lanes: spans of triangles that are set up ahead, cyclic banks, inner_border, clearing on
// read-out, a flattened fragment loop; with the window or a touched region, one or two buffers. Wiring only, named as in
// raster_core.sv.
module lane_core #(
    parameter int EDGE_BITS = 36,
    parameter int Z_SUM_BITS = 56,
    parameter int RECIPROCAL_BITS = 64,
    parameter int DEPTH_BITS = 64,
    parameter int DIVIDER_STAGES = 0,
    parameter int WORDS = 65536,  // of a bank
    parameter int SHIFT_REGISTER_PLACES = 64,
    parameter int MEMORY_WORDS = 4096
) (
    input  logic                    clock,
    input  logic                    reset,
    input  lane_settings_pkg::settings_t     settings,
    input  logic [31:0]             samples,
    output logic [31:0]             sample_number,
    input  faster_pkg::header_t     header,
    output logic [31:0]             vertex_sample,
    output logic [31:0]             vertex_number,
    input  faster_pkg::vertex_t     vertex_value,
    output logic [31:0]             observed_sample,
    input  logic [31:0]             valid_depths,
    output logic [31:0]             image_row,
    output logic [31:0]             image_col,
    input  logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] image_depths,
    input  logic [lane_pkg::LANES-1:0] image_edges,
    output logic                    is_done,
    output faster_pkg::counters_t   counters,
    // For who compares the maps
    output logic                    maps_are_built,
    output logic                    depth_buffer_is_drawn
);
    localparam int LANES = lane_pkg::LANES;
    localparam int WORD_BITS = faster_pkg::DEPTH_BITS;

    logic sample_vertex_has_room, sample_vertex_write, sample_vertex_has_token, sample_vertex_read;
    faster_pkg::header_t sample_vertex_in, sample_vertex_out;
    fifo #(
        .BITS(faster_pkg::HEADER_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_sample_vertex (
        .clock, .reset, .shape(settings.common.sample_vertex),
        .has_room(sample_vertex_has_room), .write(sample_vertex_write), .write_data(sample_vertex_in),
        .has_token(sample_vertex_has_token), .read(sample_vertex_read), .read_data(sample_vertex_out)
    );

    logic sample_raster_has_room, sample_raster_write, sample_raster_has_token, sample_raster_read;
    faster_pkg::header_t sample_raster_in, sample_raster_out;
    fifo #(
        .BITS(faster_pkg::HEADER_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_sample_raster (
        .clock, .reset, .shape(settings.common.sample_raster),
        .has_room(sample_raster_has_room), .write(sample_raster_write), .write_data(sample_raster_in),
        .has_token(sample_raster_has_token), .read(sample_raster_read), .read_data(sample_raster_out)
    );

    logic sample_observation_has_room, sample_observation_write, sample_observation_has_token, sample_observation_read;
    faster_pkg::header_t sample_observation_in, sample_observation_out;
    fifo #(
        .BITS(faster_pkg::HEADER_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_sample_observation (
        .clock, .reset, .shape(settings.common.sample_observation),
        .has_room(sample_observation_has_room), .write(sample_observation_write), .write_data(sample_observation_in),
        .has_token(sample_observation_has_token), .read(sample_observation_read), .read_data(sample_observation_out)
    );

    logic vertex_has_room, vertex_write, vertex_has_token, vertex_read;
    faster_pkg::vertex_t vertex_in, vertex_out;
    fifo #(
        .BITS(faster_pkg::VERTEX_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_vertex (
        .clock, .reset, .shape(settings.common.vertex),
        .has_room(vertex_has_room), .write(vertex_write), .write_data(vertex_in),
        .has_token(vertex_has_token), .read(vertex_read), .read_data(vertex_out)
    );

    logic area_has_room, area_write, area_has_token, area_read;
    logic signed [EDGE_BITS-1:0] area_in, area_out;
    fifo #(
        .BITS(EDGE_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_area (
        .clock, .reset, .shape(settings.common.area),
        .has_room(area_has_room), .write(area_write), .write_data(area_in),
        .has_token(area_has_token), .read(area_read), .read_data(area_out)
    );

    logic area_reciprocal_has_room, area_reciprocal_write, area_reciprocal_has_token, area_reciprocal_read;
    logic [RECIPROCAL_BITS-1:0] area_reciprocal_in, area_reciprocal_out;
    fifo #(
        .BITS(RECIPROCAL_BITS), .SHIFT_REGISTER_PLACES(2 * SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_area_reciprocal (
        .clock, .reset, .shape(settings.common.area_reciprocal),
        .has_room(area_reciprocal_has_room), .write(area_reciprocal_write), .write_data(area_reciprocal_in),
        .has_token(area_reciprocal_has_token), .read(area_reciprocal_read), .read_data(area_reciprocal_out)
    );

    logic command_has_room, command_write, command_has_token, command_read;
    faster_pkg::command_t command_in, command_out;
    fifo #(
        .BITS(faster_pkg::COMMAND_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_command (
        .clock, .reset, .shape(settings.common.command),
        .has_room(command_has_room), .write(command_write), .write_data(command_in),
        .has_token(command_has_token), .read(command_read), .read_data(command_out)
    );

    logic fragment_depth_has_room, fragment_depth_write, fragment_depth_has_token, fragment_depth_read;
    logic [2*Z_SUM_BITS-1:0] fragment_depth_in, fragment_depth_out;
    fifo #(
        .BITS(2 * Z_SUM_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_fragment_depth (
        .clock, .reset, .shape(settings.common.fragment_depth),
        .has_room(fragment_depth_has_room), .write(fragment_depth_write), .write_data(fragment_depth_in),
        .has_token(fragment_depth_has_token), .read(fragment_depth_read), .read_data(fragment_depth_out)
    );

    logic fragment_index_has_room, fragment_index_write, fragment_index_has_token, fragment_index_read;
    lane_pkg::group_t fragment_index_in, fragment_index_out;
    fifo #(
        .BITS(lane_pkg::GROUP_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_fragment_index (
        .clock, .reset, .shape(settings.common.fragment_index),
        .has_room(fragment_index_has_room), .write(fragment_index_write), .write_data(fragment_index_in),
        .has_token(fragment_index_has_token), .read(fragment_index_read), .read_data(fragment_index_out)
    );

    logic edge_token_has_room, edge_token_write, edge_token_has_token, edge_token_read;
    lane_pkg::group_t edge_token_in, edge_token_out;
    fifo #(
        .BITS(lane_pkg::GROUP_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_edge_token (
        .clock, .reset, .shape(settings.common.edge_token),
        .has_room(edge_token_has_room), .write(edge_token_write), .write_data(edge_token_in),
        .has_token(edge_token_has_token), .read(edge_token_read), .read_data(edge_token_out)
    );

    logic edge_map_has_room, edge_map_write, edge_map_has_token, edge_map_read;
    logic [LANES-1:0] edge_map_in, edge_map_out;
    fifo #(
        .BITS(LANES), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_edge_map (
        .clock, .reset, .shape(settings.common.edge_map),
        .has_room(edge_map_has_room), .write(edge_map_write), .write_data(edge_map_in),
        .has_token(edge_map_has_token), .read(edge_map_read), .read_data(edge_map_out)
    );

    logic observed_depth_has_room, observed_depth_write, observed_depth_has_token, observed_depth_read;
    logic [LANES*WORD_BITS-1:0] observed_depth_in, observed_depth_out;
    fifo #(
        .BITS(LANES * WORD_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_observed_depth (
        .clock, .reset, .shape(settings.common.observed_depth),
        .has_room(observed_depth_has_room), .write(observed_depth_write), .write_data(observed_depth_in),
        .has_token(observed_depth_has_token), .read(observed_depth_read), .read_data(observed_depth_out)
    );

    logic observed_edge_has_room, observed_edge_write, observed_edge_has_token, observed_edge_read;
    logic [LANES-1:0] observed_edge_in, observed_edge_out;
    fifo #(
        .BITS(LANES), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_observed_edge (
        .clock, .reset, .shape(settings.common.observed_edge),
        .has_room(observed_edge_has_room), .write(observed_edge_write), .write_data(observed_edge_in),
        .has_token(observed_edge_has_token), .read(observed_edge_read), .read_data(observed_edge_out)
    );

    logic result_has_room, result_write, result_has_token, result_read;
    faster_pkg::counters_t result_in, result_out;
    fifo #(
        .BITS(faster_pkg::COUNTERS_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_result (
        .clock, .reset, .shape(settings.common.result),
        .has_room(result_has_room), .write(result_write), .write_data(result_in),
        .has_token(result_has_token), .read(result_read), .read_data(result_out)
    );
    logic region_has_room, region_write, region_has_token, region_read;
    faster_pkg::pixel_t region_in, region_out;
    fifo #(
        .BITS(faster_pkg::PIXEL_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_region (
        .clock, .reset, .shape(settings.region),
        .has_room(region_has_room), .write(region_write), .write_data(region_in),
        .has_token(region_has_token), .read(region_read), .read_data(region_out)
    );
    logic valid_depth_has_room, valid_depth_write, valid_depth_has_token, valid_depth_read;
    logic [31:0] valid_depth_in, valid_depth_out;
    fifo #(
        .BITS(32), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_valid_depth (
        .clock, .reset, .shape(settings.valid_depth),
        .has_room(valid_depth_has_room), .write(valid_depth_write), .write_data(valid_depth_in),
        .has_token(valid_depth_has_token), .read(valid_depth_read), .read_data(valid_depth_out)
    );
    logic map_full_has_room, map_full_write, map_full_has_token, map_full_read;
    lane_pkg::full_t map_full_in, map_full_out;
    fifo #(
        .BITS(lane_pkg::FULL_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_map_full (
        .clock, .reset, .shape(settings.map_full),
        .has_room(map_full_has_room), .write(map_full_write), .write_data(map_full_in),
        .has_token(map_full_has_token), .read(map_full_read), .read_data(map_full_out)
    );
    logic map_free_has_room, map_free_write, map_free_has_token, map_free_read;
    logic map_free_in, map_free_out;
    fifo #(
        .BITS(1), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_map_free (
        .clock, .reset, .shape(settings.map_free),
        .has_room(map_free_has_room), .write(map_free_write), .write_data(map_free_in),
        .has_token(map_free_has_token), .read(map_free_read), .read_data(map_free_out)
    );
    logic depth_full_has_room, depth_full_write, depth_full_has_token, depth_full_read;
    lane_pkg::full_t depth_full_in, depth_full_out;
    fifo #(
        .BITS(lane_pkg::FULL_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_depth_full (
        .clock, .reset, .shape(settings.depth_full),
        .has_room(depth_full_has_room), .write(depth_full_write), .write_data(depth_full_in),
        .has_token(depth_full_has_token), .read(depth_full_read), .read_data(depth_full_out)
    );
    logic depth_free_has_room, depth_free_write, depth_free_has_token, depth_free_read;
    logic depth_free_in, depth_free_out;
    fifo #(
        .BITS(1), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_depth_free (
        .clock, .reset, .shape(settings.depth_free),
        .has_room(depth_free_has_room), .write(depth_free_write), .write_data(depth_free_in),
        .has_token(depth_free_has_token), .read(depth_free_read), .read_data(depth_free_out)
    );

    faster_pkg::header_t dispatched;
    assign {sample_vertex_in, sample_raster_in, sample_observation_in} = {3{dispatched}};
    sample_dispatcher dispatcher (
        .clock, .reset, .samples, .number(sample_number), .header,
        .sample_vertex_has_room, .sample_vertex_write,
        .sample_raster_has_room, .sample_raster_write,
        .sample_observation_has_room, .sample_observation_write, .sample_header(dispatched)
    );

    vertex_transform transform (
        .clock, .reset, .vertex_loop(settings.common.vertex_loop), .write_latency(settings.common.vertex_latency),
        .vertex_sample, .vertex_number, .vertex_value,
        .sample_vertex_has_token, .sample_vertex_read, .sample_vertex(sample_vertex_out),
        .vertex_has_room, .vertex_write, .vertex(vertex_in)
    );

    lane_rasterizer #(
        .EDGE_BITS(EDGE_BITS), .Z_SUM_BITS(Z_SUM_BITS)
    ) raster (
        .clock, .reset, .scan_loop(settings.common.scan_loop), .setup_cycles(6'(settings.common.setup_cycles)),
        .setups_ahead(settings.setups_ahead), .command_latency(settings.common.command_latency),
        .fragment_depth_latency(settings.common.fragment_depth_latency),
        .fragment_index_latency(settings.common.fragment_index_latency),
        .edge_token_latency(settings.common.edge_token_latency), .lanes(settings.scan_lanes),
        .sends_region(settings.sweeps_touched), .width(settings.common.width), .height(settings.common.height),
        .window(settings.common.window), .vertex_xy(settings.common.fraction.vertex_xy),
        .sample_raster_has_token, .sample_raster_read, .sample_raster(sample_raster_out),
        .vertex_has_token, .vertex_read, .vertex(vertex_out),
        .area_has_room, .area_write, .area(area_in),
        .command_has_room, .command_write, .command(command_in),
        .fragment_depth_has_room, .fragment_depth_write, .fragment_depth(fragment_depth_in),
        .fragment_index_has_room, .fragment_index_write, .fragment_index(fragment_index_in),
        .edge_token_has_room, .edge_token_write, .edge_token(edge_token_in),
        .region_has_room, .region_write, .region(region_in)
    );

    area_reciprocal_unit #(
        .AREA_BITS(EDGE_BITS), .RECIPROCAL_BITS(RECIPROCAL_BITS), .DIVIDER_STAGES(DIVIDER_STAGES)
    ) reciprocal (
        .clock, .reset, .stages(settings.common.area_reciprocal_latency), .squeezes(settings.common.reciprocals_squeeze),
        .interval(settings.common.area_reciprocal_interval),
        .capacity(settings.common.area_reciprocal.capacity), .area_reciprocal_is_read(area_reciprocal_read),
        .one(settings.common.fraction.area_reciprocal + (6'(settings.common.fraction.vertex_xy) << 1)),
        .area_has_token, .area_read, .area(area_out),
        .area_reciprocal_has_room, .area_reciprocal_write, .area_reciprocal(area_reciprocal_in)
    );

    // The object map, and who draws it and reads it out
    logic [1:0][3:0] lanes;
    assign lanes[0] = settings.scan_lanes;
    assign lanes[1] = settings.sweep_lanes;
    logic [1:0] map_buffer;
    logic [1:0][LANES-1:0] map_read, map_write, map_words, map_written;
    logic [1:0][8:0] map_read_row, map_read_group, map_write_row, map_write_group;
    assign map_read[0] = '0;
    assign map_read_row[0] = '0;
    assign map_read_group[0] = '0;
    assign map_written[0] = '1;
    assign map_written[1] = '0;
    banked_buffers #(
        .WORDS(WORDS)
    ) object_map (
        .clock, .banks(settings.object_map_banks), .window(settings.common.window), .lanes, .buffer(map_buffer),
        .read(map_read), .read_row(map_read_row), .read_group(map_read_group), .words(map_words),
        .write(map_write), .write_row(map_write_row), .write_group(map_write_group), .write_words(map_written)
    );

    logic starts_output, output_is_over;
    lane_pkg::region_t map_region;
    lane_map_builder builder (
        .clock, .reset, .token_loop(settings.common.token_loop), .receives_region(settings.sweeps_touched),
        .has_two_maps(settings.has_two_maps), .lanes(settings.scan_lanes), .window(settings.common.window),
        .edge_token_has_token, .edge_token_read, .edge_token(edge_token_out),
        .map_full_has_room, .map_full_write, .map_full(map_full_in),
        .map_free_has_token, .map_free_read, .map_free(map_free_out),
        .buffer(map_buffer[0]), .write(map_write[0]), .write_row(map_write_row[0]), .write_group(map_write_group[0]),
        .starts_output, .region(map_region), .output_is_over, .is_built(maps_are_built)
    );
    lane_map_output map_output (
        .clock, .reset, .output_loop(settings.common.output_loop), .edge_map_latency(settings.common.edge_map_latency),
        .has_two_maps(settings.has_two_maps), .lanes(settings.sweep_lanes), .window(settings.common.window),
        .map_full_has_token, .map_full_read, .map_full(map_full_out),
        .map_free_has_room, .map_free_write, .map_free(map_free_in),
        .edge_map_has_room, .edge_map_write, .edge_map(edge_map_in),
        .starts(starts_output), .region(map_region), .is_over(output_is_over), .buffer(map_buffer[1]),
        .read(map_read[1]), .read_row(map_read_row[1]), .read_token(map_read_group[1]), .words(map_words[1]),
        .write(map_write[1]), .write_row(map_write_row[1]), .write_token(map_write_group[1])
    );

    lane_observation_reader observer (
        .clock, .reset, .read_loop(settings.common.read_loop),
        .observed_depth_latency(settings.common.observed_depth_latency),
        .observed_edge_latency(settings.common.observed_edge_latency), .receives_region(settings.sweeps_touched),
        .lanes(settings.sweep_lanes), .width(settings.common.width), .height(settings.common.height),
        .window(settings.common.window), .sample(observed_sample), .valid_depths, .image_row, .image_col, .image_depths,
        .image_edges,
        .sample_observation_has_token, .sample_observation_read, .sample_observation(sample_observation_out),
        .region_has_token, .region_read, .region(region_out),
        .valid_depth_has_room, .valid_depth_write, .valid_depth(valid_depth_in),
        .observed_depth_has_room, .observed_depth_write, .observed_depth(observed_depth_in),
        .observed_edge_has_room, .observed_edge_write, .observed_edge(observed_edge_in)
    );

    // The depth buffer, and who draws it and sweeps it
    logic [1:0] depth_side_buffer;
    logic [1:0][LANES-1:0] depth_read, depth_write;
    logic [1:0][LANES*WORD_BITS-1:0] depth_words, depth_written;
    logic [1:0][8:0] depth_read_row, depth_read_group, depth_write_row, depth_write_group;
    assign depth_written[1] = '1;  // far
    banked_buffers #(
        .BITS(WORD_BITS), .WORDS(WORDS), .INITIAL(faster_pkg::FAR)
    ) depth_buffer (
        .clock, .banks(settings.depth_buffer_banks), .window(settings.common.window), .lanes, .buffer(depth_side_buffer),
        .read(depth_read), .read_row(depth_read_row), .read_group(depth_read_group), .words(depth_words),
        .write(depth_write), .write_row(depth_write_row), .write_group(depth_write_group), .write_words(depth_written)
    );

    logic starts_sweep, sweep_is_over;
    lane_pkg::region_t depth_region;
    logic [31:0] valid_raster;
    lane_inlier_unit #(
        .Z_SUM_BITS(Z_SUM_BITS), .RECIPROCAL_BITS(RECIPROCAL_BITS), .DEPTH_BITS(DEPTH_BITS)
    ) inlier (
        .clock, .reset, .fragment_loop(settings.common.fragment_loop), .receives_region(settings.sweeps_touched),
        .has_two_buffers(settings.has_two_depth_buffers), .forwards(settings.common.forwards_depth_buffer),
        .lanes(settings.scan_lanes), .window(settings.common.window), .fraction(settings.common.fraction),
        .area_reciprocal_has_token, .area_reciprocal_read, .area_reciprocal(area_reciprocal_out),
        .command_has_token, .command_read, .command(command_out),
        .fragment_depth_has_token, .fragment_depth_read, .fragment_depth(fragment_depth_out),
        .fragment_index_has_token, .fragment_index_read, .fragment_index(fragment_index_out),
        .depth_full_has_room, .depth_full_write, .depth_full(depth_full_in),
        .depth_free_has_token, .depth_free_read, .depth_free(depth_free_out),
        .buffer(depth_side_buffer[0]), .read(depth_read[0]), .read_row(depth_read_row[0]),
        .read_group(depth_read_group[0]), .words(depth_words[0]), .write(depth_write[0]),
        .write_row(depth_write_row[0]), .write_group(depth_write_group[0]), .write_words(depth_written[0]),
        .starts_sweep, .region(depth_region), .valid_raster, .sweep_is_over, .is_drawn(depth_buffer_is_drawn)
    );
    lane_sweep sweep (
        .clock, .reset, .sweep_loop(settings.common.sweep_loop), .sweeps_touched(settings.sweeps_touched),
        .has_two_buffers(settings.has_two_depth_buffers), .counts_hidden(settings.common.counts_hidden),
        .lanes(settings.sweep_lanes), .window(settings.common.window), .fraction(settings.common.fraction.depth_buffer),
        .depth_full_has_token, .depth_full_read, .depth_full(depth_full_out),
        .depth_free_has_room, .depth_free_write, .depth_free(depth_free_in),
        .edge_map_has_token, .edge_map_read, .edge_map(edge_map_out),
        .observed_depth_has_token, .observed_depth_read, .observed_depth(observed_depth_out),
        .observed_edge_has_token, .observed_edge_read, .observed_edge(observed_edge_out),
        .result_has_room, .result_write, .result(result_in),
        .starts(starts_sweep), .region(depth_region), .valid_raster, .is_over(sweep_is_over),
        .buffer(depth_side_buffer[1]), .read(depth_read[1]), .read_row(depth_read_row[1]),
        .read_token(depth_read_group[1]), .words(depth_words[1]), .write(depth_write[1]),
        .write_row(depth_write_row[1]), .write_token(depth_write_group[1])
    );

    // (read result, and with a touched region valid_depth); T += 1
    assign is_done = result_has_token && (!settings.sweeps_touched || valid_depth_has_token);
    assign result_read = is_done;
    assign valid_depth_read = is_done && settings.sweeps_touched;
    always_comb begin
        counters = result_out;
        if (settings.sweeps_touched) counters.valid_depth = valid_depth_out;
    end

    wire unused = &{1'b0, settings, map_words[0]};
endmodule
