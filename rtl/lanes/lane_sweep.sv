// Compares what is drawn with the observation, a token of `lanes` pixels per iteration; an edge pixel has its own depth.
// Clears what it has read. With one depth buffer lane_inlier_unit starts it. With two it is a process: (read depth_full,
// write depth_free); T += 1. Then loop `sweep`; T += 1 instead, if there is nothing to go over; (write result); T += 1.
module lane_sweep #(
    parameter int LANES_BUILT = lane_pkg::LANES
) (
    input  logic                                             clock,
    input  logic                                             reset,
    input  faster_pkg::loop_t                                sweep_loop,
    input  logic                                             sweeps_touched,
    input  logic                                             has_two_buffers,
    input  logic                                             counts_hidden,
    input  lane_pkg::lanes_t                                 lanes,
    input  logic [8:0]                                       window,
    input  logic [3:0]                                       fraction,

    input  logic                                             depth_full_has_token,
    output logic                                             depth_full_read,
    input  lane_pkg::full_t                                  depth_full,
    input  logic                                             depth_free_has_room,
    output logic                                             depth_free_write,
    output logic                                             depth_free,
    input  logic                                             edge_map_has_token,
    output logic                                             edge_map_read,
    input  logic [lane_pkg::LANES-1:0]                       edge_map,
    input  logic                                             observed_depth_has_token,
    output logic                                             observed_depth_read,
    input  logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] observed_depth,
    input  logic                                             observed_edge_has_token,
    output logic                                             observed_edge_read,
    input  logic [lane_pkg::LANES-1:0]                       observed_edge,
    input  logic                                             result_has_room,
    output logic                                             result_write,
    output faster_pkg::counters_t                            result,

    input  logic                                             starts,
    input  lane_pkg::region_t                                region,
    input  logic [31:0]                                      valid_raster,
    output logic                                             is_over,
    output logic                                             buffer,
    output logic [lane_pkg::LANES-1:0]                       read,
    output logic [8:0]                                       read_row,
    output logic [8:0]                                       read_token,
    input  logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] words,
    output logic [lane_pkg::LANES-1:0]                       write,
    output logic [8:0]                                       write_row,
    output logic [8:0]                                       write_token
);
    localparam int LANES = lane_pkg::LANES;
    localparam int WORD_BITS = faster_pkg::DEPTH_BITS;
    typedef enum logic [1:0] {WAIT, SWEEP, NOTHING, RESULT} state_t;
    state_t state;
    logic begins, ends;
    wire takes = has_two_buffers && state == WAIT && depth_full_has_token && depth_free_has_room;
    wire goes = takes || starts;
    wire lane_pkg::region_t new_region = has_two_buffers ? depth_full.region : region;
    assign depth_full_read = takes;
    assign depth_free_write = takes;
    assign depth_free = !depth_full.number;

    wire tokens_are_there = edge_map_has_token && observed_depth_has_token && observed_edge_has_token;
    wire advance = state == SWEEP && (!begins || tokens_are_there);
    wire takes_tokens = begins && advance;
    assign edge_map_read = takes_tokens;
    assign observed_depth_read = takes_tokens;
    assign observed_edge_read = takes_tokens;

    logic is_empty, unused_first_row, unused_first_token, is_last_token, is_last_row;
    logic [8:0] unused_tokens;
    region_walk walk (
        .clock, .starts(goes), .region(new_region), .lanes, .advance(takes_tokens), .is_empty, .row(read_row),
        .token(read_token), .row_tokens(unused_tokens), .is_first_row(unused_first_row),
        .is_first_token(unused_first_token), .is_last_token, .is_last_row
    );
    pipelined_loop loop_control (
        .clock, .reset, .shape(sweep_loop), .active(state == SWEEP), .advance, .is_last(is_last_token && is_last_row),
        .begins, .ends
    );
    wire [11:0] col = 12'(read_token) * 12'(lanes);
    wire [8:0] last = window - 9'd1;
    logic [LANES-1:0] in_window, is_judged;  // the window's border is not
    always_comb
        for (int k = 0; k < LANES; k = k + 1) begin
            in_window[k] = 4'(k) < lanes && col + 12'(k) < 12'(window);
            is_judged[k] = in_window[k] && read_row != '0 && read_row != last && col + 12'(k) != '0 &&
                           col + 12'(k) != 12'(last);
        end
    assign read = takes_tokens ? in_window : '0;

    // A step later the words are there: they are compared, and cleared.
    logic was_read;
    logic [LANES-1:0] lanes_read, lanes_judged, edges_read, observed_edges_read;
    logic [LANES*WORD_BITS-1:0] depths_read;
    assign write = advance && was_read ? lanes_read : '0;
    logic [LANES-1:0] is_inlier, is_valid_depth;
    for (genvar k = 0; k < LANES; k = k + 1) begin : g_lane
        if (k < LANES_BUILT) begin : g_built
            wire faster_pkg::depth_t own = words[k*WORD_BITS+:WORD_BITS];
            pixel_comparison comparison (
                .fraction, .is_edge(edges_read[k]), .has_own_depth(1'b1), .own, .below(own), .above(own), .right(own),
                .left(own), .observed(depths_read[k*WORD_BITS+:WORD_BITS]), .is_inlier(is_inlier[k]),
                .is_valid_depth(is_valid_depth[k])
            );
        end else begin : g_absent
            assign is_inlier[k] = 1'b0;
            assign is_valid_depth[k] = 1'b0;
        end
    end
    logic [31:0] valid_depths, inliers, edges, edge_inliers;
    always_comb begin
        {valid_depths, inliers, edges, edge_inliers} = '0;
        for (int k = 0; k < LANES; k = k + 1) begin
            valid_depths = valid_depths + 32'(lanes_judged[k] && is_valid_depth[k]);
            inliers = inliers + 32'(lanes_judged[k] && is_inlier[k]);
            edges = edges + 32'(lanes_judged[k] && edges_read[k]);
            edge_inliers = edge_inliers + 32'(lanes_judged[k] && is_inlier[k] && edges_read[k] && observed_edges_read[k]);
        end
    end

    faster_pkg::hidden_t hidden;
    lane_hidden_pixels #(
        .LANES_BUILT(LANES_BUILT)
    ) hidden_of_lanes (
        .clock, .starts(!counts_hidden || goes), .advance, .next_col(col), .takes(advance && was_read), .row(write_row),
        .judged(lanes_judged), .fraction, .words, .observed(depths_read), .result(hidden)
    );
    faster_pkg::counters_t counters;
    always_comb begin
        result = counters;
        result.hidden = hidden;
    end

    assign result_write = state == RESULT && result_has_room;
    assign is_over = result_write;
    always_ff @(posedge clock) begin
        if (goes) counters <= {has_two_buffers ? depth_full.valid_raster : valid_raster, 192'd0};
        else if (advance && was_read) begin
            if (!sweeps_touched) counters.valid_depth <= counters.valid_depth + valid_depths;
            counters.inlier <= counters.inlier + inliers;
            counters.valid_edge <= counters.valid_edge + edges;
            counters.edge_inlier <= counters.edge_inlier + edge_inliers;
        end
        if (advance) begin
            was_read <= takes_tokens;
            lanes_read <= in_window;
            lanes_judged <= is_judged;
            edges_read <= edge_map;
            depths_read <= observed_depth;
            observed_edges_read <= observed_edge;
            write_row <= read_row;
            write_token <= read_token;
        end
        if (reset) begin
            state <= WAIT;
            buffer <= 1'b0;
            was_read <= 1'b0;
        end else if (goes) begin
            state <= is_empty ? NOTHING : SWEEP;
            if (has_two_buffers) buffer <= depth_full.number;
        end else
            unique case (state)
                SWEEP: if (advance && ends) state <= RESULT;
                NOTHING: state <= RESULT;
                RESULT: if (result_write) state <= WAIT;
                default: ;
            endcase
    end

    wire unused = &{1'b0, unused_tokens, unused_first_row, unused_first_token};
endmodule
