#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "faster/accelerator_config.hpp"
#include "kernel/sizing/fifo_cost.hpp"

namespace faster::sizing {

/// How one FIFO is built: a resolved kind and a depth. What it means for time is a capacity and a read latency (SPEC
/// section 3); more of the first and less of the second never makes a run longer.
struct FifoChoice {
    FifoKind kind = FifoKind::shift_register;
    std::uint64_t depth = 1;

    std::uint64_t capacity() const { return kind == FifoKind::memory ? depth + 1 : depth; }
    Cycles read_latency() const { return kind == FifoKind::memory ? 2 : 1; }
    bool operator==(FifoChoice const& other) const { return kind == other.kind && depth == other.depth; }
    bool operator<(FifoChoice const& other) const {
        return kind != other.kind ? kind < other.kind : depth < other.depth;
    }
};

/// All FIFOs of a core, which all cores have alike.
using Choice = std::array<FifoChoice, fifo_count>;

/// The deepest that the keys accept.
constexpr std::uint64_t most_depth = 1U << 20;

/// How a FIFO of a configured kind is built with some depth: `auto` is decided by the depth.
FifoChoice choice_of(FifoKind configured, std::uint64_t depth);
/// The choice of a configuration.
Choice choice_of(AcceleratorConfig const& config);
/// The configuration with another choice.
AcceleratorConfig with_choice(AcceleratorConfig config, Choice const& choice);

/// The deepest choice of a kind that some primitives hold.
struct Level {
    FifoChoice choice;
    Primitives primitives;
    double cost = 0;  ///< in LUTs
};

/// The levels of a FIFO of a configured kind, the cheapest first. No deeper than `depth`.
std::vector<Level> levels_of(FifoKind configured, unsigned bits, std::uint64_t depth, CostWeights const& weights);

}  // namespace faster::sizing
