#pragma once
#include "dataflow/run/replay/core_watch.hpp"
#include "dataflow/run/replay/retime.hpp"

namespace dataflow::replay {

/// retime() of a run whose cores shared an external memory: all of them go on together, as they did. On a machine whose
/// memory is ideal, everything is there from cycle 0 on. With trails, the critical path is among the figures. `watch`
/// may be null.
RunStatistics retime_together(ScriptedRun const& run, Machine const& machine, bool leave_trails = false,
                              CoreWatch* watch = nullptr);

/// retime_cores() of such a run. Of a memory that is shared it must be all cores that have samples, and where one is
/// left, all are.
Cores retime_cores_together(ScriptedRun const& run, Machine const& machine, std::vector<std::size_t> const& cores,
                            CoreOptions const& options);

}  // namespace dataflow::replay
