// Goes over the rows of a triangle in the order and directions of the zigzag, and in each over the groups of `lanes`
// pixels that have a covered one; a row without takes one iteration. Groups begin at multiples of `lanes` from the
// window's first column on. Where an edge crosses a row follows from where it crossed the row before: a quotient and a
// remainder, with what a row adds to them, which the setup divides for.
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
    input  logic [3*EDGE_BITS-1:0]       start_edges,
    input  logic [3*EDGE_BITS-1:0]       edges_per_col,
    input  logic [3*EDGE_BITS-1:0]       edges_per_row,
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

    function automatic edge_t floored(input edge_t value, input edge_t by);  // by > 0
        floored = value < 0 ? -((by - edge_t'(1) - value) / by) : value / by;
    endfunction
    function automatic place_t group_of(input place_t col, input lane_pkg::lanes_t by);
        automatic place_t size = place_t'({13'b0, by});
        group_of = col < 0 ? -((size - 17'sd1 - col) / size) : col / size;
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
    always_comb begin
        first = (EDGE_BITS + 2)'(line_first);
        last = (EDGE_BITS + 2)'(line_last);
        for (int i = 0; i < 3; i = i + 1) begin
            automatic logic signed [EDGE_BITS+1:0] from = (EDGE_BITS + 2)'(left_wall) - (EDGE_BITS + 2)'(quotient[i]);
            automatic logic signed [EDGE_BITS+1:0] to = (EDGE_BITS + 2)'(left_wall) + (EDGE_BITS + 2)'(quotient[i]);
            if (side[i] == FROM_LEFT && from > first) first = from;
            if (side[i] == FROM_RIGHT && to < last) last = to;
        end
    end
    wire is_outside = (side[0] == FLAT && quotient[0] < 0) || (side[1] == FLAT && quotient[1] < 0) ||
                      (side[2] == FLAT && quotient[2] < 0);
    wire is_empty = is_outside || first > last;
    wire place_t first_col = place_t'(first) - place_t'(origin_col);  // of the window
    wire place_t last_col = place_t'(last) - place_t'(origin_col);
    wire place_t first_group = group_of(first_col, lanes);
    wire place_t last_group = group_of(last_col, lanes);
    wire place_t at = is_in_row ? current : goes_right ? first_group : last_group;
    wire is_row_over = is_empty || at == (goes_right ? last_group : first_group);
    wire place_t group_col = at * place_t'({13'b0, lanes});

    assign is_last = is_row_over && row == bottom;
    assign group.row = row - origin_row;
    assign group.col = 16'(group_col);
    always_comb
        for (int k = 0; k < lane_pkg::LANES; k = k + 1)
            group.mask[k] = 4'(k) < lanes && !is_empty && group_col + 17'(k) >= first_col && group_col + 17'(k) <= last_col;
    wire place_t from_left = group_col + place_t'(origin_col) - left_wall;
    assign z_sum = row_z_sum + Z_SUM_BITS'(from_left) * z_sum_per_col;

    wire place_t start_from_left = place_t'(start_col) - place_t'(col_min);
    always_ff @(posedge clock) begin
        if (load) begin
            for (int i = 0; i < 3; i = i + 1) begin
                automatic edge_t per_col = edges_per_col[i*EDGE_BITS+:EDGE_BITS];
                automatic edge_t per_row = edges_per_row[i*EDGE_BITS+:EDGE_BITS];
                automatic edge_t at_left = start_edges[i*EDGE_BITS+:EDGE_BITS] - edge_t'(start_from_left) * per_col;
                automatic edge_t by = per_col == '0 ? edge_t'(1) : per_col < 0 ? -per_col : per_col;
                divisor[i] <= by;
                side[i] <= per_col == '0 ? FLAT : per_col < 0 ? FROM_RIGHT : FROM_LEFT;
                quotient[i] <= floored(at_left, by);
                remainder[i] <= at_left - floored(at_left, by) * by;
                quotient_step[i] <= floored(per_row, by);
                remainder_step[i] <= per_row - floored(per_row, by) * by;
            end
            left_wall <= place_t'(col_min);
            right_wall <= place_t'(col_max) + 17'sd1;
            row <= start_row;
            bottom <= row_max;
            goes_right <= start_col == col_min;
            line_first <= place_t'(col_min);
            line_last <= start_col == col_min ? place_t'(col_max) + 17'sd1 : place_t'(start_col);
            is_in_row <= 1'b0;
            row_z_sum <= start_z_sum - Z_SUM_BITS'(start_from_left) * new_z_sum_per_col;
            z_sum_per_col <= new_z_sum_per_col;
            z_sum_per_row <= new_z_sum_per_row;
        end else if (iterate) begin
            is_in_row <= !is_row_over;
            current <= goes_right ? at + 17'sd1 : at - 17'sd1;
            if (is_row_over) begin
                for (int i = 0; i < 3; i = i + 1) begin
                    automatic edge_t sum = remainder[i] + remainder_step[i];
                    automatic logic carries = sum >= divisor[i];
                    quotient[i] <= quotient[i] + quotient_step[i] + edge_t'(carries ? 1 : 0);
                    remainder[i] <= carries ? sum - divisor[i] : sum;
                end
                row <= row + 16'sd1;
                goes_right <= !goes_right;
                line_first <= left_wall;
                line_last <= right_wall;
                row_z_sum <= row_z_sum + z_sum_per_row;
            end
        end
    end
endmodule
