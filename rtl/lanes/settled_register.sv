// Takes over what goes in with `begins` and stays there, when the logic in between has had `stages` cycles; with 0 stages
// it is a wire. What goes in may change after as many cycles.
module settled_register #(
    parameter int BITS = 1
) (
    input  logic               clock,
    input  logic               begins,
    input  faster_pkg::stage_t stages,
    input  logic [BITS-1:0]    in,
    output logic               is_there,  // `stages` cycles behind `begins`
    output logic [BITS-1:0]    out
);
    logic is_settled, was_settled;
    logic [BITS-1:0] held;
    delay_line #(
        .BITS(1)
    ) settling (
        .clock, .advance(1'b1), .stages(stages - 6'd1), .in(begins), .out(is_settled)
    );
    always_ff @(posedge clock) begin
        was_settled <= is_settled;
        if (is_settled) held <= in;
    end
    assign is_there = stages == '0 ? begins : was_settled;
    assign out = stages == '0 ? in : held;
endmodule
