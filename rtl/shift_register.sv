// What was shifted in `index` shifts before the last one. A vector per bit and an index, which synthesis maps to SRLs.
module shift_register #(
    parameter int BITS = 1,
    parameter int PLACES = 64,
    localparam int INDEX_BITS = $clog2(PLACES)
) (
    input  logic                  clock,
    input  logic                  shift,
    input  logic [BITS-1:0]       in,
    input  logic [INDEX_BITS-1:0] index,
    output logic [BITS-1:0]       out
);
    for (genvar b = 0; b < BITS; b = b + 1) begin : g_bit
        logic [PLACES-1:0] places = '0;
        always_ff @(posedge clock) if (shift) places <= {places[PLACES-2:0], in[b]};
        assign out[b] = places[index];
    end
endmodule
