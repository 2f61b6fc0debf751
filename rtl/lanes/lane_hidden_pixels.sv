// Counts drawn pixels in front of which something was measured, and has the box of the other drawn ones, a token of `lanes`
// pixels of a row at a time. Row and column 0 are the window's border: in the box they say that it is empty.
module lane_hidden_pixels #(
    parameter int LANES_BUILT = lane_pkg::LANES
) (
    input  logic                                              clock,
    input  logic                                              starts,    // the next token is the first of a sample
    input  logic                                              advance,
    input  logic [11:0]                                       next_col,  // of the token after this one
    input  logic                                              takes,     // this token
    input  logic [8:0]                                        row,
    input  logic [lane_pkg::LANES-1:0]                        judged,    // pixels that are not of the border
    input  logic [3:0]                                        fraction,
    input  logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] words,
    input  logic [lane_pkg::LANES*faster_pkg::DEPTH_BITS-1:0] observed,
    output faster_pkg::hidden_t                               result
);
    localparam int LANES = lane_pkg::LANES;
    localparam int WORD_BITS = faster_pkg::DEPTH_BITS;
    logic [LANES-1:0] is_drawn, is_hidden;
    for (genvar k = 0; k < LANES; k = k + 1) begin : g_lane
        if (k < LANES_BUILT) begin : g_built
            hidden_pixel pixel (
                .fraction, .own(words[k*WORD_BITS+:WORD_BITS]), .observed(observed[k*WORD_BITS+:WORD_BITS]),
                .is_drawn(is_drawn[k]), .is_hidden(is_hidden[k])
            );
        end else begin : g_absent
            assign is_drawn[k] = 1'b0;
            assign is_hidden[k] = 1'b0;
        end
    end

    wire [LANES-1:0] is_visible = judged & is_drawn & ~is_hidden;
    logic [7:0] col, first, last;
    logic [31:0] count;
    always_comb begin
        count = '0;
        first = '0;
        last = '0;
        for (int k = 0; k < LANES; k = k + 1) begin
            count = count + 32'(judged[k] && is_hidden[k]);
            if (is_visible[k]) last = col + 8'(k);
            if (is_visible[LANES-1-k]) first = col + 8'(LANES - 1 - k);
        end
    end
    always_ff @(posedge clock) begin
        if (advance) col <= next_col[7:0];
        if (starts) result <= '0;
        else if (takes) begin
            result.count <= result.count + count;
            if (is_visible != '0) begin
                if (result.top == '0) result.top <= row[7:0];
                if (result.left == '0 || first < result.left) result.left <= first;
                result.bottom <= row[7:0];
                if (last > result.right) result.right <= last;
            end
        end
    end

    wire unused = &{1'b0, next_col[11:8], row[8]};
endmodule
