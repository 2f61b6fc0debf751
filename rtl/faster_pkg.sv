// Types that the units of a raster core share. Numbers of cycles and places are inputs of the units, so that one
// Verilated model serves all configurations; a design has them as constants.
package faster_pkg;
    localparam int MAX_STAGES = 63;  // of a delay line

    // Widths of tokens
    localparam int HEADER_BITS = 128;
    localparam int VERTEX_BITS = 48;
    localparam int COMMAND_BITS = 2;
    localparam int PIXEL_BITS = 32;
    localparam int EDGE_TOKEN_BITS = 34;
    localparam int DEPTH_BITS = 11;  // whatever its point
    localparam int HIDDEN_BITS = 64;
    localparam int COUNTERS_BITS = 160 + HIDDEN_BITS;

    typedef logic [7:0] cycles_t;
    typedef logic [5:0] stage_t;  // 0 .. MAX_STAGES
    typedef logic [DEPTH_BITS-1:0] depth_t;
    localparam depth_t FAR = '1;

    // A pipelined loop, scheduled.
    typedef struct packed {
        cycles_t ii;     // cycles from one iteration to the next, at least 1
        cycles_t depth;  // cycles of an iteration, at least 1
    } loop_t;

    // A FIFO, its kind resolved.
    typedef struct packed {
        logic        is_memory;  // else a shift register
        logic [11:0] capacity;   // tokens that fit
    } fifo_t;

    // Fractional bits of the formats.
    typedef struct packed {
        logic [3:0] vertex_xy;
        logic [4:0] vertex_z;
        logic [5:0] area_reciprocal;
        logic [4:0] fragment_depth;
        logic [3:0] depth_buffer;
    } fraction_t;

    // Everything that a raster core is configured by.
    typedef struct packed {
        logic [15:0] width;  // of the image
        logic [15:0] height;
        logic [8:0]  window;  // at most 255
        fraction_t   fraction;
        logic        sends_edges;  // else the scan sends tokens of covered pixels only
        logic        is_inner_border;  // else dual_map
        logic        flushes_last;
        logic        forwards_object_map;
        logic        edge_map_clears_on_read_out;
        logic        inlier_unit_clears_on_read_out;
        logic        has_line_buffers;
        logic        counts_hidden;
        logic        fragment_loop_is_flattened;
        logic        forwards_depth_buffer;
        logic        reciprocals_squeeze;
        cycles_t     area_reciprocal_interval;
        logic [2:0]  depth_buffer_ports;
        cycles_t     setup_cycles;
        loop_t       vertex_loop;
        loop_t       scan_loop;
        loop_t       edge_clear_loop;
        loop_t       token_loop;
        loop_t       output_loop;
        loop_t       read_loop;
        loop_t       depth_clear_loop;
        loop_t       fragment_loop;
        loop_t       sweep_loop;
        stage_t      vertex_latency;
        stage_t      area_reciprocal_latency;
        stage_t      command_latency;
        stage_t      fragment_depth_latency;
        stage_t      fragment_index_latency;
        stage_t      edge_token_latency;
        stage_t      edge_map_latency;
        stage_t      observed_depth_latency;
        stage_t      observed_edge_latency;
        fifo_t       sample_vertex;
        fifo_t       sample_raster;
        fifo_t       sample_observation;
        fifo_t       vertex;
        fifo_t       area;
        fifo_t       area_reciprocal;
        fifo_t       command;
        fifo_t       fragment_depth;
        fifo_t       fragment_index;
        fifo_t       edge_token;
        fifo_t       edge_map;
        fifo_t       observed_depth;
        fifo_t       observed_edge;
        fifo_t       result;
    } settings_t;

    // Tokens.
    typedef struct packed {
        logic [31:0]        sample;
        logic signed [31:0] centre_row;
        logic signed [31:0] centre_col;
        logic [31:0]        triangles;
    } header_t;

    typedef struct packed {
        logic signed [15:0] x;
        logic signed [15:0] y;
        logic [15:0]        z;
    } vertex_t;

    typedef enum logic [1:0] {TRIANGLE, FRAGMENT, END_OF_COMMANDS} command_t;

    // A pixel relative to the window, which it may lie outside of.
    typedef struct packed {
        logic signed [15:0] row;
        logic signed [15:0] col;
    } pixel_t;

    typedef enum logic [1:0] {EDGE, OBJECT, END_OF_TOKENS} edge_kind_t;

    typedef struct packed {
        edge_kind_t kind;
        pixel_t     pixel;
    } edge_token_t;

    // Of pixels in front of which something was measured, and the box of the others; 0: there are none.
    typedef struct packed {
        logic [31:0] count;
        logic [7:0]  top;
        logic [7:0]  left;
        logic [7:0]  bottom;
        logic [7:0]  right;
    } hidden_t;

    typedef struct packed {
        logic [31:0] valid_raster;
        logic [31:0] valid_depth;
        logic [31:0] inlier;
        logic [31:0] valid_edge;
        logic [31:0] edge_inlier;
        hidden_t     hidden;
    } counters_t;

    typedef struct packed {
        depth_t depth;
        logic   edge_bit;
    } observation_t;
endpackage
