// Marks covered pixels, a group per iteration: inner_border with clearing on read-out.
// T += 1; (read edge_token); T += 1; loop `token`, without iterations T += 1. Then, with one map: T += 1, or with a
// touched region twice (read edge_token); T += 1; and lane_map_output reads the map out. With two maps: with a touched
// region twice (read edge_token); T += 1; then (write map_full); T += 1; (read map_free); T += 1.
module lane_map_builder (
    input  logic                        clock,
    input  logic                        reset,
    input  faster_pkg::loop_t           token_loop,
    input  logic                        receives_region,
    input  logic                        has_two_maps,
    input  lane_pkg::lanes_t            lanes,
    input  logic [8:0]                  window,

    input  logic                        edge_token_has_token,
    output logic                        edge_token_read,
    input  lane_pkg::group_t            edge_token,
    input  logic                        map_full_has_room,
    output logic                        map_full_write,
    output lane_pkg::full_t             map_full,
    input  logic                        map_free_has_token,
    output logic                        map_free_read,
    input  logic                        map_free,

    output logic                        buffer,
    output logic [lane_pkg::LANES-1:0]  write,
    output logic [8:0]                  write_row,
    output logic [8:0]                  write_group,
    output logic                        starts_output,  // with the region
    output lane_pkg::region_t           region,
    input  logic                        output_is_over,  // in this cycle
    output logic                        is_built        // the map of a sample is complete in this cycle
);
    typedef enum logic [3:0] {
        BEGIN, FIRST_TOKEN, TOKENS, NO_TOKENS, BUILT, FIRST_CORNER, LAST_CORNER, GIVE, TAKE, OUTPUT
    } state_t;
    state_t state;
    lane_pkg::group_t token, writing;
    faster_pkg::pixel_t first_corner;
    logic begins, ends, advance, is_writing;

    wire is_end = edge_token.mask == '0;
    pipelined_loop loop_control (
        .clock, .reset, .shape(token_loop), .active(state == TOKENS), .advance, .is_last(is_end), .begins, .ends
    );
    assign advance = state == TOKENS && (!begins || edge_token_has_token);
    assign edge_token_read =
        edge_token_has_token &&
        (state == FIRST_TOKEN || (state == TOKENS && begins) || state == FIRST_CORNER || state == LAST_CORNER);

    // Object bits are written in the fourth stage, or the last.
    wire faster_pkg::stage_t write_stage = token_loop.depth >= 8'd4 ? 6'd3 : 6'(token_loop.depth - 8'd1);
    delay_line #(
        .BITS(1 + lane_pkg::GROUP_BITS)
    ) token_line (
        .clock, .advance, .stages(write_stage), .in({begins, token}), .out({is_writing, writing})
    );
    wire logic signed [15:0] side = $signed({7'b0, window});
    always_comb
        for (int k = 0; k < lane_pkg::LANES; k = k + 1)
            write[k] = advance && is_writing && writing.mask[k] && writing.row >= 0 && writing.row < side &&
                       writing.col + 16'(k) >= 0 && writing.col + 16'(k) < side;
    assign write_row = 9'(writing.row);
    assign write_group = 9'(lane_pkg::divided({7'b0, writing.col[8:0]}, lanes));

    wire lane_pkg::region_t whole_window = {32'd0, side - 16'sd1, side - 16'sd1};
    wire is_turning = state == BUILT;  // to the output, without a region
    wire has_corners = state == LAST_CORNER && edge_token_has_token;
    assign starts_output = !has_two_maps && (is_turning || has_corners);
    lane_pkg::region_t received;
    assign region = receives_region ? {first_corner, edge_token.row, edge_token.col} : whole_window;
    assign map_full = {buffer, 32'd0, receives_region ? received : whole_window};
    assign map_full_write = state == GIVE && map_full_has_room;
    assign map_free_read = state == TAKE && map_free_has_token;

    // The token loop is over, and its last write: what comes next differs.
    wire state_t after_tokens = receives_region ? FIRST_CORNER : has_two_maps ? GIVE : BUILT;
    logic was_building;
    assign is_built = was_building && state != TOKENS && state != NO_TOKENS;
    always_ff @(posedge clock) begin
        was_building <= !reset && (state == TOKENS || state == NO_TOKENS);
        if (reset) begin
            state <= BEGIN;
            buffer <= 1'b0;
        end else
            unique case (state)
                BEGIN: state <= FIRST_TOKEN;
                FIRST_TOKEN: begin
                    token <= edge_token;
                    if (edge_token_has_token) state <= is_end ? NO_TOKENS : TOKENS;
                end
                TOKENS:
                    if (advance) begin
                        if (begins) token <= edge_token;
                        if (ends) state <= after_tokens;
                    end
                NO_TOKENS: state <= after_tokens;
                BUILT: state <= OUTPUT;
                FIRST_CORNER: begin
                    first_corner <= {edge_token.row, edge_token.col};
                    if (edge_token_has_token) state <= LAST_CORNER;
                end
                LAST_CORNER: begin
                    received <= region;
                    if (edge_token_has_token) state <= has_two_maps ? GIVE : OUTPUT;
                end
                GIVE: if (map_full_has_room) state <= TAKE;
                TAKE: begin
                    buffer <= map_free;
                    if (map_free_has_token) state <= BEGIN;
                end
                default: if (output_is_over) state <= BEGIN;
            endcase
    end

    wire unused = &{1'b0, region};
endmodule
