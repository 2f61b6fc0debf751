#pragma once
#include <cstdint>
#include <vector>

#include "kernel/machine/machine.hpp"
#include "kernel/sizing/fifo_cost.hpp"

namespace faster::sizing {

/// How one FIFO is built: a resolved kind and a depth. What it means for time is a capacity and a read latency (SPEC
/// section 3).
struct FifoChoice {
    FifoKind kind = FifoKind::shift_register;
    std::uint64_t depth = 1;

    std::uint64_t capacity() const { return capacity_of(kind, depth); }
    Cycles read_latency() const { return read_latency_of(kind); }
    bool operator==(FifoChoice const& other) const { return kind == other.kind && depth == other.depth; }
    bool operator<(FifoChoice const& other) const {
        return kind != other.kind ? kind < other.kind : depth < other.depth;
    }
};

/// What a FIFO has room for.
struct FifoTokens {
    unsigned bits = 0;          ///< of a token; 0: the FIFO is not there
    std::uint64_t besides = 0;  ///< tokens besides those of its depth: one per stage of a pipeline that squeezes
};

FifoTokens tokens_of(MachineFifo const& fifo);
Primitives primitives_of(FifoChoice const& choice, FifoTokens const& tokens, CostWeights const& weights);

/// All FIFOs of a core by their numbers in the machine, which all cores have alike.
using Choice = std::vector<FifoChoice>;

/// The deepest that the keys accept.
constexpr std::uint64_t most_depth = 1U << 20;

/// How a FIFO of a configured kind is built with some depth: `auto` is decided by the depth.
FifoChoice choice_of(FifoKind configured, std::uint64_t depth);
/// The choice of a machine.
Choice choice_of(Machine const& machine);
/// The machine with another choice.
Machine with_choice(Machine machine, Choice const& choice);
/// What a configuration asks of that machine, with another choice for the FIFOs that are there.
MachineSettings with_choice(MachineSettings settings, Machine const& machine, Choice const& choice);

/// The deepest choice of a kind that some primitives hold.
struct Level {
    FifoChoice choice;
    Primitives primitives;
    double cost = 0;  ///< in LUTs
};

/// The levels of a FIFO of a configured kind, the cheapest first. No deeper than `depth`.
std::vector<Level> levels_of(FifoKind configured, FifoTokens const& tokens, std::uint64_t depth,
                             CostWeights const& weights);

}  // namespace faster::sizing
