// Goes over the box of a triangle in zigzag, a pixel per iteration, and finds covered pixels and edge tokens (A.1). An
// iteration either sends a pending edge token, and does nothing else, or visits a pixel.
module zigzag_scan #(
    parameter int EDGE_BITS = 36,
    parameter int Z_SUM_BITS = 48
) (
    input  logic                   clock,
    input  logic                   load,     // a triangle: the inputs below
    input  logic                   iterate,  // an iteration begins, and its step takes place
    input  logic                   sends_edges,  // else tokens of covered pixels only
    input  logic signed [15:0]     col_min,
    input  logic signed [15:0]     col_max,
    input  logic signed [15:0]     row_max,
    input  logic signed [15:0]     start_row,
    input  logic signed [15:0]     start_col,
    input  logic [3*EDGE_BITS-1:0] start_edges,
    input  logic [3*EDGE_BITS-1:0] edges_per_col,
    input  logic [3*EDGE_BITS-1:0] edges_per_row,
    input  logic [Z_SUM_BITS-1:0]  start_z_sum,
    input  logic [Z_SUM_BITS-1:0]  z_sum_per_col,
    input  logic [Z_SUM_BITS-1:0]  z_sum_per_row,

    // What the iteration yields that begins in this step
    output logic                   is_last,
    output logic                   is_fragment,
    output logic [Z_SUM_BITS-1:0]  z_sum,
    output logic signed [16:0]     row,      // of the fragment
    output logic signed [16:0]     col,
    output logic                   has_token,
    output faster_pkg::edge_kind_t token_kind,
    output logic signed [16:0]     token_row,
    output logic signed [16:0]     token_col
);
    logic [3*EDGE_BITS-1:0] edges;
    logic signed [16:0] line_start, last_row, last_col, pending_row, pending_col;
    logic signed [16:0] left_wall, right_wall, bottom;
    logic goes_right, is_first, was_inside, is_pending;

    // Each of the three values steps by itself: no carry from one to the next.
    function automatic logic [3*EDGE_BITS-1:0] plus(input logic [3*EDGE_BITS-1:0] a, input logic [3*EDGE_BITS-1:0] b);
        plus = {
            a[2*EDGE_BITS+:EDGE_BITS] + b[2*EDGE_BITS+:EDGE_BITS],
            a[EDGE_BITS+:EDGE_BITS] + b[EDGE_BITS+:EDGE_BITS],
            a[0+:EDGE_BITS] + b[0+:EDGE_BITS]
        };
    endfunction
    function automatic logic [3*EDGE_BITS-1:0] minus(input logic [3*EDGE_BITS-1:0] a, input logic [3*EDGE_BITS-1:0] b);
        minus = {
            a[2*EDGE_BITS+:EDGE_BITS] - b[2*EDGE_BITS+:EDGE_BITS],
            a[EDGE_BITS+:EDGE_BITS] - b[EDGE_BITS+:EDGE_BITS],
            a[0+:EDGE_BITS] - b[0+:EDGE_BITS]
        };
    endfunction

    wire is_inside = !edges[3*EDGE_BITS-1] && !edges[2*EDGE_BITS-1] && !edges[EDGE_BITS-1];
    // Before the first pixel there is no edge.
    wire before_is_inside = is_first ? is_inside : was_inside;
    wire turns = (col == left_wall || col == right_wall) && col != line_start;

    assign is_last = !is_pending && turns && row == bottom;
    assign is_fragment = !is_pending && is_inside;
    assign has_token = is_pending || is_inside || (sends_edges && before_is_inside);
    assign token_kind = !is_pending && is_inside ? faster_pkg::OBJECT : faster_pkg::EDGE;
    assign token_row = is_pending ? pending_row : row;
    assign token_col = is_pending ? pending_col : col;

    always_ff @(posedge clock) begin
        if (load) begin
            edges <= start_edges;
            z_sum <= start_z_sum;
            row <= 17'(start_row);
            col <= 17'(start_col);
            line_start <= 17'(start_col);
            left_wall <= 17'(col_min);
            right_wall <= 17'(col_max) + 17'sd1;
            bottom <= 17'(row_max);
            goes_right <= start_col == col_min;
            is_first <= 1'b1;
            is_pending <= 1'b0;
        end else if (iterate) begin
            is_pending <= !is_pending && sends_edges && is_inside && !before_is_inside;
            if (!is_pending) begin
                pending_row <= last_row;
                pending_col <= last_col;
                is_first <= 1'b0;
                was_inside <= is_inside;
                last_row <= row;
                last_col <= col;
                if (turns) begin
                    edges <= plus(edges, edges_per_row);
                    z_sum <= z_sum + z_sum_per_row;
                    row <= row + 17'sd1;
                    line_start <= col;
                    goes_right <= !goes_right;
                end else begin
                    edges <= goes_right ? plus(edges, edges_per_col) : minus(edges, edges_per_col);
                    z_sum <= goes_right ? z_sum + z_sum_per_col : z_sum - z_sum_per_col;
                    col <= goes_right ? col + 17'sd1 : col - 17'sd1;
                end
            end
        end
    end
endmodule
