// Everything that a core with lanes is configured by. Apart from lane_pkg for Yosys's sake, which does not find types of
// another package in one.
package lane_settings_pkg;
    // Loops and FIFOs are those of faster_pkg::settings_t, and more.
    typedef struct packed {
        faster_pkg::settings_t common;
        lane_pkg::lanes_t      scan_lanes;
        lane_pkg::lanes_t      sweep_lanes;
        lane_pkg::lanes_t      object_map_banks;  // cyclic, of columns: multiples of both kinds of lanes
        lane_pkg::lanes_t      depth_buffer_banks;
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
