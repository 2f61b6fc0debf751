// Of an edge: where it crosses a triangle's first row, counted in columns from the left wall, and how far that moves from
// row to row. Quotients and remainders, rounded down, so that additions stay exact. What a column and a row add are whole
// pixels of an edge value, so its fractions of one decide nothing, and are left out.
module span_division #(
    parameter int CROSSING_BITS = 36,
    parameter int DIFFERENCE_BITS = 17,  // of two coordinates
    parameter int INTERVAL = 3,
    parameter int CYCLES = 18
) (
    input  logic                              clock,
    input  logic                              begins,
    input  logic signed [CROSSING_BITS-1:0]   at_wall,  // value of the edge at the left wall
    input  logic signed [DIFFERENCE_BITS-1:0] per_col,
    input  logic signed [DIFFERENCE_BITS-1:0] per_row,
    output logic [DIFFERENCE_BITS-2:0]        divisor,  // as it begins
    output logic                              crossing_is_there,
    output logic signed [CROSSING_BITS-1:0]   quotient,  // of an edge along the rows: its value
    output logic [DIFFERENCE_BITS-2:0]        remainder,
    output logic                              step_is_there,
    output logic signed [DIFFERENCE_BITS-1:0] quotient_step,
    output logic [DIFFERENCE_BITS-2:0]        remainder_step
);
    localparam int DIVISOR_BITS = DIFFERENCE_BITS - 1;
    assign divisor = per_col == '0 ? DIVISOR_BITS'(1) : DIVISOR_BITS'(per_col < 0 ? -per_col : per_col);
    span_divider #(
        .DIVIDEND_BITS(CROSSING_BITS), .DIVISOR_BITS(DIVISOR_BITS), .INTERVAL(INTERVAL), .CYCLES(CYCLES)
    ) crossing (
        .clock, .begins, .dividend(at_wall), .divisor, .ends(crossing_is_there), .quotient, .remainder
    );
    span_divider #(
        .DIVIDEND_BITS(DIFFERENCE_BITS), .DIVISOR_BITS(DIVISOR_BITS), .INTERVAL(INTERVAL), .CYCLES(CYCLES)
    ) step (
        .clock, .begins, .dividend(per_row), .divisor, .ends(step_is_there), .quotient(quotient_step),
        .remainder(remainder_step)
    );
endmodule
