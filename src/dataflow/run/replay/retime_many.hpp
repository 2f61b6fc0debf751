#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "dataflow/run/replay/retime.hpp"

namespace dataflow::replay {

/// Gets the number of a machine and its figures; none if only a run can tell: see NotRetimable.
using Done = std::function<void(std::size_t i, std::optional<RunStatistics> const& retimed)>;

/// Throws NotRetimable if a run on the machine would refuse to begin, as a module reads too late for what it does next.
void require_run_on(Machine const& machine, RecordedRun const& run);
bool allows_run_on(Machine const& machine, RecordedRun const& run);

/// retime() for each of the machines, on all host cores. `done` is told in any order, from any thread, but one at
/// a time.
void retime_many(RecordedRun const& run, std::vector<Machine> const& machines, Done const& done);
void retime_many(ScriptedRun const& run, std::vector<Machine> const& machines, Done const& done);

}  // namespace dataflow::replay
