// Goes over the rows of a triangle in the order and directions of the zigzag, and in each over the groups of `lanes`
// pixels that have a covered one; a row without takes one iteration. Groups begin at multiples of `lanes` from the
// window's first column on. Where an edge crosses a row follows from where it crossed the row before: a quotient and a
// remainder, with what a row adds to them, from span_division.
module span_scan #(
    parameter int EDGE_BITS = 36,
    parameter int Z_SUM_BITS = 56
) (
    input  logic                         clock,
    input  logic                         load,     // a triangle: the inputs below
    input  logic                         iterate,  // an iteration begins, and its step takes place
    input  lane_pkg::lanes_t             lanes,
    input  logic signed [15:0]           origin_row,  // of the window
    input  logic signed [15:0]           origin_col,
    input  logic signed [15:0]           col_min,
    input  logic signed [15:0]           col_max,
    input  logic signed [15:0]           row_max,
    input  logic signed [15:0]           start_row,
    input  logic signed [15:0]           start_col,
    // Of three edges, one behind the other
    input  logic [3*EDGE_BITS-1:0]       edges_per_col,
    input  logic [3*EDGE_BITS-1:0]       new_quotients,
    input  logic [3*EDGE_BITS-1:0]       new_remainders,
    input  logic [3*EDGE_BITS-1:0]       new_quotient_steps,
    input  logic [3*EDGE_BITS-1:0]       new_remainder_steps,
    input  logic [3*EDGE_BITS-1:0]       new_divisors,
    input  logic signed [Z_SUM_BITS-1:0] start_z_sum,
    input  logic signed [Z_SUM_BITS-1:0] new_z_sum_per_col,
    input  logic signed [Z_SUM_BITS-1:0] new_z_sum_per_row,

    // What the iteration yields that begins in this step
    output logic                         is_last,
    output lane_pkg::group_t             group,  // without a bit: nothing
    output logic signed [Z_SUM_BITS-1:0] z_sum,  // of its first column
    output logic signed [Z_SUM_BITS-1:0] z_sum_per_col
);
    typedef logic signed [EDGE_BITS-1:0] edge_t;
    typedef logic signed [16:0] place_t;
    typedef enum logic [1:0] {FROM_LEFT, FROM_RIGHT, FLAT} side_t;  // where an edge bounds a row

    // No column lies further to the left of the window than an image is wide: 4096.
    function automatic place_t group_of(input logic [15:0] col, input lane_pkg::lanes_t by);
        group_of = $signed({1'b0, lane_pkg::divided(col + {by, 12'b0}, by)}) - 17'sd4096;
    endfunction

    // Of the row at hand, counted from the left wall: columns from -quotient on, or up to quotient, or all if it is not
    // negative
    edge_t quotient[3], remainder[3], quotient_step[3], remainder_step[3], divisor[3];
    side_t side[3];
    place_t left_wall, right_wall, line_first, line_last;  // columns of the image
    logic signed [15:0] row, bottom;
    logic goes_right, is_in_row;
    place_t current;  // group
    logic signed [Z_SUM_BITS-1:0] row_z_sum, z_sum_per_row;  // at the left wall

    logic signed [EDGE_BITS+1:0] first, last;  // covered columns
    typedef logic signed [EDGE_BITS+1:0] bound_t;
    bound_t from[3], to[3];
    for (genvar i = 0; i < 3; i = i + 1) begin : g_edge
        assign from[i] = (EDGE_BITS + 2)'(left_wall) - (EDGE_BITS + 2)'(quotient[i]);
        assign to[i] = (EDGE_BITS + 2)'(left_wall) + (EDGE_BITS + 2)'(quotient[i]);
        // The row after it
        wire edge_t sum = remainder[i] + remainder_step[i];
        wire carries = sum >= divisor[i];
        wire edge_t per_col = edges_per_col[i*EDGE_BITS+:EDGE_BITS];
        always_ff @(posedge clock) begin
            if (load) begin
                divisor[i] <= new_divisors[i*EDGE_BITS+:EDGE_BITS];
                side[i] <= per_col == '0 ? FLAT : per_col < 0 ? FROM_RIGHT : FROM_LEFT;
                quotient[i] <= new_quotients[i*EDGE_BITS+:EDGE_BITS];
                remainder[i] <= new_remainders[i*EDGE_BITS+:EDGE_BITS];
                quotient_step[i] <= new_quotient_steps[i*EDGE_BITS+:EDGE_BITS];
                remainder_step[i] <= new_remainder_steps[i*EDGE_BITS+:EDGE_BITS];
            end else if (iterate && is_row_over) begin
                quotient[i] <= quotient[i] + quotient_step[i] + EDGE_BITS'(carries);
                remainder[i] <= carries ? sum - divisor[i] : sum;
            end
        end
    end
    always_comb begin
        first = (EDGE_BITS + 2)'(line_first);
        last = (EDGE_BITS + 2)'(line_last);
        for (int i = 0; i < 3; i = i + 1) begin
            if (side[i] == FROM_LEFT && from[i] > first) first = from[i];
            if (side[i] == FROM_RIGHT && to[i] < last) last = to[i];
        end
    end
    wire is_outside = (side[0] == FLAT && quotient[0] < 0) || (side[1] == FLAT && quotient[1] < 0) ||
                      (side[2] == FLAT && quotient[2] < 0);
    wire is_empty = is_outside || first > last;
    wire place_t first_col = 17'(first) - 17'(origin_col);  // of the window
    wire place_t last_col = 17'(last) - 17'(origin_col);
    wire place_t first_group = group_of(16'(first_col), lanes);
    wire place_t last_group = group_of(16'(last_col), lanes);
    wire place_t at = is_in_row ? current : goes_right ? first_group : last_group;
    wire is_row_over = is_empty || at == (goes_right ? last_group : first_group);
    wire place_t group_col = at * 17'({13'b0, lanes});

    assign is_last = is_row_over && row == bottom;
    assign group.row = row - origin_row;
    assign group.col = 16'(group_col);
    always_comb
        for (int k = 0; k < lane_pkg::LANES; k = k + 1)
            group.mask[k] = 4'(k) < lanes && !is_empty && group_col + 17'(k) >= first_col && group_col + 17'(k) <= last_col;
    wire place_t from_left = group_col + 17'(origin_col) - left_wall;
    assign z_sum = row_z_sum + Z_SUM_BITS'(from_left) * z_sum_per_col;

    wire place_t start_from_left = 17'(start_col) - 17'(col_min);
    always_ff @(posedge clock) begin
        if (load) begin
            left_wall <= 17'(col_min);
            right_wall <= 17'(col_max) + 17'sd1;
            row <= start_row;
            bottom <= row_max;
            goes_right <= start_col == col_min;
            line_first <= 17'(col_min);
            line_last <= start_col == col_min ? 17'(col_max) + 17'sd1 : 17'(start_col);
            is_in_row <= 1'b0;
            row_z_sum <= start_z_sum - Z_SUM_BITS'(start_from_left) * new_z_sum_per_col;
            z_sum_per_col <= new_z_sum_per_col;
            z_sum_per_row <= new_z_sum_per_row;
        end else if (iterate) begin
            is_in_row <= !is_row_over;
            current <= goes_right ? at + 17'sd1 : at - 17'sd1;
            if (is_row_over) begin
                row <= row + 16'sd1;
                goes_right <= !goes_right;
                line_first <= left_wall;
                line_last <= right_wall;
                row_z_sum <= row_z_sum + z_sum_per_row;
            end
        end
    end
endmodule
