// Of an edge: where it crosses a triangle's first row, counted in columns from the left wall, and how far that moves from
// row to row. Quotients and remainders, rounded down, so that additions stay exact. The rasterizer gives it 18 cycles
// behind its setup.
module span_division #(
    parameter int EDGE_BITS = 36
) (
    input  logic signed [EDGE_BITS-1:0] at_start,   // value of the edge
    input  logic signed [16:0]          from_left,  // of the start: columns behind the wall
    input  logic signed [EDGE_BITS-1:0] per_col,
    input  logic signed [EDGE_BITS-1:0] per_row,
    output logic signed [EDGE_BITS-1:0] quotient,  // of an edge along the rows: its value
    output logic signed [EDGE_BITS-1:0] remainder,
    output logic signed [EDGE_BITS-1:0] quotient_step,
    output logic signed [EDGE_BITS-1:0] remainder_step,
    output logic signed [EDGE_BITS-1:0] divisor
);
    typedef logic signed [EDGE_BITS-1:0] edge_t;
    function automatic edge_t floored(input edge_t value, input edge_t by);  // by > 0
        floored = value < 0 ? -((by - edge_t'(1) - value) / by) : value / by;
    endfunction
    wire edge_t at_wall = at_start - edge_t'(from_left) * per_col;
    assign divisor = per_col == '0 ? edge_t'(1) : per_col < 0 ? -per_col : per_col;
    assign quotient = floored(at_wall, divisor);
    assign remainder = at_wall - quotient * divisor;
    assign quotient_step = floored(per_row, divisor);
    assign remainder_step = per_row - quotient_step * divisor;
endmodule
