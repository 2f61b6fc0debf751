// The last two rows of words that went in, and one more: gives the word of a row and a pixel ago with its neighbours.
module line_buffers #(
    parameter int BITS = 11,
    parameter int MAX_WINDOW = 256
) (
    input  logic              clock,
    input  logic              advance,  // `in` is kept
    input  logic [8:0]        window,
    input  logic [BITS-1:0]   in,
    output logic [5*BITS-1:0] around  // the word, below, above, right, left; the first in the lowest bits
);
    localparam int WORDS = 2 * MAX_WINDOW + 1;
    localparam int INDEX_BITS = $clog2(WORDS);
    typedef logic [INDEX_BITS-1:0] index_t;
    wire index_t row = INDEX_BITS'(window);

    for (genvar b = 0; b < BITS; b = b + 1) begin : g_bit
        logic [WORDS-1:0] history;  // bit k: k + 1 words ago
        always_ff @(posedge clock) if (advance) history <= {history[WORDS-2:0], in[b]};
        assign around[0*BITS+b] = history[row];
        assign around[1*BITS+b] = history[0];
        assign around[2*BITS+b] = history[row<<1];
        assign around[3*BITS+b] = history[row-INDEX_BITS'(1)];
        assign around[4*BITS+b] = history[row+INDEX_BITS'(1)];
    end
endmodule
