#include "dataflow/run/replay/retime_with_path.hpp"

#include <algorithm>

#include "dataflow/run/replay/critical_path_of.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/retime_together.hpp"

namespace dataflow::replay {

namespace {

/// The core whose last sample ends last, the first of them.
std::size_t last_core(RunStatistics const& run) {
    auto const ends_before = [](CoreStatistics const& a, CoreStatistics const& b) { return a.end_cycle < b.end_cycle; };
    return static_cast<std::size_t>(std::max_element(run.cores.begin(), run.cores.end(), ends_before) -
                                    run.cores.begin());
}

}  // namespace

RunStatistics retime_with_path(ScriptedRun const& scripted, Machine const& machine) {
    if (scripted.run().memory)
        return retime_together(scripted, machine, true);
    RunStatistics run = retime(scripted, machine);
    if (run.deadlocked())
        return run;
    std::size_t const core = last_core(run);
    CoreOptions options;
    options.leave_trails = true;
    Cores const cores = retime_cores(scripted, machine, {core}, options);
    run.critical_path = critical_path_of({cores.front().get()}, machine);
    run.critical_path->core = core;
    return run;
}

}  // namespace dataflow::replay
