#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/scripted_run.hpp"

namespace dataflow::replay {

/// The figures of a run on another machine, equal to running it there, without running it. A deadlock is a result, as
/// it is of a run. `machine` must not differ from the recorded run's in more than retiming_keys() decide.
RunStatistics retime(RecordedRun const& run, Machine const& machine);
/// The figures on another machine of a run that is retimed many times. On several threads it takes less time, and more
/// processor time. Behind an external memory, which all cores share, there is one.
RunStatistics retime(ScriptedRun const& run, Machine const& machine, std::size_t jobs = 1);
/// retime(), and the critical path among the figures unless the run deadlocks.
RunStatistics retime_with_path(ScriptedRun const& run, Machine const& machine);
/// Retimes without following scripts. Several times as slow.
RunStatistics retime_unscripted(ScriptedRun const& run, Machine const& machine);

using Cores = std::vector<std::unique_ptr<timing::PhraseCore>>;

/// Asked after each sample of a core: whether to leave the others. What processes of the lead group have waited so far
/// is not all in their counters then.
using Leaves = std::function<bool(timing::CoreTiming const& timing)>;

struct CoreOptions {
    bool leave_trails = false;
    Leaves leaves = nullptr;
};

/// Some of its cores, each with its share of the samples done as far as that goes. Of cores that deadlock, since when
/// their processes wait is not always known.
Cores retime_cores(ScriptedRun const& run, Machine const& machine, std::vector<std::size_t> const& cores,
                   CoreOptions const& options = {});

}  // namespace dataflow::replay
