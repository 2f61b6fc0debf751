// Does what ../shift_register.sv does, as a ring of words: a simulation need not move every bit.
module shift_register #(
    parameter int BITS = 1,
    parameter int PLACES = 64,  // a power of two
    localparam int INDEX_BITS = $clog2(PLACES)
) (
    input  logic                  clock,
    input  logic                  shift,
    input  logic [BITS-1:0]       in,
    input  logic [INDEX_BITS-1:0] index,
    output logic [BITS-1:0]       out
);
    logic [BITS-1:0] words[PLACES];
    logic [INDEX_BITS-1:0] newest = '0;
    initial for (int i = 0; i < PLACES; i = i + 1) words[i] = '0;
    wire [INDEX_BITS-1:0] next = newest + INDEX_BITS'(1);
    wire [INDEX_BITS-1:0] at = newest - index;

    always_ff @(posedge clock) begin
        if (shift) begin
            words[next] <= in;
            newest <= next;
        end
    end
    assign out = words[at];
endmodule
