// A memory with ports that each read or write a word per cycle. What is read in a cycle is there in the next, and stays
// until the port reads again; a word written in a cycle is read in the next. More than two ports take copies.
module block_ram #(
    parameter int BITS = 1,
    parameter int WORDS = 65536,
    parameter int PORTS = 2,
    parameter logic [BITS-1:0] INITIAL = '0,
    localparam int ADDRESS_BITS = $clog2(WORDS)
) (
    input  logic                          clock,
    input  logic [PORTS-1:0]              enable,
    input  logic [PORTS-1:0]              write,
    input  logic [PORTS*ADDRESS_BITS-1:0] address,
    input  logic [PORTS*BITS-1:0]         write_data,
    output logic [PORTS*BITS-1:0]         read_data
);
    logic [BITS-1:0] words[WORDS] /*verilator public_flat_rd*/;
`ifndef SYNTHESIS  // which takes minutes over the content, and no more primitives
    initial for (int i = 0; i < WORDS; i = i + 1) words[i] = INITIAL;
`endif

    for (genvar p = 0; p < PORTS; p = p + 1) begin : g_port
        wire [ADDRESS_BITS-1:0] at = address[p*ADDRESS_BITS+:ADDRESS_BITS];
        always_ff @(posedge clock) begin
            if (enable[p]) begin
                if (write[p]) words[at] <= write_data[p*BITS+:BITS];
                read_data[p*BITS+:BITS] <= words[at];
            end
        end
    end
endmodule
