// Types of a core that works on pixels of a row side by side, in lanes: what faster_pkg has none for.
package lane_pkg;
    localparam int LANES = 10;  // at most, of a scan or a sweep; and banks of a memory
    localparam int GROUP_BITS = 32 + LANES;
    localparam int REGION_BITS = 64;
    localparam int FULL_BITS = 1 + 32 + REGION_BITS;
    typedef logic [3:0] lanes_t;

    // Pixels of a row relative to the window, which they may lie outside of: bit k of the mask is column col + k. Without
    // a bit: the end of a sample, or a corner of its region.
    typedef struct packed {
        logic signed [15:0] row;
        logic signed [15:0] col;
        logic [LANES-1:0]   mask;
    } group_t;

    // The pixels that a sample has drawn lie in this box; (0, 0) and (-1, -1): there are none.
    typedef struct packed {
        faster_pkg::pixel_t first;
        faster_pkg::pixel_t last;
    } region_t;

    // A buffer that is drawn.
    typedef struct packed {
        logic        number;
        logic [31:0] valid_raster;
        region_t     region;
    } full_t;

    // Everything that a core is configured by. Loops and FIFOs are those of faster_pkg::settings_t.
    typedef struct packed {
        faster_pkg::settings_t common;
        lanes_t                scan_lanes;
        lanes_t                sweep_lanes;
        lanes_t                object_map_banks;  // cyclic, of columns: multiples of both kinds of lanes
        lanes_t                depth_buffer_banks;
        logic [4:0]            setups_ahead;  // at least 1
        logic                  sweeps_touched;  // the region only
        logic                  has_two_maps;
        logic                  has_two_depth_buffers;
        faster_pkg::fifo_t     region;
        faster_pkg::fifo_t     valid_depth;
        faster_pkg::fifo_t     map_full;
        faster_pkg::fifo_t     map_free;
        faster_pkg::fifo_t     depth_full;
        faster_pkg::fifo_t     depth_free;
    } settings_t;
endpackage
