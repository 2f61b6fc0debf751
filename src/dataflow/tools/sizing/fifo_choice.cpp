#include "dataflow/tools/sizing/fifo_choice.hpp"

#include <algorithm>

namespace dataflow::sizing {

namespace {

/// Depths of one kind that a FIFO may have.
struct Range {
    FifoKind kind;
    std::uint64_t shallowest;
    std::uint64_t deepest;
};

/// Of `auto`; deeper ones are memories.
std::uint64_t deepest_shift_register(FifoFreedom const& fifo) {
    std::uint64_t shift_register = 1;
    std::uint64_t beyond = most_depth + 1;
    while (beyond - shift_register > 1) {
        std::uint64_t const middle = (shift_register + beyond) / 2;
        (fifo.at_depth(middle).kind == FifoKind::shift_register ? shift_register : beyond) = middle;
    }
    return shift_register;
}

/// Up to `depth`. `auto` may be a memory in any case, which can cost less than a shift register that is less deep.
std::vector<Range> ranges_of(FifoFreedom const& fifo, std::uint64_t depth) {
    if (fifo.kind != FifoKind::automatic)
        return {{fifo.kind, 1, depth}};
    std::uint64_t const deepest = deepest_shift_register(fifo);
    std::vector<Range> ranges{{FifoKind::shift_register, 1, std::min(depth, deepest)}};
    if (deepest < most_depth)
        ranges.push_back({FifoKind::memory, deepest + 1, std::max(depth, deepest + 1)});
    return ranges;
}

/// The deepest that the primitives of `depth` hold.
std::uint64_t deepest_at_cost(Range const& range, std::uint64_t depth, FifoFreedom const& fifo,
                              CostWeights const& weights) {
    Primitives const primitives = primitives_of({range.kind, depth}, fifo, weights);
    std::uint64_t same = depth;
    std::uint64_t other = range.deepest + 1;
    while (other - same > 1) {
        std::uint64_t const middle = (same + other) / 2;
        (primitives_of({range.kind, middle}, fifo, weights) == primitives ? same : other) = middle;
    }
    return same;
}

}  // namespace

FifoChoice FifoFreedom::at_depth(std::uint64_t depth) const {
    return {resolved_kind(kind, depth, bits, generation), depth, generation};
}

FifoChoice deepest_alike(FifoChoice const& choice, FifoFreedom const& fifo, CostWeights const& weights) {
    for (Range const& range : ranges_of(fifo, most_depth))
        if (range.kind == choice.kind)
            return {choice.kind, deepest_at_cost(range, choice.depth, fifo, weights), choice.generation};
    return choice;
}

FifoChoice FifoFreedom::with_capacity(FifoKind resolved, std::uint64_t capacity) const {
    return {resolved, capacity - tokens_beyond_depth(resolved, generation), generation};
}

Freedoms freedoms_of(Machine const& machine) {
    Freedoms freedoms;
    for (MachineFifo const& fifo : machine.fifos)
        freedoms.push_back(freedom_of(fifo));
    return freedoms;
}

FifoFreedom freedom_of(MachineFifo const& fifo) {
    return {fifo.configured_kind, fifo.bits, fifo.generation, fifo.tokens_of_pipeline()};
}

Primitives primitives_of(FifoChoice const& choice, FifoFreedom const& fifo, CostWeights const& weights) {
    return primitives_of(choice.kind, choice.depth + fifo.tokens_besides, fifo.bits, weights);
}

Choice choice_of(Machine const& machine) {
    Choice choice;
    for (MachineFifo const& fifo : machine.fifos)
        choice.push_back({fifo.kind, fifo.depth, fifo.generation});
    return choice;
}

Machine with_choice(Machine machine, Choice const& choice) {
    for (std::size_t i = 0; i < machine.fifos.size(); ++i) {
        machine.fifos[i].depth = choice[i].depth;
        machine.fifos[i].kind = choice[i].kind;
        machine.fifos[i].configured_kind = choice[i].kind;
    }
    return machine;
}

MachineSettings with_choice(MachineSettings settings, Machine const& machine, Choice const& choice) {
    for (std::size_t const i : fifos_of(machine)) {
        FifoSettings& fifo = settings.fifo(machine.fifos[i].name);
        fifo.depth = choice[i].depth;
        fifo.kind = choice[i].kind;
    }
    return settings;
}

std::vector<Level> levels_of(FifoFreedom const& fifo, std::uint64_t depth, CostWeights const& weights) {
    std::vector<Level> levels;
    for (Range const& range : ranges_of(fifo, depth))
        for (std::uint64_t next = range.shallowest; next <= range.deepest;) {
            std::uint64_t const deepest = deepest_at_cost(range, next, fifo, weights);
            FifoChoice const choice{range.kind, deepest, fifo.generation};
            Primitives const primitives = primitives_of(choice, fifo, weights);
            levels.push_back({choice, primitives, cost_of(primitives, weights)});
            next = deepest + 1;
        }
    std::stable_sort(levels.begin(), levels.end(), [](Level const& a, Level const& b) { return a.cost < b.cost; });
    return levels;
}

}  // namespace dataflow::sizing
