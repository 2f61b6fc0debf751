#pragma once
#include <array>
#include <cstddef>
#include <string>

namespace faster::testing {

// The parts of a raster core by the names of docs/architecture.md#the-machine, in the row order of the output files
// (docs/formats.md#output-of-a-run): the tests' own list, which knows nothing of the modules' descriptions. A part's
// number is the same whatever parts a configuration has.

/// What all kinds of parts are alike in.
template <class Kind> struct PartId {
    std::size_t number = 0;
    char const* name = "";

    friend constexpr bool operator==(Kind const& a, Kind const& b) { return a.number == b.number; }
    friend constexpr bool operator!=(Kind const& a, Kind const& b) { return a.number != b.number; }
    friend constexpr bool operator<(Kind const& a, Kind const& b) { return a.number < b.number; }
    friend constexpr std::size_t index_of(Kind const& id) { return id.number; }
    friend constexpr char const* name_of(Kind const& id) { return id.name; }
};

struct ModuleId : PartId<ModuleId> {
    operator std::string() const { return name; }  // NOLINT: as a configuration names it

    static ModuleId const sample_dispatcher, vertex_transform, rasterizer, area_reciprocal, edge_map_builder,
        observation_reader, inlier_unit, result_collector,
        edge_map_output,  ///< edge_map.buffers: 2
        inlier_sweep;     ///< inlier_unit.buffers: 2
};
inline constexpr ModuleId ModuleId::sample_dispatcher{{0, "sample_dispatcher"}};
inline constexpr ModuleId ModuleId::vertex_transform{{1, "vertex_transform"}};
inline constexpr ModuleId ModuleId::rasterizer{{2, "rasterizer"}};
inline constexpr ModuleId ModuleId::area_reciprocal{{3, "area_reciprocal"}};
inline constexpr ModuleId ModuleId::edge_map_builder{{4, "edge_map_builder"}};
inline constexpr ModuleId ModuleId::observation_reader{{5, "observation_reader"}};
inline constexpr ModuleId ModuleId::inlier_unit{{6, "inlier_unit"}};
inline constexpr ModuleId ModuleId::result_collector{{7, "result_collector"}};
inline constexpr ModuleId ModuleId::edge_map_output{{8, "edge_map_output"}};
inline constexpr ModuleId ModuleId::inlier_sweep{{9, "inlier_sweep"}};

constexpr std::size_t module_count = 10;
constexpr std::array<ModuleId, module_count> module_ids{
    ModuleId::sample_dispatcher, ModuleId::vertex_transform,   ModuleId::rasterizer,  ModuleId::area_reciprocal,
    ModuleId::edge_map_builder,  ModuleId::observation_reader, ModuleId::inlier_unit, ModuleId::result_collector,
    ModuleId::edge_map_output,   ModuleId::inlier_sweep};

struct FifoId : PartId<FifoId> {
    operator std::string() const { return name; }  // NOLINT: as a configuration names it

    static FifoId const sample_vertex, sample_raster, sample_observation, vertex, area, area_reciprocal, command,
        fragment_depth, fragment_index, edge_token, edge_map, observed_depth, observed_edge, result,
        region,       ///< sweep_region: touched
        valid_depth,  ///< likewise
        map_full,     ///< edge_map.buffers: 2
        map_free,     ///< likewise
        depth_full,   ///< inlier_unit.buffers: 2
        depth_free;   ///< likewise
};
inline constexpr FifoId FifoId::sample_vertex{{0, "sample_vertex"}};
inline constexpr FifoId FifoId::sample_raster{{1, "sample_raster"}};
inline constexpr FifoId FifoId::sample_observation{{2, "sample_observation"}};
inline constexpr FifoId FifoId::vertex{{3, "vertex"}};
inline constexpr FifoId FifoId::area{{4, "area"}};
inline constexpr FifoId FifoId::area_reciprocal{{5, "area_reciprocal"}};
inline constexpr FifoId FifoId::command{{6, "command"}};
inline constexpr FifoId FifoId::fragment_depth{{7, "fragment_depth"}};
inline constexpr FifoId FifoId::fragment_index{{8, "fragment_index"}};
inline constexpr FifoId FifoId::edge_token{{9, "edge_token"}};
inline constexpr FifoId FifoId::edge_map{{10, "edge_map"}};
inline constexpr FifoId FifoId::observed_depth{{11, "observed_depth"}};
inline constexpr FifoId FifoId::observed_edge{{12, "observed_edge"}};
inline constexpr FifoId FifoId::result{{13, "result"}};
inline constexpr FifoId FifoId::region{{14, "region"}};
inline constexpr FifoId FifoId::valid_depth{{15, "valid_depth"}};
inline constexpr FifoId FifoId::map_full{{16, "map_full"}};
inline constexpr FifoId FifoId::map_free{{17, "map_free"}};
inline constexpr FifoId FifoId::depth_full{{18, "depth_full"}};
inline constexpr FifoId FifoId::depth_free{{19, "depth_free"}};

constexpr std::size_t fifo_count = 20;
constexpr std::array<FifoId, fifo_count> fifo_ids{
    FifoId::sample_vertex, FifoId::sample_raster,  FifoId::sample_observation,
    FifoId::vertex,        FifoId::area,           FifoId::area_reciprocal,
    FifoId::command,       FifoId::fragment_depth, FifoId::fragment_index,
    FifoId::edge_token,    FifoId::edge_map,       FifoId::observed_depth,
    FifoId::observed_edge, FifoId::result,         FifoId::region,
    FifoId::valid_depth,   FifoId::map_full,       FifoId::map_free,
    FifoId::depth_full,    FifoId::depth_free};

/// Pipelined loops, in the order of docs/timing-model.md#sources-of-time. As a string: the loop whose keys
/// `accelerator.loops.MODULE.LOOP.*` time it. A loop keeps its keys when it moves to a process of its own.
struct LoopId : PartId<LoopId> {
    ModuleId module;
    char const* keys = "";  ///< MODULE.LOOP

