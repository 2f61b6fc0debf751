#pragma once
#include "kernel/base/column.hpp"
#include "kernel/base/cycles.hpp"

namespace faster {

/// What a loop of a core has to tell.
struct LoopStatistics {
    Cycles ii_target = 1;
    Cycles ii_recurrence = 1;
    Cycles ii = 1;
    Cycles depth = 1;
    std::uint64_t entries = 0;
    std::uint64_t iterations = 0;
    Cycles port_conflict_cycles = 0;
    Cycles recurrence_cycles = 0;
    std::string limited_by;
    std::string bram;                 ///< that demands most; empty if the loop touches none
    std::uint64_t bram_accesses = 0;  ///< of that, per iteration
};

/// One row of loops.csv.
struct LoopRow : LoopStatistics {
    std::uint64_t core = 0;
    std::string module;
    std::string loop;
    bool is_in_csv = true;  ///< SPEC section 4 leaves some loops out

    std::string name() const { return module + "." + loop; }
};

inline constexpr Column<LoopRow> loop_columns[]{
    {"core", "-", &LoopRow::core, Tells::key, "its core"},
    {"module", "-", &LoopRow::module, Tells::key, "the process that runs it"},
    {"loop", "-", &LoopRow::loop, Tells::key, "its name in the module"},
    {"ii_target", "cycles", &LoopRow::ii_target, Tells::shape, "what the pragma asks for"},
    {"ii_recurrence", "cycles", &LoopRow::ii_recurrence, Tells::shape, "what a dependence between iterations demands"},
    {"ii", "cycles", &LoopRow::ii, Tells::shape, "what is achieved", "loop_intervals"},
    {"depth", "cycles", &LoopRow::depth, Tells::shape, "pipeline stages"},
    {"entries", "-", &LoopRow::entries, Tells::work, "entries with at least one iteration"},
    {"iterations", "-", &LoopRow::iterations, Tells::work, "over all entries", "loop_iterations"},
    {"port_conflict_cycles", "cycles", &LoopRow::port_conflict_cycles, Tells::work, "lost to block RAM ports",
     "loop_losses"},
    {"recurrence_cycles", "cycles", &LoopRow::recurrence_cycles, Tells::work, "lost to the dependence", "loop_losses"},
    {"limited_by", "-", &LoopRow::limited_by, Tells::shape,
     "a block RAM, `recurrence`, or empty; static, also for loops that never ran"},
};

}  // namespace faster
