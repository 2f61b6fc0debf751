// A FIFO of either kind. A writer may write when there is room, a reader may read when there is a token.
module fifo #(
    parameter int BITS = 1,
    parameter int SHIFT_REGISTER_PLACES = 64,
    parameter int MEMORY_WORDS = 1024
) (
    input  logic              clock,
    input  logic              reset,
    input  faster_pkg::fifo_t shape,
    output logic              has_room,
    input  logic              write,
    input  logic [BITS-1:0]   write_data,
    output logic              has_token,
    input  logic              read,
    output logic [BITS-1:0]   read_data
);
    wire in_memory = shape.is_memory;
    logic            room_in_registers, token_in_registers, room_in_memory, token_in_memory;
    logic [BITS-1:0] from_registers, from_memory;

    fifo_shift_register #(
        .BITS  (BITS),
        .PLACES(SHIFT_REGISTER_PLACES)
    ) registers (
        .clock,
        .reset,
        .capacity  (shape.capacity),
        .has_room  (room_in_registers),
        .write     (write && !in_memory),
        .write_data,
        .has_token (token_in_registers),
        .read      (read && !in_memory),
        .read_data (from_registers)
    );
    fifo_memory #(
        .BITS (BITS),
        .WORDS(MEMORY_WORDS)
    ) memory (
        .clock,
        .reset,
        .capacity  (shape.capacity),
        .has_room  (room_in_memory),
        .write     (write && in_memory),
        .write_data,
        .has_token (token_in_memory),
        .read      (read && in_memory),
        .read_data (from_memory)
    );

    assign has_room = in_memory ? room_in_memory : room_in_registers;
    assign has_token = in_memory ? token_in_memory : token_in_registers;
    assign read_data = in_memory ? from_memory : from_registers;
endmodule
