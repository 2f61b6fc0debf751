#include "kernel/sizing/fifo_choice.hpp"

#include <algorithm>

#include "modules/core_shapes.hpp"

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
std::uint64_t deepest_at_cost(Range const& range, std::uint64_t depth, unsigned bits, CostWeights const& weights) {
    Primitives const primitives = primitives_of(range.kind, depth, bits, weights);
    std::uint64_t same = depth;
    std::uint64_t other = range.deepest + 1;
    while (other - same > 1) {
        std::uint64_t const middle = (same + other) / 2;
        (primitives_of(range.kind, middle, bits, weights) == primitives ? same : other) = middle;
    }
    return same;
}

}  // namespace

FifoChoice choice_of(FifoKind configured, std::uint64_t depth) {
    FifoConfig fifo;
    fifo.depth = depth;
    fifo.kind = configured;
    return {resolved_kind(fifo), depth};
}

Choice choice_of(AcceleratorConfig const& config) {
    Choice choice;
    for (std::size_t i = 0; i < fifo_count; ++i)
        choice[i] = choice_of(config.fifos[i].kind, config.fifos[i].depth);
    return choice;
}

AcceleratorConfig with_choice(AcceleratorConfig config, Choice const& choice) {
    for (std::size_t i = 0; i < fifo_count; ++i) {
        config.fifos[i].depth = choice[i].depth;
        config.fifos[i].kind = choice[i].kind;
    }
    return config;
}

std::vector<Level> levels_of(FifoKind configured, unsigned bits, std::uint64_t depth, CostWeights const& weights) {
    std::vector<Level> levels;
    for (Range const& range : ranges_of(configured, depth))
        for (std::uint64_t next = range.shallowest; next <= range.deepest;) {
            std::uint64_t const deepest = deepest_at_cost(range, next, bits, weights);
            Primitives const primitives = primitives_of(range.kind, deepest, bits, weights);
            levels.push_back({{range.kind, deepest}, primitives, cost_of(primitives, weights)});
            next = deepest + 1;
        }
    std::stable_sort(levels.begin(), levels.end(), [](Level const& a, Level const& b) { return a.cost < b.cost; });
    return levels;
}

}  // namespace faster::sizing
