// Goes over the rows of triangles in the order of the zigzag, ahead of the scan: which columns of a row are covered, and
// in which groups of `lanes` pixels they lie. Groups begin at multiples of `lanes` from the window's first column on. Where
// an edge crosses a row follows from where it crossed the row before: a quotient and a remainder, with what a row adds
// to them. A row per cycle enters a pipeline, and waits in shift registers for the scan, which takes a row per step at
// most: so it never waits for one, if a triangle's first is there in time.
module span_rows #(
    parameter int CROSSING_BITS = 36,
    parameter int DIFFERENCE_BITS = 17,
    localparam int DIVISOR_BITS = DIFFERENCE_BITS - 1
) (
    input  logic                           clock,
    input  logic                           reset,
    input  lane_pkg::lanes_t               lanes,
    input  logic signed [15:0]             origin_row,  // of the window
    input  logic signed [15:0]             origin_col,

    input  logic                           has_spans,
    output logic                           take_spans,
    input  lane_pkg::box_t                 box,
    input  logic [5:0]                     new_sides,
    input  logic [3*DIVISOR_BITS-1:0]      new_divisors,
    input  logic [3*CROSSING_BITS-1:0]     new_quotients,
    input  logic [3*DIVISOR_BITS-1:0]      new_remainders,
    input  logic [3*DIFFERENCE_BITS-1:0]   new_quotient_steps,
    input  logic [3*DIVISOR_BITS-1:0]      new_remainder_steps,

    output logic                           has_row,
    input  logic                           take_row,
    output lane_pkg::row_t                 row
);
    typedef logic signed [CROSSING_BITS-1:0] crossing_t;
    typedef logic signed [15:0] place_t;  // a column, or a row
    localparam int ROWS = 16;
    localparam place_t FURTHEST = 16'sd16384;  // no column lies there

    // No column lies further to the left of the window than an image is wide: 4096.
    function automatic place_t first_of_group(input place_t col, input lane_pkg::lanes_t by);
        first_of_group = (lane_pkg::divided(col + {by, 12'b0}, by) - 16'd4096) * {12'b0, by};
    endfunction

    // The row that enters the pipeline. Crossings are counted from the left wall: columns from -quotient on, or up to
    // quotient, or all if it is not negative.
    logic is_busy, goes_right;
    place_t left_wall, right_wall, line_first, line_last, at_row, bottom;
    logic [4:0] outstanding;  // rows, in the pipeline and behind it
    wire enters = is_busy && outstanding != 5'(ROWS);
    wire is_last = at_row == bottom;
    assign take_spans = has_spans && (!is_busy || (enters && is_last));

    logic [5:0] sides;
    logic [2:0] is_outside;
    logic signed [15:0] crossings[3];
    for (genvar i = 0; i < 3; i = i + 1) begin : g_edge
        crossing_t quotient;
        logic [DIVISOR_BITS-1:0] remainder, remainder_step, divisor;
        logic signed [DIFFERENCE_BITS-1:0] quotient_step;
        wire [DIVISOR_BITS:0] sum = {1'b0, remainder} + {1'b0, remainder_step};
        wire [DIVISOR_BITS:0] less = sum - {1'b0, divisor};
        wire carries = sum >= {1'b0, divisor};
        always_ff @(posedge clock) begin
            if (take_spans) begin
                divisor <= new_divisors[i*DIVISOR_BITS+:DIVISOR_BITS];
                quotient <= new_quotients[i*CROSSING_BITS+:CROSSING_BITS];
                remainder <= new_remainders[i*DIVISOR_BITS+:DIVISOR_BITS];
                quotient_step <= new_quotient_steps[i*DIFFERENCE_BITS+:DIFFERENCE_BITS];
                remainder_step <= new_remainder_steps[i*DIVISOR_BITS+:DIVISOR_BITS];
            end else if (enters) begin
                quotient <= quotient + CROSSING_BITS'(quotient_step) + CROSSING_BITS'({1'b0, carries});
                remainder <= carries ? less[DIVISOR_BITS-1:0] : sum[DIVISOR_BITS-1:0];
            end
        end
        // First stage: the column, or one beyond all
        wire crossing_t moved = sides[2*i+:2] == lane_pkg::FROM_LEFT ? CROSSING_BITS'(left_wall) - quotient :
                                                                       CROSSING_BITS'(left_wall) + quotient;
        always_ff @(posedge clock) begin
            crossings[i] <= moved > CROSSING_BITS'(FURTHEST) ? FURTHEST :
                            moved < -CROSSING_BITS'(FURTHEST) ? -FURTHEST : 16'(moved);
            is_outside[i] <= sides[2*i+:2] == lane_pkg::FLAT && quotient < 0;
        end
        wire unused = &{1'b0, less};
    end
    always_ff @(posedge clock) begin
        if (take_spans) begin
            sides <= new_sides;
            left_wall <= box.col_min;
            right_wall <= box.col_max + 16'sd1;
            at_row <= box.start_row;
            bottom <= box.row_max;
            goes_right <= box.start_col == box.col_min;
            line_first <= box.col_min;
            line_last <= box.start_col == box.col_min ? box.col_max + 16'sd1 : box.start_col;
        end else if (enters) begin
            at_row <= at_row + 16'sd1;
            goes_right <= !goes_right;
            line_first <= left_wall;
            line_last <= right_wall;
        end
        if (reset) begin
            is_busy <= 1'b0;
            outstanding <= '0;
        end else begin
            if (take_spans) is_busy <= box.is_drawn;
            else if (enters && is_last) is_busy <= 1'b0;
            outstanding <= outstanding + 5'(enters) - 5'(take_row);
        end
    end

    // Stages: what all edges leave; where the window has it; the groups
    logic [3:0] is_there;
    logic [2:0] went_right, was_last;
    logic [5:0] of_sides;
    place_t image_rows[2], window_row, limit_first, limit_last, first, last, bounded_first, bounded_last, first_col, last_col;
    logic all_outside, is_empty;
    always_comb begin
        first = limit_first;
        last = limit_last;
        for (int i = 0; i < 3; i = i + 1) begin
            if (of_sides[2*i+:2] == lane_pkg::FROM_LEFT && crossings[i] > first) first = crossings[i];
            if (of_sides[2*i+:2] == lane_pkg::FROM_RIGHT && crossings[i] < last) last = crossings[i];
        end
    end
    wire place_t first_group = first_of_group(first_col, lanes);
    wire place_t last_group = first_of_group(last_col, lanes);
    lane_pkg::row_t entering;
    always_ff @(posedge clock) begin
        is_there <= reset ? '0 : {is_there[2:0], enters};
        went_right <= {went_right[1:0], goes_right};
        was_last <= {was_last[1:0], is_last};
        image_rows[0] <= at_row;
        image_rows[1] <= image_rows[0];
        window_row <= image_rows[1] - origin_row;
        of_sides <= sides;
        limit_first <= line_first;
        limit_last <= line_last;
        bounded_first <= first;
        bounded_last <= last;
        all_outside <= is_outside != '0;
        is_empty <= all_outside || bounded_first > bounded_last;
        first_col <= bounded_first - origin_col;
        last_col <= bounded_last - origin_col;
        entering.is_empty <= is_empty;
        entering.is_last <= was_last[2];
        entering.goes_right <= went_right[2];
        entering.row <= window_row;
        entering.first_col <= first_col;
        entering.last_col <= last_col;
        entering.first_group <= went_right[2] ? first_group : last_group;
        entering.last_group <= went_right[2] ? last_group : first_group;
    end
    logic unused_room;
    fifo_shift_register #(
        .BITS(lane_pkg::ROW_BITS), .PLACES(ROWS)
    ) of_scan (
        .clock, .reset, .capacity(12'(ROWS)), .has_room(unused_room), .write(is_there[3]), .write_data(entering),
        .has_token(has_row), .read(take_row), .read_data(row)
    );
    wire unused = unused_room;
endmodule
