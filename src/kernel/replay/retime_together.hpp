#pragma once
#include "kernel/figures/run_statistics.hpp"
#include "kernel/replay/core_watch.hpp"
#include "kernel/replay/scripted_run.hpp"

namespace faster::replay {

/// retime() of a run whose cores shared an external memory: all of them go on together, as they did. On a machine whose
/// memory is ideal, everything is there from cycle 0 on. With trails, the critical path is among the figures. `watch`
/// may be null.
RunStatistics retime_together(ScriptedRun const& run, Machine const& machine, bool leave_trails = false,
                              CoreWatch* watch = nullptr);

}  // namespace faster::replay
