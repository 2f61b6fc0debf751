// Loop `sweep`: a pixel per iteration. It reads the pixel and its four neighbours from the depth buffer, as many words
// per step as there are ports; with line buffers one word, and judges a row and a pixel later; with inner_border the
// pixel only. Border pixels are read and skipped. Clearing on read-out writes "far" where no later iteration looks.
module inlier_sweep #(
    parameter int WORDS = 65536,
    parameter int PORTS = 6,
    parameter int MAX_WINDOW = 256,
    localparam int ADDRESS_BITS = $clog2(WORDS),
    localparam int DEPTH_WIDTH = faster_pkg::DEPTH_BITS
) (
    input  logic                          clock,
    input  logic                          active,
    input  logic                          starts,   // the next iteration is the first of a sample
    input  logic                          begins,   // an iteration begins in this step
    input  logic                          advance,  // the step takes place
    input  logic [2:0]                    ports,
    input  logic                          is_inner_border,
    input  logic                          has_line_buffers,
    input  logic                          clears_on_read_out,
    input  logic [8:0]                    window,
    input  logic [3:0]                    fraction,
    input  logic                          edge_map,
    input  faster_pkg::depth_t            observed_depth,
    input  logic                          observed_edge,
    output logic                          reads_tokens,
    output logic                          is_last,
    output logic [PORTS-1:0]              enable,
    output logic [PORTS-1:0]              write,
    output logic [PORTS*ADDRESS_BITS-1:0] address,
    input  logic [PORTS*DEPTH_WIDTH-1:0]  words_read,
    // Of a pixel that leaves the pipeline
    output logic                          counts,
    output logic                          is_valid_depth,
    output logic                          is_inlier,
    output logic                          is_edge,
    output logic                          is_edge_inlier,
    // It may be one of the border, too.
    output logic                          leaves,
    output faster_pkg::depth_t            own,
    output faster_pkg::depth_t            observed
);
    typedef logic [ADDRESS_BITS-1:0] address_t;
    typedef logic [DEPTH_WIDTH-1:0] word_t;
    typedef logic [3:0] access_t;  // of an iteration: the pixel, below, above, right, left; then what is cleared
    localparam access_t CLEARED = 4'd5;
    localparam access_t NONE = 4'd8;  // and those behind it

    wire address_t row_words = ADDRESS_BITS'(window);
    wire [17:0] pixels = 18'(window) * 18'(window);
    wire [17:0] row_and_one = 18'(window) + 18'd1;
    wire uses_lines = has_line_buffers && !is_inner_border;
    wire reads_one = uses_lines || is_inner_border;  // word
    wire reads_neighbours = !reads_one;

    // Iterations: with line buffers the first fill them, with clearing and neighbours the last only clear.
    logic [17:0] counter;
    wire [17:0] iterations = pixels + (uses_lines || (reads_neighbours && clears_on_read_out) ? row_and_one : '0);
    assign is_last = counter + 18'd1 == iterations;
    assign reads_tokens = active && begins && (uses_lines ? counter >= row_and_one : counter < pixels);

    // The judged pixel, in the order of the tokens
    logic [8:0] row, col;
    wire [8:0] last = window - 9'd1;
    wire is_border = row == '0 || row == last || col == '0 || col == last;

    always_ff @(posedge clock) begin
        if (starts) begin
            counter <= '0;
            row <= '0;
            col <= '0;
        end else if (advance && begins) begin
            counter <= counter + 18'd1;
            if (reads_tokens) begin
                col <= col == last ? '0 : col + 9'd1;
                if (col == last) row <= row + 9'd1;
            end
        end
    end

    // Accesses: `ports` of them in each step from an iteration's first on. A single word is read in the first step, and
    // cleared in the second.
    address_t began_address;
    access_t  next_access, read_first;  // of this step, if no iteration begins; of the step before
    logic     clears_single, has_begun;
    wire address_t pixel_address = begins ? ADDRESS_BITS'(counter) : began_address;
    wire access_t first_access = begins ? 4'd0 : next_access;
    wire access_t after_access = first_access + 4'(ports);
    wire is_cleared = clears_on_read_out && (begins ? counter : 18'(began_address)) >= row_and_one;

    always_comb begin
        enable = '0;
        write = '0;
        address = '0;
        if (reads_one) begin
            enable[0] = begins && counter < pixels;
            address[0+:ADDRESS_BITS] = pixel_address;
            enable[1] = clears_single;
            write[1] = 1'b1;
            address[ADDRESS_BITS+:ADDRESS_BITS] = began_address;
        end else begin
            for (int p = 0; p < PORTS; p = p + 1) begin
                if (3'(p) < ports && (begins || has_begun)) begin
                    enable[p] = first_access + 4'(p) < CLEARED || (first_access + 4'(p) == CLEARED && is_cleared);
                    write[p] = clears_on_read_out && first_access + 4'(p) == CLEARED;
                    case (first_access + 4'(p))
                        4'd0: address[p*ADDRESS_BITS+:ADDRESS_BITS] = pixel_address;
                        4'd1: address[p*ADDRESS_BITS+:ADDRESS_BITS] = pixel_address + row_words;
                        4'd2: address[p*ADDRESS_BITS+:ADDRESS_BITS] = pixel_address - row_words;
                        4'd3: address[p*ADDRESS_BITS+:ADDRESS_BITS] = pixel_address + ADDRESS_BITS'(1);
                        4'd4: address[p*ADDRESS_BITS+:ADDRESS_BITS] = pixel_address - ADDRESS_BITS'(1);
                        default: address[p*ADDRESS_BITS+:ADDRESS_BITS] = pixel_address - row_words - ADDRESS_BITS'(1);
                    endcase
                end
            end
        end
    end
    always_ff @(posedge clock) begin
        if (starts) begin
            has_begun <= 1'b0;
            clears_single <= 1'b0;
        end else if (advance) begin
            clears_single <= begins && reads_one && clears_on_read_out && counter < pixels;
            read_first <= first_access;
            next_access <= after_access > CLEARED ? NONE : after_access;
            if (begins) begin
                began_address <= ADDRESS_BITS'(counter);
                has_begun <= 1'b1;
            end
        end
    end

    // Words read in earlier steps of an iteration wait for those of its last step of reading; a step later all are
    // there.
    access_t first_of_last;  // access of that step
    faster_pkg::stage_t all_read;  // stage in which they are there
    always_comb begin
        case (ports)
            3'd1: {all_read, first_of_last} = {6'd5, 4'd4};
            3'd2: {all_read, first_of_last} = {6'd3, 4'd4};
            3'd3: {all_read, first_of_last} = {6'd2, 4'd3};
            3'd4: {all_read, first_of_last} = {6'd2, 4'd4};
            default: {all_read, first_of_last} = {6'd1, 4'd0};
        endcase
        if (reads_one) {all_read, first_of_last} = {6'd1, 4'd0};
    end
    logic [5*DEPTH_WIDTH-1:0] around;  // as line_buffers has them
    for (genvar a = 0; a < 5; a = a + 1) begin : g_around
        word_t kept;
        wire access_t port_before = 4'(a) - read_first;
        wire access_t port_now = 4'(a) - first_of_last;
        always_ff @(posedge clock) if (advance && port_before < 4'(ports)) kept <= word_of(port_before);
        assign around[a*DEPTH_WIDTH+:DEPTH_WIDTH] = 4'(a) >= first_of_last ? word_of(port_now) : kept;
    end
    function automatic word_t word_of(input access_t port);
        word_of = words_read[0+:DEPTH_WIDTH];
        for (int p = 1; p < PORTS; p = p + 1) if (4'(p) == port) word_of = words_read[p*DEPTH_WIDTH+:DEPTH_WIDTH];
    endfunction

    // What an iteration brings to the comparison
    typedef struct packed {
        logic  is_token;
        logic  is_pixel;  // inside the border
        logic  edge_bit;
        word_t observed_depth;
        logic  observed_edge;
    } judged_t;
    judged_t judged;
    logic has_words;
    delay_line #(
        .BITS(5 + DEPTH_WIDTH)
    ) tokens (
        .clock, .advance, .stages(all_read),
        .in({active && begins, reads_tokens, reads_tokens && !is_border, edge_map, observed_depth, observed_edge}),
        .out({has_words, judged})
    );

    // Line buffers: the words read before, one more with each iteration. The judged pixel is a row and a pixel back.
    logic [5*DEPTH_WIDTH-1:0] of_lines;
    line_buffers #(
        .BITS(DEPTH_WIDTH),
        .MAX_WINDOW(MAX_WINDOW)
    ) lines (
        .clock, .advance(advance && has_words && uses_lines), .window, .in(words_read[0+:DEPTH_WIDTH]),
        .around(of_lines)
    );
    wire [5*DEPTH_WIDTH-1:0] words = uses_lines ? of_lines : around;

    pixel_comparison comparison (
        .fraction, .is_edge(judged.edge_bit), .has_own_depth(is_inner_border),
        .own(words[0*DEPTH_WIDTH+:DEPTH_WIDTH]), .below(words[1*DEPTH_WIDTH+:DEPTH_WIDTH]),
        .above(words[2*DEPTH_WIDTH+:DEPTH_WIDTH]), .right(words[3*DEPTH_WIDTH+:DEPTH_WIDTH]),
        .left(words[4*DEPTH_WIDTH+:DEPTH_WIDTH]),
        .observed(judged.observed_depth), .is_inlier, .is_valid_depth
    );
    assign counts = has_words && judged.is_pixel;
    assign leaves = has_words && judged.is_token;
    assign own = words[0+:DEPTH_WIDTH];
    assign observed = judged.observed_depth;
    assign is_edge = judged.edge_bit;
    assign is_edge_inlier = is_inlier && judged.edge_bit && judged.observed_edge;
endmodule
