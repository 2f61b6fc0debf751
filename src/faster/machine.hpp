#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace faster {

/// The parts of one raster core by the names of SPEC section 1, in the row order of the output files (SPEC section 4).
enum class FifoId : std::size_t {
    sample_vertex,
    sample_raster,
    sample_observation,
    vertex,
    area,
    area_reciprocal,
    command,
    fragment_depth,
    fragment_index,
    edge_token,
    edge_map,
    observed_depth,
    observed_edge,
    result,
    region,       ///< sweep_region: touched
    valid_depth,  ///< likewise
    map_full,     ///< edge_map.buffers: 2
    map_free,     ///< likewise
    depth_full,   ///< inlier_unit.buffers: 2
    depth_free,   ///< likewise
};
constexpr std::size_t fifo_count = 20;
constexpr std::array<char const*, fifo_count> fifo_names{
    "sample_vertex",   "sample_raster",  "sample_observation", "vertex",         "area",
    "area_reciprocal", "command",        "fragment_depth",     "fragment_index", "edge_token",
    "edge_map",        "observed_depth", "observed_edge",      "result",         "region",
    "valid_depth",     "map_full",       "map_free",           "depth_full",     "depth_free"};

enum class ModuleId : std::size_t {
    sample_dispatcher,
    vertex_transform,
    rasterizer,
    area_reciprocal,
    edge_map_builder,
    observation_reader,
    inlier_unit,
    result_collector,
    edge_map_output,  ///< edge_map.buffers: 2
    inlier_sweep,     ///< inlier_unit.buffers: 2
};
constexpr std::size_t module_count = 10;
constexpr std::array<char const*, module_count> module_names{
    "sample_dispatcher",  "vertex_transform", "rasterizer",       "area_reciprocal", "edge_map_builder",
    "observation_reader", "inlier_unit",      "result_collector", "edge_map_output", "inlier_sweep"};

/// Between which modules a FIFO stands, unless Parts say otherwise.
struct FifoEnds {
    ModuleId writer;
    ModuleId reader;
};
constexpr std::array<FifoEnds, fifo_count> fifo_ends{{{ModuleId::sample_dispatcher, ModuleId::vertex_transform},
                                                      {ModuleId::sample_dispatcher, ModuleId::rasterizer},
                                                      {ModuleId::sample_dispatcher, ModuleId::observation_reader},
                                                      {ModuleId::vertex_transform, ModuleId::rasterizer},
                                                      {ModuleId::rasterizer, ModuleId::area_reciprocal},
                                                      {ModuleId::area_reciprocal, ModuleId::inlier_unit},
                                                      {ModuleId::rasterizer, ModuleId::inlier_unit},
                                                      {ModuleId::rasterizer, ModuleId::inlier_unit},
                                                      {ModuleId::rasterizer, ModuleId::inlier_unit},
                                                      {ModuleId::rasterizer, ModuleId::edge_map_builder},
                                                      {ModuleId::edge_map_builder, ModuleId::inlier_unit},
                                                      {ModuleId::observation_reader, ModuleId::inlier_unit},
                                                      {ModuleId::observation_reader, ModuleId::inlier_unit},
                                                      {ModuleId::inlier_unit, ModuleId::result_collector},
                                                      {ModuleId::rasterizer, ModuleId::observation_reader},
                                                      {ModuleId::observation_reader, ModuleId::result_collector},
                                                      {ModuleId::edge_map_builder, ModuleId::edge_map_output},
                                                      {ModuleId::edge_map_output, ModuleId::edge_map_builder},
                                                      {ModuleId::inlier_unit, ModuleId::inlier_sweep},
                                                      {ModuleId::inlier_sweep, ModuleId::inlier_unit}}};

/// Pipelined loops, in the order of SPEC section 3. The rasterizer's `setup` is no loop: see AcceleratorConfig.
enum class LoopId : std::size_t {
    vertex,
    scan,
    edge_clear,
    token,
    output,
    read,
    depth_clear,
    fragment,
    sweep,
    extract,          ///< flow fpga_grip
    buffered_output,  ///< output, sweep and extract in processes of their own
    buffered_sweep,
    buffered_extract,
};
constexpr std::size_t loop_count = 13;
/// Loops with keys of their own: the first. The others are timed by the keys of the loops they replace.
constexpr std::size_t keyed_loop_count = 10;

/// Where a loop stands: MODULE.NAME.
struct LoopName {
    ModuleId module;
    char const* name;
};
constexpr std::array<LoopName, loop_count> loop_names{{{ModuleId::vertex_transform, "vertex"},
                                                       {ModuleId::rasterizer, "scan"},
                                                       {ModuleId::edge_map_builder, "clear"},
                                                       {ModuleId::edge_map_builder, "token"},
                                                       {ModuleId::edge_map_builder, "output"},
                                                       {ModuleId::observation_reader, "read"},
                                                       {ModuleId::inlier_unit, "clear"},
                                                       {ModuleId::inlier_unit, "fragment"},
                                                       {ModuleId::inlier_unit, "sweep"},
                                                       {ModuleId::inlier_unit, "extract"},
                                                       {ModuleId::edge_map_output, "output"},
                                                       {ModuleId::inlier_sweep, "sweep"},
                                                       {ModuleId::inlier_sweep, "extract"}}};

/// The loop whose keys `accelerator.loops.MODULE.NAME.*` time a loop. A loop keeps its keys when it moves to a process
/// of its own.
constexpr LoopId configured_as(LoopId id) {
    switch (id) {
        case LoopId::buffered_output:
            return LoopId::output;
        case LoopId::buffered_sweep:
            return LoopId::sweep;
        case LoopId::buffered_extract:
            return LoopId::extract;
        default:
            return id;
    }
}

/// A loop of a module by its own name, which must be one.
inline LoopId loop_named(ModuleId module, std::string_view name) {
    std::size_t i = 0;
    while (loop_names[i].module != module || loop_names[i].name != name)
        ++i;
    return static_cast<LoopId>(i);
}

enum class BramId : std::size_t { edge_map, object_map, depth_buffer };
constexpr std::size_t bram_count = 3;
constexpr std::array<char const*, bram_count> bram_names{"edge_map", "object_map", "depth_buffer"};

template <class Id> constexpr std::size_t index_of(Id id) { return static_cast<std::size_t>(id); }
inline char const* name_of(FifoId id) { return fifo_names[index_of(id)]; }
inline char const* name_of(ModuleId id) { return module_names[index_of(id)]; }
inline char const* name_of(BramId id) { return bram_names[index_of(id)]; }

}  // namespace faster
