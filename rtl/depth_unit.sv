// The depth of a fragment: floor(z sum x reciprocal / 2^(2 vertex_xy + vertex_z + area_reciprocal - fragment_depth)),
// whether it may be drawn at all (at most 2 m), and its code in the depth buffer.
module depth_unit #(
    parameter int Z_SUM_BITS = 48,
    parameter int RECIPROCAL_BITS = 64,
    parameter int DEPTH_BITS = 64  // of a fragment's depth, saturated
) (
    input  faster_pkg::fraction_t      fraction,  // that of the depth buffer does not matter here
    input  logic [Z_SUM_BITS-1:0]      z_sum,
    input  logic [RECIPROCAL_BITS-1:0] reciprocal,
    output logic                       is_near,
    output logic [DEPTH_BITS-1:0]      depth
);
    localparam int PRODUCT_BITS = Z_SUM_BITS + RECIPROCAL_BITS;
    typedef logic signed [7:0] shift_t;

    wire [PRODUCT_BITS-1:0] product = PRODUCT_BITS'(z_sum) * PRODUCT_BITS'(reciprocal);
    wire shift_t right = (8'({1'b0, fraction.vertex_xy}) <<< 1) + 8'({1'b0, fraction.vertex_z}) +
                         8'({1'b0, fraction.area_reciprocal}) - 8'({1'b0, fraction.fragment_depth});
    wire shift_t left = -right;
    // To the left there are 30 bits at most.
    wire [PRODUCT_BITS+29:0] shifted =
        right[7] ? (PRODUCT_BITS + 30)'(product) << left : (PRODUCT_BITS + 30)'(product) >> right;

    assign depth = |shifted[PRODUCT_BITS+29:DEPTH_BITS] ? '1 : shifted[DEPTH_BITS-1:0];
    assign is_near = depth <= DEPTH_BITS'(2) << fraction.fragment_depth;

    wire unused = &{1'b0, fraction.depth_buffer};
endmodule
