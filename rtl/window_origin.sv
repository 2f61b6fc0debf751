// The window's first row and column: its centre, less half a side.
module window_origin (
    input  logic signed [31:0] centre_row,
    input  logic signed [31:0] centre_col,
    input  logic [8:0]         window,
    output logic signed [31:0] row,
    output logic signed [31:0] col
);
    wire logic signed [31:0] half = $signed({23'b0, window >> 1});
    assign row = centre_row - half;
    assign col = centre_col - half;
endmodule
