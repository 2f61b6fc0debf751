// A FIFO of a memory and an output register: what is written in cycle s is in the memory in s + 1, in the register in
// s + 2. The capacity counts both, whatever generation of HLS says how large the memory is.
module fifo_memory #(
    parameter int BITS = 1,
    parameter int WORDS = 64  // a power of two
) (
    input  logic            clock,
    input  logic            reset,
    input  logic [11:0]     capacity,  // tokens, at most WORDS + 1
    output logic            has_room,
    input  logic            write,
    input  logic [BITS-1:0] write_data,
    output logic            has_token,
    input  logic            read,
    output logic [BITS-1:0] read_data
);
    localparam int ADDRESS_BITS = $clog2(WORDS);
    typedef logic [ADDRESS_BITS-1:0] address_t;

    logic [BITS-1:0] words[WORDS];
    address_t write_at, read_at;
    logic [11:0] stored;  // in the memory
    logic        is_held;  // by the register

    wire take = stored != '0 && (!is_held || read);

    assign has_token = is_held;
    assign has_room = stored + 12'(is_held) < capacity;

    always_ff @(posedge clock) begin
        if (write) words[write_at] <= write_data;
        if (take) read_data <= words[read_at];
        if (reset) begin
            write_at <= '0;
            read_at <= '0;
            stored <= '0;
            is_held <= 1'b0;
        end else begin
            write_at <= write_at + ADDRESS_BITS'(write);
            read_at <= read_at + ADDRESS_BITS'(take);
            stored <= stored + 12'(write) - 12'(take);
            is_held <= take || (is_held && !read);
        end
    end
endmodule
