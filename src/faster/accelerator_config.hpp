#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "common/edge_extraction_config.hpp"
#include "common/edge_map_config.hpp"
#include "common/fixed_point.hpp"
#include "common/flow.hpp"
#include "common/inlier_unit_config.hpp"
#include "common/rasterizer_config.hpp"
#include "faster/machine.hpp"
#include "kernel/base/cycles.hpp"
#include "kernel/machine/partition_config.hpp"

namespace faster {

/// How a FIFO is built (SPEC section 3): decides its capacity and read latency.
enum class FifoKind { automatic, shift_register, memory };

/// One FIFO; keys `accelerator.fifos.NAME.*`.
struct FifoConfig {
    std::uint64_t depth = 2;  ///< tokens, >= 1; HLS default
    FifoKind kind = FifoKind::automatic;
    Cycles write_latency =
        0;  ///< stage of the writing loop in which the token leaves, < its depth; 0 where not written in a loop
};

/// One pipelined loop; keys `accelerator.loops.MODULE.LOOP.*`.
struct LoopConfig {
    Cycles ii = 1;             ///< initiation interval asked for by the pragma, >= 1
    Cycles recurrence_ii = 1;  ///< initiation interval that a loop-carried dependence demands, >= 1
    Cycles depth = 1;          ///< pipeline stages, >= 1
};

/// One block RAM; keys `accelerator.brams.NAME.*`.
struct BramConfig {
    std::uint64_t ports = 2;  ///< accesses per cycle and bank, >= 1
    PartitionConfig partition;
};

/// The machine: keys `accelerator.*`. Defaults are the thesis's final design as SPEC section 3 times it.
struct AcceleratorConfig {
    std::string architecture = "faster";  ///< name of the preset that the other keys start from
    std::uint64_t raster_cores = 10;
    int window = 200;  ///< side of the square window [px]
    double clock_mhz = 200.0;
    FractionBits fraction_bits;
    Flow flow = Flow::faster;
    EdgeMapConfig edge_map;
    EdgeExtractionConfig edge_extraction;
    RasterizerConfig rasterizer;
    InlierUnitConfig inlier_unit;
    Cycles setup_depth = 12;  ///< loops.rasterizer.setup.depth
    std::array<FifoConfig, fifo_count> fifos = default_fifos();
    std::array<LoopConfig, keyed_loop_count> loops = default_loops();
    std::array<BramConfig, bram_count> brams;

    FifoConfig const& fifo(FifoId id) const { return fifos[index_of(id)]; }
    FifoConfig& fifo(FifoId id) { return fifos[index_of(id)]; }
    LoopConfig const& loop(LoopId id) const { return loops[index_of(configured_as(id))]; }
    LoopConfig& loop(LoopId id) { return loops[index_of(configured_as(id))]; }
    BramConfig const& bram(BramId id) const { return brams[index_of(id)]; }
    BramConfig& bram(BramId id) { return brams[index_of(id)]; }

    static std::array<FifoConfig, fifo_count> default_fifos();
    static std::array<LoopConfig, keyed_loop_count> default_loops();
};

}  // namespace faster
