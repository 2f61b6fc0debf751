// Draws the triangles of a sample in one loop `scan`, a group of pixels per iteration, while others are set up.
// (read sample_raster); T += 1; with triangles, loop `scan`: three iterations for each of the first triangles, which read
// its vertices; then for each triangle one that sends area and, if it is drawn, command Triangle, those of its scan, and
// as many that do nothing as make them three. The first three of them read the vertices of a triangle further on. Then
// T += 1; (write command End, edge_token end); T += 1; with a touched region twice (write fragment_index, edge_token,
// region); T += 1.
module lane_rasterizer #(
    parameter int EDGE_BITS = 36,
    parameter int Z_SUM_BITS = 56,
    parameter int CROSSING_BITS = 36,    // where an edge crosses a row
    parameter int DIFFERENCE_BITS = 17,  // of two coordinates
    parameter int SETUPS = 32
) (
    input  logic                         clock,
    input  logic                         reset,
    input  faster_pkg::loop_t            scan_loop,
    input  faster_pkg::stage_t           setup_cycles,  // divisions included; at least 24
    input  logic [4:0]                   setups_ahead,  // at least 1
    input  faster_pkg::stage_t           command_latency,
    input  faster_pkg::stage_t           fragment_depth_latency,
    input  faster_pkg::stage_t           fragment_index_latency,
    input  faster_pkg::stage_t           edge_token_latency,
    input  lane_pkg::lanes_t             lanes,
    input  logic                         sends_region,
    input  logic [15:0]                  width,
    input  logic [15:0]                  height,
    input  logic [8:0]                   window,
    input  logic [3:0]                   vertex_xy,

    input  logic                         sample_raster_has_token,
    output logic                         sample_raster_read,
    input  faster_pkg::header_t          sample_raster,
    input  logic                         vertex_has_token,
    output logic                         vertex_read,
    input  faster_pkg::vertex_t          vertex,
    input  logic                         area_has_room,
    output logic                         area_write,
    output logic signed [EDGE_BITS-1:0]  area,
    input  logic                         command_has_room,
    output logic                         command_write,
    output faster_pkg::command_t         command,
    input  logic                         fragment_depth_has_room,
    output logic                         fragment_depth_write,
    output logic [2*Z_SUM_BITS-1:0]      fragment_depth,  // z sum of the first column, what a column adds
    input  logic                         fragment_index_has_room,
    output logic                         fragment_index_write,
    output lane_pkg::group_t             fragment_index,
    input  logic                         edge_token_has_room,
    output logic                         edge_token_write,
    output lane_pkg::group_t             edge_token,
    input  logic                         region_has_room,
    output logic                         region_write,
    output faster_pkg::pixel_t           region
);
    typedef enum logic [2:0] {TAKE_SAMPLE, SCAN, SCAN_DONE, END_SAMPLE, FIRST_CORNER, LAST_CORNER} state_t;
    typedef enum logic [1:0] {READ_ONLY, ANNOUNCE, VISIT, NOTHING} work_t;  // of an iteration
    state_t state;
    work_t work;
    logic [1:0] ordinal;  // of the iteration among its triangle's; 3: or a later one
    logic [31:0] triangles_left;  // the one at work included
    logic [31:0] vertices_left;   // to be read
    logic [31:0] reads_only_left;
    logic [1:0] vertex_number;  // of its triangle
    logic begins, ends, advance, is_last;
    logic signed [15:0] origin_row, origin_col;

    pipelined_loop loop_control (
        .clock, .reset, .shape(scan_loop), .active(state == SCAN), .advance, .is_last, .begins, .ends
    );

    // Vertices; a setup begins when the iteration with its third vertex is over
    faster_pkg::vertex_t v0, v1;
    logic [3*faster_pkg::VERTEX_BITS-1:0] read_triangle;
    wire reads_vertex = begins && (work == READ_ONLY || (ordinal != 2'd3 && vertices_left != '0));
    wire reads_third = reads_vertex && vertex_number == 2'd2;
    logic has_third;  // the iteration at hand
    faster_pkg::cycles_t steps_left;  // of it
    wire is_over = advance && (begins ? scan_loop.ii == 8'd1 : steps_left == 8'd1);
    wire setup_begins = is_over && (begins ? reads_third : has_third);

    logic is_ready, has_spans, take_spans;
    logic signed [15:0] left_wall;
    logic signed [Z_SUM_BITS-1:0] z_sum_at_wall, z_sum_per_col, z_sum_per_row;
    lane_pkg::box_t box;
    logic [5:0] sides;
    logic [3*(DIFFERENCE_BITS-1)-1:0] divisors, remainders, remainder_steps;
    logic [3*CROSSING_BITS-1:0] quotients;
    logic [3*DIFFERENCE_BITS-1:0] quotient_steps;
    setup_ahead #(
        .EDGE_BITS(EDGE_BITS), .Z_SUM_BITS(Z_SUM_BITS), .CROSSING_BITS(CROSSING_BITS), .DIFFERENCE_BITS(DIFFERENCE_BITS),
        .SETUPS(SETUPS)
    ) ahead (
        .clock, .reset, .begins(setup_begins), .triangle(begins ? {v0, v1, vertex} : read_triangle),
        .cycles(setup_cycles), .width, .height, .vertex_xy,
        .is_ready, .take(area_write), .area, .left_wall, .z_sum_at_wall, .z_sum_per_col, .z_sum_per_row,
        .has_spans, .take_spans, .box, .sides, .divisors, .quotients, .remainders, .quotient_steps, .remainder_steps
    );

    logic has_row, take_row;
    lane_pkg::row_t row;
    span_rows #(
        .CROSSING_BITS(CROSSING_BITS), .DIFFERENCE_BITS(DIFFERENCE_BITS)
    ) rows (
        .clock, .reset, .lanes, .origin_row, .origin_col, .has_spans, .take_spans, .box, .new_sides(sides),
        .new_divisors(divisors), .new_quotients(quotients), .new_remainders(remainders),
        .new_quotient_steps(quotient_steps), .new_remainder_steps(remainder_steps), .has_row, .take_row, .row
    );

    // Iterations
    wire announces = begins && work == ANNOUNCE;
    wire is_drawn = area > 0;
    wire visits = begins && work == VISIT;
    logic scan_is_last, scan_sends;
    lane_pkg::group_t group;
    logic signed [Z_SUM_BITS-1:0] z_sum, z_step;
    span_scan #(
        .Z_SUM_BITS(Z_SUM_BITS)
    ) scan (
        .clock, .load(announces && advance), .iterate(visits && advance), .lanes, .new_left_wall(left_wall - origin_col),
        .z_sum_at_wall, .new_z_sum_per_col(z_sum_per_col), .new_z_sum_per_row(z_sum_per_row), .row, .take_row,
        .is_last(scan_is_last), .sends(scan_sends), .group, .z_sum, .z_sum_per_col(z_step)
    );
    wire sends = visits && scan_sends;
    wire is_triangle_over = ordinal[1] && ((work == VISIT && scan_is_last) || work == NOTHING);
    assign is_last = is_triangle_over && triangles_left == 32'd1;

    // What an iteration sends, each FIFO at a stage of its own
    logic command_leaves, triangle_leaves, depth_leaves, index_leaves, token_leaves;
    lane_pkg::group_t scanned_index, scanned_token;
    delay_line #(
        .BITS(2)
    ) command_line (
        .clock, .advance, .stages(command_latency), .in({sends || (announces && is_drawn), announces}),
        .out({command_leaves, triangle_leaves})
    );
    delay_line #(
        .BITS(1 + 2 * Z_SUM_BITS)
    ) fragment_depth_line (
        .clock, .advance, .stages(fragment_depth_latency), .in({sends, z_sum, z_step}),
        .out({depth_leaves, fragment_depth})
    );
    delay_line #(
        .BITS(1 + lane_pkg::GROUP_BITS)
    ) fragment_index_line (
        .clock, .advance, .stages(fragment_index_latency), .in({sends, group}), .out({index_leaves, scanned_index})
    );
    delay_line #(
        .BITS(1 + lane_pkg::GROUP_BITS)
    ) edge_token_line (
        .clock, .advance, .stages(edge_token_latency), .in({sends, group}), .out({token_leaves, scanned_token})
    );
    assign advance = state == SCAN && (!reads_vertex || vertex_has_token) && (!announces || (is_ready && area_has_room)) &&
                     (!visits || has_row) && (!command_leaves || command_has_room) && (!depth_leaves || fragment_depth_has_room) &&
                     (!index_leaves || fragment_index_has_room) && (!token_leaves || edge_token_has_room);

    // The region: rows and columns of what was sent of the window
    lane_pkg::region_t touched;
    logic has_touched;
    lane_pkg::region_t of_group;
    logic is_group_inside;
    always_comb begin
        of_group = '0;
        is_group_inside = 1'b0;
        for (int k = lane_pkg::LANES - 1; k >= 0; k = k - 1)
            if (group.mask[k] && group.col + 16'(k) >= 0 && group.col + 16'(k) < $signed({7'b0, window})) begin
                if (!is_group_inside) of_group.last_col = group.col + 16'(k);
                of_group.first_col = group.col + 16'(k);
                is_group_inside = 1'b1;
            end
        of_group.first_row = group.row;
        of_group.last_row = group.row;
        if (group.row < 0 || group.row >= $signed({7'b0, window})) is_group_inside = 1'b0;
    end
    always_ff @(posedge clock) begin
        if (state == TAKE_SAMPLE) has_touched <= 1'b0;
        else if (sends && advance && is_group_inside) begin
            has_touched <= 1'b1;
            if (!has_touched) touched <= of_group;
            else begin
                if (of_group.first_row < touched.first_row) touched.first_row <= of_group.first_row;
                if (of_group.first_col < touched.first_col) touched.first_col <= of_group.first_col;
                if (of_group.last_row > touched.last_row) touched.last_row <= of_group.last_row;
                if (of_group.last_col > touched.last_col) touched.last_col <= of_group.last_col;
            end
        end
    end
    wire faster_pkg::pixel_t corner = state == FIRST_CORNER ? (has_touched ? {touched.first_row, touched.first_col} : '0) :
                                                              (has_touched ? {touched.last_row, touched.last_col} : '1);

    // Steps outside of the loop
    wire ends_sample = state == END_SAMPLE && command_has_room && edge_token_has_room;
    wire sends_corner = (state == FIRST_CORNER || state == LAST_CORNER) && fragment_index_has_room &&
                        edge_token_has_room && region_has_room;
    assign sample_raster_read = state == TAKE_SAMPLE && sample_raster_has_token;
    assign vertex_read = reads_vertex && advance;
    assign area_write = announces && advance;
    assign command_write = (advance && command_leaves) || ends_sample;
    assign command = state != SCAN ? faster_pkg::END_OF_COMMANDS :
                     triangle_leaves ? faster_pkg::TRIANGLE : faster_pkg::FRAGMENT;
    assign fragment_depth_write = advance && depth_leaves;
    assign fragment_index_write = (advance && index_leaves) || sends_corner;
    assign fragment_index = state == SCAN ? scanned_index : {corner, lane_pkg::LANES'(0)};
    assign edge_token_write = (advance && token_leaves) || ends_sample || sends_corner;
    assign edge_token = state == SCAN ? scanned_token : state == END_SAMPLE ? '0 : {corner, lane_pkg::LANES'(0)};
    assign region_write = sends_corner;
    assign region = corner;

    logic signed [31:0] new_origin_row, new_origin_col;
    window_origin origin (
        .centre_row(sample_raster.centre_row), .centre_col(sample_raster.centre_col), .window,
        .row(new_origin_row), .col(new_origin_col)
    );
    // No image is wider than 4096 pixels: a window further off covers none of it either way.
    function automatic logic signed [15:0] clamped(input logic signed [31:0] offset);
        clamped = offset < -8192 ? -16'sd8192 : offset > 8192 ? 16'sd8192 : 16'(offset);
    endfunction

    wire [31:0] samples_ahead = 32'(setups_ahead) < sample_raster.triangles ? 32'(setups_ahead) : sample_raster.triangles;
    always_ff @(posedge clock) begin
        if (reset) begin
            state <= TAKE_SAMPLE;
        end else begin
            unique case (state)
                TAKE_SAMPLE: begin
                    origin_row <= clamped(new_origin_row);
                    origin_col <= clamped(new_origin_col);
                    triangles_left <= sample_raster.triangles;
                    vertices_left <= (sample_raster.triangles << 1) + sample_raster.triangles;
                    reads_only_left <= (samples_ahead << 1) + samples_ahead;
                    vertex_number <= '0;
                    work <= READ_ONLY;
                    if (sample_raster_read) state <= sample_raster.triangles == '0 ? SCAN_DONE : SCAN;
                end
                SCAN: if (advance && ends) state <= SCAN_DONE;
                SCAN_DONE: state <= END_SAMPLE;
                END_SAMPLE: if (ends_sample) state <= sends_region ? FIRST_CORNER : TAKE_SAMPLE;
                FIRST_CORNER: if (sends_corner) state <= LAST_CORNER;
                default: if (sends_corner) state <= TAKE_SAMPLE;
            endcase
            if (begins && advance) begin
                steps_left <= scan_loop.ii - 8'd1;
                has_third <= reads_third;
                if (reads_vertex) begin
                    {v0, v1} <= {v1, vertex};
                    vertex_number <= vertex_number == 2'd2 ? 2'd0 : vertex_number + 2'd1;
                    vertices_left <= vertices_left - 32'd1;
                    if (reads_third) read_triangle <= {v0, v1, vertex};
                end
                ordinal <= ordinal == 2'd3 ? 2'd3 : ordinal + 2'd1;
                unique case (work)
                    READ_ONLY: begin
                        reads_only_left <= reads_only_left - 32'd1;
                        if (reads_only_left == 32'd1) work <= ANNOUNCE;
                        ordinal <= '0;
                    end
                    ANNOUNCE: work <= is_drawn ? VISIT : NOTHING;
                    VISIT: if (scan_is_last) work <= NOTHING;
                    default: ;
                endcase
                if (is_triangle_over) begin
                    work <= ANNOUNCE;
                    ordinal <= '0;
                    triangles_left <= triangles_left - 32'd1;
                end
            end else if (advance) begin
                steps_left <= steps_left == '0 ? '0 : steps_left - 8'd1;
            end
        end
    end

    wire unused = &{1'b0, sample_raster.sample};
endmodule
