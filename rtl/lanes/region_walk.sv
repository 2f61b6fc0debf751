// Where a loop over the tokens of a region is: rows of tokens of `lanes` pixels, from its first to its last.
module region_walk (
    input  logic              clock,
    input  logic              starts,  // with the region below
    input  lane_pkg::region_t region,
    input  lane_pkg::lanes_t  lanes,
    input  logic              advance,
    output logic              is_empty,  // of the region that it starts with
    output logic [8:0]        row,
    output logic [8:0]        token,      // in the row of the window
    output logic [8:0]        row_tokens,  // of the region
    output logic              is_first_row,
    output logic              is_first_token,  // of a row
    output logic              is_last_token,
    output logic              is_last_row
);
    logic [8:0] first_row, last_row, first_token, last_token;
    assign is_empty = region.last_row < region.first_row;
    assign is_first_row = row == first_row;
    assign is_first_token = token == first_token;
    assign is_last_token = token == last_token;
    assign is_last_row = row == last_row;
    assign row_tokens = last_token - first_token + 9'd1;

    always_ff @(posedge clock) begin
        if (starts) begin
            first_row <= 9'(region.first_row);
            last_row <= 9'(region.last_row);
            first_token <= 9'(lane_pkg::divided(region.first_col, lanes));
            last_token <= 9'(lane_pkg::divided(region.last_col, lanes));
            row <= 9'(region.first_row);
            token <= 9'(lane_pkg::divided(region.first_col, lanes));
        end else if (advance) begin
            token <= is_last_token ? first_token : token + 9'd1;
            if (is_last_token) row <= row + 9'd1;
        end
    end
endmodule
