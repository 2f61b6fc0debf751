// Quotient and remainder of a signed number by a positive one, rounded down: restoring, as few bits a cycle as CYCLES
// cycles allow. A stage works INTERVAL cycles on one division, so one can begin every INTERVAL cycles. Results are there in
// the cycle of `ends`; one cycle later they may be others'.
module span_divider #(
    parameter int DIVIDEND_BITS = 25,  // with its sign; also those of the quotient
    parameter int DIVISOR_BITS = 14,
    parameter int INTERVAL = 3,
    parameter int CYCLES = 18
) (
    input  logic                            clock,
    input  logic                            begins,
    input  logic signed [DIVIDEND_BITS-1:0] dividend,
    input  logic [DIVISOR_BITS-1:0]         divisor,
    output logic                            ends,
    output logic signed [DIVIDEND_BITS-1:0] quotient,
    output logic [DIVISOR_BITS-1:0]         remainder
);
    localparam int BITS = (DIVIDEND_BITS - 2 + CYCLES) / CYCLES;  // a cycle
    localparam int STAGES = (DIVIDEND_BITS - 2 + BITS * INTERVAL) / (BITS * INTERVAL);
    localparam int REST_BITS = STAGES * INTERVAL * BITS;
    // Below zero the complement is divided: floor(n / d) is ~floor(~n / d). Dividend bits leave `rest` at the top while
    // quotient bits enter at the bottom.
    logic [REST_BITS-1:0] rest[STAGES+1];
    logic [DIVISOR_BITS-1:0] left[STAGES+1], by[STAGES+1];
    logic is_negative[STAGES+1];
    logic [STAGES:0] takes;
    assign is_negative[0] = dividend[DIVIDEND_BITS-1];
    wire [DIVIDEND_BITS-2:0] magnitude = dividend[DIVIDEND_BITS-2:0] ^ {DIVIDEND_BITS - 1{is_negative[0]}};
    assign rest[0] = REST_BITS'(magnitude);
    assign left[0] = '0;
    assign by[0] = divisor;
    assign takes[0] = begins;

    for (genvar s = 0; s < STAGES; s = s + 1) begin : g_stage
        wire [DIVISOR_BITS-1:0] divided_by = takes[s] ? by[s] : by[s+1];
        logic [REST_BITS-1:0] next_rest;
        logic [DIVISOR_BITS-1:0] next_left;
        logic [DIVISOR_BITS:0] partial;
        logic [DIVISOR_BITS+1:0] difference;
        always_comb begin
            next_rest = takes[s] ? rest[s] : rest[s+1];
            next_left = takes[s] ? left[s] : left[s+1];
            partial = '0;
            difference = '0;
            for (int b = 0; b < BITS; b = b + 1) begin
                partial = {next_left, next_rest[REST_BITS-1]};
                difference = {1'b0, partial} - {2'b00, divided_by};
                next_rest = {next_rest[REST_BITS-2:0], !difference[DIVISOR_BITS+1]};
                next_left = difference[DIVISOR_BITS+1] ? partial[DIVISOR_BITS-1:0] : difference[DIVISOR_BITS-1:0];
            end
        end
        logic [INTERVAL-1:0] working = '0;
        always_ff @(posedge clock) begin
            rest[s+1] <= next_rest;
            left[s+1] <= next_left;
            if (takes[s]) begin
                by[s+1] <= by[s];
                is_negative[s+1] <= is_negative[s];
            end
            working <= INTERVAL'({working, takes[s]});
        end
        assign takes[s+1] = working[INTERVAL-1];
    end
    assign ends = takes[STAGES];
    assign quotient = DIVIDEND_BITS'(rest[STAGES]) ^ {DIVIDEND_BITS{is_negative[STAGES]}};
    assign remainder = is_negative[STAGES] ? by[STAGES] + ~left[STAGES] : left[STAGES];
    wire unused = &{1'b0, rest[STAGES]};
endmodule
