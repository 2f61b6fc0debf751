// Sends the vertices of a sample. The arithmetic of the transform is outside: vertices come as codes, and stay in the
// pipeline for as many stages as computing them takes. (read sample_vertex); T += 1; loop `vertex`; without triangles
// T += 1.
module vertex_transform (
    input  logic                clock,
    input  logic                reset,
    input  faster_pkg::loop_t   vertex_loop,
    input  faster_pkg::stage_t  write_latency,
    output logic [31:0]         vertex_sample,  // whose vertex is asked for
    output logic [31:0]         vertex_number,  // in the sample: three for each triangle
    input  faster_pkg::vertex_t vertex_value,

    input  logic                sample_vertex_has_token,
    output logic                sample_vertex_read,
    input  faster_pkg::header_t sample_vertex,
    input  logic                vertex_has_room,
    output logic                vertex_write,
    output faster_pkg::vertex_t vertex
);
    typedef enum logic [1:0] {TAKE_SAMPLE, LOOP, NO_TRIANGLES} state_t;
    state_t state;
    logic [31:0] vertices;  // of the sample

    wire is_last = vertex_number + 32'd1 == vertices;
    logic begins, ends, leaves;

    assign sample_vertex_read = state == TAKE_SAMPLE && sample_vertex_has_token;
    assign vertex_write = state == LOOP && leaves && vertex_has_room;
    wire advance = state == LOOP && (!leaves || vertex_has_room);

    pipelined_loop loop_control (
        .clock, .reset, .shape(vertex_loop), .active(state == LOOP), .advance, .is_last, .begins, .ends
    );
    delay_line #(
        .BITS(1 + faster_pkg::VERTEX_BITS)
    ) pipeline (
        .clock, .advance, .stages(write_latency), .in({begins, vertex_value}), .out({leaves, vertex})
    );

    always_ff @(posedge clock) begin
        if (reset) state <= TAKE_SAMPLE;
        else
            unique case (state)
                TAKE_SAMPLE: begin
                    vertex_sample <= sample_vertex.sample;
                    vertices <= (sample_vertex.triangles << 1) + sample_vertex.triangles;
                    vertex_number <= '0;
                    if (sample_vertex_read) state <= sample_vertex.triangles == '0 ? NO_TRIANGLES : LOOP;
                end
                LOOP:
                    if (advance) begin
                        if (begins) vertex_number <= vertex_number + 32'd1;
                        if (ends) state <= TAKE_SAMPLE;
                    end
                default: state <= TAKE_SAMPLE;
            endcase
    end

    wire unused = &{1'b0, sample_vertex.centre_row, sample_vertex.centre_col};
endmodule
