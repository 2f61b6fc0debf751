#pragma once
#include "dataflow/run/replay/scripted_run.hpp"

namespace dataflow::replay {

/// retime(), and the critical path among the figures unless the run deadlocks.
RunStatistics retime_with_path(ScriptedRun const& run, Machine const& machine);

}  // namespace dataflow::replay
