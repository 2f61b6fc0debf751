#pragma once
#include <memory>
#include <vector>

#include "config/accelerator_config.hpp"
#include "retiming/recorded_run.hpp"
#include "retiming/scripted_run.hpp"
#include "stats/run_statistics.hpp"
#include "timing/core_timing.hpp"

namespace faster::retiming {

/// The figures of a run with other retiming_keys(), equal to running it, without running it. A deadlock is a result, as
/// it is of a run. `config` must not differ from the recorded run's in other keys.
RunStatistics retime(RecordedRun const& run, AcceleratorConfig const& config);
/// The same, several times as fast.
RunStatistics retime(ScriptedRun const& run, AcceleratorConfig const& config);

/// One core of it, with its share of the samples done as far as that goes. Cores of one configuration that are retimed
/// one after the other may share an automaton, which makes the later ones quicker; all or none of them leave trails.
std::unique_ptr<timing::CoreTiming> retime_core(RecordedRun const& run, AcceleratorConfig const& config,
                                                std::size_t core, std::shared_ptr<timing::Automaton> const& automaton,
                                                bool leaves_trail = false);
/// The same, quicker. Of a core that deadlocks, since when its processes wait is not always known.
std::unique_ptr<timing::CoreTiming> retime_core(ScriptedRun const& run, AcceleratorConfig const& config,
                                                std::size_t core, std::shared_ptr<timing::Automaton> const& automaton,
                                                bool leaves_trail = false);

/// Several at once, quicker than one after the other.
std::vector<std::unique_ptr<timing::CoreTiming>> retime_cores(ScriptedRun const& run, AcceleratorConfig const& config,
                                                              std::vector<std::size_t> const& cores);

}  // namespace faster::retiming
