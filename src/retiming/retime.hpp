#pragma once
#include "config/accelerator_config.hpp"
#include "retiming/recorded_run.hpp"
#include "retiming/scripted_run.hpp"
#include "stats/run_statistics.hpp"

namespace faster::retiming {

/// The figures of a run with other retiming_keys(), equal to running it, without running it. A deadlock is a result, as
/// it is of a run. `config` must not differ from the recorded run's in other keys.
RunStatistics retime(RecordedRun const& run, AcceleratorConfig const& config);
/// The same, several times as fast.
RunStatistics retime(ScriptedRun const& run, AcceleratorConfig const& config);

}  // namespace faster::retiming
