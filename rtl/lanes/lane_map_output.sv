// Reads the object map out and sends its border, a token per iteration, a row of tokens later; clears what it has read.
// With one map lane_map_builder starts it. With two it is a process: (read map_full, write map_free); T += 1. Then loop
// `output`; T += 1 instead, if there is nothing to go over.
module lane_map_output #(
    parameter int PLACES = 512  // tokens of two rows
) (
    input  logic                       clock,
    input  logic                       reset,
    input  faster_pkg::loop_t          output_loop,
    input  faster_pkg::stage_t         edge_map_latency,  // at least 1: the word has to be read first
    input  logic                       has_two_maps,
    input  lane_pkg::lanes_t           lanes,
    input  logic [8:0]                 window,

    input  logic                       map_full_has_token,
    output logic                       map_full_read,
    input  lane_pkg::full_t            map_full,
    input  logic                       map_free_has_room,
    output logic                       map_free_write,
    output logic                       map_free,
    input  logic                       edge_map_has_room,
    output logic                       edge_map_write,
    output logic [lane_pkg::LANES-1:0] edge_map,

    input  logic                       starts,
    input  lane_pkg::region_t          region,
    output logic                       is_over,
    output logic                       buffer,
    output logic [lane_pkg::LANES-1:0] read,
    output logic [8:0]                 read_row,
    output logic [8:0]                 read_token,
    input  logic [lane_pkg::LANES-1:0] words,
    output logic [lane_pkg::LANES-1:0] write,
    output logic [8:0]                 write_row,
    output logic [8:0]                 write_token
);
    typedef enum logic [1:0] {WAIT, OUTPUT, NOTHING} state_t;
    state_t state;
    logic begins, ends, advance, is_last, leaves;
    wire takes = has_two_maps && state == WAIT && map_full_has_token && map_free_has_room;
    wire goes = takes || starts;
    wire lane_pkg::region_t new_region = has_two_maps ? map_full.region : region;

    pipelined_loop loop_control (
        .clock, .reset, .shape(output_loop), .active(state == OUTPUT), .advance, .is_last, .begins, .ends
    );
    // What is read, and a row of tokens later what is judged
    logic is_empty, unused_empty, unused_first, all_read;
    logic [8:0] row_tokens, unused_tokens, lead;
    logic read_ends_row, read_is_last_row, unused_first_token;
    wire reads = begins && advance && !all_read;
    region_walk reading (
        .clock, .starts(goes), .region(new_region), .lanes, .advance(reads), .is_empty, .row(read_row), .token(read_token),
        .row_tokens, .is_first_row(unused_first), .is_first_token(unused_first_token), .is_last_token(read_ends_row),
        .is_last_row(read_is_last_row)
    );
    logic [8:0] row, token;
    logic is_first_row, is_last_row, is_first_token, is_last_token, judges, was_begun, was_read, is_judged;
    region_walk judging (
        .clock, .starts(goes), .region(new_region), .lanes, .advance(advance && is_judged), .is_empty(unused_empty), .row, .token,
        .row_tokens(unused_tokens), .is_first_row, .is_first_token, .is_last_token, .is_last_row
    );
    assign judges = begins && lead == '0;
    logic [8:0] judged_rows_left, judged_tokens_left;  // of the iterations to come
    assign is_last = judges && judged_rows_left == 9'd1 && judged_tokens_left == 9'd1;

    // Words of the window only
    logic [lane_pkg::LANES-1:0] in_window;
    always_comb
        for (int k = 0; k < lane_pkg::LANES; k = k + 1)
            in_window[k] = 4'(k) < lanes && 12'(read_token) * 12'(lanes) + 12'(k) < 12'(window);
    assign read = reads ? in_window : '0;
    logic [lane_pkg::LANES-1:0] lanes_read;
    assign write = advance && was_read ? lanes_read : '0;

    logic [lane_pkg::LANES-1:0] edge_bits;
    lane_border #(
        .PLACES(PLACES)
    ) border (
        .clock, .advance(advance && was_begun), .lanes, .window, .row_tokens, .covered(words & lanes_read),
        .row, .token, .is_first_row, .is_last_row, .is_first_token, .is_last_token, .edge_bits
    );
    delay_line #(
        .BITS(1 + lane_pkg::LANES)
    ) output_line (
        .clock, .advance, .stages(edge_map_latency - 6'd1), .in({is_judged, edge_bits}), .out({leaves, edge_map})
    );
    assign advance = state == OUTPUT && (!leaves || edge_map_has_room);
    assign edge_map_write = advance && leaves;
    assign map_full_read = takes;
    assign map_free_write = takes;
    assign map_free = !map_full.number;
    assign is_over = state == NOTHING || (advance && ends);

    wire [8:0] new_rows = 9'(new_region.last_row - new_region.first_row + 16'sd1);
    wire [8:0] new_tokens = 9'(lane_pkg::divided(new_region.last_col, lanes) - lane_pkg::divided(new_region.first_col, lanes) + 16'd1);
    always_ff @(posedge clock) begin
        if (reset) begin
            state <= WAIT;
            buffer <= 1'b0;
        end else begin
            if (goes) begin
                state <= is_empty ? NOTHING : OUTPUT;
                if (has_two_maps) buffer <= map_full.number;
                lead <= new_tokens;
                judged_rows_left <= new_rows;
                judged_tokens_left <= new_tokens;
                all_read <= 1'b0;
                was_begun <= 1'b0;
                was_read <= 1'b0;
                is_judged <= 1'b0;
            end else if (is_over) state <= WAIT;
            if (advance) begin
                was_begun <= begins;
                was_read <= reads;
                lanes_read <= in_window;
                is_judged <= judges;
                write_row <= read_row;
                write_token <= read_token;
                if (reads && read_ends_row && read_is_last_row) all_read <= 1'b1;
                if (begins && lead != '0) lead <= lead - 9'd1;
                if (judges) begin
                    judged_tokens_left <= judged_tokens_left == 9'd1 ? row_tokens : judged_tokens_left - 9'd1;
                    if (judged_tokens_left == 9'd1) judged_rows_left <= judged_rows_left - 9'd1;
                end
            end
        end
    end

    wire unused = &{1'b0, unused_empty, unused_first, unused_tokens, unused_first_token, map_full.valid_raster};
endmodule
