#pragma once
#include <string>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::report {

/// One architecture on one workload. Stalls and conflicts in lane-cycles of all modules and cores.
struct ArchitectureRow {
    std::string architecture;
    std::string workload;
    bool deadlocked = false;  ///< then there are no cycles
    Cycles total_cycles = 0;
    double milliseconds = 0;
    Cycles empty_stall_cycles = 0;
    Cycles full_stall_cycles = 0;
    Cycles port_conflict_cycles = 0;
    double ramb36 = 0;  ///< block RAMs of 36 Kbit of all cores
    double lut = 0;     ///< of all cores, as are the two below
    double ff = 0;
    double dsp = 0;
    /// Samples whose results were judged (docs/validation.md); the rest is means and shares over them.
    std::size_t judged_samples = 0;
    double precision = 0;
    double recall = 0;
    double closed = 0;
    double thin = 0;
};

/// The figures of a run; names are left to the caller.
ArchitectureRow architecture_row(RunStatistics const& run);

/// For people, as Markdown: a row per architecture with the milliseconds of every workload, the time against the first
/// architecture's (geometric mean over the workloads that both finish), port conflicts, block RAMs, and, where edge
/// maps were judged, their quality over all workloads. The rows of an architecture stand together, and have the same
/// workloads in the same order.
std::string architecture_markdown(std::vector<ArchitectureRow> const& rows);

/// architectures.csv (docs/formats.md): a row per architecture and workload.
std::string architecture_csv(std::vector<ArchitectureRow> const& rows);

/// A row for another process, and back.
std::string to_text(ArchitectureRow const& row);
ArchitectureRow row_from_text(std::string const& text);

}  // namespace dataflow::report
