// Goes over the groups of a triangle that have a covered pixel, row by row; a row without takes one iteration. span_rows
// has worked the rows out.
module span_scan #(
    parameter int Z_SUM_BITS = 56
) (
    input  logic                         clock,
    input  logic                         load,     // a triangle: the inputs below
    input  logic                         iterate,  // an iteration begins, and its step takes place
    input  lane_pkg::lanes_t             lanes,
    input  logic signed [15:0]           new_left_wall,  // column of the window
    input  logic signed [Z_SUM_BITS-1:0] z_sum_at_wall,
    input  logic signed [Z_SUM_BITS-1:0] new_z_sum_per_col,
    input  logic signed [Z_SUM_BITS-1:0] new_z_sum_per_row,
    input  lane_pkg::row_t               row,
    output logic                         take_row,

    // What the iteration yields that begins in this step
    output logic                         is_last,
    output logic                         sends,
    output lane_pkg::group_t             group,  // its mask only if it sends
    output logic signed [Z_SUM_BITS-1:0] z_sum,  // of its first column
    output logic signed [Z_SUM_BITS-1:0] z_sum_per_col
);
    logic is_in_row;
    logic signed [15:0] left_wall, current;
    logic signed [Z_SUM_BITS-1:0] row_z_sum, z_sum_per_row;  // at the left wall
    wire logic signed [15:0] step = $signed({12'b0, lanes});
    wire logic signed [15:0] col = is_in_row ? current : row.first_group;  // of the group
    wire is_row_over = row.is_empty || col == row.last_group;
    assign sends = !row.is_empty;
    assign is_last = is_row_over && row.is_last;
    assign take_row = iterate && is_row_over;

    logic [lane_pkg::LANES-1:0] covered;
    always_comb
        for (int k = 0; k < lane_pkg::LANES; k = k + 1)
            covered[k] = 4'(k) < lanes && col + 16'(k) >= row.first_col && col + 16'(k) <= row.last_col;
    assign group = {row.row, col, covered};
    wire logic signed [16:0] from_left = 17'(col) - 17'(left_wall);
    assign z_sum = row_z_sum + Z_SUM_BITS'(from_left) * z_sum_per_col;

    always_ff @(posedge clock) begin
        if (load) begin
            is_in_row <= 1'b0;
            left_wall <= new_left_wall;
            row_z_sum <= z_sum_at_wall;
            z_sum_per_col <= new_z_sum_per_col;
            z_sum_per_row <= new_z_sum_per_row;
        end else if (iterate) begin
            is_in_row <= !is_row_over;
            current <= row.goes_right ? col + step : col - step;
            if (is_row_over) row_z_sum <= row_z_sum + z_sum_per_row;
        end
    end
endmodule
