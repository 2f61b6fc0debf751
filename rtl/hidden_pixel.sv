// Whether something is drawn at a pixel, and something else was measured more than 2/256 m in front of it. Where nothing was
// measured nothing hides.
module hidden_pixel (
    input  logic [3:0]         fraction,  // fractional bits of depths
    input  faster_pkg::depth_t own,
    input  faster_pkg::depth_t observed,
    output logic               is_drawn,
    output logic               is_hidden
);
    wire [10:0] in_front = own - observed;
    assign is_drawn = 13'(own) < 13'd2 << fraction;
    assign is_hidden = is_drawn && observed != '0 && own > observed && {in_front, 7'b0} > 18'd1 << fraction;
endmodule
