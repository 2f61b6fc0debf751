#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/tools/resources/fifo_cost.hpp"

namespace dataflow::sizing {

/// How one FIFO is built: a resolved kind and a depth, by the rules of a generation, which all FIFOs of a search have
/// alike. What it means for time is a capacity and a read latency (docs/timing-model.md#fifos).
struct FifoChoice {
    FifoKind kind = FifoKind::shift_register;
    std::uint64_t depth = 1;
    FifoGeneration generation = FifoGeneration::spec;

    std::uint64_t capacity() const { return depth + tokens_beyond_depth(kind, generation); }
    Cycles read_latency() const { return read_latency_of(kind); }
    bool operator==(FifoChoice const& other) const { return kind == other.kind && depth == other.depth; }
    bool operator<(FifoChoice const& other) const {
        return kind != other.kind ? kind < other.kind : depth < other.depth;
    }
};

/// All FIFOs of a core by their numbers in the machine, which all cores have alike.
using Choice = std::vector<FifoChoice>;

/// The deepest that the keys accept.
constexpr std::uint64_t most_depth = 1U << 20;

/// What a configuration says of how one FIFO is built, whatever its depth.
struct FifoFreedom {
    FifoKind kind = FifoKind::automatic;
    unsigned bits = 0;  ///< of a token; 0: the FIFO is not there
    FifoGeneration generation = FifoGeneration::spec;
    std::uint64_t tokens_besides = 0;  ///< that it has to hold besides its depth: one per stage that squeezes

    /// `auto` is decided by the depth.
    FifoChoice at_depth(std::uint64_t depth) const;
    /// Of a kind that is decided, with room for so many tokens.
    FifoChoice with_capacity(FifoKind resolved, std::uint64_t capacity) const;
};

FifoFreedom freedom_of(MachineFifo const& fifo);
Primitives primitives_of(FifoChoice const& choice, FifoFreedom const& fifo, CostWeights const& weights);
/// The deepest of that kind which the primitives of `choice` hold.
FifoChoice deepest_alike(FifoChoice const& choice, FifoFreedom const& fifo, CostWeights const& weights);

/// All FIFOs of a core by their numbers.
using Freedoms = std::vector<FifoFreedom>;
Freedoms freedoms_of(Machine const& machine);

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

/// The levels of a FIFO, the cheapest first. No deeper than `depth`, but for the shallowest memory that `auto` can be.
std::vector<Level> levels_of(FifoFreedom const& fifo, std::uint64_t depth, CostWeights const& weights);

}  // namespace dataflow::sizing
