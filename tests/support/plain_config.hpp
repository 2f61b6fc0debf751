#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/memory_twin.hpp"
#include "support/parts.hpp"
#include "support/token_bits.hpp"

namespace faster::testing {

// What a configuration asks of its parts, as plain values: what its settings say, or else the default of
// docs/timing-model.md, which the tests state themselves.

struct FifoConfig {
    std::uint64_t depth = 2;  ///< tokens; HLS default
    FifoKind kind = FifoKind::automatic;
    Cycles write_latency = 0;  ///< stage of the writing loop in which a token leaves; 0 where not written in a loop
    bool squeezes = false;     ///< of area_reciprocal: results in its unit close up instead of freezing
    unsigned bits = 0;         ///< of a token
    FifoGeneration rules = FifoGeneration::spec;
};

struct LoopConfig {
    Cycles ii = 1;
    Cycles recurrence_ii = 1;
    Cycles depth = 1;  ///< pipeline stages
};

struct BramConfig {
    std::uint64_t ports = 2;  ///< accesses per cycle and bank
    PartitionConfig partition;
};

inline Cycles default_write_latency(FifoId fifo) {
    constexpr std::array<Cycles, fifo_count> stages{0, 0, 0, 40, 0, 36, 7, 7, 7, 7, 2, 4, 4, 0, 0, 0, 0, 0, 0, 0};
    return stages[index_of(fifo)];
}

inline Cycles default_depth(LoopId loop) {
    constexpr std::array<Cycles, loop_count> stages{41, 8, 2, 4, 3, 5, 2, 10, 8, 12, 3, 8, 12};
    return stages[index_of(loop)];
}

inline FifoConfig fifo_of(AcceleratorConfig const& config, FifoId id) {
    FifoSettings const asked = config.fifo(id);
    FifoConfig fifo;
    fifo.depth = asked.depth.value_or(fifo.depth);
    fifo.kind = asked.kind.value_or(fifo.kind);
    fifo.write_latency = asked.write_latency.value_or(default_write_latency(id));
    fifo.squeezes = asked.when_full == WhenFull::squeeze;
    fifo.bits = token_bits(id, config);
    fifo.rules = config.fifo_rules;
    return fifo;
}

inline LoopConfig loop_of(AcceleratorConfig const& config, LoopId id) {
    LoopSettings const asked = config.loop(id);
    LoopConfig loop;
    loop.ii = asked.ii.value_or(loop.ii);
    loop.recurrence_ii = asked.recurrence_ii.value_or(loop.recurrence_ii);
    loop.depth = asked.depth.value_or(default_depth(id));
    return loop;
}

inline BramConfig bram_of(AcceleratorConfig const& config, BramId id) {
    auto const asked = config.memories.find(id);
    return asked == config.memories.end() ? BramConfig{} : BramConfig{asked->second.ports, asked->second.partition};
}

/// What the loops that read what they write do to a memory, and whether they wait for each other.
struct DependenceConfig {
    Cycles read_stage = 0;
    Cycles write_stage = 0;
    bool waits = false;
};

/// docs/timing-model.md#hazards; in a pipeline too short for the stages, both are as much earlier as the write has to
/// be.
inline DependenceConfig dependence_of(AcceleratorConfig const& config, LoopId loop, BramId bram) {
    bool const is_fragment = loop == LoopId::fragment;
    std::string const name =
        std::string(is_fragment ? "inlier_unit.fragment." : "edge_map_builder.token.") + name_of(bram);
    DependenceSettings const asked = config.dependence(name);
    Cycles const read = asked.read_stage.value_or(is_fragment ? 7 : 2);
    Cycles const write = asked.write_stage.value_or(is_fragment ? 9 : 3);
    Cycles const last = loop_of(config, loop).depth - 1;
    Cycles const shift = write > last ? write - last : 0;
    return {read > shift ? read - shift : 0, write - shift, asked.hazards == HazardHandling::interlock};
}

/// Cycles from the area of a drawn triangle to the next area.
inline Cycles reciprocal_interval(AcceleratorConfig const& config) {
    return config.number("area_reciprocal.interval").value_or(1);
}

/// Cycles of the rasterizer's triangle setup, without those that spans take besides.
inline Cycles setup_depth_of(AcceleratorConfig const& config) { return config.setup("rasterizer").value_or(12); }

inline TwinMemory memory_of(AcceleratorConfig const& config) {
    ExternalMemorySettings const& asked = config.external_memory;
    MemoryPlacement const& placement = config.memory_placement;
    TwinMemory memory;
    memory.is_axi = asked.model == MemoryModel::axi;
    memory.ports = asked.ports;
    memory.port_bytes = asked.port_bytes;
    memory.burst_bytes = asked.burst_bytes;
    memory.outstanding = asked.outstanding;
    memory.request_cycles = asked.request_cycles;
    memory.read_latency_ns = asked.read_latency_ns;
    memory.dram_gb_per_s = asked.dram_gb_per_s;
    memory.dram_efficiency = asked.dram_efficiency;
    memory.prefetch = asked.prefetch;
    memory.mesh_on_chip = placement.mesh == Placement::on_chip;
    memory.observation_on_chip = placement.observation == Placement::on_chip;
    memory.observation_copies = placement.observation_copies;
    memory.mesh_address = placement.mesh_address;
    memory.image_address = placement.image_address;
    memory.table_address = placement.table_address;
    memory.header_address = placement.header_address;
    memory.result_address = placement.result_address;
    return memory;
}

}  // namespace faster::testing
