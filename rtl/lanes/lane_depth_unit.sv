// A lane of the drawing: the depth of its pixel of a group, and the depth test in the last three stages of loop
// `fragment`: the word is read, compared, written. What an iteration or two before writes is forwarded: of a lane, for
// it meets no other's pixels.
module lane_depth_unit #(
    parameter int ADDRESS_BITS = 18,
    parameter int Z_SUM_BITS = 48,
    parameter int RECIPROCAL_BITS = 64,
    parameter int DEPTH_BITS = 64
) (
    input  logic                       clock,
    input  logic                       advance,
    input  logic                       forwards,
    input  faster_pkg::stage_t         read_stage,
    input  faster_pkg::fraction_t      fraction,
    input  logic                       is_fragment,  // of the window
    input  logic [Z_SUM_BITS-1:0]      z_sum,
    input  logic [RECIPROCAL_BITS-1:0] reciprocal,
    output logic                       reads,
    input  logic [ADDRESS_BITS-1:0]    comparing_address,  // row and group, of all lanes
    input  logic [ADDRESS_BITS-1:0]    writing_address,
    input  faster_pkg::depth_t         read_word,  // a step later
    output logic                       writes,
    output faster_pkg::depth_t         word
);
    typedef struct packed {
        logic                  is_candidate;
        logic [DEPTH_BITS-1:0] depth;
    } fragment_t;
    logic is_near;
    logic [DEPTH_BITS-1:0] new_depth;
    depth_unit #(
        .Z_SUM_BITS     (Z_SUM_BITS),
        .RECIPROCAL_BITS(RECIPROCAL_BITS),
        .DEPTH_BITS     (DEPTH_BITS)
    ) depth_of_pixel (
        .fraction, .z_sum(is_fragment ? z_sum : '0), .reciprocal, .is_near, .depth(new_depth)
    );
    fragment_t reading, comparing, writing;
    delay_line #(
        .BITS(1 + DEPTH_BITS)
    ) fragment_line (
        .clock, .advance, .stages(read_stage), .in({is_fragment && is_near, new_depth}), .out(reading)
    );
    assign reads = reading.is_candidate;

    wire logic signed [5:0] finer = 6'({1'b0, fraction.fragment_depth}) - 6'({2'b0, fraction.depth_buffer});
    wire logic [5:0] coarser = 6'(-finer);
    wire [DEPTH_BITS-1:0] written_code = finer[5] ? writing.depth << coarser : writing.depth >> 6'(finer);
    assign word = written_code[faster_pkg::DEPTH_BITS-1:0];
    assign writes = writing.is_candidate;

    logic was_written;
    logic [ADDRESS_BITS-1:0] written_address;
    faster_pkg::depth_t written_word;
    wire faster_pkg::depth_t buffered =
        forwards && writing.is_candidate && writing_address == comparing_address ? word :
        forwards && was_written && written_address == comparing_address ? written_word : read_word;
    wire [DEPTH_BITS-1:0] buffered_finely = DEPTH_BITS'(buffered) << 6'(finer);
    wire [DEPTH_BITS+11:0] depth_finely = (DEPTH_BITS + 12)'(comparing.depth) << coarser;
    wire is_nearer = finer[5] ? depth_finely <= (DEPTH_BITS + 12)'(buffered) : comparing.depth <= buffered_finely;

    always_ff @(posedge clock) begin
        if (advance) begin
            comparing <= reading;
            writing <= {comparing.is_candidate && is_nearer, comparing.depth};
            was_written <= writing.is_candidate;
            written_address <= writing_address;
            written_word <= word;
        end
    end

    wire unused = &{1'b0, written_code[DEPTH_BITS-1:faster_pkg::DEPTH_BITS]};
endmodule
