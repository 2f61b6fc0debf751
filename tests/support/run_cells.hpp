#pragma once
#include <string>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"
#include "faster/dataflow_names.hpp"
#include "support/cycle_twin.hpp"

namespace faster::testing {

/// One figure of a run under a name that says where it stands: "core 2, fifo command, writes".
struct Cell {
    std::string name;
    std::string value;
};
using Cells = std::vector<Cell>;

/// Which part of a run's figures.
enum class Part { Samples, Fifos, Loops, Stalls, Memory };

/// The figures that engine and twin both have, in the same order.
Cells cells_of(RunStatistics const& run, Part part);
Cells cells_of(TwinResult const& twin, Part part);

/// All figures of a run, for comparing engines with each other; of one that deadlocked, without classes
/// of cycles.
Cells all_cells(RunStatistics const& run);
/// The stuck processes as they are printed, all but where in its program each stands, ...
Cells stuck_cells(RunStatistics const& run);
/// ... and that.
Cells position_cells(RunStatistics const& run);

/// The critical path, which must have been traced.
Cells path_cells(RunStatistics const& run);

/// "name: a against b" of the first cell that differs; empty if none does.
std::string first_difference(Cells const& a, Cells const& b);

}  // namespace faster::testing
