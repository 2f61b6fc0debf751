// A raster core for a simulation in which everything can be set while it runs: keys in, accesses to FIFOs out. FIFOs are
// numbered as in fifos.csv, loops as in docs/timing-model.md#sources-of-time. What the keys mean is worked out here, from the
// rules of docs/timing-model.md.
module cosimulated_core (
    input  logic               clock,
    input  logic               reset,

    input  logic [15:0]        width,
    input  logic [15:0]        height,
    input  logic [8:0]         window,
    input  logic [3:0]         vertex_xy,
    input  logic [4:0]         vertex_z,
    input  logic [5:0]         area_reciprocal_fraction,
    input  logic [4:0]         fragment_depth_fraction,
    input  logic [3:0]         depth_buffer_fraction,
    input  logic               sends_edges,
    input  logic               is_inner_border,
    input  logic               flushes_last,
    input  logic               forwards_object_map,
    input  logic               edge_map_clears_on_read_out,
    input  logic               inlier_unit_clears_on_read_out,
    input  logic               has_line_buffers,
    input  logic               counts_hidden,
    input  logic               fragment_loop_is_flattened,
    input  logic               forwards_depth_buffer,
    input  logic               reciprocals_squeeze,
    input  logic [7:0]         area_reciprocal_interval,
    input  logic [7:0]         edge_map_ports,
    input  logic [7:0]         object_map_ports,
    input  logic [7:0]         depth_buffer_ports,
    input  logic [7:0]         setup_cycles,
    input  logic [7:0]         loop_target[LOOPS],
    input  logic [7:0]         loop_recurrence[LOOPS],
    input  logic [7:0]         loop_depth[LOOPS],
    input  logic [1:0]         fifo_rules,  // spec, vivado_hls, vitis_hls
    input  logic [1:0]         fifo_kind[FIFOS],  // auto, shift_register, memory
    input  logic [11:0]        fifo_depth[FIFOS],
    input  logic [5:0]         fifo_write_latency[FIFOS],  // 0 where no loop writes

    input  logic [31:0]        samples,
    output logic [31:0]        sample_number,
    input  logic [31:0]        header_sample,
    input  logic signed [31:0] header_centre_row,
    input  logic signed [31:0] header_centre_col,
    input  logic [31:0]        header_triangles,
    output logic [31:0]        vertex_sample,
    output logic [31:0]        vertex_number,
    input  logic [15:0]        vertex_x,
    input  logic [15:0]        vertex_y,
    input  logic [15:0]        vertex_depth,
    output logic [31:0]        image_row,
    output logic [31:0]        image_col,
    input  logic [10:0]        observed_depth,
    input  logic               observed_edge,

    // Accesses of this cycle, and what is written
    output logic [FIFOS-1:0]   fifo_write,
    output logic [FIFOS-1:0]   fifo_read,
    output logic signed [63:0] field[FIFOS][10],  // of its token, in the order of a recording
    output logic               maps_are_built,
    output logic               depth_buffer_is_drawn
);
    localparam int FIFOS = 14;
    localparam int LOOPS = 9;
    typedef enum logic [3:0] {
        VERTEX, SCAN, EDGE_CLEAR, TOKEN, OUTPUT, READ, DEPTH_CLEAR, FRAGMENT, SWEEP
    } loop_number_t;
    typedef enum logic [3:0] {
        F_SAMPLE_VERTEX, F_SAMPLE_RASTER, F_SAMPLE_OBSERVATION, F_VERTEX, F_AREA, F_AREA_RECIPROCAL, F_COMMAND,
        F_FRAGMENT_DEPTH, F_FRAGMENT_INDEX, F_EDGE_TOKEN, F_EDGE_MAP, F_OBSERVED_DEPTH, F_OBSERVED_EDGE, F_RESULT
    } fifo_number_t;

    // II = max(II_target, II_recurrence, II_ports), the worst branch counting in every iteration
    function automatic logic [7:0] ports_interval(input logic [7:0] accesses, input logic [7:0] ports);
        ports_interval = (accesses + ports - 8'd1) / ports;
    endfunction
    function automatic logic [7:0] larger(input logic [7:0] a, input logic [7:0] b);
        larger = a > b ? a : b;
    endfunction
    function automatic faster_pkg::loop_t scheduled(input loop_number_t number, input logic [7:0] ports);
        scheduled = {larger(larger(loop_target[number], loop_recurrence[number]), ports), loop_depth[number]};
    endfunction

    wire has_edge_map = !is_inner_border;
    wire [7:0] cleared_edge = 8'(edge_map_clears_on_read_out);
    wire [7:0] clear_ports = larger(has_edge_map ? ports_interval(8'd1, edge_map_ports) : 8'd1,
                                    ports_interval(8'd1, object_map_ports));
    wire [7:0] token_ports = has_edge_map ? larger(ports_interval(8'd2, edge_map_ports),
                                                   ports_interval(8'd2, object_map_ports)) :
                                            ports_interval(8'd1, object_map_ports);
    // What is read is the edge map, or with inner_border the object map; cleared are both.
    wire [7:0] output_ports =
        has_edge_map ? larger(ports_interval(8'd1 + cleared_edge, edge_map_ports),
                              ports_interval(larger(cleared_edge, 8'd1), object_map_ports)) :
                       ports_interval(8'd1 + cleared_edge, object_map_ports);
    wire [7:0] swept_words = is_inner_border || has_line_buffers ? 8'd1 : 8'd5;
    wire [7:0] sweep_ports =
        ports_interval(swept_words + 8'(inlier_unit_clears_on_read_out), depth_buffer_ports);

    // Bits of a token decide what `auto` is in the FIFO rules of HLS.
    function automatic logic [7:0] bits_for(input logic [17:0] largest);
        logic [7:0] bits;
        bits = '0;
        for (int b = 0; b < 18; ++b) if (largest[b]) bits = 8'(b + 1);
        bits_for = bits;
    endfunction
    wire [7:0] reciprocal_bits = 8'(area_reciprocal_fraction) + (8'(vertex_xy) << 1) + 8'd1;
    wire [7:0] pixel_bits = bits_for(18'(window) * 18'(window));
    wire [7:0] hidden_bits = counts_hidden ? pixel_bits + (bits_for(18'(window)) << 2) : '0;
    wire [7:0] result_bits = (pixel_bits << 2) + 8'd32 + hidden_bits;
    function automatic faster_pkg::fifo_t resolved(input fifo_number_t number, input logic [7:0] bits);
        logic is_small;
        logic is_memory;
        is_small = fifo_rules != 2'd0 && 20'(fifo_depth[number]) * 20'(bits) <= 20'd1024;
        is_memory = fifo_kind[number] == 2'd2 ||
                    (fifo_kind[number] == 2'd0 && fifo_depth[number] > 12'd2 && !is_small);
        resolved = {is_memory, fifo_depth[number] + 12'(is_memory && fifo_rules != 2'd2)};
    endfunction

    // Taken over at the reset.
    faster_pkg::settings_t settings, settings_asked_for;
    always_ff @(posedge clock) if (reset) settings <= settings_asked_for;
    always_comb begin
        settings_asked_for.width = width;
        settings_asked_for.height = height;
        settings_asked_for.window = window;
        settings_asked_for.fraction = {
            vertex_xy, vertex_z, area_reciprocal_fraction, fragment_depth_fraction, depth_buffer_fraction
        };
        settings_asked_for.sends_edges = sends_edges;
        settings_asked_for.is_inner_border = is_inner_border;
        settings_asked_for.flushes_last = flushes_last;
        settings_asked_for.forwards_object_map = forwards_object_map;
        settings_asked_for.edge_map_clears_on_read_out = edge_map_clears_on_read_out;
        settings_asked_for.inlier_unit_clears_on_read_out = inlier_unit_clears_on_read_out;
        settings_asked_for.has_line_buffers = has_line_buffers;
        settings_asked_for.counts_hidden = counts_hidden;
        settings_asked_for.fragment_loop_is_flattened = fragment_loop_is_flattened;
        settings_asked_for.forwards_depth_buffer = forwards_depth_buffer;
        settings_asked_for.reciprocals_squeeze = reciprocals_squeeze;
        settings_asked_for.area_reciprocal_interval = area_reciprocal_interval;
        settings_asked_for.depth_buffer_ports = depth_buffer_ports > 8'd6 ? 3'd6 : depth_buffer_ports[2:0];
        settings_asked_for.setup_cycles = setup_cycles;
        settings_asked_for.vertex_loop = scheduled(VERTEX, 8'd1);
        settings_asked_for.scan_loop = scheduled(SCAN, 8'd1);
        settings_asked_for.edge_clear_loop = scheduled(EDGE_CLEAR, clear_ports);
        settings_asked_for.token_loop = scheduled(TOKEN, token_ports);
        settings_asked_for.output_loop = scheduled(OUTPUT, output_ports);
        settings_asked_for.read_loop = scheduled(READ, 8'd1);
        settings_asked_for.depth_clear_loop = scheduled(DEPTH_CLEAR, ports_interval(8'd1, depth_buffer_ports));
        settings_asked_for.fragment_loop = scheduled(FRAGMENT, ports_interval(8'd2, depth_buffer_ports));
        settings_asked_for.sweep_loop = scheduled(SWEEP, sweep_ports);
        settings_asked_for.vertex_latency = fifo_write_latency[F_VERTEX];
        settings_asked_for.area_reciprocal_latency = fifo_write_latency[F_AREA_RECIPROCAL];
        settings_asked_for.command_latency = fifo_write_latency[F_COMMAND];
        settings_asked_for.fragment_depth_latency = fifo_write_latency[F_FRAGMENT_DEPTH];
        settings_asked_for.fragment_index_latency = fifo_write_latency[F_FRAGMENT_INDEX];
        settings_asked_for.edge_token_latency = fifo_write_latency[F_EDGE_TOKEN];
        settings_asked_for.edge_map_latency = fifo_write_latency[F_EDGE_MAP];
        settings_asked_for.observed_depth_latency = fifo_write_latency[F_OBSERVED_DEPTH];
        settings_asked_for.observed_edge_latency = fifo_write_latency[F_OBSERVED_EDGE];
        settings_asked_for.sample_vertex = resolved(F_SAMPLE_VERTEX, 8'd128);
        settings_asked_for.sample_raster = resolved(F_SAMPLE_RASTER, 8'd128);
        settings_asked_for.sample_observation = resolved(F_SAMPLE_OBSERVATION, 8'd128);
        settings_asked_for.vertex = resolved(F_VERTEX, 8'd48);
        settings_asked_for.area = resolved(F_AREA, 8'd33);
        settings_asked_for.area_reciprocal = resolved(F_AREA_RECIPROCAL, reciprocal_bits);
        if (reciprocals_squeeze)
            settings_asked_for.area_reciprocal.capacity += 12'(fifo_write_latency[F_AREA_RECIPROCAL]);
        settings_asked_for.command = resolved(F_COMMAND, 8'd2);
        settings_asked_for.fragment_depth = resolved(F_FRAGMENT_DEPTH, 8'd48);
        settings_asked_for.fragment_index = resolved(F_FRAGMENT_INDEX, 8'd32);
        settings_asked_for.edge_token = resolved(F_EDGE_TOKEN, 8'd34);
        settings_asked_for.edge_map = resolved(F_EDGE_MAP, 8'd1);
        settings_asked_for.observed_depth = resolved(F_OBSERVED_DEPTH, 8'd11);
        settings_asked_for.observed_edge = resolved(F_OBSERVED_EDGE, 8'd1);
        settings_asked_for.result = resolved(F_RESULT, result_bits);
    end

    logic is_done;
    faster_pkg::counters_t counters;
    raster_core core (
        .clock, .reset, .settings, .samples, .sample_number,
        .header({header_sample, header_centre_row, header_centre_col, header_triangles}),
        .vertex_sample, .vertex_number, .vertex_value({vertex_x, vertex_y, vertex_depth}),
        .image_row, .image_col, .observation({observed_depth, observed_edge}),
        .is_done, .counters,
        .maps_are_built, .depth_buffer_is_drawn
    );

    always_comb begin
        fifo_write[F_SAMPLE_VERTEX] = core.sample_vertex_write;
        fifo_read[F_SAMPLE_VERTEX] = core.sample_vertex_read;
        fifo_write[F_SAMPLE_RASTER] = core.sample_raster_write;
        fifo_read[F_SAMPLE_RASTER] = core.sample_raster_read;
        fifo_write[F_SAMPLE_OBSERVATION] = core.sample_observation_write;
        fifo_read[F_SAMPLE_OBSERVATION] = core.sample_observation_read;
        fifo_write[F_VERTEX] = core.vertex_write;
        fifo_read[F_VERTEX] = core.vertex_read;
        fifo_write[F_AREA] = core.area_write;
        fifo_read[F_AREA] = core.area_read;
        fifo_read[F_AREA_RECIPROCAL] = core.area_reciprocal_read;
        fifo_write[F_COMMAND] = core.command_write;
        fifo_read[F_COMMAND] = core.command_read;
        fifo_write[F_FRAGMENT_DEPTH] = core.fragment_depth_write;
        fifo_read[F_FRAGMENT_DEPTH] = core.fragment_depth_read;
        fifo_write[F_FRAGMENT_INDEX] = core.fragment_index_write;
        fifo_read[F_FRAGMENT_INDEX] = core.fragment_index_read;
        fifo_write[F_EDGE_TOKEN] = core.edge_token_write;
        fifo_read[F_EDGE_TOKEN] = core.edge_token_read;
        fifo_write[F_EDGE_MAP] = core.edge_map_write;
        fifo_read[F_EDGE_MAP] = core.edge_map_read;
        fifo_write[F_OBSERVED_DEPTH] = core.observed_depth_write;
        fifo_read[F_OBSERVED_DEPTH] = core.observed_depth_read;
        fifo_write[F_OBSERVED_EDGE] = core.observed_edge_write;
        fifo_read[F_OBSERVED_EDGE] = core.observed_edge_read;
        fifo_write[F_RESULT] = core.result_write;
        fifo_read[F_RESULT] = core.result_read;
        for (int f = 0; f < FIFOS; ++f) for (int k = 0; k < 10; ++k) field[f][k] = '0;
        field[F_SAMPLE_VERTEX][0] = 64'(core.sample_vertex_in.sample);
        field[F_SAMPLE_VERTEX][1] = 64'(core.sample_vertex_in.centre_row);
        field[F_SAMPLE_VERTEX][2] = 64'(core.sample_vertex_in.centre_col);
        field[F_SAMPLE_VERTEX][3] = 64'(core.sample_vertex_in.triangles);
        field[F_SAMPLE_RASTER][0] = 64'(core.sample_raster_in.sample);
        field[F_SAMPLE_RASTER][1] = 64'(core.sample_raster_in.centre_row);
        field[F_SAMPLE_RASTER][2] = 64'(core.sample_raster_in.centre_col);
        field[F_SAMPLE_RASTER][3] = 64'(core.sample_raster_in.triangles);
        field[F_SAMPLE_OBSERVATION][0] = 64'(core.sample_observation_in.sample);
        field[F_SAMPLE_OBSERVATION][1] = 64'(core.sample_observation_in.centre_row);
        field[F_SAMPLE_OBSERVATION][2] = 64'(core.sample_observation_in.centre_col);
        field[F_SAMPLE_OBSERVATION][3] = 64'(core.sample_observation_in.triangles);
        field[F_VERTEX][0] = 64'(core.vertex_in.x);
        field[F_VERTEX][1] = 64'(core.vertex_in.y);
        field[F_VERTEX][2] = 64'(core.vertex_in.z);
        field[F_AREA][0] = 64'(core.area_in);
        // A recording has a squeezing unit's result where it is issued.
        if (settings.reciprocals_squeeze) begin
            fifo_write[F_AREA_RECIPROCAL] = core.reciprocal.begins;
            field[F_AREA_RECIPROCAL][0] = 64'(core.reciprocal.quotient);
        end else begin
            fifo_write[F_AREA_RECIPROCAL] = core.area_reciprocal_write;
            field[F_AREA_RECIPROCAL][0] = 64'(core.area_reciprocal_in);
        end
        field[F_COMMAND][0] = 64'(core.command_in);
        field[F_FRAGMENT_DEPTH][0] = 64'(core.fragment_depth_in);
        field[F_FRAGMENT_INDEX][0] = 64'(core.fragment_index_in.row);
        field[F_FRAGMENT_INDEX][1] = 64'(core.fragment_index_in.col);
        field[F_EDGE_TOKEN][0] = 64'(core.edge_token_in.pixel.row);
        field[F_EDGE_TOKEN][1] = 64'(core.edge_token_in.pixel.col);
        field[F_EDGE_TOKEN][2] = 64'(core.edge_token_in.kind);
        field[F_EDGE_MAP][0] = 64'(core.edge_map_in);
        field[F_OBSERVED_DEPTH][0] = 64'(core.observed_depth_in);
        field[F_OBSERVED_EDGE][0] = 64'(core.observed_edge_in);
        field[F_RESULT][0] = 64'(core.result_in.valid_raster);
        field[F_RESULT][1] = 64'(core.result_in.valid_depth);
        field[F_RESULT][2] = 64'(core.result_in.inlier);
        field[F_RESULT][3] = 64'(core.result_in.valid_edge);
        field[F_RESULT][4] = 64'(core.result_in.edge_inlier);
        field[F_RESULT][5] = 64'(core.result_in.hidden.count);
        field[F_RESULT][6] = 64'(core.result_in.hidden.top);
        field[F_RESULT][7] = 64'(core.result_in.hidden.left);
        field[F_RESULT][8] = 64'(core.result_in.hidden.bottom);
        field[F_RESULT][9] = 64'(core.result_in.hidden.right);
    end

    wire unused = &{1'b0, is_done, counters};
endmodule
