#pragma once
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/figures/critical_path.hpp"
#include "dataflow/run/figures/cycle_class.hpp"
#include "dataflow/run/figures/dependence_row.hpp"
#include "dataflow/run/figures/memory_traffic.hpp"
#include "dataflow/run/figures/sensitivity.hpp"
#include "dataflow/run/figures/table_columns.hpp"

namespace dataflow {

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
    Cycles end_cycle = 0;               ///< one past the last cycle that counts, see run_end(); 0 without samples
    std::vector<FifoStatistics> fifos;  ///< by their numbers in the machine
    std::vector<LoopStatistics> loops;
    std::vector<ProcessStatistics> processes;
    std::vector<DependenceStatistics> dependences;  ///< if asked for, else empty
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
    bool waits_for_memory = false;
    std::string source;  ///< file and line of its loop, or of its access outside loops
};

/// Everything a run has to tell. Simulated figures only: host time is measured by whoever calls.
struct RunStatistics {
    Machine machine;  ///< what the figures are of
    Cycles total_cycles = 0;
    Cycles load_cycles = 0;                 ///< of them, before the cores' cycle 0: memories on the chip are filled
    std::vector<SampleStatistics> samples;  ///< by sample
    std::vector<CoreStatistics> cores;
    std::optional<MemoryTraffic> memory;        ///< of an external memory that is not ideal
    std::vector<StuckProcess> stuck;            ///< empty unless the run deadlocked
    std::vector<SampleStatistics> unfinished;   ///< likewise; of each stuck core the first that began and did not end
    std::vector<Sensitivity> sensitivities;     ///< if asked for, else empty
    std::vector<Alternative> alternatives;      ///< likewise
    std::optional<CriticalPath> critical_path;  ///< if asked for, unless the run deadlocked
    std::vector<std::string> warnings;          ///< what in workload or results looks like a mistake

    /// Those of the cores, which is what the classes of their processes add up to.
    Cycles core_cycles() const { return total_cycles - load_cycles; }
    bool deadlocked() const { return !stuck.empty(); }
    Cycles deadlock_cycle() const;
    /// The core that ends last, the first of them.
    std::size_t last_core() const;
    /// The processes that wait for each other in a circle, in order; the last waits for the first.
    std::vector<StuckProcess> wait_cycle() const;
};

/// A core of a machine in which nothing has happened.
CoreStatistics empty_core(Machine const& machine);

/// FIFOs that were not read empty, for people: a finished run has none, or the model is wrong.
std::string leftover_tokens(RunStatistics const& run);
/// Those that need not be: FifoEnd::keeps_tokens().
std::string kept_tokens(RunStatistics const& run);

/// One module of all cores together.
ProcessStatistics process_sum(RunStatistics const& run, std::size_t module);

}  // namespace dataflow
