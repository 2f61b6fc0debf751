#pragma once
#include <vector>

#include "dataflow/tools/sizing/cheapest_choice.hpp"
#include "dataflow/tools/sizing/core_times.hpp"

namespace dataflow::sizing {

/// The FIFOs as they are configured: how they may be built.
struct FifoFrame {
    std::vector<std::size_t> freezing;  ///< numbers, see freezing_fifos()
    Freedoms freedoms;
    CostWeights weights;

    FifoFrame(Machine const& machine, CostWeights const& weights);
    std::size_t fifos() const { return freedoms.size(); }
};

/// Depths beyond which nothing gets faster, and what they take: the reference of all bounds.
struct Unbounded {
    Choice choice;
    Cycles total_cycles = 0;
    std::size_t last_core = 0;  ///< which takes as long
};

/// Deepens FIFOs of the configured kinds, `auto` ones as memories, until the critical path of the core that ends last
/// waits for no room, and no pipeline ever freezes. Then no depth whatsoever is faster (unless `most_depth` is
/// reached, or cores share a memory: then some other may be).
Unbounded unbounded(FifoFrame const& frame, CoreTimes& times, unsigned jobs);

/// An unbounded `auto` FIFO that was never filled is a memory so shallow that it would be a shift register: one that is
/// no slower.
FifoChoice as_it_may_be(FifoChoice const& choice, FifoFreedom const& fifo);

}  // namespace dataflow::sizing
