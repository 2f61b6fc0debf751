#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "dataflow/core/machine/machine.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::rtl {

/// FIFOs of the twins, in their order: that of fifos.csv. The first are those of rtl/cosimulated_core.sv.
inline constexpr std::array<char const*, 20> twin_fifos{
    "sample_vertex",   "sample_raster",  "sample_observation", "vertex",         "area",
    "area_reciprocal", "command",        "fragment_depth",     "fragment_index", "edge_token",
    "edge_map",        "observed_depth", "observed_edge",      "result",         "region",
    "valid_depth",     "map_full",       "map_free",           "depth_full",     "depth_free"};
/// Its loops, in the order of docs/timing-model.md#sources-of-time.
inline constexpr std::array<char const*, 9> twin_loops{
    "vertex_transform.vertex", "rasterizer.scan",         "edge_map_builder.clear",
    "edge_map_builder.token",  "edge_map_builder.output", "observation_reader.read",
    "inlier_unit.clear",       "inlier_unit.fragment",    "inlier_unit.sweep"};

/// A configuration as the twin is given it: keys, from which it works out intervals and kinds by itself.
struct TwinSettings {
    struct Fifo {
        std::uint8_t kind = 0;  ///< auto, shift_register, memory
        std::uint16_t depth = 2;
        std::uint8_t write_latency = 0;
    };
    struct Loop {
        std::uint8_t target = 1;
        std::uint8_t recurrence = 1;
        std::uint8_t depth = 1;
    };
    std::uint16_t width = 0;
    std::uint16_t height = 0;
    std::uint16_t window = 0;
    FractionBits fraction;
    bool sends_edges = true;
    bool is_inner_border = false;
    bool flushes_last = false;
    bool forwards = true;  ///< every read sees all earlier writes; else as `inter false` makes it
    bool edge_map_clears_on_read_out = false;
    bool inlier_unit_clears_on_read_out = false;
    bool has_line_buffers = false;
    bool counts_hidden = false;
    bool is_flattened = false;  ///< the loop `fragment`
    bool reciprocals_squeeze = false;
    std::uint8_t area_reciprocal_interval = 1;
    std::array<std::uint8_t, 3> ports{2, 2, 2};  ///< of edge_map, object_map, depth_buffer
    std::uint8_t setup_cycles = 12;
    std::uint8_t fifo_rules = 0;  ///< spec, vivado_hls, vitis_hls
    std::array<Loop, twin_loops.size()> loops;
    std::array<Fifo, twin_fifos.size()> fifos;

    /// Of the twin with lanes (rtl/lanes), which has one way of most of the above.
    struct Lanes {
        std::uint8_t scan = 1;
        std::uint8_t sweep = 1;
        std::uint8_t object_map_banks = 1;
        std::uint8_t depth_buffer_banks = 1;
        std::uint8_t setups_ahead = 1;
        bool sweeps_touched = false;
        bool has_two_maps = false;
        bool has_two_depth_buffers = false;
    };
    std::optional<Lanes> lanes;
};

/// Of a configuration and its machine. Throws InputError if it asks for what the twin does not have, naming the key:
/// another design, more places than the twin has, or a stage in which no hardware could do it.
TwinSettings twin_settings(AcceleratorConfig const& config, Machine const& machine, int width, int height);

}  // namespace faster::rtl
