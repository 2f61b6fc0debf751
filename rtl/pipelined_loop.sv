// Control of a pipelined loop of n iterations: it takes the steps 0 .. (n - 1) ii + depth - 1, and is left when it has
// drained. An iteration begins in every ii-th step. A step that does not advance is frozen: nothing of it happens.
module pipelined_loop (
    input  logic              clock,
    input  logic              reset,
    input  faster_pkg::loop_t shape,
    input  logic              active,   // the process is in the loop, which has at least one iteration
    input  logic              advance,  // the step of this cycle takes place; never while not active
    input  logic              is_last,  // no iteration follows the one that begins in this step
    output logic              begins,   // an iteration begins in this step
    output logic              ends      // the loop is over with this step
);
    faster_pkg::cycles_t wait_steps;  // until an iteration begins, or the pipeline is empty
    logic drains;

    assign begins = active && !drains && wait_steps == '0;
    assign ends = (begins && is_last && shape.depth == 8'd1) || (drains && wait_steps == 8'd1);

    always_ff @(posedge clock) begin
        if (reset) begin
            wait_steps <= '0;
            drains <= 1'b0;
        end else if (advance) begin
            if (ends) begin
                wait_steps <= '0;
                drains <= 1'b0;
            end else if (begins) begin
                wait_steps <= is_last ? shape.depth - 8'd1 : shape.ii - 8'd1;
                drains <= is_last;
            end else begin
                wait_steps <= wait_steps - 8'd1;
            end
        end
    end
endmodule
