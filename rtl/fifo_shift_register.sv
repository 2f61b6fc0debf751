// A FIFO of shift registers: a token goes in at the front, and the oldest is picked out by its age. What is written in
// cycle s can be read in s + 1; a place read in cycle r can be written in r + 1.
module fifo_shift_register #(
    parameter int BITS = 1,
    parameter int PLACES = 64
) (
    input  logic            clock,
    input  logic            reset,
    input  logic [11:0]     capacity,  // tokens, at most PLACES
    output logic            has_room,
    input  logic            write,
    input  logic [BITS-1:0] write_data,
    output logic            has_token,
    input  logic            read,
    output logic [BITS-1:0] read_data
);
    localparam int COUNT_BITS = $clog2(PLACES + 1);
    localparam int INDEX_BITS = $clog2(PLACES);
    typedef logic [COUNT_BITS-1:0] count_t;

    count_t count;
    wire [INDEX_BITS-1:0] oldest = INDEX_BITS'(count) - INDEX_BITS'(1);

    assign has_token = count != '0;
    assign has_room = 12'(count) < capacity;

    always_ff @(posedge clock) begin
        if (reset) count <= '0;
        else count <= count + COUNT_BITS'(write) - COUNT_BITS'(read);
    end

    shift_register #(
        .BITS  (BITS),
        .PLACES(PLACES)
    ) tokens (
        .clock, .shift(write), .in(write_data), .index(oldest), .out(read_data)
    );
endmodule
