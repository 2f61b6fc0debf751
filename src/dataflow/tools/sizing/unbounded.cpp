#include "dataflow/tools/sizing/unbounded.hpp"

#include <algorithm>
#include <numeric>

namespace dataflow::sizing {

namespace {

constexpr std::uint64_t first_depth = 64;
constexpr std::uint64_t growth = 512;
constexpr std::size_t samples_at_first = 4;  // most of what holds a core up shows in them

/// Of a depth at which `auto` is a memory, whatever the tokens' width.
FifoChoice deep(FifoFreedom const& fifo, std::uint64_t depth) {
    return {fifo.kind == FifoKind::automatic ? FifoKind::memory : fifo.kind, depth, fifo.generation};
}

/// What a path waits for room in; false: in nothing that could be deeper.
bool deepen(Choice& choice, Cut const& path) {
    bool is_deeper = false;
    for (Cut::Member const& member : path.members) {
        FifoChoice& fifo = choice[member.fifo];
        if (member.capacity == 0 || fifo.depth == most_depth)
            continue;
        fifo.depth = std::min(most_depth, fifo.depth * growth);
        is_deeper = true;
    }
    return is_deeper;
}

/// No room that no core ever needs.
Choice without_spare_room(Choice const& choice, CoreTimes const& times) {
    Choice smaller = choice;
    for (std::size_t i = 0; i < choice.size(); ++i) {
        std::uint64_t const spare = choice[i].capacity() - times.needed_room(choice, i);
        smaller[i].depth -= std::min(spare, choice[i].depth - 1);
    }
    return smaller;
}

/// Those of some FIFOs that have been full; false: none that could be deeper.
bool deepen_full(Choice& choice, std::vector<std::size_t> const& fifos, CoreTimes const& times) {
    Cut full;
    for (std::size_t const fifo : fifos)
        if (times.was_full(choice, fifo))
            full.members.push_back({fifo, choice[fifo].capacity(), false});
    return deepen(choice, full);
}

std::vector<std::size_t> all_of(FifoFrame const& frame) {
    std::vector<std::size_t> fifos(frame.fifos());
    std::iota(fifos.begin(), fifos.end(), std::size_t{0});
    return fifos;
}

/// A path that waits for memory does not say who let a master ask late. With all the room there is it is not later.
bool is_late(Choice choice, Cycles total_cycles, FifoFrame const& frame, CoreTimes& times, unsigned jobs) {
    for (std::size_t i = 0; i < choice.size(); ++i)
        choice[i] = frame.freedoms[i].with_capacity(choice[i].kind, timing::FifoShape::unlimited);
    return times.total_cycles(choice, jobs) < total_cycles;
}

std::size_t last_core(Choice const& choice, CoreTimes& times, Cycles total_cycles) {
    std::size_t core = 0;
    while (times.cycles(core, choice) != total_cycles)
        ++core;
    return core;
}

/// On the relaxed machine.
Unbounded relaxed_unbounded(FifoFrame const& frame, CoreTimes& times, bool has_memory, unsigned jobs) {
    Unbounded result;
    for (FifoFreedom const& fifo : frame.freedoms)
        result.choice.push_back(deep(fifo, first_depth));
    bool is_deep = times.cores() == 0;
    while (!is_deep && deepen(result.choice, times.first_suspects(0, result.choice, samples_at_first))) {
    }
    while (!is_deep) {
        result.total_cycles = times.total_cycles(result.choice, jobs);
        result.last_core = last_core(result.choice, times, result.total_cycles);
        is_deep = !deepen(result.choice, times.explain(result.last_core, result.choice)) &&
                  !deepen_full(result.choice, frame.freezing, times) &&
                  !(has_memory && is_late(result.choice, result.total_cycles, frame, times, jobs) &&
                    deepen_full(result.choice, all_of(frame), times));
    }
    result.choice = without_spare_room(result.choice, times);
    return result;
}

/// Where the cores wait for each other, the last one's critical path may ask for more room. What more room still would
/// do nobody can say, so that these FIFOs are such as an answer may have.
void deepen_together(Unbounded& result, FifoFrame const& frame, CoreTimes& times, unsigned jobs) {
    do
        result.last_core = last_core(result.choice, times, times.total_cycles(result.choice, jobs));
    while (deepen(result.choice, times.explain(result.last_core, result.choice)));
    result.choice = without_spare_room(result.choice, times);
    for (std::size_t i = 0; i < result.choice.size(); ++i)
        result.choice[i] = as_it_may_be(result.choice[i], frame.freedoms[i]);
}

}  // namespace

FifoFrame::FifoFrame(Machine const& machine, CostWeights const& cost_weights)
    : freezing(freezing_fifos(machine)), freedoms(freedoms_of(machine)), weights(cost_weights) {}

FifoChoice as_it_may_be(FifoChoice const& choice, FifoFreedom const& fifo) {
    bool const may_be = fifo.at_depth(choice.depth).kind == choice.kind;
    return may_be ? choice : fifo.at_depth(choice.capacity());
}

Unbounded unbounded(FifoFrame const& frame, CoreTimes& times, unsigned jobs) {
    Unbounded result = relaxed_unbounded(frame, times.relaxed(), times.are_together(), jobs);
    if (times.are_together() && times.cores() > 0)
        deepen_together(result, frame, times, jobs);
    result.total_cycles = times.total_cycles(result.choice, jobs);
    return result;
}

}  // namespace dataflow::sizing
