// Sends the observation of a window, pixel by pixel; what lies outside the image is depth 0 and no edge.
// (read sample_observation); T += 1; loop `read`.
module observation_reader (
    input  logic                     clock,
    input  logic                     reset,
    input  faster_pkg::loop_t        read_loop,
    input  faster_pkg::stage_t       observed_depth_latency,
    input  faster_pkg::stage_t       observed_edge_latency,
    input  logic [15:0]              width,
    input  logic [15:0]              height,
    input  logic [8:0]               window,
    output logic [31:0]              image_row,  // of the pixel asked for
    output logic [31:0]              image_col,
    input  faster_pkg::observation_t observation,

    input  logic                     sample_observation_has_token,
    output logic                     sample_observation_read,
    input  faster_pkg::header_t      sample_observation,
    input  logic                     observed_depth_has_room,
    output logic                     observed_depth_write,
    output faster_pkg::depth_t       observed_depth,
    input  logic                     observed_edge_has_room,
    output logic                     observed_edge_write,
    output logic                     observed_edge
);
    typedef enum logic {TAKE_SAMPLE, LOOP} state_t;
    state_t state;
    logic signed [31:0] row, col, first_col;
    logic [8:0] rows_left, cols_left;  // the one at work included

    wire is_in_image = row >= 0 && col >= 0 && row < $signed({16'b0, height}) && col < $signed({16'b0, width});
    wire is_last = rows_left == 9'd1 && cols_left == 9'd1;
    logic begins, ends, depth_leaves, edge_leaves;
    wire advance = state == LOOP && (!depth_leaves || observed_depth_has_room) &&
                   (!edge_leaves || observed_edge_has_room);

    assign image_row = row;
    assign image_col = col;
    assign sample_observation_read = state == TAKE_SAMPLE && sample_observation_has_token;
    assign observed_depth_write = advance && depth_leaves;
    assign observed_edge_write = advance && edge_leaves;

    pipelined_loop loop_control (
        .clock, .reset, .shape(read_loop), .active(state == LOOP), .advance, .is_last, .begins, .ends
    );
    delay_line #(
        .BITS(1 + faster_pkg::DEPTH_BITS)
    ) depth_line (
        .clock, .advance, .stages(observed_depth_latency),
        .in({begins, is_in_image ? observation.depth : '0}), .out({depth_leaves, observed_depth})
    );
    delay_line #(
        .BITS(2)
    ) edge_line (
        .clock, .advance, .stages(observed_edge_latency),
        .in({begins, is_in_image && observation.edge_bit}), .out({edge_leaves, observed_edge})
    );

    logic signed [31:0] first_row, new_first_col;
    window_origin origin (
        .centre_row(sample_observation.centre_row), .centre_col(sample_observation.centre_col), .window,
        .row(first_row), .col(new_first_col)
    );

    always_ff @(posedge clock) begin
        if (reset) state <= TAKE_SAMPLE;
        else if (state == TAKE_SAMPLE) begin
            row <= first_row;
            col <= new_first_col;
            first_col <= new_first_col;
            rows_left <= window;
            cols_left <= window;
            if (sample_observation_read) state <= LOOP;
        end else if (advance) begin
            if (begins) begin
                col <= cols_left == 9'd1 ? first_col : col + 1;
                cols_left <= cols_left == 9'd1 ? window : cols_left - 9'd1;
                if (cols_left == 9'd1) begin
                    row <= row + 1;
                    rows_left <= rows_left - 9'd1;
                end
            end
            if (ends) state <= TAKE_SAMPLE;
        end
    end

    wire unused = &{1'b0, sample_observation.sample, sample_observation.triangles};
endmodule
