#include "kernel/sizing/fifo_choice.hpp"

#include <algorithm>

namespace faster::sizing {

namespace {

/// Depths of one kind that a configured kind may have.
struct Range {
    FifoKind kind;
    std::uint64_t shallowest;
    std::uint64_t deepest;
};

std::vector<Range> ranges_of(FifoKind configured, std::uint64_t depth) {
    if (configured != FifoKind::automatic)
        return {{configured, 1, depth}};
    std::vector<Range> ranges{{FifoKind::shift_register, 1, 1}};
    while (ranges[0].deepest < depth && choice_of(configured, ranges[0].deepest + 1).kind == FifoKind::shift_register)
        ++ranges[0].deepest;
    if (ranges[0].deepest < depth)
        ranges.push_back({FifoKind::memory, ranges[0].deepest + 1, depth});
    return ranges;
}

/// The deepest that the primitives of `depth` hold.
std::uint64_t deepest_at_cost(Range const& range, std::uint64_t depth, FifoTokens const& tokens,
                              CostWeights const& weights) {
    Primitives const primitives = primitives_of({range.kind, depth}, tokens, weights);
    std::uint64_t same = depth;
    std::uint64_t other = range.deepest + 1;
    while (other - same > 1) {
        std::uint64_t const middle = (same + other) / 2;
        (primitives_of({range.kind, middle}, tokens, weights) == primitives ? same : other) = middle;
    }
    return same;
}

}  // namespace

FifoChoice choice_of(FifoKind configured, std::uint64_t depth) { return {resolved_kind(configured, depth), depth}; }

FifoTokens tokens_of(MachineFifo const& fifo) {
    bool const squeezes = fifo.flushes && fifo.when_full == WhenFull::squeeze;
    return {fifo.bits, squeezes ? fifo.write_latency : 0};
}

Primitives primitives_of(FifoChoice const& choice, FifoTokens const& tokens, CostWeights const& weights) {
    return primitives_of(choice.kind, choice.depth + tokens.besides, tokens.bits, weights);
}

Choice choice_of(Machine const& machine) {
    Choice choice;
    for (MachineFifo const& fifo : machine.fifos)
        choice.push_back({fifo.kind, fifo.depth});
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

std::vector<Level> levels_of(FifoKind configured, FifoTokens const& tokens, std::uint64_t depth,
                             CostWeights const& weights) {
    std::vector<Level> levels;
    for (Range const& range : ranges_of(configured, depth))
        for (std::uint64_t next = range.shallowest; next <= range.deepest;) {
            std::uint64_t const deepest = deepest_at_cost(range, next, tokens, weights);
            Primitives const primitives = primitives_of({range.kind, deepest}, tokens, weights);
            levels.push_back({{range.kind, deepest}, primitives, cost_of(primitives, weights)});
            next = deepest + 1;
        }
    std::stable_sort(levels.begin(), levels.end(), [](Level const& a, Level const& b) { return a.cost < b.cost; });
    return levels;
}

}  // namespace faster::sizing
