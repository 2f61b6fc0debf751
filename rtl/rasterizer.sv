// Scans the box of every triangle and sends what it covers.
// (read sample_raster); T += 1. Per triangle: 3 x ((read vertex); T += 1); the setup; (write area, and if drawn command
// Triangle); T += 1; if drawn: loop `scan`. Then T += 1; (write command End, edge_token end); T += 1.
module rasterizer #(
    parameter int EDGE_BITS = 36,
    parameter int Z_SUM_BITS = 48
) (
    input  logic                        clock,
    input  logic                        reset,
    input  faster_pkg::loop_t           scan_loop,
    input  faster_pkg::cycles_t         setup_cycles,
    input  faster_pkg::stage_t          command_latency,
    input  faster_pkg::stage_t          fragment_depth_latency,
    input  faster_pkg::stage_t          fragment_index_latency,
    input  faster_pkg::stage_t          edge_token_latency,
    input  logic                        sends_edges,
    input  logic [15:0]                 width,
    input  logic [15:0]                 height,
    input  logic [8:0]                  window,
    input  logic [3:0]                  vertex_xy,

    input  logic                        sample_raster_has_token,
    output logic                        sample_raster_read,
    input  faster_pkg::header_t         sample_raster,
    input  logic                        vertex_has_token,
    output logic                        vertex_read,
    input  faster_pkg::vertex_t         vertex,
    input  logic                        area_has_room,
    output logic                        area_write,
    output logic signed [EDGE_BITS-1:0] area,
    input  logic                        command_has_room,
    output logic                        command_write,
    output faster_pkg::command_t        command,
    input  logic                        fragment_depth_has_room,
    output logic                        fragment_depth_write,
    output logic [Z_SUM_BITS-1:0]       fragment_depth,
    input  logic                        fragment_index_has_room,
    output logic                        fragment_index_write,
    output faster_pkg::pixel_t          fragment_index,
    input  logic                        edge_token_has_room,
    output logic                        edge_token_write,
    output faster_pkg::edge_token_t     edge_token
);
    typedef enum logic [2:0] {TAKE_SAMPLE, VERTICES, SETUP, ANNOUNCE, SCAN, LAST_TRIANGLE_DONE, END_SAMPLE} state_t;
    state_t state;
    logic [31:0] triangles_left;  // the one at work included
    logic [1:0] vertices_read;  // of it
    faster_pkg::cycles_t setup_left;
    faster_pkg::vertex_t v0, v1, v2;
    logic signed [31:0] origin_row, origin_col;

    logic signed [31:0] new_origin_row, new_origin_col;
    window_origin origin (
        .centre_row(sample_raster.centre_row), .centre_col(sample_raster.centre_col), .window,
        .row(new_origin_row), .col(new_origin_col)
    );

    // Setup: all of it is ready in the last of its cycles.
    logic signed [EDGE_BITS-1:0] new_area;
    logic signed [15:0] new_col_min, new_col_max, new_row_max, new_start_row, new_start_col;
    logic [3*EDGE_BITS-1:0] new_edges, new_edges_per_col, new_edges_per_row;
    logic [Z_SUM_BITS-1:0] new_z_sum, new_z_sum_per_col, new_z_sum_per_row;
    logic [3*EDGE_BITS-1:0] edges_per_col, edges_per_row;
    logic [Z_SUM_BITS-1:0] z_sum_per_col, z_sum_per_row;
    wire setup_done = state == SETUP && setup_left == 8'd1;

    triangle_setup #(
        .EDGE_BITS (EDGE_BITS),
        .Z_SUM_BITS(Z_SUM_BITS)
    ) setup (
        .v0, .v1, .v2, .vertex_xy, .width, .height,
        .area         (new_area),
        .col_min      (new_col_min),
        .col_max      (new_col_max),
        .row_max      (new_row_max),
        .start_row    (new_start_row),
        .start_col    (new_start_col),
        .start_edges  (new_edges),
        .edges_per_col(new_edges_per_col),
        .edges_per_row(new_edges_per_row),
        .start_z_sum  (new_z_sum),
        .z_sum_per_col(new_z_sum_per_col),
        .z_sum_per_row(new_z_sum_per_row)
    );

    always_ff @(posedge clock) begin
        if (setup_done) begin
            area <= new_area;
            edges_per_col <= new_edges_per_col;
            edges_per_row <= new_edges_per_row;
            z_sum_per_col <= new_z_sum_per_col;
            z_sum_per_row <= new_z_sum_per_row;
        end
    end

    // The scan
    logic begins, ends, is_last, is_fragment, has_token, advance;
    logic [Z_SUM_BITS-1:0] z_sum;
    logic signed [16:0] row, col, token_row, token_col;
    faster_pkg::edge_kind_t token_kind;

    zigzag_scan #(
        .EDGE_BITS (EDGE_BITS),
        .Z_SUM_BITS(Z_SUM_BITS)
    ) scan (
        .clock,
        .load       (setup_done),
        .iterate    (begins && advance),
        .sends_edges,
        .col_min    (new_col_min),
        .col_max    (new_col_max),
        .row_max    (new_row_max),
        .start_row  (new_start_row),
        .start_col  (new_start_col),
        .start_edges(new_edges),
        .edges_per_col,
        .edges_per_row,
        .start_z_sum(new_z_sum),
        .z_sum_per_col,
        .z_sum_per_row,
        .is_last, .is_fragment, .z_sum, .row, .col, .has_token, .token_kind, .token_row, .token_col
    );
    pipelined_loop loop_control (
        .clock, .reset, .shape(scan_loop), .active(state == SCAN), .advance, .is_last, .begins, .ends
    );

    // What an iteration sends, each FIFO at a stage of its own
    logic command_leaves, fragment_depth_leaves, fragment_index_leaves, edge_token_leaves;
    wire faster_pkg::pixel_t index = {16'(32'(row) - origin_row), 16'(32'(col) - origin_col)};
    wire faster_pkg::edge_token_t token =
        {token_kind, 16'(32'(token_row) - origin_row), 16'(32'(token_col) - origin_col)};
    faster_pkg::edge_token_t scanned_token;

    delay_line command_line (
        .clock, .advance, .stages(command_latency), .in(begins && is_fragment), .out(command_leaves)
    );
    delay_line #(
        .BITS(1 + Z_SUM_BITS)
    ) fragment_depth_line (
        .clock, .advance, .stages(fragment_depth_latency), .in({begins && is_fragment, z_sum}),
        .out({fragment_depth_leaves, fragment_depth})
    );
    delay_line #(
        .BITS(1 + faster_pkg::PIXEL_BITS)
    ) fragment_index_line (
        .clock, .advance, .stages(fragment_index_latency), .in({begins && is_fragment, index}),
        .out({fragment_index_leaves, fragment_index})
    );
    delay_line #(
        .BITS(1 + faster_pkg::EDGE_TOKEN_BITS)
    ) edge_token_line (
        .clock, .advance, .stages(edge_token_latency), .in({begins && has_token, token}),
        .out({edge_token_leaves, scanned_token})
    );
    assign advance = state == SCAN && (!command_leaves || command_has_room) &&
                     (!fragment_depth_leaves || fragment_depth_has_room) &&
                     (!fragment_index_leaves || fragment_index_has_room) &&
                     (!edge_token_leaves || edge_token_has_room);

    // Steps outside of the loop
    wire is_drawn = area > 0;
    wire announces = state == ANNOUNCE && area_has_room && (!is_drawn || command_has_room);
    wire ends_sample = state == END_SAMPLE && command_has_room && edge_token_has_room;

    assign sample_raster_read = state == TAKE_SAMPLE && sample_raster_has_token;
    assign vertex_read = state == VERTICES && vertex_has_token;
    assign area_write = announces;
    assign command_write = (announces && is_drawn) || (advance && command_leaves) || ends_sample;
    assign command = state == ANNOUNCE ? faster_pkg::TRIANGLE :
                     state == SCAN ? faster_pkg::FRAGMENT : faster_pkg::END_OF_COMMANDS;
    assign fragment_depth_write = advance && fragment_depth_leaves;
    assign fragment_index_write = advance && fragment_index_leaves;
    assign edge_token_write = (advance && edge_token_leaves) || ends_sample;
    assign edge_token = state == SCAN ? scanned_token : {faster_pkg::END_OF_TOKENS, 32'd0};

    wire triangle_done = (announces && !is_drawn) || (advance && ends);

    always_ff @(posedge clock) begin
        if (reset) state <= TAKE_SAMPLE;
        else begin
            unique case (state)
                TAKE_SAMPLE: begin
                    origin_row <= new_origin_row;
                    origin_col <= new_origin_col;
                    triangles_left <= sample_raster.triangles;
                    vertices_read <= '0;
                    if (sample_raster_read) state <= sample_raster.triangles == '0 ? LAST_TRIANGLE_DONE : VERTICES;
                end
                VERTICES:
                    if (vertex_read) begin
                        {v0, v1, v2} <= {v1, v2, vertex};
                        vertices_read <= vertices_read + 2'd1;
                        setup_left <= setup_cycles;
                        if (vertices_read == 2'd2) state <= SETUP;
                    end
                SETUP: begin
                    setup_left <= setup_left - 8'd1;
                    if (setup_done) state <= ANNOUNCE;
                end
                ANNOUNCE: if (announces && is_drawn) state <= SCAN;
                SCAN: ;
                LAST_TRIANGLE_DONE: state <= END_SAMPLE;
                default: if (ends_sample) state <= TAKE_SAMPLE;
            endcase
            if (triangle_done) begin
                triangles_left <= triangles_left - 32'd1;
                vertices_read <= '0;
                state <= triangles_left == 32'd1 ? LAST_TRIANGLE_DONE : VERTICES;
            end
        end
    end

    wire unused = &{1'b0, sample_raster.sample};
endmodule
