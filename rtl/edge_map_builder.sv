// Merges the edge tokens of a sample into its contour (A.2).
// T += 1; loop `clear`; (read edge_token); T += 1; loop `token`, without iterations T += 1; T += 1; loop `output`.
// With clearing on read-out there is no loop `clear`: an output iteration clears what it has read. With inner_border
// only covered pixels are kept, and the output finds those beside one that is not covered, a row later.
module edge_map_builder #(
    parameter int WORDS = 65536
) (
    input  logic                    clock,
    input  logic                    reset,
    input  faster_pkg::loop_t       clear_loop,
    input  faster_pkg::loop_t       token_loop,
    input  faster_pkg::loop_t       output_loop,
    input  faster_pkg::stage_t      edge_map_latency,  // at least 1: the word has to be read first
    input  logic                    is_inner_border,
    input  logic                    clears_on_read_out,
    input  logic                    flushes_last,
    input  logic                    forwards,  // object bits that are being written, to who reads them
    input  logic [8:0]              window,

    input  logic                    edge_token_has_token,
    output logic                    edge_token_read,
    input  faster_pkg::edge_token_t edge_token,
    input  logic                    edge_map_has_room,
    output logic                    edge_map_write,
    output logic                    edge_map,
    output logic                    is_built  // the maps of a sample are complete in this cycle
);
    localparam int ADDRESS_BITS = $clog2(WORDS);
    typedef logic [ADDRESS_BITS-1:0] address_t;
    typedef enum logic [2:0] {BEGIN, CLEAR, FIRST_TOKEN, TOKENS, NO_TOKENS, TURN, OUTPUT} state_t;
    state_t state;

    wire address_t row_words = ADDRESS_BITS'(window);
    wire [17:0] pixels = 18'(window) * 18'(window);
    logic begins, ends, advance, is_last;
    logic [17:0] counter;  // iterations of clear and output
    wire address_t counter_address = ADDRESS_BITS'(counter);
    wire counts_last = counter + 18'd1 == (state == OUTPUT && is_inner_border ? pixels + 18'(window) : pixels);

    pipelined_loop loop_control (
        .clock,
        .reset,
        .shape (state == CLEAR ? clear_loop : state == TOKENS ? token_loop : output_loop),
        .active(state == CLEAR || state == TOKENS || state == OUTPUT),
        .advance,
        .is_last,
        .begins,
        .ends
    );

    // Loop `token`: an iteration consumes the token and reads the next one, or is the second one of an object token.
    faster_pkg::edge_token_t token;
    logic is_second;
    address_t object_address;  // of the object token that the second iteration belongs to
    wire consumes = state == TOKENS && begins && !is_second;
    logic is_in_window;
    in_window token_in_window (.pixel(token.pixel), .window, .is_inside(is_in_window));
    wire is_object = consumes && token.kind == faster_pkg::OBJECT && is_in_window;
    wire is_edge = consumes && token.kind == faster_pkg::EDGE && is_in_window;
    wire needs_second = is_object && !is_inner_border;
    wire is_last_token = consumes ? edge_token.kind == faster_pkg::END_OF_TOKENS && !(needs_second && flushes_last) :
                                    token.kind == faster_pkg::END_OF_TOKENS;
    wire address_t token_address = ADDRESS_BITS'(token.pixel.row) * row_words + ADDRESS_BITS'(token.pixel.col);

    assign is_last = state == TOKENS ? is_last_token : counts_last;
    assign edge_token_read = edge_token_has_token && (state == FIRST_TOKEN || consumes);

    // Its pipeline reads the object map in one stage and writes in the next, the last of the loop, or the fourth.
    typedef struct packed {
        logic     edge_token;
        logic     object_token;
        logic     second;
        logic     has_below;
        logic     has_above;
        address_t address;
    } work_t;
    wire work_t work = {
        is_edge, is_object, state == TOKENS && begins && is_second,
        token.pixel.row != $signed({7'b0, window}) - 16'sd1, token.pixel.row != 16'sd0,
        is_second ? object_address : token_address
    };
    wire faster_pkg::stage_t read_stage =
        token_loop.depth >= 8'd4 ? 6'd2 : 6'(token_loop.depth - 8'd2);
    work_t reading, writing;

    delay_line #(
        .BITS(5 + ADDRESS_BITS)
    ) token_line (
        .clock, .advance(advance && state == TOKENS), .stages(read_stage), .in(work), .out(reading)
    );
    wire address_t own_or_below = reading.edge_token ? reading.address : reading.address + row_words;
    wire address_t above = reading.address - row_words;
    logic forward_first, forward_above;
    logic object_first, object_above;  // what was read: the pixel itself or the one below, and the one above
    wire is_covered_first = object_first || forward_first;
    wire is_covered_above = object_above || forward_above;
    logic below_is_due, above_is_due;

    always_ff @(posedge clock) begin
        if (advance && state == TOKENS) begin
            writing <= reading;
            forward_first <= forwards && writing.second && writing.address == own_or_below;
            forward_above <= forwards && writing.second && writing.address == above;
            if (writing.object_token) begin
                below_is_due <= writing.has_below && !is_covered_first;
                above_is_due <= writing.has_above && !is_covered_above;
            end
        end
    end
    // What is in the pipeline when the loop begins has left it before: nothing is written twice.
    wire works = advance && state == TOKENS;
    wire sets_edge = works && writing.edge_token && !is_covered_first && !is_inner_border;
    wire clears_edge = works && writing.object_token && !is_inner_border;
    wire second_writes = works && writing.second;
    wire sets_object = second_writes || (works && writing.object_token && is_inner_border);

    // Loop `output`: reads a word of the map and sends a bit; a stage later it may clear it.
    wire reads_out = state == OUTPUT && begins && advance && counter < pixels;
    logic clears_word;
    address_t read_address;
    always_ff @(posedge clock) begin
        if (advance && state == OUTPUT) begin
            clears_word <= begins && counter < pixels && clears_on_read_out;
            read_address <= counter_address;
        end
    end
    wire clears_now = advance && state == OUTPUT && clears_word;
    wire clears_in_loop = state == CLEAR && begins;

    // Ports of the edge map: 0 clears, sets and reads out; 1 sets the pixel above, clears on read-out.
    logic edge_bit, unused_edge_bit;
    block_ram #(
        .BITS (1),
        .WORDS(WORDS)
    ) edge_map_ram (
        .clock,
        .enable({
            clears_now || (second_writes && above_is_due),
            clears_in_loop || sets_edge || clears_edge || (second_writes && below_is_due) || reads_out
        }),
        .write({1'b1, state != OUTPUT}),
        .address({
            state == OUTPUT ? read_address : writing.address - row_words,
            state == TOKENS ? writing.second ? writing.address + row_words : writing.address : counter_address
        }),
        .write_data({state == TOKENS, sets_edge || second_writes}),
        .read_data({unused_edge_bit, edge_bit})
    );
    // Of the object map: 0 and 1 read and clear, 2 sets.
    logic unused_object_bit;
    block_ram #(
        .BITS (1),
        .WORDS(WORDS),
        .PORTS(3)
    ) object_map_ram (
        .clock,
        .enable({sets_object, works || clears_now, works || clears_in_loop || reads_out}),
        .write({1'b1, state == OUTPUT, state == CLEAR}),
        .address({
            writing.address,
            state == OUTPUT ? read_address : above,
            state == TOKENS ? own_or_below : counter_address
        }),
        .write_data(3'b100),
        .read_data({unused_object_bit, object_above, object_first})
    );

    // The bit that leaves
    logic is_read, border_bit, leaves;
    inner_border border (
        .clock, .advance(advance && state == OUTPUT), .starts(state == TURN), .begins, .window,
        .is_covered(object_first), .edge_bit(border_bit)
    );
    wire sends = state == OUTPUT && begins && (!is_inner_border || counter >= 18'(window));
    always_ff @(posedge clock) begin
        if (reset) is_read <= 1'b0;
        else if (advance && state == OUTPUT) is_read <= sends;
    end
    delay_line #(
        .BITS(2)
    ) output_line (
        .clock, .advance(advance && state == OUTPUT), .stages(edge_map_latency - 6'd1),
        .in({is_read, is_inner_border ? border_bit : edge_bit}), .out({leaves, edge_map})
    );
    assign edge_map_write = state == OUTPUT && leaves && edge_map_has_room;
    assign advance = state == CLEAR || (state == TOKENS && (!consumes || edge_token_has_token)) ||
                     (state == OUTPUT && (!leaves || edge_map_has_room));
    assign is_built = state == TURN;

    always_ff @(posedge clock) begin
        if (reset) begin
            state <= BEGIN;
            counter <= '0;
        end else begin
            unique case (state)
                BEGIN: state <= clears_on_read_out ? FIRST_TOKEN : CLEAR;
                CLEAR: if (ends) state <= FIRST_TOKEN;
                FIRST_TOKEN: begin
                    is_second <= 1'b0;
                    token <= edge_token;
                    if (edge_token_has_token)
                        state <= edge_token.kind == faster_pkg::END_OF_TOKENS ? NO_TOKENS : TOKENS;
                end
                TOKENS:
                    if (advance) begin
                        if (begins) is_second <= needs_second;
                        if (consumes) begin
                            token <= edge_token;
                            object_address <= token_address;
                        end
                        if (ends) state <= TURN;
                    end
                NO_TOKENS: state <= TURN;
                TURN: state <= OUTPUT;
                default: if (advance && ends) state <= BEGIN;
            endcase
            if (state != CLEAR && state != OUTPUT) counter <= '0;
            else if (advance && begins) counter <= counter + 18'd1;
        end
    end

    wire unused = &{1'b0, unused_edge_bit, unused_object_bit};
endmodule
