// Judges the pixels of tokens while they are read out, row by row of a region: an edge is a covered pixel beside one that
// is not. Beyond the region nothing is covered, beyond the window everything. The last two rows are kept in shift
// registers, so the token of a row before is judged.
module lane_border #(
    parameter int PLACES = 512,  // tokens of two rows
    localparam int LANES = lane_pkg::LANES
) (
    input  logic             clock,
    input  logic             advance,  // `covered` is kept
    input  lane_pkg::lanes_t lanes,
    input  logic [8:0]       window,
    input  logic [8:0]       row_tokens,
    input  logic [LANES-1:0] covered,  // of the token below the judged one
    // The judged token
    input  logic [8:0]       row,
    input  logic [8:0]       token,
    input  logic             is_first_row,
    input  logic             is_last_row,
    input  logic             is_first_token,
    input  logic             is_last_token,
    output logic [LANES-1:0] edge_bits
);
    localparam int INDEX_BITS = $clog2(PLACES);
    typedef logic [INDEX_BITS-1:0] index_t;
    wire index_t behind = INDEX_BITS'(row_tokens) - INDEX_BITS'(1);
    logic [LANES-1:0] judged, above, left;
    logic right;  // the next token's first pixel
    wire is_alone = row_tokens == 9'd1;
    for (genvar k = 0; k < LANES; k = k + 1) begin : g_lane
        logic [PLACES-1:0] history;  // bit i: i + 1 tokens before
        always_ff @(posedge clock) if (advance) history <= {history[PLACES-2:0], covered[k]};
        assign judged[k] = history[behind];
        assign above[k] = history[behind+INDEX_BITS'(row_tokens)];
        assign left[k] = history[behind+INDEX_BITS'(1)];
        if (k == 0) assign right = history[behind-INDEX_BITS'(1)];
    end

    wire [8:0] last = window - 9'd1;
    wire [8:0] first_col = token * 9'(lanes);
    wire lane_pkg::lanes_t last_lane = lanes - 4'd1;
    for (genvar k = 0; k < LANES; k = k + 1) begin : g_pixel
        wire [8:0] col = first_col + 9'(k);
        wire to_left = k == 0 ? !is_first_token && left[last_lane] : judged[k == 0 ? 0 : k-1];
        wire to_right = 4'(k) == last_lane ? !is_last_token && !is_alone && right : judged[k == LANES - 1 ? k : k+1];
        assign edge_bits[k] =
            4'(k) < lanes && judged[k] &&
            !((row == '0 || (!is_first_row && above[k])) && (row == last || (!is_last_row && covered[k])) &&
              (col == '0 || to_left) && (col == last || to_right));
    end
endmodule
