// Counts drawn pixels in front of which something was measured, and has the box of the other drawn ones. Pixels leave the
// sweep row by row. Row and column 0 are the window's border, which is not compared: in the box they say that it is empty.
module hidden_pixels (
    input  logic                clock,
    input  logic                starts,  // the next pixel is the first of a sample
    input  logic                leaves,  // a pixel does
    input  logic                counts,  // it is not of the border
    input  logic [8:0]          window,
    input  logic [3:0]          fraction,
    input  faster_pkg::depth_t  own,
    input  faster_pkg::depth_t  observed,
    output faster_pkg::hidden_t result
);
    logic is_drawn, is_hidden;
    hidden_pixel pixel (.fraction, .own, .observed, .is_drawn, .is_hidden);
    wire is_visible = leaves && counts && is_drawn && !is_hidden;

    logic [7:0] row, col;
    wire is_last = 9'(col) + 9'd1 == window;
    always_ff @(posedge clock) begin
        if (starts) begin
            row <= '0;
            col <= '0;
            result <= '0;
        end else if (leaves) begin
            col <= is_last ? '0 : col + 8'd1;
            if (is_last) row <= row + 8'd1;
            result.count <= result.count + 32'(counts && is_hidden);
            if (is_visible) begin
                if (result.top == '0) result.top <= row;
                if (result.left == '0 || col < result.left) result.left <= col;
                result.bottom <= row;
                if (col > result.right) result.right <= col;
            end
        end
    end
endmodule
