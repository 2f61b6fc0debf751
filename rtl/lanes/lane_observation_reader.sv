// Sends the observation of a window, or of the region of it that a sample has touched, a token of `lanes` pixels per
// iteration; what lies outside image or window is depth 0 and no edge.
// (read sample_observation); T += 1; with a touched region loop `read`, four iterations that write nothing; (write
// valid_depth); T += 1; twice (read region); T += 1. Then loop `read`; T += 1 instead, if the region is empty.
module lane_observation_reader (
    input  logic                                             clock,
    input  logic                                             reset,
    input  faster_pkg::loop_t                                read_loop,
    input  faster_pkg::stage_t                               observed_depth_latency,
    input  faster_pkg::stage_t                               observed_edge_latency,
    input  logic                                             receives_region,
    input  lane_pkg::lanes_t                                 lanes,
    input  logic [15:0]                                      width,
    input  logic [15:0]                                      height,
    input  logic [8:0]                                       window,
    output logic [31:0]                                      sample,  // whose valid depths are asked for
    input  logic [31:0]                                      valid_depths,
    output logic [31:0]                                      image_row,  // of the token asked for
    output logic [31:0]                                      image_col,  // its first column
    input  logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] image_depths,
    input  logic [lane_pkg::LANES-1:0]                       image_edges,

    input  logic                                             sample_observation_has_token,
    output logic                                             sample_observation_read,
    input  faster_pkg::header_t                              sample_observation,
    input  logic                                             region_has_token,
    output logic                                             region_read,
    input  faster_pkg::pixel_t                               region,
    input  logic                                             valid_depth_has_room,
    output logic                                             valid_depth_write,
    output logic [31:0]                                      valid_depth,
    input  logic                                             observed_depth_has_room,
    output logic                                             observed_depth_write,
    output logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] observed_depth,
    input  logic                                             observed_edge_has_room,
    output logic                                             observed_edge_write,
    output logic [lane_pkg::LANES-1:0]                       observed_edge
);
    localparam int DEPTH_BITS = faster_pkg::DEPTH_BITS;
    localparam int LANES = lane_pkg::LANES;
    typedef enum logic [2:0] {TAKE_SAMPLE, TABLE, VALID_DEPTH, FIRST_CORNER, LAST_CORNER, READ, NOTHING} state_t;
    state_t state;
    logic [2:0] table_reads_left;
    logic signed [31:0] origin_row, origin_col, new_origin_row, new_origin_col;
    faster_pkg::pixel_t first_corner;
    logic begins, ends, advance, is_last, depth_leaves, edge_leaves;

    window_origin origin (
        .centre_row(sample_observation.centre_row), .centre_col(sample_observation.centre_col), .window,
        .row(new_origin_row), .col(new_origin_col)
    );
    pipelined_loop loop_control (
        .clock, .reset, .shape(read_loop), .active(state == TABLE || state == READ), .advance, .is_last, .begins, .ends
    );

    assign sample_observation_read = state == TAKE_SAMPLE && sample_observation_has_token;
    assign region_read = (state == FIRST_CORNER || state == LAST_CORNER) && region_has_token;
    wire has_corners = state == LAST_CORNER && region_has_token;
    wire logic signed [15:0] last = $signed({7'b0, window}) - 16'sd1;
    wire lane_pkg::region_t walked = receives_region ? {first_corner, region} : {32'd0, last, last};
    wire starts = receives_region ? has_corners : sample_observation_read;
    logic is_empty, unused_first_row, unused_first_token, is_last_token, is_last_row;
    logic [8:0] row, token, unused_tokens;
    region_walk walk (
        .clock, .starts, .region(walked), .lanes, .advance(state == READ && begins && advance), .is_empty, .row, .token,
        .row_tokens(unused_tokens), .is_first_row(unused_first_row), .is_first_token(unused_first_token), .is_last_token,
        .is_last_row
    );
    assign is_last = state == TABLE ? table_reads_left == 3'd1 : is_last_token && is_last_row;
    wire [11:0] col = 12'(token) * 12'(lanes);
    assign image_row = origin_row + 32'(row);
    assign image_col = origin_col + 32'(col);

    logic [LANES*DEPTH_BITS-1:0] depths;
    logic [LANES-1:0] edge_bits;
    wire is_row_in_image = $signed(image_row) >= 0 && $signed(image_row) < $signed({16'b0, height});
    for (genvar k = 0; k < LANES; k = k + 1) begin : g_lane
        wire logic signed [31:0] at = $signed(image_col) + k;
        wire is_there = is_row_in_image && at >= 0 && at < $signed({16'b0, width}) && col + 12'(k) < 12'(window) &&
                        4'(k) < lanes;
        assign depths[k*DEPTH_BITS+:DEPTH_BITS] = is_there ? image_depths[k*DEPTH_BITS+:DEPTH_BITS] : '0;
        assign edge_bits[k] = is_there && image_edges[k];
    end
    wire sends = state == READ && begins;
    delay_line #(
        .BITS(1 + LANES * DEPTH_BITS)
    ) depth_line (
        .clock, .advance, .stages(observed_depth_latency), .in({sends, depths}), .out({depth_leaves, observed_depth})
    );
    delay_line #(
        .BITS(1 + LANES)
    ) edge_line (
        .clock, .advance, .stages(observed_edge_latency), .in({sends, edge_bits}), .out({edge_leaves, observed_edge})
    );
    assign advance = state == TABLE || (state == READ && (!depth_leaves || observed_depth_has_room) &&
                                        (!edge_leaves || observed_edge_has_room));
    assign observed_depth_write = state == READ && advance && depth_leaves;
    assign observed_edge_write = state == READ && advance && edge_leaves;
    assign valid_depth_write = state == VALID_DEPTH && valid_depth_has_room;
    assign valid_depth = valid_depths;

    always_ff @(posedge clock) begin
        if (reset) state <= TAKE_SAMPLE;
        else
            unique case (state)
                TAKE_SAMPLE: begin
                    origin_row <= new_origin_row;
                    origin_col <= new_origin_col;
                    sample <= sample_observation.sample;
                    table_reads_left <= 3'd4;
                    if (sample_observation_read) state <= receives_region ? TABLE : READ;
                end
                TABLE:
                    if (ends) state <= VALID_DEPTH;
                    else if (begins) table_reads_left <= table_reads_left - 3'd1;
                VALID_DEPTH: if (valid_depth_has_room) state <= FIRST_CORNER;
                FIRST_CORNER: begin
                    first_corner <= region;
                    if (region_has_token) state <= LAST_CORNER;
                end
                LAST_CORNER: if (region_has_token) state <= is_empty ? NOTHING : READ;
                READ: if (advance && ends) state <= TAKE_SAMPLE;
                default: state <= TAKE_SAMPLE;
            endcase
    end

    wire unused = &{1'b0, sample_observation.triangles, unused_first_row, unused_first_token, unused_tokens};
endmodule
