// Starts the samples of a core: (write sample_vertex, sample_raster, sample_observation); T += 1.
module sample_dispatcher (
    input  logic                clock,
    input  logic                reset,
    input  logic [31:0]         samples,  // of this core
    output logic [31:0]         number,   // of the sample asked for, from 0
    input  faster_pkg::header_t header,   // of that sample

    input  logic                sample_vertex_has_room,
    output logic                sample_vertex_write,
    input  logic                sample_raster_has_room,
    output logic                sample_raster_write,
    input  logic                sample_observation_has_room,
    output logic                sample_observation_write,
    output faster_pkg::header_t sample_header
);
    wire advance = number != samples && sample_vertex_has_room && sample_raster_has_room && sample_observation_has_room;

    assign sample_vertex_write = advance;
    assign sample_raster_write = advance;
    assign sample_observation_write = advance;
    assign sample_header = header;

    always_ff @(posedge clock) begin
        if (reset) number <= '0;
        else if (advance) number <= number + 32'd1;
    end
endmodule
