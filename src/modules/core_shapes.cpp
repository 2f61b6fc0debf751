#include "modules/core_shapes.hpp"

#include <algorithm>

#include "faster/edge_map_design.hpp"
#include "faster/loop_accesses.hpp"
#include "faster/parts.hpp"
#include "kernel/machine/bank_partition.hpp"

namespace faster {

FifoKind resolved_kind(FifoConfig const& config) {
    if (config.kind != FifoKind::automatic)
        return config.kind;
    return config.depth <= 2 ? FifoKind::shift_register : FifoKind::memory;
}

timing::FifoShape fifo_shape(FifoId id, AcceleratorConfig const& config) {
    FifoConfig const& fifo = config.fifo(id);
    bool const memory = resolved_kind(fifo) == FifoKind::memory;
    timing::FifoShape shape;
    shape.name = name_of(id);
    shape.capacity = memory ? fifo.depth + 1 : fifo.depth;
    shape.read_latency = memory ? 2 : 1;
    shape.write_latency = fifo.write_latency;
    // The reciprocal unit flushes: its stages drain into the FIFO on their own, whatever the unit reads.
    shape.issue_latency = id == FifoId::area_reciprocal ? fifo.write_latency : 0;
    return shape;
}

timing::InitiationInterval initiation_interval(LoopId id, AcceleratorConfig const& config) {
    EdgeMapDesign const& design = design_of(config.edge_map.algorithm);
    std::vector<timing::BramDemand> demands;
    for (MemoryAccess const& access : loop_accesses(id, config)) {
        BramConfig const& bram = config.bram(access.bram);
        BankPartition const partition(bram.partition, config.window);
        demands.push_back({name_of(access.bram), partition.accesses_per_bank(access.pattern), bram.ports});
    }
    Cycles const recurrence = id == LoopId::token ? design.token_recurrence : 1;
    return timing::schedule(config.loop(id).ii, std::max(config.loop(id).recurrence_ii, recurrence), demands);
}

Cycles loop_depth(LoopId id, AcceleratorConfig const& config) {
    EdgeExtractionConfig const& units = config.edge_extraction;
    Cycles const in_units = id == LoopId::extract ? units.square_root_latency + units.divider_latency : 0;
    return config.loop(id).depth + in_units;
}

timing::LoopShape loop_shape(LoopId id, AcceleratorConfig const& config) {
    timing::LoopShape shape;
    shape.name = loop_names[index_of(id)].name;
    shape.interval = initiation_interval(id, config);
    shape.depth = loop_depth(id, config);
    return shape;
}

timing::Lead rasterizer_and_followers(Parts const& parts) {
    auto const follower = [](ModuleId module, FifoId anchor) {
        return timing::Lead::Follower{static_cast<unsigned>(module), static_cast<unsigned>(anchor)};
    };
    timing::Lead lead{
        static_cast<unsigned>(ModuleId::rasterizer),
        {follower(ModuleId::vertex_transform, FifoId::vertex), follower(ModuleId::area_reciprocal, FifoId::area),
         follower(ModuleId::edge_map_builder, FifoId::edge_token), follower(ModuleId::inlier_unit, FifoId::command)}};
    auto const is_absent = [&parts](timing::Lead::Follower const& one) {
        return !has_part(parts, static_cast<FifoId>(one.anchor));
    };
    lead.followers.erase(std::remove_if(lead.followers.begin(), lead.followers.end(), is_absent), lead.followers.end());
    return lead;
}

}  // namespace faster
