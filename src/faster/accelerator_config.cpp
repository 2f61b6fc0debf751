#include "faster/accelerator_config.hpp"

namespace faster {

std::array<FifoConfig, fifo_count> AcceleratorConfig::default_fifos() {
    std::array<FifoConfig, fifo_count> fifos;
    auto const written_in_stage = [&fifos](FifoId id, Cycles stage) { fifos[index_of(id)].write_latency = stage; };
    written_in_stage(FifoId::vertex, 40);
    written_in_stage(FifoId::area_reciprocal, 36);
    written_in_stage(FifoId::command, 7);
    written_in_stage(FifoId::fragment_depth, 7);
    written_in_stage(FifoId::fragment_index, 7);
    written_in_stage(FifoId::edge_token, 7);
    written_in_stage(FifoId::edge_map, 2);
    written_in_stage(FifoId::observed_depth, 4);
    written_in_stage(FifoId::observed_edge, 4);
    return fifos;
}

std::array<LoopConfig, keyed_loop_count> AcceleratorConfig::default_loops() {
    std::array<LoopConfig, keyed_loop_count> loops;
    auto const depth = [&loops](LoopId id, Cycles stages) { loops[index_of(id)].depth = stages; };
    depth(LoopId::vertex, 41);
    depth(LoopId::scan, 8);
    depth(LoopId::edge_clear, 2);
    depth(LoopId::token, 4);
    depth(LoopId::output, 3);
    depth(LoopId::read, 5);
    depth(LoopId::depth_clear, 2);
    depth(LoopId::fragment, 10);
    depth(LoopId::sweep, 8);
    depth(LoopId::extract, 12);
    return loops;
}

}  // namespace faster
