// Sets triangles up while others are scanned, one every three cycles at most. The scan may take a triangle `cycles` cycles
// behind its setup's first; span_rows takes its spans as soon as they are divided, which is earlier. In between all
// that is known of a triangle waits in shift registers.
module setup_ahead #(
    parameter int EDGE_BITS = 36,
    parameter int Z_SUM_BITS = 56,
    parameter int CROSSING_BITS = 36,
    parameter int DIFFERENCE_BITS = 17,
    parameter int SETUPS = 32  // at most
) (
    input  logic                                  clock,
    input  logic                                  reset,
    input  logic                                  begins,
    input  logic [3*faster_pkg::VERTEX_BITS-1:0]  triangle,
    input  faster_pkg::stage_t                    cycles,  // at least 24
    input  logic [15:0]                           width,
    input  logic [15:0]                           height,
    input  logic [3:0]                            vertex_xy,

    output logic                                  is_ready,
    input  logic                                  take,
    output logic signed [EDGE_BITS-1:0]           area,
    output logic signed [15:0]                    left_wall,
    output logic signed [Z_SUM_BITS-1:0]          z_sum_at_wall,
    output logic signed [Z_SUM_BITS-1:0]          z_sum_per_col,
    output logic signed [Z_SUM_BITS-1:0]          z_sum_per_row,

    output logic                                  has_spans,
    input  logic                                  take_spans,
    output lane_pkg::box_t                        box,
    // Of three edges, one behind the other
    output logic [5:0]                            sides,
    output logic [3*(DIFFERENCE_BITS-1)-1:0]      divisors,
    output logic [3*CROSSING_BITS-1:0]            quotients,
    output logic [3*(DIFFERENCE_BITS-1)-1:0]      remainders,
    output logic [3*DIFFERENCE_BITS-1:0]          quotient_steps,
    output logic [3*(DIFFERENCE_BITS-1)-1:0]      remainder_steps
);
    localparam int DIVISOR_BITS = DIFFERENCE_BITS - 1;
    // What `cycles` leaves beside division, FIFO and the first row: 3 cycles for the products of the setup, 2 for those
    // with the distance from the wall.
    wire faster_pkg::stage_t spare = cycles - 6'd24;
    wire faster_pkg::stage_t for_setup = spare < 6'd3 ? spare : 6'd3;
    wire faster_pkg::stage_t for_wall = spare - for_setup < 6'd2 ? spare - for_setup : 6'd2;

    logic has_begun;
    faster_pkg::vertex_t vertices_v0, vertices_v1, vertices_v2;
    always_ff @(posedge clock) begin
        has_begun <= !reset && begins;
        if (begins) {vertices_v0, vertices_v1, vertices_v2} <= triangle;
    end

    logic signed [EDGE_BITS-1:0] new_area;
    logic signed [15:0] col_min, col_max, row_max, start_row, start_col;
    logic [3*EDGE_BITS-1:0] start_edges, edges_per_col, edges_per_row;
    logic signed [Z_SUM_BITS-1:0] start_z_sum, new_z_sum_per_col, new_z_sum_per_row;
    triangle_setup #(
        .EDGE_BITS (EDGE_BITS),
        .Z_SUM_BITS(Z_SUM_BITS)
    ) setup (
        .v0(vertices_v0), .v1(vertices_v1), .v2(vertices_v2), .vertex_xy, .width, .height,
        .area(new_area), .col_min, .col_max, .row_max, .start_row, .start_col, .start_edges, .edges_per_col,
        .edges_per_row, .start_z_sum, .z_sum_per_col(new_z_sum_per_col), .z_sum_per_row(new_z_sum_per_row)
    );
    logic [3*DIFFERENCE_BITS-1:0] per_col, per_row;  // without fractions of a pixel
    for (genvar i = 0; i < 3; i = i + 1) begin : g_difference
        assign per_col[i*DIFFERENCE_BITS+:DIFFERENCE_BITS] =
            DIFFERENCE_BITS'($signed(edges_per_col[i*EDGE_BITS+:EDGE_BITS]) >>> vertex_xy);
        assign per_row[i*DIFFERENCE_BITS+:DIFFERENCE_BITS] =
            DIFFERENCE_BITS'($signed(edges_per_row[i*EDGE_BITS+:EDGE_BITS]) >>> vertex_xy);
    end

    logic is_set_up, is_at_wall;
    logic signed [EDGE_BITS-1:0] set_area;
    lane_pkg::box_t set_box;
    logic [3*EDGE_BITS-1:0] set_edges;
    logic [3*DIFFERENCE_BITS-1:0] set_per_col, set_per_row;
    logic signed [Z_SUM_BITS-1:0] set_z_sum, set_z_sum_per_col, set_z_sum_per_row;
    settled_register #(
        .BITS(4 * EDGE_BITS + lane_pkg::BOX_BITS + 6 * DIFFERENCE_BITS + 3 * Z_SUM_BITS)
    ) set_up (
        .clock, .begins(has_begun), .stages(for_setup), .is_there(is_set_up),
        .in({new_area, new_area > 0, col_min, col_max, row_max, start_row, start_col, start_edges, per_col, per_row,
             start_z_sum, new_z_sum_per_col, new_z_sum_per_row}),
        .out({set_area, set_box, set_edges, set_per_col, set_per_row, set_z_sum, set_z_sum_per_col, set_z_sum_per_row})
    );

    // From the start to the left wall
    wire logic signed [16:0] from_left = 17'(set_box.start_col) - 17'(set_box.col_min);
    logic [3*CROSSING_BITS-1:0] new_at_wall, at_wall;
    for (genvar i = 0; i < 3; i = i + 1) begin : g_wall
        wire logic signed [DIFFERENCE_BITS-1:0] of_edge = set_per_col[i*DIFFERENCE_BITS+:DIFFERENCE_BITS];
        wire logic signed [EDGE_BITS-1:0] value = set_edges[i*EDGE_BITS+:EDGE_BITS];
        assign new_at_wall[i*CROSSING_BITS+:CROSSING_BITS] =
            CROSSING_BITS'(value >>> vertex_xy) - CROSSING_BITS'(from_left) * CROSSING_BITS'(of_edge);
    end
    wire logic signed [Z_SUM_BITS-1:0] new_z_sum_at_wall = set_z_sum - Z_SUM_BITS'(from_left) * set_z_sum_per_col;
    logic signed [Z_SUM_BITS-1:0] settled_z_sum;
    settled_register #(
        .BITS(3 * CROSSING_BITS + Z_SUM_BITS)
    ) wall (
        .clock, .begins(is_set_up), .stages(for_wall), .is_there(is_at_wall), .in({new_at_wall, new_z_sum_at_wall}),
        .out({at_wall, settled_z_sum})
    );

    logic [2:0] crossing_is_there, step_is_there;
    logic [5:0] new_sides;
    logic [3*DIVISOR_BITS-1:0] new_divisors, new_remainders, new_remainder_steps;
    logic [3*CROSSING_BITS-1:0] new_quotients;
    logic [3*DIFFERENCE_BITS-1:0] new_quotient_steps;
    for (genvar i = 0; i < 3; i = i + 1) begin : g_edge
        wire logic signed [DIFFERENCE_BITS-1:0] of_edge = set_per_col[i*DIFFERENCE_BITS+:DIFFERENCE_BITS];
        assign new_sides[2*i+:2] = of_edge == '0 ? lane_pkg::FLAT : of_edge < 0 ? lane_pkg::FROM_RIGHT : lane_pkg::FROM_LEFT;
        span_division #(
            .CROSSING_BITS(CROSSING_BITS), .DIFFERENCE_BITS(DIFFERENCE_BITS)
        ) division (
            .clock, .begins(is_at_wall), .at_wall(at_wall[i*CROSSING_BITS+:CROSSING_BITS]), .per_col(of_edge),
            .per_row(set_per_row[i*DIFFERENCE_BITS+:DIFFERENCE_BITS]), .divisor(new_divisors[i*DIVISOR_BITS+:DIVISOR_BITS]),
            .crossing_is_there(crossing_is_there[i]), .quotient(new_quotients[i*CROSSING_BITS+:CROSSING_BITS]),
            .remainder(new_remainders[i*DIVISOR_BITS+:DIVISOR_BITS]),
            .step_is_there(step_is_there[i]), .quotient_step(new_quotient_steps[i*DIFFERENCE_BITS+:DIFFERENCE_BITS]),
            .remainder_step(new_remainder_steps[i*DIVISOR_BITS+:DIVISOR_BITS])
        );
    end

    // There is room: as many triangles are read ahead as there are places.
    logic [3:0] unused_room;
    logic [1:0] unused_token;
    logic [1:0] has_quotients;
    assign has_spans = has_quotients == 2'b11;
    fifo_shift_register #(
        .BITS(EDGE_BITS + 16 + 3 * Z_SUM_BITS), .PLACES(SETUPS)
    ) of_scan (
        .clock, .reset, .capacity(12'd1), .has_room(unused_room[0]), .write(is_at_wall),
        .write_data({set_area, set_box.col_min, settled_z_sum, set_z_sum_per_col, set_z_sum_per_row}),
        .has_token(unused_token[0]), .read(take),
        .read_data({area, left_wall, z_sum_at_wall, z_sum_per_col, z_sum_per_row})
    );
    fifo_shift_register #(
        .BITS(lane_pkg::BOX_BITS + 6 + 3 * DIVISOR_BITS), .PLACES(SETUPS)
    ) of_rows (
        .clock, .reset, .capacity(12'd1), .has_room(unused_room[1]), .write(is_at_wall),
        .write_data({set_box, new_sides, new_divisors}), .has_token(unused_token[1]), .read(take_spans),
        .read_data({box, sides, divisors})
    );
    fifo_shift_register #(
        .BITS(3 * CROSSING_BITS + 3 * DIVISOR_BITS), .PLACES(SETUPS)
    ) of_crossings (
        .clock, .reset, .capacity(12'd1), .has_room(unused_room[2]), .write(crossing_is_there[0]),
        .write_data({new_quotients, new_remainders}), .has_token(has_quotients[0]), .read(take_spans),
        .read_data({quotients, remainders})
    );
    fifo_shift_register #(
        .BITS(3 * DIFFERENCE_BITS + 3 * DIVISOR_BITS), .PLACES(SETUPS)
    ) of_steps (
        .clock, .reset, .capacity(12'd1), .has_room(unused_room[3]), .write(step_is_there[0]),
        .write_data({new_quotient_steps, new_remainder_steps}), .has_token(has_quotients[1]), .read(take_spans),
        .read_data({quotient_steps, remainder_steps})
    );

    localparam int COUNT_BITS = $clog2(SETUPS + 1);
    logic [COUNT_BITS-1:0] ready;
    logic becomes_ready;
    delay_line #(
        .BITS(1)
    ) until_ready (
        .clock, .advance(1'b1), .stages(cycles), .in(begins && !reset), .out(becomes_ready)
    );
    always_ff @(posedge clock)
        ready <= reset ? '0 : ready + COUNT_BITS'(becomes_ready) - COUNT_BITS'(take);
    assign is_ready = ready != '0;

    wire unused = &{1'b0, unused_room, unused_token, crossing_is_there[2:1], step_is_there[2:1]};
endmodule
