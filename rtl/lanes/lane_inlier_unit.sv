// Draws the fragments of a sample, a group per iteration, all in one loop: with clearing on read-out.
// T += 1; (read command); T += 1; unless it is End: loop `fragment`, an iteration for each command before End: (read
// area_reciprocal, command) or (read fragment_depth, fragment_index, command). Then, with one depth buffer: T += 1, or
// with a touched region twice (read fragment_index); T += 1; and lane_sweep sweeps it. With two: with a touched region
// twice (read fragment_index); T += 1; then (write depth_full); T += 1; (read depth_free); T += 1.
module lane_inlier_unit #(
    parameter int Z_SUM_BITS = 56,
    parameter int RECIPROCAL_BITS = 64,
    parameter int DEPTH_BITS = 64,
    parameter int LANES_BUILT = lane_pkg::LANES
) (
    input  logic                       clock,
    input  logic                       reset,
    input  faster_pkg::loop_t          fragment_loop,
    input  logic                       receives_region,
    input  logic                       has_two_buffers,
    input  logic                       forwards,
    input  lane_pkg::lanes_t           lanes,
    input  logic [8:0]                 window,
    input  faster_pkg::fraction_t      fraction,

    input  logic                       area_reciprocal_has_token,
    output logic                       area_reciprocal_read,
    input  logic [RECIPROCAL_BITS-1:0] area_reciprocal,
    input  logic                       command_has_token,
    output logic                       command_read,
    input  faster_pkg::command_t       command,
    input  logic                       fragment_depth_has_token,
    output logic                       fragment_depth_read,
    input  logic [2*Z_SUM_BITS-1:0]    fragment_depth,
    input  logic                       fragment_index_has_token,
    output logic                       fragment_index_read,
    input  lane_pkg::group_t           fragment_index,
    input  logic                       depth_full_has_room,
    output logic                       depth_full_write,
    output lane_pkg::full_t            depth_full,
    input  logic                       depth_free_has_token,
    output logic                       depth_free_read,
    input  logic                       depth_free,

    output logic                       buffer,
    output logic [lane_pkg::LANES-1:0] read,
    output logic [8:0]                 read_row,
    output logic [8:0]                 read_group,
    input  logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] words,
    output logic [lane_pkg::LANES-1:0] write,
    output logic [8:0]                 write_row,
    output logic [8:0]                 write_group,
    output logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] write_words,
    output logic                       starts_sweep,
    output lane_pkg::region_t          region,
    output logic [31:0]                valid_raster,
    input  logic                       sweep_is_over,
    output logic                       is_drawn  // the depth buffer of a sample is complete in this cycle
);
    localparam int LANES = lane_pkg::LANES;
    localparam int WORD_BITS = faster_pkg::DEPTH_BITS;
    localparam int ADDRESS_BITS = 18;
    typedef enum logic [3:0] {BEGIN, FIRST_COMMAND, FRAGMENTS, DRAWN, FIRST_CORNER, LAST_CORNER, GIVE, TAKE, SWEEP} state_t;
    state_t state;
    logic begins, ends;
    faster_pkg::command_t next;  // command, read one ahead
    logic [RECIPROCAL_BITS-1:0] reciprocal;
    faster_pkg::pixel_t first_corner;

    wire begins_triangle = begins && next == faster_pkg::TRIANGLE;
    wire takes_fragment = begins && next == faster_pkg::FRAGMENT;
    wire draws = state == FRAGMENTS && (!begins || command_has_token) && (!begins_triangle || area_reciprocal_has_token) &&
                 (!takes_fragment || (fragment_depth_has_token && fragment_index_has_token));
    pipelined_loop loop_control (
        .clock, .reset, .shape(fragment_loop), .active(state == FRAGMENTS), .advance(draws),
        .is_last(command == faster_pkg::END_OF_COMMANDS), .begins, .ends
    );
    wire takes_command = state == FIRST_COMMAND && command_has_token;
    assign area_reciprocal_read = begins_triangle && draws;
    assign command_read = takes_command || (begins && draws);
    assign fragment_depth_read = takes_fragment && draws;
    wire takes_corner = (state == FIRST_CORNER || state == LAST_CORNER) && fragment_index_has_token;
    assign fragment_index_read = (takes_fragment && draws) || takes_corner;

    // Read in stage 7, compared in stage 8, written in stage 9; in a shorter pipeline in its last three
    wire faster_pkg::stage_t read_stage = fragment_loop.depth >= 8'd10 ? 6'd7 : 6'(fragment_loop.depth - 8'd3);
    wire logic signed [15:0] side = $signed({7'b0, window});
    wire is_row_inside = fragment_index.row >= 0 && fragment_index.row < side;
    wire [8:0] group = 9'(lane_pkg::divided({7'b0, fragment_index.col[8:0]}, lanes));
    logic [ADDRESS_BITS-1:0] reading_address, comparing_address, writing_address;
    delay_line #(
        .BITS(ADDRESS_BITS)
    ) address_line (
        .clock, .advance(draws), .stages(read_stage), .in({9'(fragment_index.row), group}), .out(reading_address)
    );
    always_ff @(posedge clock) if (draws) {comparing_address, writing_address} <= {reading_address, comparing_address};
    assign {read_row, read_group} = reading_address;
    assign {write_row, write_group} = writing_address;

    wire logic signed [Z_SUM_BITS-1:0] z_sum = fragment_depth[Z_SUM_BITS+:Z_SUM_BITS];
    wire logic signed [Z_SUM_BITS-1:0] z_step = fragment_depth[0+:Z_SUM_BITS];
    logic [LANES-1:0] lane_reads, lane_writes;
    for (genvar k = 0; k < LANES; k = k + 1) begin : g_lane
        if (k < LANES_BUILT) begin : g_built
            wire logic signed [15:0] col = fragment_index.col + 16'(k);
            wire logic [Z_SUM_BITS-1:0] lane_z_sum = z_sum + Z_SUM_BITS'(k) * z_step;
            lane_depth_unit #(
                .ADDRESS_BITS(ADDRESS_BITS), .RECIPROCAL_BITS(RECIPROCAL_BITS), .DEPTH_BITS(DEPTH_BITS)
            ) lane (
                .clock, .advance(draws), .forwards, .read_stage, .fraction,
                .is_fragment(takes_fragment && fragment_index.mask[k] && is_row_inside && col >= 0 && col < side),
                .z_sum(lane_z_sum[47:0]), .reciprocal,
                .reads(lane_reads[k]), .comparing_address, .writing_address,
                .read_word(words[k*WORD_BITS+:WORD_BITS]),
                .writes(lane_writes[k]), .word(write_words[k*WORD_BITS+:WORD_BITS])
            );
            wire unused = &{1'b0, lane_z_sum[Z_SUM_BITS-1:48]};
        end else begin : g_absent
            assign lane_reads[k] = 1'b0;
            assign lane_writes[k] = 1'b0;
            assign write_words[k*WORD_BITS+:WORD_BITS] = '0;
        end
    end
    assign read = draws ? lane_reads : '0;
    assign write = draws ? lane_writes : '0;
    logic [3:0] written;
    always_comb begin
        written = '0;
        for (int k = 0; k < LANES; k = k + 1) written = written + 4'(write[k]);
    end

    wire lane_pkg::region_t whole_window = {32'd0, side - 16'sd1, side - 16'sd1};
    lane_pkg::region_t received;
    assign region = receives_region ? {first_corner, fragment_index.row, fragment_index.col} : whole_window;
    assign starts_sweep = !has_two_buffers && (state == DRAWN || (state == LAST_CORNER && takes_corner));
    assign depth_full = {buffer, valid_raster, receives_region ? received : whole_window};
    assign depth_full_write = state == GIVE && depth_full_has_room;
    assign depth_free_read = state == TAKE && depth_free_has_token;
    wire state_t after_drawing = receives_region ? FIRST_CORNER : has_two_buffers ? GIVE : DRAWN;

    logic was_drawing;
    assign is_drawn = was_drawing && state != FRAGMENTS && state != FIRST_COMMAND;
    always_ff @(posedge clock) begin
        was_drawing <= !reset && (state == FRAGMENTS || state == FIRST_COMMAND);
        if (command_read) next <= command;
        if (area_reciprocal_read) reciprocal <= area_reciprocal;
        valid_raster <= state == BEGIN ? '0 : valid_raster + 32'(written);
        if (reset) begin
            state <= BEGIN;
            buffer <= 1'b0;
        end else
            unique case (state)
                BEGIN: state <= FIRST_COMMAND;
                FIRST_COMMAND:
                    if (takes_command) state <= command == faster_pkg::END_OF_COMMANDS ? after_drawing : FRAGMENTS;
                FRAGMENTS: if (draws && ends) state <= after_drawing;
                DRAWN: state <= SWEEP;
                FIRST_CORNER: begin
                    first_corner <= {fragment_index.row, fragment_index.col};
                    if (takes_corner) state <= LAST_CORNER;
                end
                LAST_CORNER: begin
                    received <= region;
                    if (takes_corner) state <= has_two_buffers ? GIVE : SWEEP;
                end
                GIVE: if (depth_full_has_room) state <= TAKE;
                TAKE: begin
                    buffer <= depth_free;
                    if (depth_free_has_token) state <= BEGIN;
                end
                default: if (sweep_is_over) state <= BEGIN;
            endcase
    end
endmodule
