// The quotient of 2^(QUOTIENT_BITS - 1) and a number, restoring: BITS bits a step, and INTERVAL steps in each stage. So
// there are INTERVAL times fewer stages than in a pipeline that takes a divisor per step; this one takes one every
// INTERVAL steps, and the quotient is there INTERVAL * STAGES steps after `begins`. A divisor of 0 yields nonsense.
module iterative_divider #(
    parameter int QUOTIENT_BITS = 39,
    parameter int DIVISOR_BITS = 28,
    parameter int BITS = 1,
    parameter int INTERVAL = 3,
    parameter int STAGES = 13  // STAGES * INTERVAL * BITS is at least QUOTIENT_BITS
) (
    input  logic                     clock,
    input  logic                     advance,
    input  logic                     begins,
    input  logic [DIVISOR_BITS-1:0]  divisor,
    output logic [QUOTIENT_BITS-1:0] quotient
);
    localparam int BITS_OF_STAGE = BITS * INTERVAL;
    localparam int LAST = STAGES * BITS_OF_STAGE - 1;
    logic [DIVISOR_BITS-1:0] remainder[STAGES+1];
    logic [DIVISOR_BITS-1:0] by[STAGES+1];
    logic [STAGES:0] takes;  // what the stage before it is done with
    logic [LAST:0] worked_out;
    assign remainder[0] = '0;
    assign by[0] = divisor;
    assign takes[0] = begins;

    for (genvar s = 0; s < STAGES; s = s + 1) begin : g_stage
        localparam int LEFT = LAST + 1 - (s + 1) * BITS_OF_STAGE;  // bits that later stages work out
        wire [DIVISOR_BITS-1:0] divided_by = takes[s] ? by[s] : by[s+1];
        logic [DIVISOR_BITS-1:0] next_remainder;
        logic [BITS-1:0] next_bits;
        logic [DIVISOR_BITS:0] partial;
        logic [DIVISOR_BITS+1:0] difference;
        always_comb begin
            next_remainder = takes[s] ? remainder[s] : remainder[s+1];
            next_bits = '0;
            partial = '0;
            difference = '0;
            for (int b = 0; b < BITS; b = b + 1) begin
                partial = {next_remainder, s == 0 && b == 0 && takes[0]};
                difference = {1'b0, partial} - {2'b00, divided_by};
                next_bits[BITS-1-b] = !difference[DIVISOR_BITS+1];
                next_remainder = next_bits[BITS-1-b] ? difference[DIVISOR_BITS-1:0] : partial[DIVISOR_BITS-1:0];
            end
        end
        logic [INTERVAL-1:0] working;
        logic [BITS_OF_STAGE+LEFT-1:0] line;  // the quotient's bits, until all are there
        always_ff @(posedge clock) begin
            if (advance) begin
                remainder[s+1] <= next_remainder;
                if (takes[s]) by[s+1] <= by[s];
                working <= INTERVAL'({working, takes[s]});
                line <= (BITS_OF_STAGE + LEFT)'({line, next_bits});
            end
        end
        assign takes[s+1] = working[INTERVAL-1];
        assign worked_out[LEFT+:BITS_OF_STAGE] = line[LEFT+:BITS_OF_STAGE];
    end
    wire unused = &{1'b0, takes[STAGES], worked_out};
    assign quotient = worked_out[LAST-:QUOTIENT_BITS];
endmodule
