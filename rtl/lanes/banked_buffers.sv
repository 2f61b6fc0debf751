// A memory of the window in cyclic banks of columns, once or twice. Two sides use it: one that draws, and one that reads
// out, never the same buffer in one cycle. Either works on groups of pixels, and there are a whole multiple of its lanes
// of banks: so a lane has banks of its own, and nothing turns lanes to banks. A bank has a port that reads and one that
// writes.
module banked_buffers #(
    parameter int BITS = 1,
    parameter int BANKS = lane_pkg::LANES,
    parameter int BUFFERS = 2,
    parameter int WORDS = 65536,  // of a bank
    parameter logic [BITS-1:0] INITIAL = '0,
    localparam int LANES = lane_pkg::LANES
) (
    input  logic                    clock,
    input  lane_pkg::lanes_t        banks,
    input  logic [8:0]              window,
    // Side 0, in the lower halves, draws; side 1 reads out
    input  logic [7:0]              lanes,
    input  logic [1:0]              buffer,
    input  logic [2*LANES-1:0]      read,  // by lane
    input  logic [17:0]             read_row,
    input  logic [17:0]             read_group,
    output logic [2*LANES*BITS-1:0] words,  // a step later
    input  logic [2*LANES-1:0]      write,
    input  logic [17:0]             write_row,
    input  logic [17:0]             write_group,
    input  logic [2*LANES*BITS-1:0] write_words
);
    localparam int ADDRESS_BITS = $clog2(WORDS);
    typedef logic [ADDRESS_BITS-1:0] address_t;
    typedef logic [3:0] part_t;
    lane_pkg::lanes_t lanes_of[2];
    logic [LANES-1:0] reads[2], writes[2];
    logic [LANES*BITS-1:0] written[2];

    wire [8:0] bank_cols = 9'(lane_pkg::divided({7'b0, window} + {12'b0, banks} - 16'd1, banks));
    // Groups go round a lane's banks.
    part_t parts[2], read_part[2], write_part[2], part_was_read[2];
    logic [8:0] read_round[2], write_round[2];
    address_t read_address[2], write_address[2];
    for (genvar s = 0; s < 2; s = s + 1) begin : g_side
        assign lanes_of[s] = lanes[4*s+:4];
        assign reads[s] = read[LANES*s+:LANES];
        assign writes[s] = write[LANES*s+:LANES];
        assign written[s] = write_words[LANES*BITS*s+:LANES*BITS];
        assign parts[s] = 4'(lane_pkg::divided({12'b0, banks}, lanes_of[s]));
        assign read_round[s] = 9'(lane_pkg::divided({7'b0, read_group[9*s+:9]}, parts[s]));
        assign write_round[s] = 9'(lane_pkg::divided({7'b0, write_group[9*s+:9]}, parts[s]));
        assign read_part[s] = 4'(read_group[9*s+:9] - read_round[s] * 9'(parts[s]));
        assign write_part[s] = 4'(write_group[9*s+:9] - write_round[s] * 9'(parts[s]));
        assign read_address[s] = ADDRESS_BITS'(read_row[9*s+:9]) * ADDRESS_BITS'(bank_cols) +
                                 ADDRESS_BITS'(read_round[s]);
        assign write_address[s] = ADDRESS_BITS'(write_row[9*s+:9]) * ADDRESS_BITS'(bank_cols) +
                                  ADDRESS_BITS'(write_round[s]);
        always_ff @(posedge clock) if (reads[s] != '0) part_was_read[s] <= read_part[s];
    end

    logic [BITS-1:0] bank_words[BUFFERS][BANKS];
    for (genvar f = 0; f < BUFFERS; f = f + 1) begin : g_buffer
        wire side = buffer[1] == 1'(f);  // whose it is, if anybody asks
        wire is_drawn = buffer[0] == 1'(f) && (reads[0] != '0 || writes[0] != '0);
        wire of_side = side && !is_drawn;
        for (genvar b = 0; b < BANKS; b = b + 1) begin : g_bank
            wire part_t part = 4'(lane_pkg::divided(16'(b), lanes_of[of_side]));
            wire lane_pkg::lanes_t lane = 4'(b) - part * lanes_of[of_side];
            wire owns = buffer[of_side] == 1'(f) && 4'(b) < banks;
            logic [2*BITS-1:0] read_words;  // the upper: of the port that writes
            block_ram #(
                .BITS(BITS),
                .WORDS(WORDS),
                .INITIAL(INITIAL)
            ) ram (
                .clock,
                .enable({owns && writes[of_side][lane] && write_part[of_side] == part,
                         owns && reads[of_side][lane] && read_part[of_side] == part}),
                .write(2'b10),
                .address({write_address[of_side], read_address[of_side]}),
                .write_data({written[of_side][lane*BITS+:BITS], BITS'(0)}),
                .read_data(read_words)
            );
            assign bank_words[f][b] = read_words[BITS-1:0];
            wire unused = &{1'b0, read_words[2*BITS-1:BITS]};
        end
    end
    // A lane's word comes from the bank that its group went to.
    for (genvar s = 0; s < 2; s = s + 1) begin : g_words
        for (genvar k = 0; k < LANES; k = k + 1) begin : g_lane
            wire [3:0] bank = 4'(k) + part_was_read[s] * lanes_of[s];
            assign words[(s*LANES+k)*BITS+:BITS] = bank_words[buffer[s]][bank < 4'(BANKS) ? bank : 4'd0];
        end
    end
endmodule
