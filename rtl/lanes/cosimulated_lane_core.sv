// A core with lanes for a simulation in which everything can be set while it runs, as cosimulated_core.sv is for
// raster_core. FIFOs and loops are numbered likewise, FIFOs of fifos.csv behind the thesis's fourteen. What the keys mean
// is worked out here, from docs/timing-model.md and docs/variants.md.
module cosimulated_lane_core (
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
    input  logic               forwards_depth_buffer,
    input  logic               reciprocals_squeeze,
    input  logic [7:0]         area_reciprocal_interval,
    input  logic [3:0]         scan_lanes,
    input  logic [3:0]         sweep_lanes,
    input  logic [3:0]         object_map_banks,
    input  logic [3:0]         depth_buffer_banks,
    input  logic [7:0]         object_map_ports,
    input  logic [7:0]         depth_buffer_ports,
    input  logic [4:0]         setups_ahead,
    input  logic               sweeps_touched,
    input  logic               has_two_maps,
    input  logic               has_two_depth_buffers,
    input  logic               counts_hidden,
    input  logic [7:0]         setup_cycles,  // without the division of spans
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
    output logic [31:0]        observed_sample,
    input  logic [31:0]        valid_depths,
    output logic [31:0]        image_row,
    output logic [31:0]        image_col,
    input  logic [10:0]        observed_depth[LANES],
    input  logic               observed_edge[LANES],

    // Accesses of this cycle, and what is written
    output logic [FIFOS-1:0]   fifo_write,
    output logic [FIFOS-1:0]   fifo_read,
    output logic signed [63:0] field[FIFOS][LANES],  // of its token, in the order of a recording
    output logic               maps_are_built,
    output logic               depth_buffer_is_drawn,
    // A word of each bank of the buffer that is drawn
    input  logic [15:0]        bank_address,
    output logic               object_words[LANES],
    output logic [10:0]        depth_words[LANES]
);
    localparam int FIFOS = 20;
    localparam int LOOPS = 9;
    localparam int LANES = lane_pkg::LANES;
    localparam int Z_SUM_BITS = 56;
    localparam logic [7:0] DIVISION_CYCLES = 8'd18;  // a bit of a quotient each
    typedef enum logic [3:0] {
        VERTEX, SCAN, EDGE_CLEAR, TOKEN, OUTPUT, READ, DEPTH_CLEAR, FRAGMENT, SWEEP
    } loop_number_t;
    typedef enum logic [4:0] {
        F_SAMPLE_VERTEX, F_SAMPLE_RASTER, F_SAMPLE_OBSERVATION, F_VERTEX, F_AREA, F_AREA_RECIPROCAL, F_COMMAND, F_FRAGMENT_DEPTH, F_FRAGMENT_INDEX, F_EDGE_TOKEN, F_EDGE_MAP, F_OBSERVED_DEPTH, F_OBSERVED_EDGE, F_RESULT, F_REGION, F_VALID_DEPTH, F_MAP_FULL, F_MAP_FREE, F_DEPTH_FULL, F_DEPTH_FREE
    } fifo_number_t;

    // II = max(II_target, II_recurrence, II_ports). There are as many banks as lanes, or a multiple of them, cyclic along
    // columns: each accesses of an iteration falls into another bank.
    function automatic logic [7:0] ports_interval(input logic [7:0] accesses, input logic [7:0] ports);
        ports_interval = (accesses + ports - 8'd1) / ports;
    endfunction
    function automatic logic [7:0] larger(input logic [7:0] a, input logic [7:0] b);
        larger = a > b ? a : b;
    endfunction
    function automatic faster_pkg::loop_t scheduled(input loop_number_t number, input logic [7:0] ports);
        scheduled = {larger(larger(loop_target[number], loop_recurrence[number]), ports), loop_depth[number]};
    endfunction

    // Bits of a token decide what `auto` is in the FIFO rules of HLS.
    function automatic logic [7:0] bits_for(input logic [17:0] largest);
        bits_for = '0;
        for (int b = 0; b < 18; ++b) if (largest[b]) bits_for = 8'(b + 1);
    endfunction
    wire is_single = scan_lanes == 4'd1;
    wire [7:0] reciprocal_bits = 8'(area_reciprocal_fraction) + (8'(vertex_xy) << 1) + 8'd1;
    wire [7:0] pixel_bits = bits_for(18'(window) * 18'(window));
    wire [7:0] hidden_bits = counts_hidden ? pixel_bits + (bits_for(18'(window)) << 2) : '0;
    wire [7:0] result_bits = (pixel_bits << 2) + 8'd32 + hidden_bits;
    wire [7:0] corner_bits = (bits_for(18'(window)) + 8'd1) << 1;
    wire [7:0] region_bits = sweeps_touched ? corner_bits << 1 : 8'd0;
    function automatic faster_pkg::fifo_t resolved(input fifo_number_t number, input logic [7:0] bits);
        automatic logic is_small = fifo_rules != 2'd0 && 20'(fifo_depth[number]) * 20'(bits) <= 20'd1024;
        automatic logic is_memory = fifo_kind[number] == 2'd2 ||
                                    (fifo_kind[number] == 2'd0 && fifo_depth[number] > 12'd2 && !is_small);
        resolved = {is_memory, fifo_depth[number] + 12'(is_memory && fifo_rules != 2'd2)};
    endfunction

    // Taken over at the reset.
    lane_settings_pkg::settings_t settings, asked_for;
    always_ff @(posedge clock) if (reset) settings <= asked_for;
    always_comb begin
        asked_for = '0;
        asked_for.common.width = width;
        asked_for.common.height = height;
        asked_for.common.window = window;
        asked_for.common.fraction = {
            vertex_xy, vertex_z, area_reciprocal_fraction, fragment_depth_fraction, depth_buffer_fraction
        };
        asked_for.common.forwards_depth_buffer = forwards_depth_buffer;
        asked_for.common.reciprocals_squeeze = reciprocals_squeeze;
        asked_for.common.area_reciprocal_interval = area_reciprocal_interval;
        asked_for.common.counts_hidden = counts_hidden;
        asked_for.common.setup_cycles = setup_cycles + DIVISION_CYCLES;
        asked_for.common.vertex_loop = scheduled(VERTEX, 8'd1);
        asked_for.common.scan_loop = scheduled(SCAN, 8'd1);
        asked_for.common.token_loop = scheduled(TOKEN, ports_interval(8'd1, object_map_ports));
        asked_for.common.output_loop = scheduled(OUTPUT, ports_interval(8'd2, object_map_ports));
        asked_for.common.read_loop = scheduled(READ, 8'd1);
        asked_for.common.fragment_loop = scheduled(FRAGMENT, ports_interval(8'd2, depth_buffer_ports));
        asked_for.common.sweep_loop = scheduled(SWEEP, ports_interval(8'd2, depth_buffer_ports));
        asked_for.common.vertex_latency = fifo_write_latency[F_VERTEX];
        asked_for.common.area_reciprocal_latency = fifo_write_latency[F_AREA_RECIPROCAL];
        asked_for.common.command_latency = fifo_write_latency[F_COMMAND];
        asked_for.common.fragment_depth_latency = fifo_write_latency[F_FRAGMENT_DEPTH];
        asked_for.common.fragment_index_latency = fifo_write_latency[F_FRAGMENT_INDEX];
        asked_for.common.edge_token_latency = fifo_write_latency[F_EDGE_TOKEN];
        asked_for.common.edge_map_latency = fifo_write_latency[F_EDGE_MAP];
        asked_for.common.observed_depth_latency = fifo_write_latency[F_OBSERVED_DEPTH];
        asked_for.common.observed_edge_latency = fifo_write_latency[F_OBSERVED_EDGE];
        asked_for.scan_lanes = scan_lanes;
        asked_for.sweep_lanes = sweep_lanes;
        asked_for.object_map_banks = object_map_banks;
        asked_for.depth_buffer_banks = depth_buffer_banks;
        asked_for.setups_ahead = setups_ahead;
        asked_for.sweeps_touched = sweeps_touched;
        asked_for.has_two_maps = has_two_maps;
        asked_for.has_two_depth_buffers = has_two_depth_buffers;
        asked_for.common.sample_vertex = resolved(F_SAMPLE_VERTEX, 8'd128);
        asked_for.common.sample_raster = resolved(F_SAMPLE_RASTER, 8'd128);
        asked_for.common.sample_observation = resolved(F_SAMPLE_OBSERVATION, 8'd128);
        asked_for.common.vertex = resolved(F_VERTEX, 8'd48);
        asked_for.common.area = resolved(F_AREA, 8'd33);
        asked_for.common.area_reciprocal = resolved(F_AREA_RECIPROCAL, reciprocal_bits);
        asked_for.common.command = resolved(F_COMMAND, 8'd2);
        asked_for.common.fragment_depth = resolved(F_FRAGMENT_DEPTH, is_single ? 8'd48 : 8'd81);
        asked_for.common.fragment_index = resolved(F_FRAGMENT_INDEX, is_single ? 8'd32 : 8'd32 + 8'(scan_lanes));
        asked_for.common.edge_token = resolved(F_EDGE_TOKEN, is_single ? 8'd34 : 8'd32 + 8'(scan_lanes));
        asked_for.common.edge_map = resolved(F_EDGE_MAP, 8'(sweep_lanes));
        asked_for.common.observed_depth = resolved(F_OBSERVED_DEPTH, 8'd11 * 8'(sweep_lanes));
        asked_for.common.observed_edge = resolved(F_OBSERVED_EDGE, 8'(sweep_lanes));
        asked_for.common.result = resolved(F_RESULT, result_bits);
        asked_for.region = resolved(F_REGION, corner_bits);
        asked_for.valid_depth = resolved(F_VALID_DEPTH, pixel_bits);
        asked_for.map_full = resolved(F_MAP_FULL, 8'd1 + region_bits);
        asked_for.map_free = resolved(F_MAP_FREE, 8'd1);
        asked_for.depth_full = resolved(F_DEPTH_FULL, 8'd33 + region_bits);
        asked_for.depth_free = resolved(F_DEPTH_FREE, 8'd1);
        if (reciprocals_squeeze)
            asked_for.common.area_reciprocal.capacity += 12'(fifo_write_latency[F_AREA_RECIPROCAL]);
    end

    logic is_done;
    faster_pkg::counters_t counters;
    logic [LANES*11-1:0] image_depths;
    logic [LANES-1:0] image_edges;
    for (genvar k = 0; k < LANES; k = k + 1) begin : g_lane
        assign image_depths[k*11+:11] = observed_depth[k];
        assign image_edges[k] = observed_edge[k];
        assign object_words[k] = core.map_buffer[0] ? core.object_map.g_buffer[1].g_bank[k].ram.words[bank_address] :
                                                      core.object_map.g_buffer[0].g_bank[k].ram.words[bank_address];
        assign depth_words[k] =
            core.depth_side_buffer[0] ? core.depth_buffer.g_buffer[1].g_bank[k].ram.words[bank_address] :
                                        core.depth_buffer.g_buffer[0].g_bank[k].ram.words[bank_address];
    end
    lane_core #(
        .Z_SUM_BITS(Z_SUM_BITS)
    ) core (
        .clock, .reset, .settings, .samples, .sample_number,
        .header({header_sample, header_centre_row, header_centre_col, header_triangles}),
        .vertex_sample, .vertex_number, .vertex_value({vertex_x, vertex_y, vertex_depth}),
        .observed_sample, .valid_depths, .image_row, .image_col, .image_depths, .image_edges,
        .is_done, .counters, .maps_are_built, .depth_buffer_is_drawn
    );

    // Of a token of fragment_depth
    wire logic signed [Z_SUM_BITS-1:0] z_sum = core.fragment_depth_in[Z_SUM_BITS+:Z_SUM_BITS];
    wire logic signed [Z_SUM_BITS-1:0] z_step = core.fragment_depth_in[0+:Z_SUM_BITS];

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
        fifo_write[F_AREA_RECIPROCAL] = core.area_reciprocal_write;
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
        fifo_write[F_REGION] = core.region_write;
        fifo_read[F_REGION] = core.region_read;
        fifo_write[F_VALID_DEPTH] = core.valid_depth_write;
        fifo_read[F_VALID_DEPTH] = core.valid_depth_read;
        fifo_write[F_MAP_FULL] = core.map_full_write;
        fifo_read[F_MAP_FULL] = core.map_full_read;
        fifo_write[F_MAP_FREE] = core.map_free_write;
        fifo_read[F_MAP_FREE] = core.map_free_read;
        fifo_write[F_DEPTH_FULL] = core.depth_full_write;
        fifo_read[F_DEPTH_FULL] = core.depth_full_read;
        fifo_write[F_DEPTH_FREE] = core.depth_free_write;
        fifo_read[F_DEPTH_FREE] = core.depth_free_read;
        for (int f = 0; f < FIFOS; ++f) for (int k = 0; k < LANES; ++k) field[f][k] = '0;
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
        field[F_AREA_RECIPROCAL][0] = 64'(core.area_reciprocal_in);
        if (settings.common.reciprocals_squeeze) begin
            fifo_write[F_AREA_RECIPROCAL] = core.reciprocal.begins;
            field[F_AREA_RECIPROCAL][0] = 64'(core.reciprocal.quotient);
        end
        field[F_COMMAND][0] = 64'(core.command_in);
        field[F_FRAGMENT_DEPTH][0] = 64'(z_sum);
        field[F_FRAGMENT_DEPTH][1] = 64'(z_step);
        field[F_FRAGMENT_INDEX][0] = 64'(core.fragment_index_in.row);
        field[F_FRAGMENT_INDEX][1] = 64'(core.fragment_index_in.col);
        field[F_FRAGMENT_INDEX][2] = 64'(core.fragment_index_in.mask);
        field[F_EDGE_TOKEN][0] = 64'(core.edge_token_in.row);
        field[F_EDGE_TOKEN][1] = 64'(core.edge_token_in.col);
        // A single pixel's token has a kind instead: object, or the end.
        field[F_EDGE_TOKEN][2] = !is_single ? 64'(core.edge_token_in.mask) :
                                 core.edge_token_in.mask != '0 ? 64'sd1 : 64'sd2;
        for (int k = 0; k < LANES; ++k) begin
            field[F_EDGE_MAP][k] = 64'(core.edge_map_in[k]);
            field[F_OBSERVED_DEPTH][k] = 64'(core.observed_depth_in[k*11+:11]);
            field[F_OBSERVED_EDGE][k] = 64'(core.observed_edge_in[k]);
        end
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
        field[F_REGION][0] = 64'(core.region_in.row);
        field[F_REGION][1] = 64'(core.region_in.col);
        field[F_VALID_DEPTH][0] = 64'(core.valid_depth_in);
        field[F_MAP_FULL][0] = 64'(core.map_full_in.number);
        field[F_MAP_FULL][1] = 64'(core.map_full_in.region.first_row);
        field[F_MAP_FULL][2] = 64'(core.map_full_in.region.first_col);
        field[F_MAP_FULL][3] = 64'(core.map_full_in.region.last_row);
        field[F_MAP_FULL][4] = 64'(core.map_full_in.region.last_col);
        field[F_MAP_FREE][0] = 64'(core.map_free_in);
        field[F_DEPTH_FULL][0] = 64'(core.depth_full_in.number);
        field[F_DEPTH_FULL][1] = 64'(core.depth_full_in.valid_raster);
        field[F_DEPTH_FULL][2] = 64'(core.depth_full_in.region.first_row);
        field[F_DEPTH_FULL][3] = 64'(core.depth_full_in.region.first_col);
        field[F_DEPTH_FULL][4] = 64'(core.depth_full_in.region.last_row);
        field[F_DEPTH_FULL][5] = 64'(core.depth_full_in.region.last_col);
        field[F_DEPTH_FREE][0] = 64'(core.depth_free_in);
    end

    wire unused = &{1'b0, is_done, counters};
endmodule