    operator std::string() const { return keys; }  // NOLINT: as a configuration names it

    static LoopId const vertex, scan, edge_clear, token, output, read, depth_clear, fragment, sweep,
        extract,          ///< flow fpga_grip
        buffered_output,  ///< output, sweep and extract in processes of their own
        buffered_sweep, buffered_extract;
};
inline constexpr LoopId LoopId::vertex{{0, "vertex"}, ModuleId::vertex_transform, "vertex_transform.vertex"};
inline constexpr LoopId LoopId::scan{{1, "scan"}, ModuleId::rasterizer, "rasterizer.scan"};
inline constexpr LoopId LoopId::edge_clear{{2, "clear"}, ModuleId::edge_map_builder, "edge_map_builder.clear"};
inline constexpr LoopId LoopId::token{{3, "token"}, ModuleId::edge_map_builder, "edge_map_builder.token"};
inline constexpr LoopId LoopId::output{{4, "output"}, ModuleId::edge_map_builder, "edge_map_builder.output"};
inline constexpr LoopId LoopId::read{{5, "read"}, ModuleId::observation_reader, "observation_reader.read"};
inline constexpr LoopId LoopId::depth_clear{{6, "clear"}, ModuleId::inlier_unit, "inlier_unit.clear"};
inline constexpr LoopId LoopId::fragment{{7, "fragment"}, ModuleId::inlier_unit, "inlier_unit.fragment"};
inline constexpr LoopId LoopId::sweep{{8, "sweep"}, ModuleId::inlier_unit, "inlier_unit.sweep"};
inline constexpr LoopId LoopId::extract{{9, "extract"}, ModuleId::inlier_unit, "inlier_unit.extract"};
inline constexpr LoopId LoopId::buffered_output{{10, "output"}, ModuleId::edge_map_output, "edge_map_builder.output"};
inline constexpr LoopId LoopId::buffered_sweep{{11, "sweep"}, ModuleId::inlier_sweep, "inlier_unit.sweep"};
inline constexpr LoopId LoopId::buffered_extract{{12, "extract"}, ModuleId::inlier_sweep, "inlier_unit.extract"};

constexpr std::size_t loop_count = 13;
constexpr std::array<LoopId, loop_count> loop_ids{
    LoopId::vertex,          LoopId::scan,    LoopId::edge_clear,      LoopId::token,
    LoopId::output,          LoopId::read,    LoopId::depth_clear,     LoopId::fragment,
    LoopId::sweep,           LoopId::extract, LoopId::buffered_output, LoopId::buffered_sweep,
    LoopId::buffered_extract};
/// Loops with keys of their own.
constexpr std::size_t keyed_loop_count = 10;
constexpr std::array<LoopId, keyed_loop_count> keyed_loop_ids{
    LoopId::vertex, LoopId::scan,        LoopId::edge_clear, LoopId::token, LoopId::output,
    LoopId::read,   LoopId::depth_clear, LoopId::fragment,   LoopId::sweep, LoopId::extract};

struct BramId : PartId<BramId> {
    operator std::string() const { return name; }  // NOLINT: as a configuration names it

    static BramId const edge_map, object_map, depth_buffer,
        observation;  ///< memory.observation: on_chip; shared by cores, so none of a core's own
};
inline constexpr BramId BramId::edge_map{{0, "edge_map"}};
inline constexpr BramId BramId::object_map{{1, "object_map"}};
inline constexpr BramId BramId::depth_buffer{{2, "depth_buffer"}};
inline constexpr BramId BramId::observation{{3, "observation"}};

constexpr std::size_t bram_count = 3;
constexpr std::array<BramId, bram_count> bram_ids{BramId::edge_map, BramId::object_map, BramId::depth_buffer};

}  // namespace faster::testing
