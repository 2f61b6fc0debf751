#pragma once
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow {

/// One thing that the cycles of a process go into. A loop counts with all cycles of its iterations, those that a port
/// conflict or a recurrence costs included.
struct Cause {
    enum class Kind { loop, stall, memory_stall, setup, fill_drain, idle, between_loops };
    Kind kind = Kind::loop;
    std::size_t item = 0;      ///< number of a loop or FIFO of the machine
    Cycles cycles = 0;         ///< of one core
    Cycles port_conflict = 0;  ///< of them, in a loop
    Cycles interlock = 0;      ///< of them, in which iterations wait for others to write
};

/// What a run is bound by: of the core that ends last, the module that waits least, and what its time goes into.
struct Diagnosis {
    std::size_t core = 0;
    std::size_t module = 0;
    Cycles cycles = 0;          ///< of the run, without a load
    Cycles waits = 0;           ///< of them, in which the module stalls or is idle
    std::vector<Cause> causes;  ///< the largest first; they add up to cycles
};

Diagnosis diagnose(RunStatistics const& run);

}  // namespace dataflow
