// Whether a pixel lies in the window.
module in_window (
    input  faster_pkg::pixel_t pixel,
    input  logic [8:0]         window,
    output logic               is_inside
);
    wire logic signed [15:0] side = $signed({7'b0, window});
    assign is_inside = pixel.row >= 16'sd0 && pixel.col >= 16'sd0 && pixel.row < side && pixel.col < side;
endmodule
