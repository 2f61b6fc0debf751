#pragma once
#include <array>
#include <cstddef>

namespace faster {

/// What a process does in a cycle: always exactly one of these.
enum class CycleClass : std::size_t {
    busy,           ///< works: an operation, or an iteration at its target interval
    fill_drain,     ///< a loop's pipeline fills or empties
    setup,          ///< prepares what its next loop works on
    empty_stall,    ///< an input FIFO is empty
    full_stall,     ///< an output FIFO is full
    port_conflict,  ///< a block RAM has too few ports for the target interval
    recurrence,     ///< a loop-carried dependence forbids the target interval
    idle_before,    ///< has had nothing to do yet: waits for its first token
    idle_after,     ///< has nothing to do any more
};
constexpr std::size_t cycle_class_count = 9;
constexpr std::array<char const*, cycle_class_count> cycle_class_names{"busy",        "fill_drain",  "setup",
                                                                       "empty_stall", "full_stall",  "port_conflict",
                                                                       "recurrence",  "idle_before", "idle_after"};

constexpr std::size_t index_of(CycleClass which) { return static_cast<std::size_t>(which); }
inline char const* name_of(CycleClass which) { return cycle_class_names[index_of(which)]; }

}  // namespace faster
