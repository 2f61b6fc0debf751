// Keeps the depth buffer of a sample, then compares it with the observation (A.3).
// T += 1; loop `clear`; (read command); T += 1; while Triangle: (read area_reciprocal, command); T += 1; loop `fragment`
// while the last command is Fragment, without iterations T += 1; at End: T += 1; loop `sweep`; (write result); T += 1.
// With a flattened loop `fragment` has an iteration for every command before End: (read area_reciprocal, command) or
// (read fragment_depth, fragment_index, command).
module inlier_unit #(
    parameter int WORDS = 65536,
    parameter int PORTS = 6,  // of the depth buffer, as built
    parameter int Z_SUM_BITS = 48,
    parameter int RECIPROCAL_BITS = 64,
    parameter int DEPTH_BITS = 64
) (
    input  logic                       clock,
    input  logic                       reset,
    input  faster_pkg::loop_t          clear_loop,
    input  faster_pkg::loop_t          fragment_loop,
    input  faster_pkg::loop_t          sweep_loop,
    input  logic [2:0]                 ports,  // that the sweep uses, at most PORTS
    input  logic                       is_inner_border,
    input  logic                       has_line_buffers,
    input  logic                       is_flattened,
    input  logic                       forwards,  // depths that are being written, to who reads them
    input  logic                       clears_on_read_out,
    input  logic                       counts_hidden,
    input  logic [8:0]                 window,
    input  faster_pkg::fraction_t      fraction,

    input  logic                       area_reciprocal_has_token,
    output logic                       area_reciprocal_read,
    input  logic [RECIPROCAL_BITS-1:0] area_reciprocal,
    input  logic                       command_has_token,
    output logic                       command_read,
    input  faster_pkg::command_t       command,
    input  logic                       fragment_depth_has_token,
    output logic                       fragment_depth_read,
    input  logic [Z_SUM_BITS-1:0]      fragment_depth,
    input  logic                       fragment_index_has_token,
    output logic                       fragment_index_read,
    input  faster_pkg::pixel_t         fragment_index,
    input  logic                       edge_map_has_token,
    output logic                       edge_map_read,
    input  logic                       edge_map,
    input  logic                       observed_depth_has_token,
    output logic                       observed_depth_read,
    input  faster_pkg::depth_t         observed_depth,
    input  logic                       observed_edge_has_token,
    output logic                       observed_edge_read,
    input  logic                       observed_edge,
    input  logic                       result_has_room,
    output logic                       result_write,
    output faster_pkg::counters_t      result,
    output logic                       is_drawn  // the depth buffer of a sample is complete in this cycle
);
    localparam int ADDRESS_BITS = $clog2(WORDS);
    localparam int DEPTH_WIDTH = faster_pkg::DEPTH_BITS;
    typedef logic [ADDRESS_BITS-1:0] address_t;
    typedef enum logic [3:0] {
        BEGIN, CLEAR, FIRST_COMMAND, RECIPROCAL, FRAGMENTS, NO_FRAGMENTS, END_SEEN, SWEEP, RESULT
    } state_t;
    state_t state;

    wire address_t row_words = ADDRESS_BITS'(window);
    wire [17:0] pixels = 18'(window) * 18'(window);
    logic begins, ends, advance, sweep_advances, sweep_is_last;
    logic [17:0] counter;  // iterations of clear

    pipelined_loop loop_control (
        .clock,
        .reset,
        .shape  (state == CLEAR ? clear_loop : state == FRAGMENTS ? fragment_loop : sweep_loop),
        .active (state == CLEAR || state == FRAGMENTS || state == SWEEP),
        .advance,
        .is_last(state == CLEAR ? counter + 18'd1 == pixels :
                 state == FRAGMENTS ? is_last_fragment : sweep_is_last),
        .begins,
        .ends
    );

    // Steps of the drawing
    logic [RECIPROCAL_BITS-1:0] reciprocal;
    faster_pkg::command_t next;  // command, read one ahead
    wire begins_triangle = state == FRAGMENTS && begins && is_flattened && next == faster_pkg::TRIANGLE;
    wire takes_fragment = state == FRAGMENTS && begins && !begins_triangle;
    wire is_last_fragment =
        is_flattened ? command == faster_pkg::END_OF_COMMANDS : command != faster_pkg::FRAGMENT;
    wire fragment_is_there = fragment_depth_has_token && fragment_index_has_token && command_has_token;
    wire triangle_is_there = area_reciprocal_has_token && command_has_token;
    wire draws = state == FRAGMENTS && (!takes_fragment || fragment_is_there) && (!begins_triangle || triangle_is_there);
    wire takes_reciprocal = (state == RECIPROCAL && triangle_is_there) || (begins_triangle && draws);
    wire takes_command = state == FIRST_COMMAND && command_has_token;
    wire fragment_is_taken = takes_fragment && draws;

    assign area_reciprocal_read = takes_reciprocal;
    assign command_read = takes_command || takes_reciprocal || fragment_is_taken;
    assign fragment_depth_read = fragment_is_taken;
    assign fragment_index_read = fragment_is_taken;

    // Loop `fragment`: reads the depth buffer in stage 7, compares in stage 8, writes in stage 9; in a shorter pipeline
    // in its last three.
    typedef struct packed {
        logic                  is_candidate;  // in the window, and near enough
        address_t              address;
        logic [DEPTH_BITS-1:0] depth;
    } fragment_t;
    logic is_near, is_in_window;
    in_window index_in_window (.pixel(fragment_index), .window, .is_inside(is_in_window));
    fragment_t reading, comparing, writing;
    wire address_t index_address = ADDRESS_BITS'(fragment_index.row) * row_words + ADDRESS_BITS'(fragment_index.col);
    logic [DEPTH_BITS-1:0] new_depth;
    depth_unit #(
        .Z_SUM_BITS     (Z_SUM_BITS),
        .RECIPROCAL_BITS(RECIPROCAL_BITS),
        .DEPTH_BITS     (DEPTH_BITS)
    ) depth_of_fragment (
        .fraction, .z_sum(fragment_depth), .reciprocal, .is_near, .depth(new_depth)
    );
    wire fragment_t fragment = {
        takes_fragment && is_near && is_in_window, index_address, new_depth
    };
    wire faster_pkg::stage_t read_stage =
        fragment_loop.depth >= 8'd10 ? 6'd7 : 6'(fragment_loop.depth - 8'd3);
    delay_line #(
        .BITS(1 + ADDRESS_BITS + DEPTH_BITS)
    ) fragment_line (
        .clock, .advance(draws), .stages(read_stage), .in(fragment), .out(reading)
    );

    // Between the precision of fragments and of the buffer
    wire logic signed [5:0] finer =
        6'({1'b0, fraction.fragment_depth}) - 6'({2'b0, fraction.depth_buffer});
    wire logic [5:0] coarser = 6'(-finer);
    // What was read, unless an iteration before it writes the word now, or wrote it in the step of the read.
    logic [DEPTH_WIDTH-1:0] read_word, written_word;
    address_t written_address;
    logic was_written;
    wire [DEPTH_WIDTH-1:0] buffered =
        forwards && writing.is_candidate && writing.address == comparing.address ? written_code[DEPTH_WIDTH-1:0] :
        forwards && was_written && written_address == comparing.address ? written_word : read_word;
    wire [DEPTH_BITS-1:0] buffered_finely = DEPTH_BITS'(buffered) << 6'(finer);
    wire [DEPTH_BITS+11:0] depth_finely = (DEPTH_BITS + 12)'(comparing.depth) << coarser;
    wire is_nearer = finer[5] ? depth_finely <= (DEPTH_BITS + 12)'(buffered) : comparing.depth <= buffered_finely;
    wire [DEPTH_BITS-1:0] written_code = finer[5] ? writing.depth << coarser : writing.depth >> 6'(finer);

    always_ff @(posedge clock) begin
        if (draws) begin
            comparing <= reading;
            writing <= comparing;
            writing.is_candidate <= comparing.is_candidate && is_nearer;
            was_written <= writing.is_candidate;
            written_address <= writing.address;
            written_word <= written_code[DEPTH_WIDTH-1:0];
        end
    end

    // Loop `sweep`
    logic                   sweep_reads;
    logic [PORTS-1:0]       sweep_enable, sweep_write;
    logic [PORTS*ADDRESS_BITS-1:0] sweep_address;
    logic [PORTS*DEPTH_WIDTH-1:0]  words_read;
    logic counts, is_valid_depth, is_inlier, is_edge, is_edge_inlier, leaves;
    faster_pkg::depth_t own, observed;

    inlier_sweep #(
        .WORDS(WORDS),
        .PORTS(PORTS)
    ) sweep (
        .clock, .active(state == SWEEP), .starts(state == END_SEEN), .begins, .advance(sweep_advances),
        .ports, .is_inner_border, .has_line_buffers, .clears_on_read_out, .window, .fraction(fraction.depth_buffer),
        .edge_map, .observed_depth, .observed_edge,
        .reads_tokens(sweep_reads), .is_last(sweep_is_last),
        .enable(sweep_enable), .write(sweep_write), .address(sweep_address), .words_read,
        .counts, .is_valid_depth, .is_inlier, .is_edge, .is_edge_inlier, .leaves, .own, .observed
    );
    faster_pkg::hidden_t hidden;
    hidden_pixels hidden_of_sweep (
        .clock, .starts(!counts_hidden || state == BEGIN), .leaves(leaves && sweep_advances), .counts, .window,
        .fraction(fraction.depth_buffer), .own, .observed, .result(hidden)
    );
    wire tokens_are_there = edge_map_has_token && observed_depth_has_token && observed_edge_has_token;
    assign sweep_advances = state == SWEEP && (!sweep_reads || tokens_are_there);
    assign edge_map_read = sweep_advances && sweep_reads;
    assign observed_depth_read = edge_map_read;
    assign observed_edge_read = edge_map_read;
    assign advance = state == CLEAR || draws || sweep_advances;

    // Ports of the depth buffer: 0 reads fragments' words, 1 clears and writes; the sweep uses all it may.
    logic [PORTS-1:0] enable, write;
    logic [PORTS*ADDRESS_BITS-1:0] address;
    logic [PORTS*DEPTH_WIDTH-1:0] write_data;
    always_comb begin
        enable = sweep_advances ? sweep_enable : '0;
        write = sweep_write;
        address = sweep_address;
        write_data = '1;  // far
        if (state == CLEAR) begin
            enable[1:0] = {begins, 1'b0};
            write[1:0] = 2'b10;
            address[ADDRESS_BITS+:ADDRESS_BITS] = ADDRESS_BITS'(counter);
        end else if (state == FRAGMENTS) begin
            enable[1:0] = {draws && writing.is_candidate, draws};
            write[1:0] = 2'b10;
            address[0+:2*ADDRESS_BITS] = {writing.address, reading.address};
            write_data[DEPTH_WIDTH+:DEPTH_WIDTH] = written_code[DEPTH_WIDTH-1:0];
        end
    end
    block_ram #(
        .BITS   (DEPTH_WIDTH),
        .WORDS  (WORDS),
        .PORTS  (PORTS),
        .INITIAL(faster_pkg::FAR)
    ) depth_buffer_ram (
        .clock, .enable, .write, .address, .write_data, .read_data(words_read)
    );
    assign read_word = words_read[DEPTH_WIDTH-1:0];

    faster_pkg::counters_t counters;
    always_comb begin
        result = counters;
        result.hidden = hidden;
    end
    assign result_write = state == RESULT && result_has_room;
    assign is_drawn = state == END_SEEN;

    always_ff @(posedge clock) begin
        if (state == BEGIN) counters <= '0;
        else begin
            counters.valid_raster <= counters.valid_raster + 32'(draws && writing.is_candidate);
            if (counts && sweep_advances) begin
                counters.valid_depth <= counters.valid_depth + 32'(is_valid_depth);
                counters.inlier <= counters.inlier + 32'(is_inlier);
                counters.valid_edge <= counters.valid_edge + 32'(is_edge);
                counters.edge_inlier <= counters.edge_inlier + 32'(is_edge_inlier);
            end
        end
    end

    always_ff @(posedge clock) begin
        if (reset) begin
            state <= BEGIN;
            counter <= '0;
        end else begin
            if (command_read) next <= command;
            if (takes_reciprocal) reciprocal <= area_reciprocal;
            counter <= state == CLEAR ? counter + 18'(begins) : '0;
            unique case (state)
                BEGIN: state <= clears_on_read_out ? FIRST_COMMAND : CLEAR;
                CLEAR: if (ends) state <= FIRST_COMMAND;
                FIRST_COMMAND:
                    if (takes_command)
                        state <= command != faster_pkg::TRIANGLE ? END_SEEN : is_flattened ? FRAGMENTS : RECIPROCAL;
                RECIPROCAL:
                    if (takes_reciprocal) state <= command == faster_pkg::FRAGMENT ? FRAGMENTS : NO_FRAGMENTS;
                FRAGMENTS:
                    if (draws && ends) state <= next == faster_pkg::TRIANGLE ? RECIPROCAL : END_SEEN;
                NO_FRAGMENTS: state <= next == faster_pkg::TRIANGLE ? RECIPROCAL : END_SEEN;
                END_SEEN: state <= SWEEP;
                SWEEP: if (sweep_advances && ends) state <= RESULT;
                default: if (result_write) state <= BEGIN;
            endcase
        end
    end

    wire unused = &{1'b0, written_code[DEPTH_BITS-1:DEPTH_WIDTH], reading.depth};
endmodule
