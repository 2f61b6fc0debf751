// Compares a pixel with the observation (A.3): an edge pixel takes the depth of the first drawn one below, above, right
// or left of it, or 0; with inner_border it has its own.
module pixel_comparison (
    input  logic [3:0]         fraction,  // fractional bits of depths
    input  logic               is_edge,
    input  logic               has_own_depth,
    input  faster_pkg::depth_t own,
    input  faster_pkg::depth_t below,
    input  faster_pkg::depth_t above,
    input  faster_pkg::depth_t right,
    input  faster_pkg::depth_t left,
    input  faster_pkg::depth_t observed,
    output logic               is_inlier,
    output logic               is_valid_depth
);
    wire [12:0] two_metres = 13'd2 << fraction;
    wire [12:0] three_metres = 13'd3 << fraction;
    wire faster_pkg::depth_t of_neighbour = 13'(below) < two_metres ? below :
                                            13'(above) < two_metres ? above :
                                            13'(right) < two_metres ? right :
                                            13'(left) < two_metres ? left : '0;
    wire faster_pkg::depth_t depth = is_edge && !has_own_depth ? of_neighbour : own;
    wire [10:0] difference = depth > observed ? depth - observed : observed - depth;

    // At most 2/256 m
    assign is_inlier = 13'(depth) < two_metres && {difference, 7'b0} <= 18'd1 << fraction;
    assign is_valid_depth = 13'(observed) <= three_metres;
endmodule
