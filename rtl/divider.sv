// Restoring division of unsigned numbers, an equal share of the quotient's bits in each stage; a divisor of 0 yields
// nonsense. With 0 stages the quotient is there at once. With an interval above 1 a divisor comes every INTERVAL steps at
// most, and the dividend is 2^(DIVIDEND_BITS - 1).
module divider #(
    parameter int DIVIDEND_BITS = 39,
    parameter int DIVISOR_BITS = 28,
    parameter int STAGES = 0,
    parameter int INTERVAL = 1  // above 1: at most STAGES
) (
    input  logic                     clock,
    input  logic                     advance,
    input  logic                     begins,  // with this divisor; only looked at with an interval above 1
    input  logic [DIVIDEND_BITS-1:0] dividend,
    input  logic [DIVISOR_BITS-1:0]  divisor,
    output logic [DIVIDEND_BITS-1:0] quotient
);
    if (STAGES == 0) begin : g_at_once
        wire [DIVISOR_BITS-1:0] not_zero = divisor == '0 ? DIVISOR_BITS'(1) : divisor;
        assign quotient = dividend / DIVIDEND_BITS'(not_zero);
        wire unused = &{1'b0, clock, advance, begins};
    end
    if (INTERVAL > 1) begin : g_iterative
        // As few bits a step as the stages allow
        localparam int STEPS = STAGES - STAGES % INTERVAL;
        localparam int BITS = (DIVIDEND_BITS + STEPS - 1) / STEPS;
        localparam int TURNS = (DIVIDEND_BITS + BITS * INTERVAL - 1) / (BITS * INTERVAL);
        logic [DIVIDEND_BITS-1:0] worked_out;
        iterative_divider #(
            .QUOTIENT_BITS(DIVIDEND_BITS),
            .DIVISOR_BITS (DIVISOR_BITS),
            .BITS         (BITS),
            .INTERVAL     (INTERVAL),
            .STAGES       (TURNS)
        ) turns (
            .clock, .advance, .begins, .divisor, .quotient(worked_out)
        );
        delay_line #(
            .BITS(DIVIDEND_BITS)
        ) rest_of_stages (
            .clock, .advance, .stages(6'(STAGES - TURNS * INTERVAL)), .in(worked_out), .out(quotient)
        );
        wire unused = &{1'b0, dividend};
    end
    if (STAGES > 0 && INTERVAL == 1) begin : g_pipeline
        localparam int BITS_PER_STAGE = (DIVIDEND_BITS + STAGES - 1) / STAGES;
        // Dividend bits leave `rest` at the top while quotient bits enter at the bottom.
        logic [DIVIDEND_BITS-1:0] rest[STAGES+1];
        logic [DIVISOR_BITS-1:0]  remainder[STAGES+1];
        logic [DIVISOR_BITS-1:0]  by[STAGES+1];
        assign rest[0] = dividend;
        assign remainder[0] = '0;
        assign by[0] = divisor;

        for (genvar s = 0; s < STAGES; s = s + 1) begin : g_stage
            localparam int FIRST = s * BITS_PER_STAGE;
            localparam int BITS = FIRST >= DIVIDEND_BITS ? 0 :
                                  FIRST + BITS_PER_STAGE > DIVIDEND_BITS ? DIVIDEND_BITS - FIRST : BITS_PER_STAGE;
            logic [DIVIDEND_BITS-1:0] next_rest;
            logic [DIVISOR_BITS-1:0] next_remainder;
            logic [DIVISOR_BITS:0] partial;
            always_comb begin
                next_rest = rest[s];
                next_remainder = remainder[s];
                partial = '0;
                for (int b = 0; b < BITS; b = b + 1) begin
                    partial = {next_remainder, next_rest[DIVIDEND_BITS-1]};
                    next_rest = {next_rest[DIVIDEND_BITS-2:0], partial >= {1'b0, by[s]}};
                    if (partial >= {1'b0, by[s]}) partial = partial - {1'b0, by[s]};
                    next_remainder = partial[DIVISOR_BITS-1:0];
                end
            end
            always_ff @(posedge clock) begin
                if (advance) begin
                    rest[s+1] <= next_rest;
                    remainder[s+1] <= next_remainder;
                    by[s+1] <= by[s];
                end
            end
        end
        assign quotient = rest[STAGES];
        wire unused = begins;
    end
endmodule
