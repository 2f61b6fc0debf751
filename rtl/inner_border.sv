// Judges covered pixels while the object map is read out, one per iteration: an edge has a neighbour in the window that
// is not covered. The last two rows are kept in a shift register, so the pixel of a row before is judged.
module inner_border #(
    parameter int MAX_WINDOW = 256
) (
    input  logic       clock,
    input  logic       advance,
    input  logic       starts,  // the next iteration is the first of a sample
    input  logic       begins,
    input  logic [8:0] window,
    input  logic       is_covered,  // the pixel that the iteration a step ago has read; any, once all are read
    output logic       edge_bit     // of the pixel a row before it
);
    logic [2*MAX_WINDOW-1:0] history;  // of pixels read; bit k: k + 1 before
    logic is_read;  // an iteration has begun a step ago
    logic [8:0] row, col;  // of the judged pixel; the first row is none
    logic is_before;  // there is no row before yet
    localparam int INDEX_BITS = $clog2(2 * MAX_WINDOW);
    typedef logic [INDEX_BITS-1:0] index_t;
    wire index_t one_row = INDEX_BITS'(window);

    wire is_pixel_covered = history[one_row-INDEX_BITS'(1)];
    wire is_right_covered = history[one_row-INDEX_BITS'(2)];
    wire is_left_covered = history[one_row];
    wire is_above_covered = history[(one_row<<1)-INDEX_BITS'(1)];
    wire is_last_col = col == window - 9'd1;

    assign edge_bit = is_pixel_covered &&
                      ((row != window - 9'd1 && !is_covered) || (row != '0 && !is_above_covered) ||
                       (!is_last_col && !is_right_covered) || (col != '0 && !is_left_covered));

    always_ff @(posedge clock) begin
        if (starts) begin
            is_read <= 1'b0;
            row <= '0;
            col <= '0;
            is_before <= 1'b1;
        end else if (advance) begin
            is_read <= begins;
            if (is_read) begin
                history <= {history[2*MAX_WINDOW-2:0], is_covered};
                col <= is_last_col ? '0 : col + 9'd1;
                if (is_last_col) begin
                    is_before <= 1'b0;
                    if (!is_before) row <= row + 9'd1;
                end
            end
        end
    end
endmodule
