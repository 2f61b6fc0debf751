// What a scan needs to know of a triangle: bounds, area, where it starts, the edge values there and what a column and a
// row add to them, likewise of the z sum. The rasterizer gives it the cycles of its setup.
module triangle_setup #(
    parameter int EDGE_BITS = 36,  // of an edge value
    parameter int Z_SUM_BITS = 48
) (
    input  faster_pkg::vertex_t         v0,
    input  faster_pkg::vertex_t         v1,
    input  faster_pkg::vertex_t         v2,
    input  logic [3:0]                  vertex_xy,  // fractional bits
    input  logic [15:0]                 width,
    input  logic [15:0]                 height,
    output logic signed [EDGE_BITS-1:0] area,       // 0: rejected
    output logic signed [15:0]          col_min,
    output logic signed [15:0]          col_max,
    output logic signed [15:0]          row_max,
    output logic signed [15:0]          start_row,
    output logic signed [15:0]          start_col,
    // Edge values w0 = E_12, w1 = E_20, w2 = E_01 at the start pixel, one behind the other
    output logic [3*EDGE_BITS-1:0]      start_edges,
    output logic [3*EDGE_BITS-1:0]      edges_per_col,
    output logic [3*EDGE_BITS-1:0]      edges_per_row,
    output logic [Z_SUM_BITS-1:0]       start_z_sum,
    output logic [Z_SUM_BITS-1:0]       z_sum_per_col,
    output logic [Z_SUM_BITS-1:0]       z_sum_per_row
);
    typedef logic signed [EDGE_BITS-1:0] edge_t;
    typedef logic signed [15:0] code_t;
    typedef logic signed [16:0] difference_t;

    function automatic code_t least(input code_t a, input code_t b, input code_t c);
        code_t of_two;
        of_two = a < b ? a : b;
        least = c < of_two ? c : of_two;
    endfunction
    function automatic code_t most(input code_t a, input code_t b, input code_t c);
        code_t of_two;
        of_two = a > b ? a : b;
        most = c > of_two ? c : of_two;
    endfunction

    // E_ab(P) = (Px - ax)(by - ay) - (bx - ax)(Py - ay)
    function automatic edge_t edge_value(input code_t ax, input code_t ay, input code_t bx, input code_t by,
                                         input logic signed [16:0] px, input logic signed [16:0] py);
        logic signed [17:0] from_a_x, from_a_y;
        difference_t along_x, along_y;
        from_a_x = 18'(px) - 18'(ax);
        from_a_y = 18'(py) - 18'(ay);
        along_x = 17'(bx) - 17'(ax);
        along_y = 17'(by) - 17'(ay);
        edge_value = EDGE_BITS'(from_a_x) * EDGE_BITS'(along_y) - EDGE_BITS'(along_x) * EDGE_BITS'(from_a_y);
    endfunction

    // A pixel further, along one axis: the other end's coordinate difference, a pixel times.
    function automatic edge_t per_pixel(input code_t a, input code_t b, input logic [3:0] fraction);
        per_pixel = (EDGE_BITS'(b) - EDGE_BITS'(a)) << fraction;
    endfunction

    // Modulo 2^Z_SUM_BITS, which is exact for covered pixels.
    function automatic logic [Z_SUM_BITS-1:0] weighted(input edge_t w, input logic [15:0] z);
        weighted = Z_SUM_BITS'(w) * Z_SUM_BITS'($signed({1'b0, z}));
    endfunction

    wire code_t row_min = least(v0.y, v1.y, v2.y) >>> vertex_xy;
    assign col_min = least(v0.x, v1.x, v2.x) >>> vertex_xy;
    assign col_max = most(v0.x, v1.x, v2.x) >>> vertex_xy;
    assign row_max = most(v0.y, v1.y, v2.y) >>> vertex_xy;
    // A negative greatest bound has a negative least one.
    wire is_rejected = row_min < 0 || col_min < 0 || {1'b0, col_max} >= {1'b0, width} ||
                       {1'b0, row_max} >= {1'b0, height};
    assign area = is_rejected ? '0 : edge_value(v0.x, v0.y, v1.x, v1.y, 17'(v2.x), 17'(v2.y));

    // The vertex of the smallest y, the first of equal ones.
    faster_pkg::vertex_t top;
    always_comb begin
        top = v0;
        if (v1.y < top.y) top = v1;
        if (v2.y < top.y) top = v2;
    end
    assign start_row = top.y >>> vertex_xy;
    assign start_col = top.x >>> vertex_xy;
    wire logic signed [16:0] at_x = 17'(start_col) << vertex_xy;
    wire logic signed [16:0] at_y = 17'(start_row) << vertex_xy;

    wire edge_t w0 = edge_value(v1.x, v1.y, v2.x, v2.y, at_x, at_y);
    wire edge_t w1 = edge_value(v2.x, v2.y, v0.x, v0.y, at_x, at_y);
    wire edge_t w2 = edge_value(v0.x, v0.y, v1.x, v1.y, at_x, at_y);
    wire edge_t w0_per_col = per_pixel(v1.y, v2.y, vertex_xy);
    wire edge_t w1_per_col = per_pixel(v2.y, v0.y, vertex_xy);
    wire edge_t w2_per_col = per_pixel(v0.y, v1.y, vertex_xy);
    wire edge_t w0_per_row = per_pixel(v2.x, v1.x, vertex_xy);
    wire edge_t w1_per_row = per_pixel(v0.x, v2.x, vertex_xy);
    wire edge_t w2_per_row = per_pixel(v1.x, v0.x, vertex_xy);

    assign start_edges = {w0, w1, w2};
    assign edges_per_col = {w0_per_col, w1_per_col, w2_per_col};
    assign edges_per_row = {w0_per_row, w1_per_row, w2_per_row};
    assign start_z_sum = weighted(w0, v0.z) + weighted(w1, v1.z) + weighted(w2, v2.z);
    assign z_sum_per_col = weighted(w0_per_col, v0.z) + weighted(w1_per_col, v1.z) + weighted(w2_per_col, v2.z);
    assign z_sum_per_row = weighted(w0_per_row, v0.z) + weighted(w1_per_row, v1.z) + weighted(w2_per_row, v2.z);

    wire unused = &{1'b0, top.z};
endmodule
