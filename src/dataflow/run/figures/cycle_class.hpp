#pragma once
#include <array>
#include <iterator>

#include "dataflow/base/column.hpp"

namespace dataflow {

/// What a process does in a cycle: always exactly one of these.
enum class CycleClass : std::size_t {
    busy,
    fill_drain,
    setup,
    empty_stall,
    full_stall,
    memory_stall,
    port_conflict,
    recurrence,
    idle_before,
    idle_after,
};

/// The classes by their names. Columns of modules have the same names with "_cycles" behind.
inline constexpr ColumnFacts cycle_classes[]{
    {"busy", "cycles", Tells::work, "works: an operation, or an iteration at its target interval"},
    {"fill_drain", "cycles", Tells::work, "a loop's pipeline fills or empties: L - II for every entry"},
    {"setup", "cycles", Tells::work, "prepares what its next loop goes over"},
    {"empty_stall", "cycles", Tells::waiting, "an input FIFO is empty; `stalls` has them by FIFO"},
    {"full_stall", "cycles", Tells::waiting, "an output FIFO is full; `stalls` has them by FIFO"},
    {"memory_stall", "cycles", Tells::waiting, "the external memory has not brought what comes next"},
    {"port_conflict", "cycles", Tells::work,
     "a block RAM has too few ports for the target interval; `port_conflicts` has them by block RAM"},
    {"recurrence", "cycles", Tells::work, "a dependence between iterations forbids the target interval"},
    {"idle_before", "cycles", Tells::waiting,
     "waits for its first token, and has done nothing before. `fifos.csv` counts these cycles as an empty stall"},
    {"idle_after", "cycles", Tells::waiting, "has nothing to do any more"},
};
constexpr std::size_t cycle_class_count = std::size(cycle_classes);

constexpr std::array<char const*, cycle_class_count> cycle_class_names = [] {
    std::array<char const*, cycle_class_count> names{};
    for (std::size_t i = 0; i < cycle_class_count; ++i)
        names[i] = cycle_classes[i].name;
    return names;
}();
constexpr std::size_t index_of(CycleClass which) { return static_cast<std::size_t>(which); }
/// Nobody waits for an ideal memory: then there is no such class.
constexpr bool is_class_of(std::size_t which, bool has_external_memory) {
    return has_external_memory || which != index_of(CycleClass::memory_stall);
}
inline char const* name_of(CycleClass which) { return cycle_class_names[index_of(which)]; }

}  // namespace dataflow
