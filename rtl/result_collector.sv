// Takes the counters of each sample to the host: (read result); T += 1.
module result_collector (
    input  logic                  result_has_token,
    output logic                  result_read,
    input  faster_pkg::counters_t result,
    output logic                  is_taken,  // a sample is done in this cycle
    output faster_pkg::counters_t counters
);
    assign result_read = result_has_token;
    assign is_taken = result_read;
    assign counters = result;
endmodule
