// What went in `stages` steps ago; with 0 stages, what goes in.
module delay_line #(
    parameter int BITS = 1
) (
    input  logic               clock,
    input  logic               advance,  // a step takes place
    input  faster_pkg::stage_t stages,
    input  logic [BITS-1:0]    in,
    output logic [BITS-1:0]    out
);
    logic [BITS-1:0] delayed;
    shift_register #(
        .BITS  (BITS),
        .PLACES(faster_pkg::MAX_STAGES + 1)
    ) line (
        .clock, .shift(advance), .in, .index(stages - 6'(1)), .out(delayed)
    );
    assign out = stages == '0 ? in : delayed;
endmodule
