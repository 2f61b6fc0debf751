#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "support/memory_twin.hpp"
#include "support/parts.hpp"

namespace faster::testing {

struct TwinSample {
    SampleCounters counters;
    Cycles start_cycle = 0;  ///< its sample_raster token is read
    Cycles end_cycle = 0;    ///< its result token is read
};

struct TwinFifo {
    std::uint64_t writes = 0;
    std::uint64_t reads = 0;
    Cycles full_stall_cycles = 0;
    Cycles empty_stall_cycles = 0;
    std::uint64_t max_occupancy = 0;  ///< tokens written and not read at the end of a cycle
};

struct TwinLoop {
    Cycles ii = 1;
    std::uint64_t entries = 0;  ///< with at least one iteration
    std::uint64_t iterations = 0;
    Cycles port_conflict_cycles = 0;
    Cycles recurrence_cycles = 0;
    std::string limited_by;  ///< a BRAM, "recurrence" or nothing
};

struct TwinProcess {
    Cycles empty_stall = 0;
    Cycles full_stall = 0;
    std::vector<Cycles> empty_stalls, full_stalls;  ///< the cycles of these
    Cycles memory_stall = 0;
    Cycles end_cycle = 0;  ///< local time after its last state: the first cycle it has nothing to do in
};

/// After a deadlock the tables hold what had happened by then: finished samples keep their cycles, the others have 0
/// for what they did not reach, and a wait that never ended is charged up to the cycle in which the twin noticed.
struct TwinResult {
    bool deadlock = false;
    /// Max over the processes not finished of the cycle in which they reached the step they are stuck in; over all
    /// cores.
    Cycles deadlock_cycle = 0;
    Cycles load_cycles = 0;                                        ///< before cycle 0
    Cycles total_cycles = 0;                                       ///< with the load
    std::vector<TwinSample> samples;                               ///< one per stimulus sample, in order
    std::vector<std::array<TwinFifo, fifo_count>> fifos;           ///< [core][FifoId]
    std::vector<std::array<TwinLoop, loop_count>> loops;           ///< [core][LoopId]
    std::vector<std::array<TwinProcess, module_count>> processes;  ///< [core][ModuleId]
    // With memory `axi`, else empty:
    std::vector<std::array<TwinTraffic, master_count>> traffic;  ///< [core][TwinMaster]
    std::vector<std::uint64_t> port_beats;                       ///< [port]: of reads
    std::uint64_t controller_ps = 0;                             ///< spent serving
};

/// The oracle of docs/timing-model.md: lets cycle 0, 1, 2, ... pass and has every process of a
/// core attempt its current step in each. Slow and plain on purpose; shares nothing with the engine but the
/// configuration and stimulus structs. Window and fraction bits are the stimulus's, as for a trace. Throws
/// std::invalid_argument on a stimulus with a posed mesh (it has no vertex transform) and on a write latency beyond the
/// end of its loop. With memory `axi` all cores go through the same cycles.
TwinResult run_twin(AcceleratorConfig const& config, Stimulus const& stimulus);
/// With this memory instead of the configuration's.
TwinResult run_twin(AcceleratorConfig const& config, Stimulus const& stimulus, TwinMemory const& memory);

}  // namespace faster::testing
