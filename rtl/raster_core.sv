// One raster core (docs/architecture.md#the-machine): eight processes and the FIFOs between them. Wiring only. `NAME_in` is the token that
// is written to FIFO NAME in a cycle with `NAME_write`, `NAME_out` the one that is read in a cycle with `NAME_read`.
module raster_core #(
    parameter int EDGE_BITS = 36,  // of an edge value and of an area
    parameter int Z_SUM_BITS = 48,
    parameter int RECIPROCAL_BITS = 64,
    parameter int DEPTH_BITS = 64,  // of a fragment's depth, at its precision
    parameter int DIVIDER_STAGES = 0,
    parameter int WORDS = 65536,  // of a map
    parameter int DEPTH_BUFFER_PORTS = 6,
    parameter int SHIFT_REGISTER_PLACES = 64,
    parameter int MEMORY_WORDS = 1024
) (
    input  logic                    clock,
    input  logic                    reset,
    input  faster_pkg::settings_t    settings,
    // What the core works on, and what comes of it
    input  logic [31:0]              samples,
    output logic [31:0]              sample_number,
    input  faster_pkg::header_t      header,
    output logic [31:0]              vertex_sample,
    output logic [31:0]              vertex_number,
    input  faster_pkg::vertex_t      vertex_value,
    output logic [31:0]              image_row,
    output logic [31:0]              image_col,
    input  faster_pkg::observation_t observation,
    output logic                    is_done,  // a sample, whose counters are
    output faster_pkg::counters_t    counters,
    // For who compares the maps
    output logic                    maps_are_built,
    output logic                    depth_buffer_is_drawn
);
    logic sample_vertex_has_room, sample_vertex_write, sample_vertex_has_token, sample_vertex_read;
    faster_pkg::header_t sample_vertex_in, sample_vertex_out;
    fifo #(
        .BITS(faster_pkg::HEADER_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_sample_vertex (
        .clock, .reset, .shape(settings.sample_vertex),
        .has_room(sample_vertex_has_room), .write(sample_vertex_write), .write_data(sample_vertex_in),
        .has_token(sample_vertex_has_token), .read(sample_vertex_read), .read_data(sample_vertex_out)
    );

    logic sample_raster_has_room, sample_raster_write, sample_raster_has_token, sample_raster_read;
    faster_pkg::header_t sample_raster_in, sample_raster_out;
    fifo #(
        .BITS(faster_pkg::HEADER_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_sample_raster (
        .clock, .reset, .shape(settings.sample_raster),
        .has_room(sample_raster_has_room), .write(sample_raster_write), .write_data(sample_raster_in),
        .has_token(sample_raster_has_token), .read(sample_raster_read), .read_data(sample_raster_out)
    );

    logic sample_observation_has_room, sample_observation_write, sample_observation_has_token, sample_observation_read;
    faster_pkg::header_t sample_observation_in, sample_observation_out;
    fifo #(
        .BITS(faster_pkg::HEADER_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_sample_observation (
        .clock, .reset, .shape(settings.sample_observation),
        .has_room(sample_observation_has_room), .write(sample_observation_write), .write_data(sample_observation_in),
        .has_token(sample_observation_has_token), .read(sample_observation_read), .read_data(sample_observation_out)
    );

    logic vertex_has_room, vertex_write, vertex_has_token, vertex_read;
    faster_pkg::vertex_t vertex_in, vertex_out;
    fifo #(
        .BITS(faster_pkg::VERTEX_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_vertex (
        .clock, .reset, .shape(settings.vertex),
        .has_room(vertex_has_room), .write(vertex_write), .write_data(vertex_in),
        .has_token(vertex_has_token), .read(vertex_read), .read_data(vertex_out)
    );

    logic area_has_room, area_write, area_has_token, area_read;
    logic signed [EDGE_BITS-1:0] area_in, area_out;
    fifo #(
        .BITS(EDGE_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_area (
        .clock, .reset, .shape(settings.area),
        .has_room(area_has_room), .write(area_write), .write_data(area_in),
        .has_token(area_has_token), .read(area_read), .read_data(area_out)
    );

    logic area_reciprocal_has_room, area_reciprocal_write, area_reciprocal_has_token, area_reciprocal_read;
    logic [RECIPROCAL_BITS-1:0] area_reciprocal_in, area_reciprocal_out;
    fifo #(
        .BITS(RECIPROCAL_BITS), .SHIFT_REGISTER_PLACES(2 * SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_area_reciprocal (
        .clock, .reset, .shape(settings.area_reciprocal),
        .has_room(area_reciprocal_has_room), .write(area_reciprocal_write), .write_data(area_reciprocal_in),
        .has_token(area_reciprocal_has_token), .read(area_reciprocal_read), .read_data(area_reciprocal_out)
    );

    logic command_has_room, command_write, command_has_token, command_read;
    faster_pkg::command_t command_in, command_out;
    fifo #(
        .BITS(faster_pkg::COMMAND_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_command (
        .clock, .reset, .shape(settings.command),
        .has_room(command_has_room), .write(command_write), .write_data(command_in),
        .has_token(command_has_token), .read(command_read), .read_data(command_out)
    );

    logic fragment_depth_has_room, fragment_depth_write, fragment_depth_has_token, fragment_depth_read;
    logic [Z_SUM_BITS-1:0] fragment_depth_in, fragment_depth_out;
    fifo #(
        .BITS(Z_SUM_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_fragment_depth (
        .clock, .reset, .shape(settings.fragment_depth),
        .has_room(fragment_depth_has_room), .write(fragment_depth_write), .write_data(fragment_depth_in),
        .has_token(fragment_depth_has_token), .read(fragment_depth_read), .read_data(fragment_depth_out)
    );

    logic fragment_index_has_room, fragment_index_write, fragment_index_has_token, fragment_index_read;
    faster_pkg::pixel_t fragment_index_in, fragment_index_out;
    fifo #(
        .BITS(faster_pkg::PIXEL_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_fragment_index (
        .clock, .reset, .shape(settings.fragment_index),
        .has_room(fragment_index_has_room), .write(fragment_index_write), .write_data(fragment_index_in),
        .has_token(fragment_index_has_token), .read(fragment_index_read), .read_data(fragment_index_out)
    );

    logic edge_token_has_room, edge_token_write, edge_token_has_token, edge_token_read;
    faster_pkg::edge_token_t edge_token_in, edge_token_out;
    fifo #(
        .BITS(faster_pkg::EDGE_TOKEN_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_edge_token (
        .clock, .reset, .shape(settings.edge_token),
        .has_room(edge_token_has_room), .write(edge_token_write), .write_data(edge_token_in),
        .has_token(edge_token_has_token), .read(edge_token_read), .read_data(edge_token_out)
    );

    logic edge_map_has_room, edge_map_write, edge_map_has_token, edge_map_read;
    logic edge_map_in, edge_map_out;
    fifo #(
        .BITS(1), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_edge_map (
        .clock, .reset, .shape(settings.edge_map),
        .has_room(edge_map_has_room), .write(edge_map_write), .write_data(edge_map_in),
        .has_token(edge_map_has_token), .read(edge_map_read), .read_data(edge_map_out)
    );

    logic observed_depth_has_room, observed_depth_write, observed_depth_has_token, observed_depth_read;
    faster_pkg::depth_t observed_depth_in, observed_depth_out;
    fifo #(
        .BITS(faster_pkg::DEPTH_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_observed_depth (
        .clock, .reset, .shape(settings.observed_depth),
        .has_room(observed_depth_has_room), .write(observed_depth_write), .write_data(observed_depth_in),
        .has_token(observed_depth_has_token), .read(observed_depth_read), .read_data(observed_depth_out)
    );

    logic observed_edge_has_room, observed_edge_write, observed_edge_has_token, observed_edge_read;
    logic observed_edge_in, observed_edge_out;
    fifo #(
        .BITS(1), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_observed_edge (
        .clock, .reset, .shape(settings.observed_edge),
        .has_room(observed_edge_has_room), .write(observed_edge_write), .write_data(observed_edge_in),
        .has_token(observed_edge_has_token), .read(observed_edge_read), .read_data(observed_edge_out)
    );

    logic result_has_room, result_write, result_has_token, result_read;
    faster_pkg::counters_t result_in, result_out;
    fifo #(
        .BITS(faster_pkg::COUNTERS_BITS), .SHIFT_REGISTER_PLACES(SHIFT_REGISTER_PLACES), .MEMORY_WORDS(MEMORY_WORDS)
    ) fifo_result (
        .clock, .reset, .shape(settings.result),
        .has_room(result_has_room), .write(result_write), .write_data(result_in),
        .has_token(result_has_token), .read(result_read), .read_data(result_out)
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
        .clock, .reset, .vertex_loop(settings.vertex_loop), .write_latency(settings.vertex_latency),
        .vertex_sample, .vertex_number, .vertex_value,
        .sample_vertex_has_token, .sample_vertex_read, .sample_vertex(sample_vertex_out),
        .vertex_has_room, .vertex_write, .vertex(vertex_in)
    );

    rasterizer #(
        .EDGE_BITS(EDGE_BITS), .Z_SUM_BITS(Z_SUM_BITS)
    ) raster (
        .clock, .reset, .scan_loop(settings.scan_loop), .setup_cycles(settings.setup_cycles),
        .command_latency(settings.command_latency), .fragment_depth_latency(settings.fragment_depth_latency),
        .fragment_index_latency(settings.fragment_index_latency), .edge_token_latency(settings.edge_token_latency),
        .sends_edges(settings.sends_edges), .width(settings.width), .height(settings.height),
        .window(settings.window), .vertex_xy(settings.fraction.vertex_xy),
        .sample_raster_has_token, .sample_raster_read, .sample_raster(sample_raster_out),
        .vertex_has_token, .vertex_read, .vertex(vertex_out),
        .area_has_room, .area_write, .area(area_in),
        .command_has_room, .command_write, .command(command_in),
        .fragment_depth_has_room, .fragment_depth_write, .fragment_depth(fragment_depth_in),
        .fragment_index_has_room, .fragment_index_write, .fragment_index(fragment_index_in),
        .edge_token_has_room, .edge_token_write, .edge_token(edge_token_in)
    );

    area_reciprocal_unit #(
        .AREA_BITS(EDGE_BITS), .RECIPROCAL_BITS(RECIPROCAL_BITS), .DIVIDER_STAGES(DIVIDER_STAGES)
    ) reciprocal (
        .clock, .reset, .stages(settings.area_reciprocal_latency), .squeezes(settings.reciprocals_squeeze),
        .interval(settings.area_reciprocal_interval),
        .capacity(settings.area_reciprocal.capacity), .area_reciprocal_is_read(area_reciprocal_read),
        .one(settings.fraction.area_reciprocal + (6'(settings.fraction.vertex_xy) << 1)),
        .area_has_token, .area_read, .area(area_out),
        .area_reciprocal_has_room, .area_reciprocal_write, .area_reciprocal(area_reciprocal_in)
    );

    edge_map_builder #(
        .WORDS(WORDS)
    ) builder (
        .clock, .reset, .clear_loop(settings.edge_clear_loop), .token_loop(settings.token_loop),
        .output_loop(settings.output_loop), .edge_map_latency(settings.edge_map_latency),
        .is_inner_border(settings.is_inner_border), .clears_on_read_out(settings.edge_map_clears_on_read_out),
        .flushes_last(settings.flushes_last), .forwards(settings.forwards_object_map), .window(settings.window),
        .edge_token_has_token, .edge_token_read, .edge_token(edge_token_out),
        .edge_map_has_room, .edge_map_write, .edge_map(edge_map_in),
        .is_built(maps_are_built)
    );

    observation_reader observer (
        .clock, .reset, .read_loop(settings.read_loop), .observed_depth_latency(settings.observed_depth_latency),
        .observed_edge_latency(settings.observed_edge_latency), .width(settings.width), .height(settings.height),
        .window(settings.window), .image_row, .image_col, .observation,
        .sample_observation_has_token, .sample_observation_read, .sample_observation(sample_observation_out),
        .observed_depth_has_room, .observed_depth_write, .observed_depth(observed_depth_in),
        .observed_edge_has_room, .observed_edge_write, .observed_edge(observed_edge_in)
    );

    inlier_unit #(
        .WORDS(WORDS), .PORTS(DEPTH_BUFFER_PORTS), .Z_SUM_BITS(Z_SUM_BITS), .RECIPROCAL_BITS(RECIPROCAL_BITS),
        .DEPTH_BITS(DEPTH_BITS)
    ) inlier (
        .clock, .reset, .clear_loop(settings.depth_clear_loop), .fragment_loop(settings.fragment_loop),
        .sweep_loop(settings.sweep_loop), .ports(settings.depth_buffer_ports),
        .is_inner_border(settings.is_inner_border), .has_line_buffers(settings.has_line_buffers),
        .is_flattened(settings.fragment_loop_is_flattened), .forwards(settings.forwards_depth_buffer),
        .clears_on_read_out(settings.inlier_unit_clears_on_read_out), .counts_hidden(settings.counts_hidden),
        .window(settings.window), .fraction(settings.fraction),
        .area_reciprocal_has_token, .area_reciprocal_read, .area_reciprocal(area_reciprocal_out),
        .command_has_token, .command_read, .command(command_out),
        .fragment_depth_has_token, .fragment_depth_read, .fragment_depth(fragment_depth_out),
        .fragment_index_has_token, .fragment_index_read, .fragment_index(fragment_index_out),
        .edge_map_has_token, .edge_map_read, .edge_map(edge_map_out),
        .observed_depth_has_token, .observed_depth_read, .observed_depth(observed_depth_out),
        .observed_edge_has_token, .observed_edge_read, .observed_edge(observed_edge_out),
        .result_has_room, .result_write, .result(result_in),
        .is_drawn(depth_buffer_is_drawn)
    );

    result_collector collector (
        .result_has_token, .result_read, .result(result_out), .is_taken(is_done), .counters
    );
endmodule
