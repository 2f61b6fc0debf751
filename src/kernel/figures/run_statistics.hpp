#pragma once
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "kernel/base/cycles.hpp"
#include "kernel/figures/critical_path.hpp"
#include "kernel/figures/cycle_class.hpp"
#include "kernel/figures/sensitivity.hpp"
#include "kernel/machine/machine.hpp"

namespace faster {

/// What a sample's result consists of, in the order of Design::counters().
using Counters = std::vector<std::uint64_t>;

/// One row of samples.csv (SPEC section 4).
struct SampleStatistics {
    std::uint64_t sample = 0;
    std::uint64_t core = 0;
    Cycles start_cycle = 0;  ///< of the stamp with which it begins
    Cycles end_cycle = 0;    ///< of the stamp with which it ends
    Counters counters;

    Cycles latency_cycles() const { return end_cycle + 1 - start_cycle; }
};

/// One row of fifos.csv.
struct FifoStatistics {
    FifoKind kind = FifoKind::shift_register;  ///< as resolved
    std::uint64_t depth = 0;                   ///< tokens, as configured
    std::uint64_t capacity = 0;                ///< tokens that fit
    Cycles write_latency = 0;
    std::uint64_t writes = 0;
    std::uint64_t reads = 0;
    Cycles full_stall_cycles = 0;
    Cycles empty_stall_cycles = 0;
    std::uint64_t max_occupancy = 0;
};

/// One row of loops.csv.
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

/// Where the cycles of one process went. Every cycle of the run is in exactly one class: they add up to total_cycles.
struct ProcessStatistics {
    std::array<Cycles, cycle_class_count> cycles{};
    std::vector<Cycles> stalls;          ///< full or empty, by the FIFO that caused them
    std::vector<Cycles> port_conflicts;  ///< by the block RAM that has too few ports

    Cycles& operator[](CycleClass which) { return cycles[index_of(which)]; }
    Cycles operator[](CycleClass which) const { return cycles[index_of(which)]; }
    Cycles sum() const { return std::accumulate(cycles.begin(), cycles.end(), Cycles{0}); }
};

struct CoreStatistics {
    std::uint64_t samples = 0;
    Cycles end_cycle = 0;  ///< one past its last result read; 0 without samples
    std::vector<FifoStatistics> fifos;          ///< by their numbers in the machine
    std::vector<LoopStatistics> loops;
    std::vector<ProcessStatistics> processes;
};

/// One process of a stuck core.
struct StuckProcess {
    std::uint64_t core = 0;
    std::string process;
    std::string position;
    std::string fifo;
    bool to_write = false;
    std::uint64_t occupancy = 0;
    std::uint64_t capacity = 0;
    Cycles since_cycle = 0;
    std::string waits_for;  ///< the process at the FIFO's other end
    std::string source;     ///< file and line of its loop, or of its access outside loops
};

/// Everything a run has to tell. Simulated figures only: host time is measured by whoever calls.
struct RunStatistics {
    Machine machine;  ///< what the figures are of
    Cycles total_cycles = 0;
    std::vector<SampleStatistics> samples;  ///< by sample
    std::vector<CoreStatistics> cores;
    std::vector<StuckProcess> stuck;            ///< empty unless the run deadlocked
    std::vector<Sensitivity> sensitivities;     ///< if asked for, else empty
    std::optional<CriticalPath> critical_path;  ///< if asked for, unless the run deadlocked

    bool deadlocked() const { return !stuck.empty(); }
    Cycles deadlock_cycle() const;
    /// The processes that wait for each other in a circle, in order; the last waits for the first.
    std::vector<StuckProcess> wait_cycle() const;
};

/// FIFOs that were not read empty, for people: a finished run has none, or the model is wrong.
std::string leftover_tokens(RunStatistics const& run);

/// Of the loops that a block RAM limits, in one core.
Cycles port_conflict_cycles(CoreStatistics const& core, std::string const& memory);

/// One module of all cores together.
ProcessStatistics process_sum(RunStatistics const& run, std::size_t module);

}  // namespace faster
